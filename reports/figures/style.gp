# SPDX-License-Identifier: MIT
# The style that all figures share, and the file that they are drawn to.
#
# A figure sets width and height (cm) and loads this file. From the command line come
#   folder  where its CSV files are, with a slash at the end
#   format  'pdf', 'png' or 'svg'; of animation.gp 'gif', a film
#   output  the file to write
#   heading, chosen_width, chosen_height  a title, and a size (cm) instead of the figure's own, if there are any
# as in
#   gnuplot -e "folder='build/reports/'; format='pdf'; output='refinement.pdf'" refinement.gp

if (exists('chosen_width')) { width = chosen_width; height = chosen_height }
if (!exists('heading')) { heading = '' }
if (heading ne '') { set title heading noenhanced }
title_share = heading eq '' ? 0 : 0.6 / height  # of the height, for figures with margins of their own
typeface = 'DejaVu Sans,8.8'  # in points as printed, and the one size; indices and exponents have 7
if (format eq 'pdf') {
  # This terminal, too, takes fonts at 96 dots per inch and not at 72.
  # Its lines are half as wide as those of the others.
  set terminal pdfcairo enhanced color font typeface fontscale 0.75 linewidth 1.8 \
      size width cm, height cm
}
if (format eq 'svg') {
  pixels_per_cm = 96.0 / 2.54
  set terminal svg enhanced font typeface fontscale 1.0 linewidth 1.0 \
      size width * pixels_per_cm, height * pixels_per_cm background '#FFFFFF'
}
if (format eq 'png') {
  dots_per_cm = 80.0
  magnification = dots_per_cm * 2.54 / 72.0
  font_magnification = dots_per_cm * 2.54 / 96.0  # this terminal takes fonts at 96 dots per inch
  set terminal pngcairo enhanced color font typeface fontscale font_magnification \
      linewidth magnification pointscale magnification size width * dots_per_cm, height * dots_per_cm
}
if (format eq 'gif') {  # 25 frames a second, again and again
  set terminal gif animate delay 4 loop 0 optimize enhanced font typeface fontscale 2.2 linewidth 2.2 \
      size width * 80, height * 80
}
set output output
set encoding utf8
set datafile separator comma
set datafile columnheaders

# Okabe and Ito's palette, which colour-blind readers can tell apart. Grey print keeps little of it: curves of one panel differ
# in their points or dashes, too.
black = '#000000'
green = '#009E73'
blue = '#0072B2'
vermillion = '#D55E00'
purple = '#CC79A7'
grey = '#8C8C8C'
array colours[4] = [blue, vermillion, green, purple]
array shapes[4] = [4, 6, 8, 12]
# Regions of the criterion: where the tip sticks is darker than where it slips.
stick_fill = '#A6CBE6'
slip_fill = '#FFF1DD'
slip_band = '#E8D6BE'  # of a time in slip, behind curves
# |f_max|/(mu_s P) on its decadic logarithm: lighter throughout with the force, the hue changes at the limit.
ratio_palette = "set palette defined (-1.5 '#08306B', -0.75 '#2171B5', 0 '#7FB8DE', 0 '#EE9A33', 0.75 '#FDCB75', 1.5 '#FFF6D0')"

set dashtype 2 (7, 5)
set style line 1 linecolor rgb blue linewidth 1.5
set style line 2 linecolor rgb vermillion linewidth 1.2 pointtype 6 pointsize 0.5
set style line 3 linecolor rgb grey linewidth 0.8 dashtype 2
set border linewidth 0.6
set tics scale 0.6 nomirror
set grid linecolor rgb '#DDDDDD' linewidth 0.5 linetype 1
set key reverse Left samplen 2 spacing 1.2
set title offset 0, -0.6
set minussign
