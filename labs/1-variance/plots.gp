# Draws lab 1. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

array ways[5] = ["textbook_formula", "two_passes", "welford", "merged", "fast_moments"]

# Digits kept against the offset ------------------------------------------------------------------
name = "digits"; width = 80 + 420 * count; height = 450
load draw
eval panels(70, 75, 130)
set logscale x
set format x "10^{%L}"
set xrange [1:1e15]
set yrange [0:16.9]
set ytics 0,4
set xtics 1,1000
set xlabel "offset of the 1000 values"
set ylabel "correct digits"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 2
do for [s=1:count] {
  set title heading("Correct digits of the variance", s)
  plot for [i=1:5] data[s]."/digits.tsv" using "offset":ways[i] with linespoints ls other+i pi 4 notitle, \
       for [i=1:5] keyentry with linespoints ls other+i title is(ways[i])
  unset key
  unset ylabel
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
# Every point has a label. That of the merged parts is below its point, since Welford's is close.
name = "speed"; width = 80 + 420 * count; height = 400
load draw
eval panels(85, 85, 60)
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
  set title heading("Variance of 4096 values near 10⁹, in cache", s)
  plot for [i=1:5] speed(s, i) using "ns":"error" with points ls other+i ps 2, \
       for [i=1:5] speed(s, i) using "ns":"error":(is(ways[i])) with labels tc rgb ink offset 0,1.1*above[i]
  unset ylabel
}
unset multiplot
