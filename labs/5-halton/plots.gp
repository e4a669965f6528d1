# Draws lab 5. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

ways(s) = "independent jittered halton hammersley sobol scrambled_sobol"

# The lecture's points, and others, over elementary intervals -------------------------------------
# A shape of interval for each set, as many as there are points.
array points[6] = [256, 256, 216, 256, 256, 256]
array columns[6] = [1, 16, 8, 32, 16, 4]
array rows[6] = [1, 16, 27, 8, 16, 64]
name = "points"; width = 1060; height = 730 * count
load draw
set multiplot layout 2*count,3 margins 0.015, 0.985, 10./height, 1 - 36./height spacing 0.02, 40./height
set size square
set xrange [0:1]
set yrange [0:1]
set format ""
set grid lt 1 lw 0.5 lc rgb "#AAAAAA"
unset key
do for [s=1:count] {
  do for [i=1:6] {
    set xtics 0,1./columns[i] scale 0
    set ytics 0,1./rows[i] scale 0
    set title sprintf("%s, %d", is(word(ways(s), i)), points[i]).(i > 1 ? sprintf(" in %d × %d", columns[i], rows[i]) : "").who(s) noenhanced
    plot data[s]."/points-".word(ways(s), i).".tsv" using "x":"y" with points pt 7 ps 0.5 lc rgb "#0072B2"
  }
}
unset multiplot

# Discrepancy against N ---------------------------------------------------------------------------
name = "discrepancy"; width = 220 + 500 * count; height = 600
load draw
set multiplot layout 1,count title "Star discrepancy in the plane, at N = 2^{k} and between" \
  margins 80./width, 1 - 20./width, 0.29, 0.87 spacing 80./width, 0
set logscale xy
set xrange [9:5500]
set yrange [0.0005:0.7]
set format y "10^{%L}"
set xtics (16, 64, 256, 1024, 4096)
set xlabel "N"
set ylabel "D*"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3 width -3
do for [s=1:count] {
  set title panel(s) noenhanced
  plot 0.85/sqrt(x) with lines ls theory title "N^{-1/2}", \
       0.16*log(x)**2/x with lines ls theory+2 title "(log N)^2 / N", \
       0.65*log(x)/x with lines ls theory+1 title "log N / N", \
       for [m in ways(s)] data[s]."/discrepancy.tsv" using "N":m with linespoints ls value(m) notitle, \
       for [m in ways(s)] keyentry with linespoints ls value(m) title is(m)
  unset key
  unset ylabel
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[5] = ["line", "plane", "four", "kinks", "edge"]
array what[5] = ["exp(x)", "exp(x + y)", "exp(x + y + z + w)", "two kinks", "an edge: a quarter of a disk"]
array rate[5] = [1.5, 1.5, 1.5, 1.5, 0.75]
name = "convergence"; width = 1180; height = 60 + 760 * count
load draw
set multiplot layout 2*count,3 margins 75./width, 1 - 15./width, 50./height, 1 - 36./height spacing 65./width, 90./height
set logscale xy
set format "10^{%L}"
set xrange [10:100000]
set xlabel "N"
do for [s=1:count] {
  do for [i=1:5] {
    set title what[i].who(s) noenhanced
    set ylabel (i % 3 == 1 ? "error" : "")
    # The last panel of a submission leaves room on its right, where the key stands.
    if (i == 5) { set key at graph 1.25, 0.9 left top Left reverse samplen 3 } else { unset key }
    plot 0.5*x**-0.5 with lines ls theory title "N^{-1/2}", \
         0.5*x**-rate[i] with lines ls theory+1 title "N^{-3/2}; across an edge N^{-3/4}", \
         for [m in ways(s)] data[s]."/convergence-".of[i].".tsv" using "N":m with linespoints ls value(m) ps 0.8 notitle, \
         for [m in ways(s)] keyentry with linespoints ls value(m) ps 0.8 title is(m)
  }
  set multiplot next
}
unset multiplot

# The same points, randomized in four ways --------------------------------------------------------
array wave[2] = ["exp(x)", "cos(2 pi N x)"]
array waves[2] = ["smooth", "wave"]
name = "randomised"; width = 980; height = 90 + 380 * count
load draw
set multiplot layout count,2 margins 75./width, 1 - 15./width, 110./height, 1 - 46./height spacing 75./width, 90./height
set logscale xy
set format "10^{%L}"
set xrange [3:6000]
set xlabel "N"
set key at screen 0.54,0.01 center bottom vertical maxrows 2 Left reverse samplen 3
do for [s=1:count] {
  do for [i=1:2] {
    set title wave[i].who(s) noenhanced
    set ylabel (i == 1 ? "RMSE, points of base 2 on the line" : "")
    set yrange [(i == 1 ? 1e-7 : 5e-3):(i == 1 ? 1 : 2)]
    plot for [m in "independent rotated scrambled_halton scrambled_sobol"] data[s]."/randomised-".waves[i].".tsv" using "N":m \
      with linespoints ls value(m) notitle, \
      for [m in "independent rotated scrambled_halton scrambled_sobol"] keyentry with linespoints ls value(m) title is(m).(m eq "scrambled_halton" ? " (base 2: a digital shift)" : m eq "scrambled_sobol" ? " (nested)" : "")
    unset key
  }
}
unset multiplot

# How the error of exp(x) is distributed, beyond its mean square -----------------------------------
name = "tails"; width = 80 + 500 * count; height = 480
load draw
set multiplot layout 1,count title "Kurtosis of the error of exp(x) on the line, with its standard error" \
  margins 80./width, 1 - 20./width, 0.27, 0.87 spacing 80./width, 0
set logscale xy
set xrange [12:5500]
set yrange [2:5<*<200]  # where it is 3, so near that the bars are seen
set xtics (16, 64, 256, 1024, 4096)
set ytics (2, 3, 5, 10, 20, 50, 100)
set xlabel "N"
set ylabel "kurtosis"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
do for [s=1:count] {
  set title panel(s) noenhanced
  file = data[s]."/tails.tsv"
  plot 3 with lines ls theory title "normal errors", \
       file using "N":"scrambled_sobol":"standard_error" with yerrorlines ls scrambled_sobol dt 1 notitle, \
       keyentry with linespoints ls scrambled_sobol dt 1 title "5.8 base 2, scrambled", \
       file using "N":"hashed":"its" with yerrorlines ls hashed dt 1 title hashed_is
  unset key
  unset ylabel
}
unset multiplot

# Error bars from replicates ----------------------------------------------------------------------
array integrand[3] = ["smooth", "kinks", "edge"]
array held[3] = ["exp(x + y)", "two kinks", "an edge"]
name = "replicates"; width = 980; height = 20 + 430 * count
load draw
set multiplot layout count,2 margins 75./width, 1 - 15./width, 55./height, 1 - 36./height spacing 85./width, 100./height
set logscale x 2
set xrange [1.6:80]
set xtics (2, 4, 8, 16, 32, 64)
set xlabel "replicates R, of 4096/R scrambled points each"
do for [s=1:count] {
  file = data[s]."/replicates.tsv"
  set title "How often a 95 % interval holds the truth".who(s) noenhanced
  set ylabel "fraction of 400 intervals"
  set yrange [0.6:1.02]
  set key right bottom vertical maxrows 5 Left reverse samplen 3 opaque
  plot 0.95 with lines ls theory notitle, \
       for [i=1:3] file using "R":"t_".integrand[i] with points ls other+i ps 1.2 title "Student's t, ".held[i], \
       file using "R":"z_smooth" with points pt 5 ps 0.8 lc rgb "#888888" title "z of 2.5, ".held[1], \
       file using "R":"z_exact" with lines lt 1 lw 1 lc rgb "#000000" title "z, exactly, of normal means"
  set title "Half of its length, by Student's t".who(s) noenhanced
  set ylabel "mean over 400 intervals"
  set logscale y
  set format y "10^{%L}"
  set yrange [5e-5:20]
  set key right top vertical maxrows 3 Left reverse samplen 2 width -2 opaque
  plot for [i=1:3] file using "R":"reach_".integrand[i] with linespoints ls other+i title held[i], \
       for [i=1:3] file using "R":"independent_".integrand[i] with lines ls other+i lw 1 title "as if independent"
  unset logscale y
  set format y "%g"
}
unset multiplot

# The first points of a sequence ------------------------------------------------------------------
name = "early"; width = 80 + 560 * count; height = 480
load draw
set multiplot layout 1,count title "The first n of 1024 points, for exp(-x² - y²) in the plane" \
  margins 80./width, 1 - 20./width, 0.26, 0.85 spacing 80./width, 0
set logscale xy
set format y "10^{%L}"
set xrange [0.8:1300]
set yrange [5e-6:1]
set xtics (1, 4, 16, 64, 256, 1024)
set xlabel "n"
set ylabel "RMSE"
set key at screen 0.5,0.01 center bottom horizontal maxcols 3 Left reverse samplen 4 width 1
do for [s=1:count] {
  set title panel(s) noenhanced
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
array paired[5] = ["bases 29 and 31, 64 points", "5.7 rotated", "5.9 digits permuted", "Sobol' dimensions 14 and 15, 1024 points", "5.8 scrambled"]
name = "pair"; width = 1060; height = 20 + 730 * count
load draw
set multiplot layout 2*count,3 margins 0.015, 0.985, 10./height, 1 - 36./height spacing 0.02, 40./height
set size square
set xrange [0:1]
set yrange [0:1]
set xtics 0,0.125 format ""
set ytics 0,0.125 format ""
unset key
do for [s=1:count] {
  do for [i=1:5] {
    set title paired[i].who(s) noenhanced
    plot data[s]."/pair-".pair[i].".tsv" using "x":"y" with points pt 7 ps (i < 4 ? 0.8 : 0.3) lc rgb "#0072B2"
  }
  set multiplot next
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
timed = "radical_inverse halton sobol scrambled_sobol scrambled_halton"
array above[5] = [1, 1, 1, 1, -1]
name = "speed"; width = 80 + 500 * count; height = 420
load draw
set multiplot layout 1,count title "Error of exp(x + y) against time, 4096 points, in cache" \
  margins 80./width, 1 - 20./width, 0.14, 0.83 spacing 80./width, 0
set logscale xy
set xrange [0.02:2000]
set yrange [5e-6:2e-2]
set format y "10^{%L}"
set xlabel "ns per point (less is better)"
set ylabel "error (less is better)"
unset key
speed(s, m) = data[s]."/speed-".m.".tsv"
fast(m) = m eq "halton" ? "5.2 Halton" : is(m)
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [m in timed] speed(s, m) using "ns":"error" with points ls value(m) ps 2, \
       for [i=1:5] speed(s, word(timed, i)) using "ns":"error":(fast(word(timed, i))) with labels offset 0,1.1*above[i] noenhanced
  unset ylabel
}
unset multiplot
