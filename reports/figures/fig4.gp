# SPDX-License-Identifier: MIT
# Fig. 4: tip displacement at A0 = 0.5 mm.
file = folder.'fig4.csv'
values = folder.'fig4-values.csv'
load 'tip-histories.gp'
