# Draws lab 5. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

# The label of submission s, where there is more than one.
who(s) = count > 1 ? ", ".labels[s] : ""

# The lecture's points, and others ----------------------------------------------------------------
array pattern[6] = ["256 random", "256 stratified", "5.3 the first 216 Halton points", "5.4 256 Hammersley points", "5.5 256 Sobol' points", "5.8 256 Sobol' points, scrambled"]
name = "points"; width = 1060; height = 730 * count
load draw
set multiplot layout 2*count,3 margins 0.015, 0.985, 10./height, 1 - 36./height spacing 0.02, 40./height
set size square
set xrange [0:1]
set yrange [0:1]
set xtics 0,0.125 format ""
set ytics 0,0.125 format ""
unset key
do for [s=1:count] {
  do for [i=1:6] {
    set title pattern[i].who(s) noenhanced
    plot data[s]."/points-".i.".tsv" using 1:2 with points pt 7 ps 0.6 lc rgb "#0072B2"
  }
}
unset multiplot

# Discrepancy against N ---------------------------------------------------------------------------
array way[6] = ["random", "stratified", "5.3 Halton", "5.4 Hammersley", "5.5 Sobol'", "5.8 scrambled Sobol'"]
name = "discrepancy"; width = 220 + 500 * count; height = 600
load draw
array style[6] = [independent, jittered, halton, hammersley, sobol, scrambled_sobol]
set multiplot layout 1,count title "Star discrepancy in the plane, at N = 2^k and between" \
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
  set title labels[s] noenhanced
  plot 0.85/sqrt(x) with lines ls 9 lw 2 title "N^{-1/2}", \
       0.16*log(x)**2/x with lines ls 9 lw 2 dt 4 title "(log N)^2 / N", \
       0.65*log(x)/x with lines ls 9 lw 2 dt 3 title "log N / N", \
       for [i=1:6] data[s]."/discrepancy-".i.".tsv" using 1:2 with linespoints ls style[i] title way[i]
  unset key
  unset ylabel
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array what[5] = ["exp(x)", "exp(x + y)", "exp(x + y + z + w)", "two kinks", "an edge: a quarter of a disk"]
array rate[5] = [1.5, 1.5, 1.5, 1.5, 0.75]
name = "convergence"; width = 1180; height = 60 + 760 * count
load draw
array style[6] = [independent, jittered, halton, hammersley, sobol, scrambled_sobol]
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
    plot 0.5*x**-0.5 with lines ls 9 lw 2 title "N^{-1/2}", \
         0.5*x**-rate[i] with lines ls 9 lw 2 dt 3 title "N^{-3/2}; across an edge N^{-3/4}", \
         for [k=1:6] data[s]."/convergence-".i.".tsv" using 1:(column(k+1)) with linespoints ls style[k] ps 0.8 title way[k]
  }
  set multiplot next
}
unset multiplot

# The same points, made random in four ways -------------------------------------------------------
array random[4] = ["random points", "5.7 Cranley-Patterson rotation", "5.9 digits permuted (base 2: a digital shift)", "5.8 nested scrambling"]
array wave[2] = ["exp(x)", "cos(2 pi N x)"]
name = "randomised"; width = 980; height = 90 + 380 * count
load draw
array style[4] = [independent, rotated, digits_permuted, scrambled_sobol]
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
    plot for [k=1:4] data[s]."/randomised-".i.".tsv" using 1:(column(k+1)) with linespoints ls style[k] title random[k]
    unset key
  }
}
unset multiplot

# How the error of exp(x) is distributed, beyond its mean square -----------------------------------
name = "tails"; width = 80 + 500 * count; height = 420
load draw
set multiplot layout 1,count title "Kurtosis of the error of exp(x), 5.8 on the line, with its standard error" \
  margins 80./width, 1 - 20./width, 0.14, 0.83 spacing 80./width, 0
set logscale xy
set xrange [12:5500]
set yrange [2:5<*<200]  # where it is 3, so near that the bars are seen
set xtics (16, 64, 256, 1024, 4096)
set ytics (2, 3, 5, 10, 20, 50, 100)
set xlabel "N"
set ylabel "kurtosis"
unset key
do for [s=1:count] {
  set title labels[s] noenhanced
  plot 3 with lines ls 9 lw 2, \
       data[s]."/tails.tsv" using 1:2:3 with yerrorbars ls scrambled_sobol dt 1 ps 0.6, \
       data[s]."/tails.tsv" using 1:2 with lines ls scrambled_sobol
  unset ylabel
}
unset multiplot

# Error bars from replicates ----------------------------------------------------------------------
array held[3] = ["exp(x + y)", "two kinks", "an edge"]
name = "replicates"; width = 980; height = 20 + 430 * count
load draw
set multiplot layout count,2 margins 75./width, 1 - 15./width, 55./height, 1 - 36./height spacing 85./width, 100./height
set logscale x 2
set xrange [1.6:80]
set xtics (2, 4, 8, 16, 32, 64)
set xlabel "replicates R, of 4096/R scrambled points each"
do for [s=1:count] {
  set title "How often a 95 % interval holds the truth".who(s) noenhanced
  set ylabel "fraction of 400 intervals"
  set yrange [0.6:1.02]
  set key right bottom Left reverse samplen 3
  plot 0.95 with lines ls 9 lw 2 notitle, \
       for [i=1:3] data[s]."/replicates.tsv" using 1:(column(4*i-1)) with points ls i ps 1.2 title "Student's t, ".held[i], \
       data[s]."/replicates.tsv" using 1:4 with points pt 5 ps 0.8 lc rgb "#888888" title "z of 2.5, ".held[1], \
       data[s]."/replicates.tsv" using 1:2 with lines lt 1 lw 1 lc rgb "#000000" title "z, exactly, of normal means"
  set title "Half of its length".who(s) noenhanced
  set ylabel "mean over 400 intervals"
  set logscale y
  set format y "10^{%L}"
  set yrange [5e-5:1]
  set key right top Left reverse samplen 3
  plot for [i=1:3] data[s]."/replicates.tsv" using 1:(column(4*i+1)) with linespoints ls i title "Student's t, ".held[i], \
       for [i=1:3] data[s]."/replicates.tsv" using 1:(column(4*i+2)) with lines ls i lw 1 title (i == 1 ? "as if all points were independent" : "")
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
  set title labels[s] noenhanced
  plot data[s]."/early.tsv" using 1:2 with lines ls independent title "independent", \
       data[s]."/early.tsv" using 1:3 with lines ls jittered title "3.4 jittered, shuffled", \
       data[s]."/early.tsv" using 1:4 with linespoints ls scrambled_sobol title "5.8 scrambled Sobol'"
  unset key
  unset ylabel
}
unset multiplot

# Bad pairs of axes -------------------------------------------------------------------------------
array pair[5] = ["bases 29 and 31, 64 points", "5.7 rotated", "5.9 digits permuted", "Sobol' dimensions 14 and 15, 1024 points", "5.8 scrambled"]
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
    set title pair[i].who(s) noenhanced
    plot data[s]."/pair-".i.".tsv" using 1:2 with points pt 7 ps (i < 4 ? 0.8 : 0.3) lc rgb "#0072B2"
  }
  set multiplot next
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
array task[5] = ["5.1 Halton", "5.2 Halton", "5.5 Sobol'", "5.8 scrambled Sobol'", "5.9 scrambled Halton"]
name = "speed"; width = 80 + 500 * count; height = 420
load draw
set multiplot layout 1,count title "Error of exp(x + y) against time, 4096 points, in cache" \
  margins 80./width, 1 - 20./width, 0.14, 0.83 spacing 80./width, 0
set logscale xy
set xrange [0.02:2000]
set yrange [5e-6:2e-2]
set format y "10^{%L}"
set xlabel "ns a point (less is better)"
set ylabel "error (less is better)"
unset key
array above[5] = [1, 1, 1, 1, -1]
array style[5] = [halton, halton, sobol, scrambled_sobol, halton]
array mark[5] = [9, 8, 2, 10, 9]  # filled: one by one, or scrambled
do for [s=1:count] {
  set title labels[s] noenhanced
  plot for [i=1:5] data[s]."/speed.tsv" every ::i-1::i-1 using 2:3 with points ls style[i] pt mark[i] ps 2, \
       for [i=1:5] data[s]."/speed.tsv" every ::i-1::i-1 using 2:3:(task[i]) with labels offset 0,1.1*above[i]
  unset ylabel
}
unset multiplot
