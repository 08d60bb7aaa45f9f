# SPDX-License-Identifier: MIT
# What an axis says of a parameter, and by what its values are multiplied for that, in the order of studies::Parameter.
array names[11] = ['excitation frequency / Hz', 'excitation amplitude A_0 / mm', 'beam length L / m', \
    'axial force P / N', "Young's modulus E / GPa", 'static friction coefficient μ_s', \
    'direction of the axial force χ', 'kinetic friction coefficient μ_m', 'decay of the friction α / (s/m)', \
    'damping ratio ζ', 'Kelvin-Voigt damping η / s']
array scales[11] = [1, 1e3, 1, 1, 1e-9, 1, 1, 1, 1, 1, 1]
