# Draws lab 3. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)

# The label of submission s, where there is more than one.
who(s) = count > 1 ? ", ".labels[s] : ""

# Patterns ----------------------------------------------------------------------------------------
array pattern[4] = ["independent", "3.3 jittered", "3.6 Latin hypercube", "3.7 multi-jittered"]
name = "patterns"; width = 1120; height = 310 * count
load draw
set multiplot layout count,4 margins 0.015, 0.985, 0.03, 1 - 36./height spacing 0.02, 40./height
set size square
set xrange [0:1]
set yrange [0:1]
set xtics 0,0.125 format ""
set ytics 0,0.125 format ""
set grid lt 1 lw 0.5 lc rgb "#AAAAAA"
unset key
do for [s=1:count] {
  do for [i=1:4] {
    set title pattern[i].who(s) noenhanced
    plot data[s]."/patterns.tsv" using 2*i-1:2*i with points pt 7 ps 0.7 lc rgb "#0072B2"
  }
}
unset multiplot

# A picture ---------------------------------------------------------------------------------------
array shaded[3] = ["16 independent points a pixel", "16 jittered", "16 multi-jittered"]
array task[3] = ["0", "3", "7"]
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
  do for [i=1:3] {
    set title shaded[i].who(s) noenhanced
    plot data[s]."/shadow-".task[i].".tsv" matrix with image
  }
}
unset multiplot

# Error against N ---------------------------------------------------------------------------------
array of[4] = ["line", "plane", "edge", "four"]
array what[4] = ["exp(x) on the line", "exp(-x² - y²) in the plane", "an edge across the plane", "a product in four dimensions"]
array rate[4] = ["N^{-1.5}", "N^{-1}", "N^{-0.75}", "N^{-0.75}"]
array first_way[4] = ["3.1 stratified", "3.3 jittered", "3.3 jittered", "3.5 one in each 4D cell"]
array second_way[4] = ["", "3.6 Latin hypercube", "3.6 Latin hypercube", "3.4 padded 2D patterns"]
array third_way[4] = ["", "3.7 multi-jittered", "3.7 multi-jittered", "3.6 Latin hypercube"]
name = "convergence"; width = 1120; height = 800 * count
load draw
array second[4] = [0, latin_hypercube, latin_hypercube, padded]
array third[4] = [0, multi_jittered, multi_jittered, latin_hypercube]
set multiplot layout 2*count,2 margins 75./width, 1 - 15./width, 65./height, 1 - 45./height spacing 90./width, 110./height
set logscale xy
set xlabel "N"
set ylabel "RMSE"
set format "10^{%L}"
set key left bottom Left reverse samplen 3
set xrange [0.7:6000]
do for [s=1:count] {
  do for [i=1:4] {
    set title what[i].who(s) noenhanced
    file = data[s]."/convergence-".of[i].".tsv"
    ways = i == 1 ? 1 : 3
    plot file using 1:2 with lines ls 9 lw 2 title "N^{-0.5}", \
         file using 1:3 with lines ls 9 lw 2 dt 3 title rate[i], \
         file using 1:4 with points ls independent title "independent", \
         file using 1:5 with points ls jittered title first_way[i], \
         for [k=2:ways] file using 1:(column(4+k)) with points ls (k == 2 ? second[i] : third[i]) \
           title (k == 2 ? second_way[i] : third_way[i])
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
  set title labels[s] noenhanced
  plot for [i=1:4] data[s]."/within-".of[i].".tsv" using 1:2 with lines ls i notitle, \
       for [i=1:4] data[s]."/within-".of[i].".tsv" using 1:3 with points ls i title what[i]
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
do for [s=1:count] {
  set title labels[s] noenhanced
  plot data[s]."/early.tsv" using 1:2 with linespoints ls independent title "independent points", \
       data[s]."/early.tsv" using 1:3 with linespoints ls jittered pt 7 dt 3 title "3.3 jittered, row by row", \
       data[s]."/early.tsv" using 1:4 with linespoints ls jittered title "3.4 jittered, shuffled"
  unset key
  unset ylabel
}
unset multiplot

# Error against time ------------------------------------------------------------------------------
array timed[7] = ["loop, std::mt19937_64", "2.8 independent", "3.3 jittered", "3.4 jittered, shuffled", "3.5 one in each cell", "3.6 Latin hypercube", "3.7 multi-jittered"]
name = "speed"; width = 80 + 560 * count; height = 440
load draw
set multiplot layout 1,count title "Error against time: 1024 points of the plane, for exp(-x² - y²)" \
  margins 80./width, 1 - 20./width, 0.14, 0.83 spacing 80./width, 0
set logscale xy
set xrange [0.3:100]
set yrange [1e-5:5e-2]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 100)
set format y "10^{%L}"
set xlabel "ns a point (less is better)"
set ylabel "RMSE (less is better)"
unset key
array style[7] = [independent, independent, jittered, jittered, jittered, latin_hypercube, multi_jittered]
array above[7] = [1, 1, 1, -1, 1.7, 1, -1]  # names, where points lie close
array mark[7] = [5, 4, 6, 7, 15, 3, 12]  # filled, where a style comes twice
do for [s=1:count] {
  set title labels[s] noenhanced
  plot for [i=1:7] data[s]."/speed.tsv" every ::i-1::i-1 using 1:2 with points ls style[i] pt mark[i] ps 1.6, \
       for [i=1:7] data[s]."/speed.tsv" every ::i-1::i-1 using 1:2:(timed[i]) \
         with labels offset 0,1.1*above[i] noenhanced
  unset ylabel
}
unset multiplot
