# SPDX-License-Identifier: MIT
# Defines what the CSV file `values` holds: one variable a row, with its name, its value and its unit.
stats values using 2 name 'row' nooutput
do for [i = 0:int(row_records) - 1] {
  stats values every ::i::i using (name = strcol(1), number = column(2)) name 'row' nooutput
  eval sprintf('%s = %.17g', name, number)
}
