# Draws lab @number@. Called by ./lab plot with
#   count      how many submissions are drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

# Squares -----------------------------------------------------------------------------------------
name = "squares"; width = 80 + 420 * count; height = 400
load draw
set multiplot layout 1,count margins 70./width, 1 - 25./width, 60./height, 1 - head(count)/height \
  spacing 75./width, 0
set xrange [-10:10]
set yrange [0:100]
set xlabel "x"
set ylabel "square of x"
unset key
do for [s=1:count] {
  set title heading("Squares", s)
  plot data[s]."/squares.tsv" using "x":"square" with linespoints ls other+1
  unset ylabel
}
unset multiplot
