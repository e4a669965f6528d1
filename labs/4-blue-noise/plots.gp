# Draws lab 4. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

ways(s) = "independent jittered few_candidates best_candidate poisson_disk"

# Patterns over their periodograms ----------------------------------------------------------------
# As pictures: one pixel a frequency, white at twice the power of independent points.
name = "spectra"; width = 1120; height = 40 + 470 * count
load draw
set multiplot title "256 points, and the mean periodogram of 40 such patterns (black 0, white 2)"
set size square
unset key
unset xtics
unset ytics
unset grid
unset colorbox
set palette gray
set cbrange [0:2]
do for [s=1:count] {
  bottom = 470. * (count - s) / height
  do for [i=1:5] {
    left = (i - 1) / 5. + 0.008
    set lmargin at screen left
    set rmargin at screen left + 0.184
    set bmargin at screen bottom + 226./height
    set tmargin at screen bottom + 432./height
    m = word(ways(s), i)
    set title is(m).(i == 1 ? who(s) : "") noenhanced
    set xrange [0:1]
    set yrange [0:1]
    plot data[s]."/spectra-pattern-".m.".tsv" using "x":"y" with points pt 7 ps 0.4 lc rgb "#0072B2"
    set bmargin at screen bottom + 10./height
    set tmargin at screen bottom + 216./height
    set title ""
    set xrange [-0.5:96.5]
    set yrange [-0.5:96.5]
    plot data[s]."/spectra-power-".m.".tsv" matrix with image
  }
}
unset multiplot

# Power over rings --------------------------------------------------------------------------------
name = "radial"; width = 80 + 520 * count; height = 480
load draw
set multiplot layout 1,count title "Mean power over rings, N = 256" \
  margins 70./width, 1 - 20./width, 0.29, 0.84 spacing 70./width, 0
set xrange [0:3]
set yrange [0:2]
set xtics 0,0.5
set ytics 0,0.5
set xlabel "frequency abs(k) / sqrt(N)"
set ylabel "power (independent points: 1)"
set key at screen 0.5,0.01 center bottom horizontal maxcols 3 Left reverse samplen 3 width 1
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [m in ways(s)] data[s]."/radial.tsv" using "frequency":m with linespoints ls value(m) pi 4 notitle, \
       for [m in ways(s)] keyentry with linespoints ls value(m) title is(m)
  unset key
  unset ylabel
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[2] = ["bump", "edge"]
array what[2] = ["exp(-x² - y²)", "a slanted edge"]
name = "convergence"; width = 1000; height = 100 + 440 * count
load draw
set multiplot layout count,2 title "Error of integration, root mean square of 100 patterns (40 at N = 1024)" \
  margins 80./width, 1 - 20./width, 130./height, 1 - 70./height spacing 80./width, 110./height
set logscale xy
set xrange [3:1400]
set xtics (4, 16, 64, 256, 1024)
set format y "10^{%L}"
set xlabel "N"
set ylabel "RMSE"
do for [s=1:count] {
  do for [f=1:2] {
    set title what[f].who(s) noenhanced
    if (f == 1 && s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3 width 2 } else { unset key }
    file = data[s]."/convergence-".of[f].".tsv"
    plot 0.3*x**-0.5 with lines ls theory title "N^{-1/2}", \
         (f == 2 ? 0.4*x**-0.75 : NaN) with lines ls theory+2 title "N^{-3/4} (edge)", \
         0.5/x with lines ls theory+1 title "N^{-1}", \
         for [m in "independent jittered best_candidate poisson_disk"] file using "N":m with linespoints ls value(m) notitle, \
         for [m in "independent jittered best_candidate poisson_disk"] keyentry with linespoints ls value(m) title is(m)
  }
}
unset multiplot

# Time against N ----------------------------------------------------------------------------------
name = "speed"; width = 80 + 480 * count; height = 420
load draw
set multiplot layout 1,count title "Time per point against N" \
  margins 80./width, 1 - 20./width, 0.16, 0.83 spacing 80./width, 0
set logscale xy
set xrange [40:100000]
set xtics (64, 256, 1024, 4096, 16384, 65536)
set yrange [0.5:1000]
set xlabel "N points"
set ylabel "µs per point"
set key left top Left reverse samplen 3
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [m in "best_candidate poisson_disk"] data[s]."/speed.tsv" using "N":m with linespoints ls value(m) title is(m)
  unset ylabel
}
unset multiplot
