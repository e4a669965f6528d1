# Draws lab 6. Called by ./lab plot with
#   count      how many submissions stand side by side
#   labels[i]  what they are called, data[i] the folder of their data
#   draw       the look of every plot, to load with name, width and height set (common/draw.gp)
#   here       the folder of this script

array kinds[5] = ["independent", "stratified", "blue_noise", "halton", "sobol"]  # render.gp
array ways[5] = ["independent", "multi_jittered", "best_candidate", "scrambled_halton", "scrambled_sobol"]

# Error against N, and against time ---------------------------------------------------------------
array scenes[4] = ["rect_light", "pixel_edge", "motion_edge", "pixel_time_lens"]
array what[4] = ["under a lamp (smooth, 2D)", "an edge in a pixel (2D)", "a moving edge (1D + 1D)", "pixel, time and lens (5D)"]
array rate[4] = [1.5, 0.75, 0.75, 0.6]
array rates[4] = ["N^{-3/2}", "N^{-3/4}", "N^{-3/4}", "N^{-3/5}"]
do for [against=1:2] {
  name = against == 1 ? "error" : "time"; width = 1180; height = 30 + 430 * count
  load draw
  set multiplot layout count,4 margins 70./width, 1 - 15./width, 105./height, 1 - 36./height spacing 45./width, 90./height
  set logscale xy
  set format y "10^{%L}"
  set yrange [1e-6:0.3]
  if (against == 1) {
    set xtics (16, 64, 256, 1024, 4096)
    set xrange [11:6000]
    set xlabel "samples"
  } else {
    set format x "10^{%L}"
    set xrange [0.05:50000]
    set xlabel "μs of CPU time"
  }
  do for [s=1:count] {
    do for [i=1:4] {
      set title what[i].who(s)
      set ylabel (i == 1 ? "RMSE" : "")
      file = data[s]."/error-".scenes[i].".tsv"
      if (i == 1 && s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 2 Left reverse samplen 3 width 2 } else { unset key }
      set label 1 (against == 1 ? rates[i] : "") at graph 0.95, graph 0.93 right textcolor rgb "#777777"
      plot for [k=1:5] file using (column(against == 1 ? "N" : ways[k]."_us")):(column(ways[k])) with linespoints ls value(ways[k]) notitle, \
           for [k=1:5] keyentry with linespoints ls value(ways[k]) title is(ways[k]), \
           (against == 1 ? 0.4*x**-0.5 : NaN) with lines ls theory title (against == 1 ? "N^{-1/2}" : ""), \
           (against == 1 ? 0.4*x**-rate[i] : NaN) with lines ls theory+1 notitle
    }
  }
  unset multiplot
}

# What each next2 is worth ------------------------------------------------------------------------
name = "next2"; width = 1180; height = 40 + 400 * count
load draw
set multiplot layout count,3 margins 70./width, 1 - 15./width, 105./height, 1 - 46./height spacing 85./width, 100./height
do for [s=1:count] {
  set title "dimensions 14 and 15, scrambled".who(s)
  set size ratio -1
  set xrange [0:1]; set yrange [0:1]
  set xtics 0.125 format "" ; set ytics 0.125 format ""
  unset key; set xlabel ""; set ylabel ""
  plot data[s]."/next2-pair.tsv" using "x":"y" with points pt 7 ps 0.3 lc rgb "#000000"
  set size noratio
  set xrange [0.3:20.7]
  set xtics (1, 4, 8, 12, 16, 20) format "%g"
  set logscale y
  set ytics autofreq format "10^{%L}"
  set xlabel "the k-th next2() of a sample"
  array scene[2] = ["under a lamp", "at an edge"]
  do for [i=1:2] {
    set title scene[i].", 1024 samples".who(s)
    set ylabel (i == 1 ? "RMSE" : "")
    set yrange [(i == 1 ? 2e-5 : 1e-3):3e-2]
    if (i == 1 && s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 1 Left reverse samplen 3 width 1 } else { unset key }
    file = data[s]."/next2.tsv"
    plot file using "k":sprintf("scrambled_sobol_%d", i) with linespoints ls scrambled_sobol notitle, \
         keyentry with linespoints ls scrambled_sobol title "6.3, blocks of eight", \
         file using "k":sprintf("sobol_%d", i) with linespoints ls sobol notitle, \
         keyentry with linespoints ls sobol title "one sequence, scrambled", \
         file using "k":sprintf("independent_%d", i) with lines ls independent title "independent"
  }
  unset logscale y
}
unset multiplot

# The variance by order ---------------------------------------------------------------------------
array colours[5] = ["#0072B2", "#56B4E9", "#F0E442", "#E69F00", "#D55E00"]
array orders[5] = ["one dimension at a time", "two together", "three", "four", "five"]
name = "anova"; width = 900; height = 500
load draw
set title "The variance of a sample by how many dimensions make it together" offset 0,0.4
set style data histograms
set style histogram rowstacked
set style fill solid 0.9 border rgb "#444444"
set boxwidth 0.6
set yrange [0:1]
set xrange [-0.6:5.6]
set ylabel "fraction of the variance"
set xtics ("lamp\n2D" 0, "ball of light\n2D" 1, "penumbra\n2D" 2, "edge in a pixel\n2D" 3, "moving edge\n1D + 1D" 4, "pixel, time, lens\n2D + 1D + 2D" 5)
set bmargin 7.5
set key at screen 0.5,0.01 center bottom horizontal maxcols 3 Left reverse samplen 2 width 1
plot for [k=1:5] data[1]."/anova.tsv" using k lc rgb colours[k] title orders[k], \
     data[1]."/anova.tsv" using 0:6 with points pt 9 ps 2 lc rgb "#000000" title "within one next() or next2()"

# What a coordinate costs -------------------------------------------------------------------------
# On a logarithmic axis the length of a bar says nothing: a point for each cost, and a line between.
array samples[3] = [16, 256, 4096]
name = "speed"; width = 1180; height = 30 + 430 * count
load draw
set multiplot layout count,4 margins 80./width, 1 - 15./width, 105./height, 1 - 36./height spacing 45./width, 120./height
do for [s=1:count] {
  set logscale y
  set format y "10^{%L}"
  set yrange [0.3:10000]
  set xrange [0.4:5.6]
  set xtics ("independent" 1, "stratified" 2, "blue noise" 3, "Halton" 4, "Sobol'" 5) rotate by 35 right
  set xlabel ""
  do for [i=1:3] {
    set title sprintf("%d samples", samples[i]).who(s)
    set ylabel (i == 1 ? "ns per coordinate, of 4 (less is better)" : "") offset 0.7,0
    if (i == 1) { set key left top Left reverse samplen 1 } else { unset key }
    if (i == 3) { set label 1 "blue noise is not timed:\n4096²/2 candidates" at 3,200 center textcolor rgb "#666666" } else { unset label 1 }
    file = data[s]."/speed-".samples[i].".tsv"
    plot file using ($0+1):"all":"generation":"all" with yerrorbars pt -1 lw 1 lc rgb "#999999" notitle, \
         for [k=1:5] file every ::k-1::k-1 using ($0+k):"all" with points ls value(ways[k]) ps 1.4 notitle, \
         keyentry with points pt 5 ps 1.2 lc rgb "#444444" title "all of it", \
         file using ($0+1):"generation" with points pt 1 ps 1.6 lw 2 lc rgb "#444444" title "generation alone"
  }
  unset label 1
  unset logscale y
  set format y "%g"
  set yrange [0:*]
  set xrange [1.5:8.5]
  set xtics norotate autofreq 2,2,8
  set xlabel "dimensions"
  unset ylabel
  set title "256 samples (thin: next())".who(s)
  set key right top Left reverse samplen 3
  set offsets 0, 0, graph 0.5, 0  # for the key
  file = data[s]."/speed-dims.tsv"
  plot 0 with lines ls theory notitle, \
       for [k in "1 2 4 5"] file using "dims":ways[k+0]."_2" with linespoints ls value(ways[k+0]) title is(ways[k+0]), \
       for [k in "1 2 4 5"] file using "dims":ways[k+0]."_1" with lines ls value(ways[k+0]) lw 1 notitle
  unset offsets
}
unset multiplot

# A picture by each, and its error ----------------------------------------------------------------
columns = 5
array titles[5*count]
largest = 0
do for [s=1:count] {
  load data[s]."/samplers.gp"
  largest = range > largest ? range : largest
  do for [k=1:5] { titles[5*s-5+k] = drawn[k] }
}
range = largest > 0 ? largest : 1
headline = "A floor under a lamp, half in the shadow of a table: 16 samples a pixel"
sheet = "samplers"
load here."/render.gp"
