# Draws lab 4. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

ways(s) = "independent jittered few_candidates best_candidate poisson_disk"

# Patterns over their periodograms ----------------------------------------------------------------
# Periodograms are pictures with one pixel per frequency; white is twice the power of independent points.
# Three patterns are in the first row and two in the second, each above its periodogram. The sixth panel
# is the gray scale.
name = "spectra"; width = 640 * count; height = 940
load draw
set multiplot
set size square
unset key
unset grid
set palette gray
set cbrange [0:2]
w = 203; step = 464  # in pixels: the width of a panel, and the height of a pattern with its periodogram
do for [s=1:count] {
  do for [i=1:5] {
    left = 640. * (s - 1) + ((i - 1) % 3) * (w + 10) + 5
    top = (i > 3 ? step : 0) + 32
    set lmargin at screen left / width
    set rmargin at screen (left + w) / width
    set tmargin at screen 1 - 1. * top / height
    set bmargin at screen 1 - 1. * (top + w) / height
    m = word(ways(s), i)
    unset tics
    unset colorbox
    set title is(m).(i == 1 ? who(s) : "")
    set xrange [0:1]
    set yrange [0:1]
    plot data[s]."/spectra-pattern-".m.".tsv" using "x":"y" with points pt 7 ps 0.4 lc rgb dot
    set tmargin at screen 1 - (top + w + 8.) / height
    set bmargin at screen 1 - (top + 2. * w + 8) / height
    set title ""
    set xrange [-0.5:96.5]
    set yrange [-0.5:96.5]
    if (i == 5) {
      set colorbox user horizontal origin (left + w + 40.) / width, 1 - (top + 1.5 * w) / height size 130. / width, 16. / height
      set cbtics ("0" 0, "1" 1, "2" 2) nomirror out textcolor rgb ink
      set label 3 "mean power\nof 40 patterns" at screen (left + w + 105.) / width, 1 - (top + 1.25 * w) / height center tc rgb ink
    }
    plot data[s]."/spectra-power-".m.".tsv" matrix with image
    unset label 3
  }
}
unset multiplot

# Power over rings --------------------------------------------------------------------------------
name = "radial"; width = 80 + 420 * count; height = 470
load draw
eval panels(75, 70, 130)
set termoption enhanced
set xrange [0:3]
set yrange [0:2]
set xtics 0,0.5
set ytics 0,0.5
set xlabel "frequency |k| / √N"
set ylabel "power (independent points: 1)"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Mean power over rings, N = 256", s)
  plot for [m in ways(s)] data[s]."/radial.tsv" using "frequency":m with linespoints ls value(m) pi 4 notitle, \
       for [m in ways(s)] keyentry with linespoints ls value(m) title is(m)
  unset key
  unset ylabel
}
unset multiplot

# Gain over independent points against N ---------------------------------------------------------
# The dashed line is the limit of Poisson disks, 1 / sqrt(P) with their power at the lowest frequency.
array of[2] = ["bump", "edge"]
array what[2] = ["exp(-x² - y²)", "a slanted edge"]
name = "convergence"; width = 620 * count; height = 470
load draw
set termoption enhanced
array limit[count]
do for [s=1:count] {
  stats data[s]."/radial.tsv" using (column("frequency") < 0.07 ? column("poisson_disk") : NaN) nooutput
  limit[s] = exists("STATS_min") ? 1 / sqrt(STATS_min) : NaN
  undefine STATS_*
}
set multiplot layout 1,2*count margins 75./width, 1 - 20./width, 145./height, 1 - 32./height spacing 45./width, 0
set logscale xy
set xrange [3:110000]
set yrange [0.8:100]
set xtics (4, 64, 1024, "16k" 16384)
set ytics (1, 2, 4, 8, 16, 32, 64)
set xlabel "N"
do for [s=1:count] {
  do for [f=1:2] {
    set title what[f].who(s)
    set ylabel (f == 1 && s == 1 ? "RMSE of independent points / RMSE" : "")
    if (f == 2 && s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3 width 2 } else { unset key }
    file = data[s]."/gain-".of[f].".tsv"
    set label 1 (f == 1 ? "N^{1/2}" : "N^{1/4}") at (f == 1 ? 900 : 80000), (f == 1 ? 42 : 7.5) right tc rgb ink
    plot for [m in "jittered best_candidate poisson_disk"] file using "N":m with linespoints ls value(m) notitle, \
         for [m in "jittered best_candidate poisson_disk"] keyentry with linespoints ls value(m) title is(m), \
         (f == 1 ? 1.2*x**0.5 : 0.75*x**0.25) with lines ls theory+1 notitle, \
         (f == 1 ? limit[s] : NaN) with lines ls theory title "limit of Poisson disks"
  }
}
unset multiplot

# Time against N ----------------------------------------------------------------------------------
name = "speed"; width = 80 + 420 * count; height = 420
load draw
set multiplot layout 1,count margins 80./width, 1 - 35./width, 90./height, 1 - head(count)/height \
  spacing 80./width, 0
set logscale xy
set xrange [40:100000]
set xtics (64, 256, 1024, 4096, 16384, 65536)
set yrange [0.5:1000]
set xlabel "N points"
set ylabel "µs per point"
set key at screen 0.5,0.01 center bottom maxrows 1 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Time per point against N", s)
  plot for [m in "best_candidate poisson_disk"] data[s]."/speed.tsv" using "N":m with linespoints ls value(m) title is(m)
  unset key
  unset ylabel
}
unset multiplot
