# Draws lab 3. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

# Patterns, over their strata ---------------------------------------------------------------------
name = "patterns"; width = 1120; height = 310 * count
load draw
set multiplot layout count,4 margins 0.015, 0.985, 0.03, 1 - 36./height spacing 0.02, 40./height
set size square
set xrange [0:1]
set yrange [0:1]
set format ""
unset key
array columns[4] = [1, 8, 64, 64]  # of a grid: independent points have no strata
array rows[4] = [1, 8, 64, 64]
do for [s=1:count] {
  do for [i=1:4] {
    m = word("independent jittered latin_hypercube multi_jittered", i)
    set xtics 0,1./columns[i] scale 0
    set ytics 0,1./rows[i] scale 0
    set grid lt 1 lw 0.5 lc rgb (i > 2 ? "#DDDDDD" : "#888888")
    unset arrow
    if (m eq "multi_jittered") {
      do for [k=1:7] {
        set arrow from k/8.,0 to k/8.,1 nohead back lt 1 lw 1 lc rgb "#888888"
        set arrow from 0,k/8. to 1,k/8. nohead back lt 1 lw 1 lc rgb "#888888"
      }
    }
    set title is(m).who(s) noenhanced
    plot data[s]."/patterns-".m.".tsv" using "x":"y" with points pt 7 ps 0.7 lc rgb "#0072B2"
  }
}
unset multiplot

# A picture ---------------------------------------------------------------------------------------
name = "shadow"; width = 1080; height = 400 * count
load draw
set multiplot layout count,3 margins 0.01, 0.99, 0.02, 1 - 50./height spacing 0.015, 50./height
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
  do for [m in "independent jittered multi_jittered"] {
    set title is(m).", 16 points a pixel".who(s) noenhanced
    plot data[s]."/shadow-".m.".tsv" matrix with image
  }
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[4] = ["line", "plane", "edge", "four"]
array what[4] = ["exp(x) on the line", "exp(-x² - y²) in the plane", "an edge across the plane", "exp(x + y + z + w)"]
array rate[4] = ["N^{-1.5}", "N^{-1}", "N^{-0.75}", "N^{-0.75}"]
array ways[4] = ["stratified", "jittered latin_hypercube multi_jittered", "jittered latin_hypercube multi_jittered", "jittered_nd padded latin_hypercube"]
name = "convergence"; width = 1120; height = 800 * count
load draw
set multiplot layout 2*count,2 margins 75./width, 1 - 15./width, 65./height, 1 - 45./height spacing 90./width, 110./height
set logscale xy
set xlabel "N"
set ylabel "RMSE"
set format "10^{%L}"
set key left bottom Left reverse samplen 3 opaque
set xrange [0.7:6000]
do for [s=1:count] {
  do for [i=1:4] {
    set title what[i].who(s) noenhanced
    file = data[s]."/convergence-".of[i].".tsv"
    plot file using "N":"by_chance" with lines ls theory title "N^{-0.5}", \
         file using "N":"by_strata" with lines ls theory+1 title rate[i], \
         for [m in "independent ".ways[i]] file using "N":m with points ls value(m) title is(m)
  }
}
unset multiplot

# The variance within the strata ------------------------------------------------------------------
name = "within"; width = 80 + 480 * count; height = 550
load draw
set multiplot layout 1,count title "What is left of the variance: the fraction within the strata" \
  margins 80./width, 1 - 20./width, 0.28, 0.86 spacing 80./width, 0
set logscale xy
set format "10^{%L}"
set xrange [0.7:6000]
set yrange [3e-8:3]
set xlabel "N strata (line: exact; points: N times the mean squared error)"
set ylabel "variance within the strata / variance"
set key at screen 0.5,0.01 center bottom horizontal maxcols 2 Left reverse samplen 3 width 1
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [i=1:4] data[s]."/within-".of[i].".tsv" using "N":"exact" with lines ls other+i notitle, \
       for [i=1:4] data[s]."/within-".of[i].".tsv" using "N":"measured" with points ls other+i notitle, \
       for [i=1:4] keyentry with points ls other+i title what[i]
  unset key
  unset ylabel
}
unset multiplot

# Stopping early ----------------------------------------------------------------------------------
name = "early"; width = 80 + 480 * count; height = 500
load draw
set multiplot layout 1,count title "The first n of 1024 points, for exp(-x² - y²) in the plane" \
  margins 80./width, 1 - 20./width, 0.28, 0.85 spacing 80./width, 0
set logscale xy
set format "10^{%L}"
set xrange [0.8:1300]
set yrange [1e-4:1]
set xlabel "n"
set ylabel "RMSE"
set key at screen 0.5,0.01 center bottom horizontal maxcols 3 Left reverse samplen 4 width 1
how(m) = m eq "jittered" ? ", row by row" : m eq "padded" ? " (shuffled)" : ""
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [m in "independent jittered padded"] data[s]."/early.tsv" using "N":m \
    with linespoints ls value(m) notitle, \
    for [m in "independent jittered padded"] keyentry with linespoints ls value(m) title is(m).how(m)
  unset key
  unset ylabel
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
timed = "textbook independent jittered padded jittered_nd latin_hypercube multi_jittered"
name = "speed"; width = 80 + 560 * count; height = 440
load draw
set multiplot layout 1,count title "Error against time: 1024 points of the plane, for exp(-x² - y²)" \
  margins 80./width, 1 - 20./width, 0.14, 0.83 spacing 80./width, 0
set logscale xy
set xrange [0.3:100]
set yrange [1e-5:5e-2]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 100)
set format y "10^{%L}"
set xlabel "ns per point (less is better)"
set ylabel "RMSE (less is better)"
unset key
array above[7] = [1, 1, 1, -1, 1.7, 1, -1]  # names, where points lie close
speed(s, m) = data[s]."/speed-".m.".tsv"
do for [s=1:count] {
  set title panel(s) noenhanced
  plot for [m in timed] speed(s, m) using "ns":"error" with points ls value(m) ps 1.6, \
       for [i=1:7] speed(s, word(timed, i)) using "ns":"error":(is(word(timed, i))) \
         with labels offset 0,1.1*above[i] noenhanced
  unset ylabel
}
unset multiplot
