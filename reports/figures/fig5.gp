# SPDX-License-Identifier: MIT
# Fig. 5: tip displacement at A0 = 1 mm.
file = folder.'fig5.csv'
values = folder.'fig5-values.csv'
load 'tip-histories.gp'
