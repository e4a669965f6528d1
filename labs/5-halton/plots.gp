# Draws lab 5. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

ways(s) = "independent jittered halton hammersley sobol scrambled_sobol"

# The lecture's points, and others, over elementary intervals -------------------------------------
# Each set has one shape of interval, with as many intervals as there are points.
array points[6] = [256, 256, 216, 256, 256, 256]
array columns[6] = [1, 16, 8, 32, 16, 4]
array rows[6] = [1, 16, 27, 8, 16, 64]
name = "points"; width = 600 * count; height = 1010
load draw
set multiplot layout 3,2*count margins 5./width, 1 - 5./width, 5./height, 1 - 52./height spacing 12./width, 58./height
set size square
set xrange [0:1]
set yrange [0:1]
set format ""
set grid lt 1 lw 0.5 lc rgb "#50808080"
unset key
do for [row=0:2] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
  set xtics 0,1./columns[i] scale 0
  set ytics 0,1./rows[i] scale 0
  set title sprintf("%s%s\n%d points%s", is(word(ways(s), i)), who(s), points[i], i > 1 ? sprintf(" in %d × %d", columns[i], rows[i]) : "")
  plot data[s]."/points-".word(ways(s), i).".tsv" using "x":"y" with points pt 7 ps 0.5 lc rgb dot
} } }
unset multiplot

# Discrepancy against N ---------------------------------------------------------------------------
name = "discrepancy"; width = 80 + 460 * count; height = 590
load draw
set termoption enhanced
eval panels(80, 80, 195)
set logscale xy
set xrange [9:5500]
set yrange [0.0005:0.7]
set format y "10^{%L}"
set xtics (16, 64, 256, 1024, 4096)
set xlabel "N"
set ylabel "star discrepancy D*"
set key at screen 10./width,0.01 left bottom vertical maxrows 5 Left reverse samplen 3
do for [s=1:count] {
  set title heading("At N = 2ᵏ and between", s)
  plot for [m in ways(s)] data[s]."/discrepancy.tsv" using "N":m with linespoints ls value(m) notitle, \
       for [m in ways(s)] keyentry with linespoints ls value(m) title is(m), \
       0.85/sqrt(x) with lines ls theory title "N^{-1/2}", \
       0.16*log(x)**2/x with lines ls theory+2 title "(log N)^2 / N", \
       0.65*log(x)/x with lines ls theory+1 title "log N / N"
  unset key
  unset ylabel
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[5] = ["line", "plane", "four", "kinks", "edge"]
array what[5] = ["exp(x)", "exp(x + y)", "exp(x + y + z + w)", "two kinks", "an edge: a quarter of a disk"]
array rate[5] = [1.5, 1.5, 1.5, 1.5, 0.75]
array rates[5] = ["N^{-3/2}", "N^{-3/2}", "N^{-3/2}", "N^{-3/2}", "N^{-3/4}"]
name = "convergence"; width = 620 * count; height = 1080
load draw
set termoption enhanced
set multiplot layout 3,2*count margins 80./width, 1 - 20./width, 65./height, 1 - 32./height spacing 65./width, 100./height
set logscale xy
set format "10^{%L}"
set xrange [10:100000]
do for [row=0:2] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
  if (i == 6) {
    set multiplot next
  } else {
    set title what[i].who(s)
    set xlabel "N"
    set ylabel (i % 2 == 1 ? "error" : "")
    set label 1 rates[i] at graph 0.04, graph 0.07 left tc rgb ink
    # The legend is to the right of the last panel.
    if (i == 5) { set key at graph 1.2, 0.95 left top Left reverse samplen 3 } else { unset key }
    plot for [m in ways(s)] data[s]."/convergence-".of[i].".tsv" using "N":m with linespoints ls value(m) ps 0.8 notitle, \
         for [m in ways(s)] keyentry with linespoints ls value(m) ps 0.8 title is(m), \
         0.5*x**-0.5 with lines ls theory title "N^{-1/2}", \
         0.5*x**-rate[i] with lines ls theory+1 title "the rate in the corner"
  }
} } }
unset multiplot

# The same points, randomized in four ways --------------------------------------------------------
array wave[2] = ["exp(x)", "cos(2πNx)"]
array waves[2] = ["smooth", "wave"]
how(m) = is(m).(m eq "scrambled_halton" ? " (base 2: a digital shift)" : m eq "scrambled_sobol" ? " (nested)" : "")
name = "randomized"; width = 620 * count; height = 430
load draw
set termoption enhanced
set multiplot layout 1,2*count margins 80./width, 1 - 25./width, 145./height, 1 - 32./height spacing 70./width, 0
set logscale xy
set format "10^{%L}"
set xrange [3:6000]
set xlabel "N"
set key at screen 0.5,0.01 center bottom vertical maxrows 4 Left reverse samplen 3
do for [s=1:count] {
  do for [i=1:2] {
    set title wave[i].who(s)
    set ylabel (i == 1 ? "RMSE, base 2, on the line" : "")
    set yrange [(i == 1 ? 1e-7 : 5e-3):(i == 1 ? 1 : 2)]
    plot for [m in "independent rotated scrambled_halton scrambled_sobol"] data[s]."/randomized-".waves[i].".tsv" using "N":m \
      with linespoints ls value(m) notitle, \
      for [m in "independent rotated scrambled_halton scrambled_sobol"] keyentry with linespoints ls value(m) title how(m)
    unset key
  }
}
unset multiplot

# The kurtosis of the error of exp(x) --------------------------------------------------------------
name = "tails"; width = 80 + 420 * count; height = 440
load draw
eval panels(70, 75, 130)
set logscale xy
set xrange [12:5500]
set yrange [2:5<*<200]  # if it is 3, close enough to see the error bars
set xtics (16, 64, 256, 1024, 4096)
set ytics (2, 3, 5, 10, 20, 50, 100)
set xlabel "N"
set ylabel "kurtosis of the error of exp(x)"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Kurtosis, with its standard error", s)
  file = data[s]."/tails.tsv"
  plot 3 with lines ls theory title "Gaussian errors", \
       file using "N":"scrambled_sobol":"standard_error" with yerrorlines ls scrambled_sobol dt 1 notitle, \
       keyentry with linespoints ls scrambled_sobol dt 1 title "5.8 base 2, scrambled", \
       file using "N":"hashed":"its" with yerrorlines ls hashed dt 1 title hashed_is
  unset key
  unset ylabel
}
unset multiplot

# How many replicates -----------------------------------------------------------------------------
array integrand[3] = ["smooth", "kinks", "edge"]
array held[3] = ["exp(x + y)", "two kinks", "an edge"]
name = "replicates"; width = 620 * count; height = 475
load draw
set termoption enhanced
set multiplot layout 1,2*count margins 80./width, 1 - 20./width, 180./height, 1 - 32./height spacing 65./width, 0
set logscale x 2
set xrange [1.6:80]
set xtics (2, 4, 8, 16, 32, 64)
set xlabel "R replicates of 4096/R points"
do for [s=1:count] {
  file = data[s]."/replicates.tsv"
  set title "With the true value".who(s)
  set ylabel (s == 1 ? "fraction of 400 intervals of 95 %" : "")
  set yrange [0.6:1.02]
  unset key
  plot 0.95 with lines ls theory notitle, \
       for [i=1:3] file using "R":"t_".integrand[i] with points ls other+i ps 1.2 notitle, \
       file using "R":"z_smooth" with points ls textbook ps 0.8 notitle, \
       file using "R":"z_exact" with lines lt 1 lw 1 lc rgb ink notitle
  set title "Half of their mean length".who(s)
  set ylabel ""
  set logscale y
  set format y "10^{%L}"
  set yrange [5e-5:1]
  if (s == count) { set key at screen 10./width,0.01 left bottom vertical maxrows 4 Left reverse samplen 3 width -6 }
  plot for [i=1:3] file using "R":"reach_".integrand[i] with linespoints ls other+i notitle, \
       for [i=1:3] file using "R":"independent_".integrand[i] with lines ls other+i lw 1 notitle, \
       for [i=1:3] keyentry with linespoints ls other+i title held[i].", Student's t", \
       keyentry with points ls textbook ps 0.8 title "exp(x + y), z of 2.5", \
       keyentry with lines lt 1 lw 1 lc rgb ink title "the same, Gaussian", \
       for [i=1:3] keyentry with lines ls other+i lw 1 title held[i].", as if independent"
  unset logscale y
  set format y "%g"
}
unset multiplot

# The first points of a sequence ------------------------------------------------------------------
name = "early"; width = 80 + 420 * count; height = 450
load draw
set termoption enhanced
eval panels(80, 80, 135)
set logscale xy
set format y "10^{%L}"
set xrange [0.8:1300]
set yrange [5e-6:1]
set xtics (1, 4, 16, 64, 256, 1024)
set xlabel "n"
set ylabel "RMSE"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 4
do for [s=1:count] {
  set title heading("The first n of 1024 points, exp(-x² - y²)", s)
  plot data[s]."/early.tsv" using "N":"independent" with lines ls independent title independent_is, \
       data[s]."/early.tsv" using "N":"padded" with lines ls padded title "3.4 jittered, shuffled", \
       data[s]."/early.tsv" using "N":"scrambled_sobol" with linespoints ls scrambled_sobol notitle, \
       keyentry with linespoints ls scrambled_sobol title scrambled_sobol_is
  unset key
  unset ylabel
}
unset multiplot

# Bad pairs of axes -------------------------------------------------------------------------------
array pair[5] = ["halton", "rotated", "scrambled_halton", "sobol", "scrambled_sobol"]
array paired[5] = ["64 points, bases 29, 31", "5.7 rotated", "5.9 digits permuted", "1024 Sobol' points, 14, 15", "5.8 scrambled"]
name = "pair"; width = 620 * count; height = 470
load draw
set multiplot layout 2,3*count margins 3./width, 1 - 3./width, 5./height, 1 - 30./height spacing 8./width, 36./height
set size square
set xrange [0:1]
set yrange [0:1]
set xtics 0,0.125 format "" scale 0
set ytics 0,0.125 format "" scale 0
set grid lt 1 lw 0.5 lc rgb "#50808080"
unset key
do for [row=0:1] { do for [s=1:count] { do for [i=3*row+1:3*row+3] {
  if (i == 6) {
    set multiplot next
  } else {
    set title paired[i].(i % 3 == 1 ? who(s) : "")
    plot data[s]."/pair-".pair[i].".tsv" using "x":"y" with points pt 7 ps (i < 4 ? 0.7 : 0.25) lc rgb dot
  }
} } }
unset multiplot

# Error against time ------------------------------------------------------------------------------
timed = "radical_inverse halton sobol scrambled_sobol scrambled_halton"
array above[5] = [1, 1, -1, 1, -1.6]
name = "speed"; width = 80 + 460 * count; height = 410
load draw
eval panels(80, 80, 60)
set logscale xy
set xrange [0.02:2000]
set yrange [5e-6:2e-2]
set format y "10^{%L}"
set xlabel "ns per point (less is better)"
set ylabel "error of exp(x + y) (less is better)"
unset key
speed(s, m) = data[s]."/speed-".m.".tsv"
fast(m) = m eq "halton" ? "5.2 Halton" : is(m)
do for [s=1:count] {
  set title heading("Error of 4096 points against their time", s)
  plot for [m in timed] speed(s, m) using "ns":"error" with points ls value(m) ps 2, \
       for [i=1:5] speed(s, word(timed, i)) using "ns":"error":(fast(word(timed, i))) \
         with labels tc rgb ink offset 0,1.1*above[i] noenhanced
  unset ylabel
}
unset multiplot
