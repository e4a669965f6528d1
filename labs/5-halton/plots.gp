# Draws lab 5. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

ways(s) = "independent jittered halton hammersley sobol scrambled_sobol"

# The lecture's points, and others, over as many elementary intervals as there are points ----------
array points[6] = [256, 256, 216, 256, 256, 256]
array columns[6] = [16, 16, 8, 16, 16, 16]
array rows[6] = [16, 16, 27, 16, 16, 16]
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
  set title sprintf("%s%s\n%d points, %d × %d boxes", is(word(ways(s), i)), who(s), points[i], columns[i], rows[i])
  plot data[s]."/points-".word(ways(s), i).".tsv" using "x":"y" with points pt 7 ps 0.5 lc rgb dot
} } }
unset multiplot

# Discrepancy against N, in units of the rate of a set ----------------------------------------------
name = "discrepancy"; width = 80 + 540 * count; height = 620
load draw
set termoption enhanced
eval panels(75, 75, 165)
set logscale xy
set xrange [14:4600]
set yrange [0.25:40]
set xtics (16, 64, 256, 1024, 4096)
set ytics (0.3, 0.5, 1, 2, 5, 10, 20)
set xlabel "N: powers of two, and between them"
set ylabel "N D* / ln N"
set key at screen 10./width,0.01 left bottom vertical maxrows 4 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Star discrepancy, divided by ln N / N", s)
  set label 1 "N^{-1/2}" at 1500,3.6 rotate by 24 center tc rgb ink
  set label 2 "(ln N)^2 / N" at 2000,1.72 rotate by 6 center tc rgb ink
  plot for [m in ways(s)] data[s]."/discrepancy.tsv" using "N":(column("N") * column(m) / log(column("N"))) with linespoints ls value(m) notitle, \
       for [m in ways(s)] keyentry with linespoints ls value(m) title is(m), \
       0.85 * sqrt(x) / log(x) with lines ls theory notitle, \
       0.2 * log(x) with lines ls theory+2 notitle
  unset key
  unset ylabel
}
unset multiplot

# Error against N: thin lines are single errors, of deterministic points ----------------------------
array of[5] = ["line", "plane", "four", "kinks", "edge"]
array what[5] = ["exp(x)", "exp(x + y)", "exp(x + y + z + w)", "two kinks", "an edge: a quarter of a disk"]
array rate[5] = [1.5, 1.5, 1.5, 1.5, 0.75]
array rates[5] = ["N^{-3/2}", "N^{-3/2}", "N^{-3/2}", "N^{-3/2}", "N^{-3/4}"]
array start[5] = [0.5, 2, 30, 1, 0.5]   # of the lines of theory at N = 1
array low[5] = [5e-9, 5e-9, 5e-7, 5e-8, 5e-6]
array high[5] = [1, 1, 10, 1, 1]
array at[5] = [60, 60, 60, 60, 2000]    # where the slope is written, below its line
thin(m) = m eq "halton" || m eq "hammersley" || m eq "sobol" ? 1 : 2
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
    set yrange [low[i]:high[i]]
    set label 1 rates[i] at at[i],0.25 * start[i] * at[i]**-rate[i] right tc rgb ink
    set label 2 "N^{-1/2}" at 60000,2.2 * start[i] * 60000**-0.5 right tc rgb ink
    # The legend is to the right of the last panel.
    if (i == 5) { set key at graph 1.2, 0.95 left top Left reverse samplen 3 } else { unset key }
    plot for [m in ways(s)] data[s]."/convergence-".of[i].".tsv" using "N":m with linespoints ls value(m) lw thin(m) ps 0.8 notitle, \
         for [m in ways(s)] keyentry with linespoints ls value(m) lw thin(m) ps 0.8 title is(m), \
         start[i] * x**-0.5 with lines ls theory notitle, \
         start[i] * x**-rate[i] with lines ls theory+1 notitle
  }
} } }
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
  set title heading("Kurtosis of the error, ± its standard error", s)
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
  set title "Intervals that contain the true value".who(s)
  set ylabel (s == 1 ? "fraction of 400 intervals of 95 %" : "")
  set yrange [0.6:1.02]
  unset key
  plot 0.95 with lines ls theory notitle, \
       for [i=1:3] file using "R":"t_".integrand[i] with points ls other+i ps 1.2 notitle, \
       file using "R":"z_smooth" with points ls textbook ps 0.8 notitle, \
       file using "R":"z_exact" with lines lt 1 lw 1 lc rgb ink notitle
  set title "Mean half-length".who(s)
  set ylabel ""
  set logscale y
  set format y "10^{%L}"
  set yrange [5e-5:1]
  if (s == count) { set key at screen 10./width,0.01 left bottom vertical maxrows 4 Left reverse samplen 3 width -6 }
  plot for [i=1:3] file using "R":"reach_".integrand[i] with linespoints ls other+i notitle, \
       for [i=1:3] file using "R":"independent_".integrand[i] with lines ls other+i lw 1 notitle, \
       for [i=1:3] keyentry with linespoints ls other+i title held[i].", Student's t", \
       keyentry with points ls textbook ps 0.8 title "exp(x + y), z of 2.5", \
       keyentry with lines lt 1 lw 1 lc rgb ink title "Gaussian errors, z of 2.5", \
       for [i=1:3] keyentry with lines ls other+i lw 1 title held[i].", independent"
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
array above[5] = [1, 1, -1, 1, 1]
name = "speed"; width = 80 + 460 * count; height = 410
load draw
eval panels(80, 80, 60)
set logscale xy
set xrange [0.05:300]
set yrange [2e-6:2e-2]
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
