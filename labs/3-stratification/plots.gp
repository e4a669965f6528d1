# Draws lab 3. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height

# Patterns, over their strata ---------------------------------------------------------------------
name = "patterns"; width = 600 * count; height = 645
load draw
set multiplot layout 2,2*count margins 5./width, 1 - 5./width, 5./height, 1 - 32./height spacing 12./width, 38./height
set size square
set xrange [0:1]
set yrange [0:1]
set format ""
unset key
do for [row=0:1] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
  m = word("independent jittered latin_hypercube multi_jittered", i)
  fine = i > 2  # 64 columns and rows, below the 8 x 8 cells
  set xtics 0,(fine ? 1/64. : 1/8.) scale 0
  set ytics 0,(fine ? 1/64. : 1/8.) scale 0
  set grid lt 1 lw 0.5 lc rgb soft
  unset arrow
  do for [k=1:7] {
    set arrow from k/8.,0 to k/8.,1 nohead back lt 1 lw 1 lc rgb ink
    set arrow from 0,k/8. to 1,k/8. nohead back lt 1 lw 1 lc rgb ink
  }
  set title is(m).who(s)
  plot data[s]."/patterns-".m.".tsv" using "x":"y" with points pt 7 ps 0.7 lc rgb dot
} } }
unset multiplot

# A picture ---------------------------------------------------------------------------------------
name = "shadow"; width = 600; height = (count > 1 ? 276 : 250) * count
load draw
array rmse[3 * count]  # read before ranges are set, because stats would apply them
do for [s=1:count] { do for [k=1:3] {
  stats data[s]."/shadow-rmse.tsv" using k nooutput
  rmse[3 * (s - 1) + k] = exists("STATS_min") ? STATS_min : NaN
  undefine STATS_*
} }
set multiplot layout count,3 margins 3./width, 1 - 3./width, 26./height, 1 - (head(count) - 6)/height spacing 6./width, (26 + head(count))/height
set xlabel offset 0,0.3
set size square
set palette gray
set cbrange [0:1]
unset colorbox
unset grid
unset xtics
unset ytics
unset key
set autoscale xfix
set autoscale yfix
do for [s=1:count] {
  do for [k=1:3] {
    m = word("independent jittered multi_jittered", k)
    set title (k == 2 && count > 1 ? labels[s]."\n" : "").is(m)
    set xlabel sprintf("RMSE %.3f", rmse[3 * (s - 1) + k])
    plot data[s]."/shadow-".m.".tsv" matrix with image
  }
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[4] = ["line", "plane", "edge", "four"]
array what[4] = ["exp(x) on the line", "exp(-x² - y²) in the plane", "an edge across the plane", "exp(x + y + z + w) in 4D"]
array rate[4] = ["N^{-3/2}", "N^{-1}", "N^{-3/4}", "N^{-3/4}"]
array slope_x[4] = [1.3, 1.3, 1.5, 2]  # below the lines of theory
array slope_y[4] = [1.2e-2, 1.7e-2, 6e-2, 0.5]
array ways[4] = ["stratified", "jittered latin_hypercube multi_jittered", "jittered latin_hypercube multi_jittered", "jittered_nd padded latin_hypercube"]
name = "convergence"; width = 620 * count; height = 900
load draw
set termoption enhanced
set multiplot layout 2,2*count margins 80./width, 1 - 15./width, 175./height, 1 - 32./height spacing 65./width, 100./height
set logscale xy
set xlabel "N"
set format "10^{%L}"
set xrange [0.7:6000]
all = "independent stratified jittered latin_hypercube multi_jittered padded jittered_nd"
do for [row=0:1] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
  set title what[i].who(s)
  set ylabel (i % 2 == 1 && s == 1 ? "RMSE" : "")
  set label 1 rate[i] at slope_x[i], slope_y[i] left tc rgb ink
  file = data[s]."/convergence-".of[i].".tsv"
  if (i == 4 && s == count) { set key at screen 0.5,0.005 center bottom vertical maxrows 5 Left reverse samplen 3 width 1 } else { unset key }
  known = data[s]."/within-".of[i].".tsv"
  plot known using "N":"by_chance" with lines ls theory title "N^{-1/2}", \
       known using "N":"by_strata" with lines ls theory+1 title "theory of strata", \
       for [m in "independent ".ways[i]] file using "N":m with points ls value(m) notitle, \
       for [m in all] keyentry with points ls value(m) title is(m)
} } }
unset multiplot

# The variance within the strata ------------------------------------------------------------------
name = "within"; width = 80 + 420 * count; height = 520
load draw
set termoption enhanced
eval panels(85, 85, 150)
set logscale xy
set format "10^{%L}"
set xrange [0.7:6000]
set yrange [3e-8:3]
set xlabel "N strata (lines exact, points measured)"
set ylabel "variance within the strata / variance"
set key at screen 0.5,0.01 center bottom vertical maxrows 4 Left reverse samplen 2
do for [s=1:count] {
  set title heading("What is left of the variance", s)
  plot for [i=1:4] data[s]."/within-".of[i].".tsv" using "N":"exact" with lines ls other+i notitle, \
       for [i=1:4] data[s]."/within-".of[i].".tsv" using "N":"measured" with points ls other+i notitle, \
       for [i=1:4] keyentry with points ls other+i title what[i]
  unset key
  unset ylabel
}
unset multiplot

# Stopping early ----------------------------------------------------------------------------------
name = "early"; width = 80 + 420 * count; height = 460
load draw
set termoption enhanced
eval panels(80, 80, 125)
set logscale y
set format y "10^{%L}"
set xrange [0:1060]
set yrange [5e-4:0.6]
set xtics 0,256
set xlabel "n"
set ylabel "RMSE"
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 4
how(m) = m eq "jittered" ? ", row by row" : m eq "padded" ? " (shuffled)" : ""
do for [s=1:count] {
  set title heading("The first n of 1,024 points, exp(-x² - y²)", s)
  plot for [m in "independent jittered padded"] data[s]."/early.tsv" using "N":m \
    with linespoints ls value(m) notitle, \
    for [m in "independent jittered padded"] keyentry with linespoints ls value(m) title is(m).how(m)
  unset key
  unset ylabel
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
timed = "textbook independent jittered padded jittered_nd latin_hypercube multi_jittered"
name = "speed"; width = 80 + 460 * count; height = 420
load draw
eval panels(80, 80, 60)
set logscale xy
set xrange [0.2:100]
set yrange [1e-5:5e-2]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 100)
set format y "10^{%L}"
set xlabel "ns per point (less is better)"
set ylabel "RMSE of exp(-x² - y²) (less is better)"
unset key
array above[7] = [1, 1, 1, -1, 1.7, 1, -1]  # label positions, where points are close
speed(s, m) = data[s]."/speed-".m.".tsv"
do for [s=1:count] {
  set title heading("Error of 1024 points against their time", s)
  plot for [m in timed] speed(s, m) using "ns":"error" with points ls value(m) ps 1.6, \
       for [i=1:7] speed(s, word(timed, i)) using "ns":"error":(is(word(timed, i))) \
         with labels tc rgb ink offset 0,1.1*above[i] noenhanced
  unset ylabel
}
unset multiplot
