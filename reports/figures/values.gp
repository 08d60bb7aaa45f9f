# SPDX-License-Identifier: MIT
# Defines what the CSV file `values` holds: one variable a row, with its name, its value and its unit, which is - for a text.
stats values using (1) name 'row' nooutput
do for [i = 0:int(row_records) - 1] {
  stats values every ::i::i using (name = strcol(1), text = strcol(2), unit = strcol(3), 1) name 'row' nooutput
  if (unit eq '-') { eval name.' = text' } else { eval name.' = '.text }
}
