# SPDX-License-Identifier: MIT
# The style that all figures share, and the file that they are drawn to.
#
# A figure sets width and height (cm) and loads this file. From the command line come
#   folder  where its CSV files are, with a slash at the end
#   format  'pdf', 'png', 'svg' or 'tex' (TikZ); of animation.gp 'gif', a film
#   output  the file to write
#   heading, chosen_width, chosen_height, chosen_font  a title, and a size (cm) and a font ('Times,9') instead of the figure's own, if
#           there are any
#   composed  if the margins are parts of the size, so that the letters shrink with it
# as in
#   gnuplot -e "folder='build/reports/'; format='pdf'; output='refinement.pdf'" refinement.gp

own_width = width
own_height = height
if (exists('chosen_width')) { width = chosen_width; height = chosen_height }
if (!exists('heading')) { heading = '' }
if (heading ne '') { set title heading noenhanced }
# In points as printed, and one size; indices and exponents have 0.8 of it.
if (!exists('columns')) { columns = 1 }  # of panels
font_size = exists('chosen_width') && (width / columns < 11 || height < 8) ? 7.2 : 8.8
composed_size = 8.8 * (1.0 * width / own_width < 1.0 * height / own_height ? 1.0 * width / own_width : 1.0 * height / own_height)
if (exists('composed')) { font_size = composed_size }
font_name = 'DejaVu Sans'
if (exists('chosen_font')) {
  font_name = chosen_font[1:strstrt(chosen_font, ',') - 1]
  font_size = real(chosen_font[strstrt(chosen_font, ',') + 1:*])
}
typeface = sprintf('%s,%.4g', font_name, font_size)
em = font_size * 2.54 / 72  # cm
# Margins of a figure's own, in parts of its size by the size of its letters.
across(letters) = letters * em / width
up(letters) = letters * em / height
title_share = heading eq '' ? 0 : up(2)
# A label in as many lines as the room (cm) asks for. A word that is longer than that makes the figure `unfit`.
length_of(text) = 0.56 * em * strlen(text)
part(text, k) = word(text, k) eq '/' ? '/ '.word(text, k + 1) : word(text, k)
after(text, k) = word(text, k) eq '/' ? k + 2 : k + 1
fits(text, room) = (unfit = unfit || length_of(text) > room, text)
wrapped(lines, line, text, k, room) = k > words(text) ? lines.fits(line, room) : \
    length_of(line.' '.part(text, k)) <= room ? wrapped(lines, line.' '.part(text, k), text, after(text, k), room) : \
    wrapped(lines.fits(line, room)."\n", part(text, k), text, after(text, k), room)
fitted(text, room) = wrapped('', word(text, 1), text, 2, room)
breaks(text) = strstrt(text, "\n") ? 1 + breaks(text[strstrt(text, "\n") + 1:*]) : 0
outwards(label) = -2 * breaks(label)  # offset of a label with more lines
# The left margin of two panels with these labels of their y axes.
margin_of(one, other) = across(6.5 + 1.3 * (breaks(one) > breaks(other) ? breaks(one) : breaks(other)))
# A composed figure has its margins for letters of `composed_size`; larger ones are cut (3 % for 9 points: empirical).
unfit = exists('chosen_font') ? exists('composed') && font_size > 1.03 * composed_size : font_size < 5
# A step of tics of 1, 2 or 5 that leaves room for their labels.
decade(x) = 10.0**floor(log10(x))
round_step(x) = x <= decade(x) ? decade(x) : x <= 2 * decade(x) ? 2 * decade(x) : x <= 5 * decade(x) ? 5 * decade(x) : 10 * decade(x)
x_step(range, room) = range > 0 ? round_step(range * 4.5 * em / room) : 1
y_step(range, room) = range > 0 ? round_step(range * 1.6 * em / room) : 1
# The rows of a legend of so many titles, the longest of so many letters, over a panel (cm), as gnuplot lays them out.
title_of(longest) = (longest + 3.5) * 0.64 * em
rows_of(titles, longest, wide) = wide < 2 * title_of(longest) ? titles : ceil(1.0 * titles / floor(wide / title_of(longest)))
# Two panels, one on the other, with a legend above and below. To be set first: the rows of these.
two_panels = "above = title_share + up(0.8 + 1.2 * top_rows); below = up(4.2 + 1.2 * bottom_rows); middle = 0.5 * (1 - above + below); \
    panel = (1 - above - middle) * height - 0.55 * em; room = panel + 0.6 * em"  # of its label
upper = "set bmargin at screen middle + up(0.55); set tmargin at screen 1 - above; set format x ''"
lower = "set tmargin at screen middle - up(0.55); set bmargin at screen below; set format x '%g'"
key_place = 0.5
upper_key = "set key at screen key_place, 1 - title_share - up(0.3) center top horizontal samplen 1.5 width -0.4 maxrows top_rows"
lower_key = "set key at screen key_place, up(0.3) center bottom horizontal samplen 1.5 width -0.4 maxrows bottom_rows"
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
if (format eq 'tex') {  # to be read by \input, with gnuplot-lua-tikz.sty
  eval sprintf("set terminal tikz size %g,%g charsize %g,%g font '\\fontsize{%g}{%g}\\selectfont'", \
               width, height, 0.64 * em, 1.3 * em, font_size, 1.2 * font_size)
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
if (format eq 'tex') { set format '%g' }  # its own has the dollars of TeX
