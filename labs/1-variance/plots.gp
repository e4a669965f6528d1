# Draws lab 1. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

array ways[5] = ["textbook_formula", "two_passes", "welford", "merged", "fast_moments"]

# Digits kept against the offset ------------------------------------------------------------------
name = "digits"; width = 80 + 430 * count; height = 460
load draw
set multiplot layout 1,count title "Right digits of the variance, 1000 values in [offset, offset + 1)" \
  margins 70./width, 1 - 20./width, 0.27, 0.83 spacing 70./width, 0
set logscale x
set format x "10^{%L}"
set xrange [1:1e15]
set yrange [0:16.9]
set ytics 0,4
set xtics 1,1000
set xlabel "offset"
set ylabel "digits kept"
set key at screen 0.5,0.01 center bottom vertical maxrows 2 Left reverse samplen 2 width -5
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [i=1:5] data[s]."/digits.tsv" using "offset":ways[i] with linespoints ls other+i pi 4 notitle, \
       for [i=1:5] keyentry with linespoints ls other+i title is(ways[i])
  unset key
  unset ylabel
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
# Every point carries its name; Welford's above it, merged parts' below, for they lie close
# together.
name = "speed"; width = 100 + 430 * count; height = 420
load draw
set multiplot layout 1,count title "Error of the variance against time, 4096 values near 10^{9}, in cache" \
  margins 90./width, 1 - 20./width, 0.14, 0.83 spacing 90./width, 0
set logscale xy
set xrange [0.03:60]
set yrange [1e-18:1e4]
set xtics (0.1, 0.3, 1, 3, 10, 30)
set ytics 1e-16,1e4,1
set format y "10^{%L}"
set xlabel "ns per value (less is better)"
set ylabel "relative error (less is better)"
unset key
array above[5] = [1, 1, 1, -1, 1]
speed(s, i) = sprintf("%s/speed-%s.tsv", data[s], ways[i])
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [i=1:5] speed(s, i) using "ns":"error" with points ls other+i ps 2, \
       for [i=1:5] speed(s, i) using "ns":"error":(is(ways[i])) with labels offset 0,1.1*above[i]
  unset ylabel
}
unset multiplot
