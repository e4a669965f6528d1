# Draws lab 2. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

array of[6] = ["exp(x)", "x < √½", "x < 0.01", "x^{−0.4}", "x^{−0.75}", "normal"]

# Error against samples ---------------------------------------------------------------------------
name = "error"; width = 80 + 430 * count; height = 480
load draw
set termoption enhanced
set multiplot layout 1,count title "Median relative error of 201 estimates (101 from 16384 samples on)" \
  margins 80./width, 1 - 20./width, 0.27, 0.85 spacing 70./width, 0
set logscale xy
set format "10^{%L}"
set xrange [3:1e5]
set yrange [4e-4:2]
set xlabel "samples N"
set ylabel "error"
set key at screen 0.5,0.01 center bottom vertical maxrows 2 Left reverse samplen 3
do for [s=1:count] {
  set title panel(s) noenhanced
  set label 1 "N^{−1/2}" at 30,0.014 right tc rgb "#666666"
  set label 2 "N^{−1/4}" at 2.5e4,0.115 left tc rgb "#666666"
  plot 0.14/sqrt(x) ls theory notitle, 0.95/x**0.25 ls theory notitle, \
       for [i=1:5] data[s]."/error.tsv" using "N":"integrand_".i with linespoints ls other+i notitle, \
       for [i=1:5] keyentry with linespoints ls other+i title of[i]
  unset key
  unset ylabel
}
unset multiplot

# Coverage ----------------------------------------------------------------------------------------
name = "coverage"; width = 80 + 430 * count; height = 480
load draw
set termoption enhanced
set multiplot layout 1,count title "How often a 95 % interval holds the true value (500 estimates)" \
  margins 80./width, 1 - 20./width, 0.27, 0.85 spacing 70./width, 0
set logscale x 2
set format x "2^{%L}"
set xrange [1.6:10000]
set yrange [0:1.09]
set xtics 2,4
set ytics 0,0.2
set xlabel "samples N"
set ylabel "fraction of intervals"
set key at screen 0.5,0.01 center bottom vertical maxrows 2 Left reverse samplen 3
do for [s=1:count] {
  set title panel(s) noenhanced
  set label 1 "0.95" at 2,1.02 left tc rgb "#666666"
  plot 0.95 ls theory notitle, data[s]."/coverage.tsv" using "N":"exact" with lines lt 1 lw 1 lc rgb "#000000" title "Student's t", \
       for [i in "6 3 4 5"] data[s]."/coverage.tsv" using "N":"integrand_".i with points ls other+i ps 1.2 notitle, \
       for [i in "6 3 4 5"] keyentry with points ls other+i ps 1.2 title of[int(i)]
  unset key
  unset ylabel
}
unset multiplot

# Sixty intervals ---------------------------------------------------------------------------------
name = "intervals"; width = 80 + 560 * count; height = 520
load draw
set termoption enhanced
array shown[2] = ["exp", "power"]
array misses[2 * count]  # counted before there are ranges, which stats would heed
do for [s=1:count] {
  do for [k=0:1] {
    stats data[s]."/intervals-".shown[k+1].".tsv" using "covers" nooutput
    misses[2 * (s - 1) + k + 1] = exists("STATS_sum") ? STATS_records - STATS_sum : NaN
    undefine STATS_*
  }
}
set multiplot layout 2,count columnsfirst title "Sixty estimates from 1000 samples each, with their 95 % intervals" \
  margins 80./width, 1 - 20./width, 0.1, 0.86 spacing 70./width, 0.06
set xrange [0:61]
unset xtics
unset key
array integrand_of[2] = ["exp(x)", "x^{−0.75}"]
do for [s=1:count] {
  do for [k=0:1] {
    set title (k == 0 ? panel(s) : "") noenhanced
    set label 1 sprintf("%s: %.0f of 60 miss", integrand_of[k+1], misses[2 * (s - 1) + k + 1]) at graph 0.02,0.9
    if (k == 0) { set yrange [0.945:1.055]; set ytics 0.95,0.05; set format y "%.2f" }
    if (k == 1) { set yrange [0.35:1.95]; set ytics 0.5,0.5; set format y "%.1f"; set xlabel "estimates, sorted (orange squares: intervals that miss the truth)" }
    if (s == 1) { set ylabel "value / truth" } else { set ylabel "" }
    file = data[s]."/intervals-".shown[k+1].".tsv"
    plot 1 lt 1 lw 1 lc rgb "#666666" notitle, \
      file using 1:($4 == 1 ? $2 : NaN):3 every ::1 with yerrorbars lt 1 lw 1 pt 7 ps 0.4 lc rgb "#0072B2", \
      file using 1:($4 == 0 ? $2 : NaN):3 every ::1 with yerrorbars lt 1 lw 1.5 pt 5 ps 0.7 lc rgb "#D55E00"
    set xlabel ""
  }
}
unset multiplot

# Irradiance two ways -----------------------------------------------------------------------------
name = "irradiance"; width = 80 + 430 * count; height = 440
load draw
set termoption enhanced
set multiplot layout 1,count title "Error of the irradiance against time (exact: 1.1333)" \
  margins 80./width, 1 - 20./width, 0.24, 0.83 spacing 70./width, 0
set logscale xy
set format "10^{%L}"
set xrange [0.1:3e3]
set yrange [1e-3:1]
set xlabel "µs"
set ylabel "root mean square error"
set key at screen 0.5,0.01 center bottom maxrows 1 Left reverse samplen 3
do for [s=1:count] {
  set title panel(s) noenhanced
  plot data[s]."/irradiance-area.tsv" using "us":"error" with linespoints ls other+1 title "points on the light", \
       data[s]."/irradiance-hemisphere.tsv" using "us":"error" with linespoints ls other+2 title "directions"
  unset key
  unset ylabel
}
unset multiplot

# Time against error ------------------------------------------------------------------------------
name = "speed"; width = 80 + 430 * count; height = 480
load draw
set termoption enhanced
array ns[3 * count]  # measured nanoseconds a number; before there are ranges, which stats would heed
do for [s=1:count] {
  do for [i=1:3] {
    stats data[s]."/speed-".(i-1).".tsv" using "ns" nooutput
    ns[3 * (s - 1) + i] = exists("STATS_min") ? STATS_min : NaN
    undefine STATS_*
  }
}
set multiplot layout 1,count title "Error of the mean of N numbers against the time to make them" \
  margins 80./width, 1 - 20./width, 0.31, 0.84 spacing 70./width, 0
set logscale xy
set format "10^{%L}"
set xrange [0.05:2e3]
set yrange [8e-4:3e-2]
set xlabel "µs"
set ylabel "root mean square error"
array source[3] = ["mt19937\\_64, uniform\\_real\\_distribution", "to\\_unit(rng()), one by one", "uniforms(rng, …)"]
array style[3] = [textbook, other + 2, independent]
do for [s=1:count] {
  set title panel(s) noenhanced
  set key at graph -0.12,-0.26 left top maxrows 3 Left reverse samplen 3
  plot for [i=1:3] data[s]."/speed-".(i-1).".tsv" using "us":"error" with linespoints ls style[i] \
       title sprintf("%s: %.2g ns", source[i], ns[3 * (s - 1) + i])
  unset ylabel
}
unset multiplot
