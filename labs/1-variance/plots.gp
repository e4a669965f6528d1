# Draws lab 1. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

array way[5] = ["1.2 textbook", "1.3 two passes", "1.4 Welford", "1.5 merged parts", "1.8 moments"]

# Digits kept against the offset of the data ------------------------------------------------------
name = "digits"; width = 460 * count; height = 420
load draw
set multiplot layout 1,count title "Digits of the variance that are right, for 1000 values in [offset, offset + 1)"
set logscale x
set format x "10^{%L}"
set xrange [1:1e15]
set yrange [0:16.5]
set ytics 0,4
set xtics 1,1000
set xlabel "offset"
set ylabel "digits kept"
set key at graph 0.03,0.03 left bottom Left reverse samplen 3
do for [s=1:count] {
  set title labels[s]
  plot for [i=1:5] data[s]."/digits.tsv" using 1:(column(i+1)) with linespoints ls i pi 4 title way[i]
}
unset multiplot

# Time against digits -----------------------------------------------------------------------------
name = "speed"; width = 460 * count; height = 420
load draw
set multiplot layout 1,count title "Time against digits kept: 4096 values near 10^{9}, in cache"
unset logscale x
set format x "%g"
set logscale y
set format y "%g"
set xrange [-0.5:16.5]
set yrange [0.03:30]
set ytics (0.03, 0.1, 0.3, 1, 3, 10, 30)
set xtics 0,4
set xlabel "digits kept (more is better)"
set ylabel "ns a value (less is better)"
set key at graph 0.97,0.97 right top
do for [s=1:count] {
  set title labels[s]
  plot for [i=1:5] data[s]."/speed.tsv" every ::i-1::i-1 using 3:2 with points ls i ps 2 title way[i]
}
unset multiplot
