# Draws lab 2. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

array of[6] = ["exp(x)", "x < √½", "x < 0.01", "x^{−0.4}", "x^{−0.75}", "normal"]

# Error against samples ---------------------------------------------------------------------------
# The median of 201 estimates, or of 101 for 16384 samples and more.
name = "error"; width = 80 + 420 * count; height = 470
load draw
set termoption enhanced
eval panels(75, 75, 130)
set logscale xy
set format "10^{%L}"
set xrange [3:1e5]
set yrange [4e-4:2]
set xlabel "samples N"
set ylabel "relative error"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Median error of 201 estimates", s)
  set label 1 "N^{−1/2}" at 30,0.014 right tc rgb ink
  set label 2 "N^{−1/4}" at 2.2e4,0.13 left tc rgb ink
  plot 0.14/sqrt(x) ls theory notitle, 0.95/x**0.25 ls theory notitle, \
       for [i=1:5] data[s]."/error.tsv" using "N":"integrand_".i with linespoints ls other+i notitle, \
       for [i=1:5] keyentry with linespoints ls other+i title of[i]
  unset key
  unset ylabel
}
unset multiplot

# Coverage ----------------------------------------------------------------------------------------
name = "coverage"; width = 80 + 420 * count; height = 470
load draw
set termoption enhanced
eval panels(75, 75, 130)
set logscale x 2
set format x "2^{%L}"
set xrange [1.6:10000]
set yrange [0:1.09]
set xtics 2,4
set ytics 0,0.2
set xlabel "samples N"
set ylabel "fraction of 500 intervals"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
do for [s=1:count] {
  set title heading("How often a 95 % interval contains the true value", s)
  plot 0.95 ls theory title "95 %", data[s]."/coverage.tsv" using "N":"exact" with lines lt 1 lw 1 lc rgb ink title "Student's t", \
       for [i in "6 3 4 5"] data[s]."/coverage.tsv" using "N":"integrand_".i with points ls other+i ps 1.2 notitle, \
       for [i in "6 3 4 5"] keyentry with points ls other+i ps 1.2 title of[int(i)]
  unset key
  unset ylabel
}
unset multiplot

# Sixty intervals ---------------------------------------------------------------------------------
name = "intervals"; width = 80 + 460 * count; height = 500
load draw
set termoption enhanced
array shown[2] = ["exp", "power"]
array misses[2 * count]  # counted before ranges are set, because stats would apply them
do for [s=1:count] {
  do for [k=0:1] {
    stats data[s]."/intervals-".shown[k+1].".tsv" using "covers" nooutput
    misses[2 * (s - 1) + k + 1] = exists("STATS_sum") ? STATS_records - STATS_sum : NaN
    undefine STATS_*
  }
}
set multiplot layout 2,count columnsfirst \
  margins 75./width, 1 - 15./width, 60./height, 1 - head(count)/height spacing 75./width, 0.04
set xrange [0:61]
unset xtics
unset key
array integrand_of[2] = ["exp(x)", "x^{−0.75}"]
do for [s=1:count] {
  do for [k=0:1] {
    set title (k == 0 ? heading("Sixty estimates, 1000 samples each, 95 % intervals", s) : "")
    set label 1 sprintf("%s: %.0f of 60 miss", integrand_of[k+1], misses[2 * (s - 1) + k + 1]) at graph 0.02,0.9 tc rgb ink
    if (k == 0) { set yrange [0.945:1.055]; set ytics 0.95,0.05; set format y "%.2f" }
    if (k == 1) { set yrange [0.35:1.95]; set ytics 0.5,0.5; set format y "%.1f"; set xlabel "estimates, sorted; orange squares: intervals that miss;\ntriangles: intervals that end above the picture" }
    if (s == 1) { set ylabel "value / true value" } else { set ylabel "" }
    file = data[s]."/intervals-".shown[k+1].".tsv"
    plot 1 lt 1 lw 1 lc rgb ink notitle, \
      file using 1:($4 == 1 ? $2 : NaN):3 every ::1 with yerrorbars lt 1 lw 1 pt 7 ps 0.4 lc rgb dot, \
      file using 1:($4 == 0 ? $2 : NaN):3 every ::1 with yerrorbars lt 1 lw 1.5 pt 5 ps 0.7 lc rgb "#D55E00", \
      top = (k == 0 ? 1.055 : 1.95), file using 1:($2 + $3 > top ? top : NaN) every ::1 with points pt 9 ps 0.9 lc rgb dot
    set xlabel ""
  }
}
unset multiplot

# Irradiance by points, directions, and (thin, a stretch task) pairs ------------------------------
name = "irradiance"; width = 80 + 420 * count; height = 440
load draw
set termoption enhanced
eval panels(80, 75, 110)
set logscale xy
set format "10^{%L}"
set xrange [0.1:1e4]
set yrange [1e-3:1]
set xlabel "µs of CPU time"
set ylabel "RMSE"
set key at screen 80./width,0.01 left bottom maxrows 2 Left reverse samplen 3
do for [s=1:count] {
  set title heading("Irradiance of 1.1333, estimated in three ways", s)
  plot data[s]."/irradiance-area.tsv" using "us":"error" with linespoints ls other+1 title "2.7 points", \
       data[s]."/irradiance-hemisphere.tsv" using "us":"error" with linespoints ls other+2 title "2.7 directions", \
       data[s]."/irradiance-combined.tsv" using "us":"error" with linespoints ls other+3 lw 1 title "2.9 pairs"
  unset key
  unset ylabel
}
unset multiplot

# Time against error ------------------------------------------------------------------------------
name = "speed"; width = 80 + 420 * count; height = 470
load draw
array ns[3 * count]  # measured nanoseconds per number; read before ranges are set, as above
do for [s=1:count] {
  do for [i=1:3] {
    stats data[s]."/speed-".(i-1).".tsv" using "ns" nooutput
    ns[3 * (s - 1) + i] = exists("STATS_min") ? STATS_min : NaN
    undefine STATS_*
  }
}
eval panels(80, 75, 135)
set termoption enhanced
set logscale xy
set format "10^{%L}"
set xrange [0.05:2e3]
set yrange [8e-4:3e-2]
set xlabel "µs of CPU time"
set ylabel "RMSE of the mean of N numbers"
array source[3] = ["mt19937\\_64, standard library", "to\\_unit(rng()), one by one", "uniforms(rng, …)"]
array style[3] = [textbook, other + 2, independent]
do for [s=1:count] {
  set title heading("Error against the time to make numbers", s)
  set key at graph -0.1,-0.2 left top maxrows 3 Left reverse samplen 3
  plot for [i=1:3] data[s]."/speed-".(i-1).".tsv" using "us":"error" with linespoints ls style[i] \
       title sprintf("%s: %.2g ns", source[i], ns[3 * (s - 1) + i])
  unset ylabel
}
unset multiplot
