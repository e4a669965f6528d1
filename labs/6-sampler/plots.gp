# Draws lab 6. Called by ./lab plot with
#   count      the number of submissions, drawn side by side
#   labels[i]  their names, data[i] the folder of their data
#   draw       the style of all plots (common/draw.gp): load it after setting name, width and height
#   here       the folder of this script

array kinds[5] = ["independent", "stratified", "blue_noise", "halton", "sobol"]  # render.gp
array ways[6] = ["independent", "multi_jittered", "best_candidate", "scrambled_halton", "scrambled_sobol", "lattice"]

# Stretch kinds are drawn thin.
style(k) = value(ways[k])
width_of(k) = k == 6 ? 1 : 2

# Error against N, and against time ---------------------------------------------------------------
array scenes[4] = ["rect_light", "pixel_edge", "motion_edge", "pixel_time_lens"]
array what[4] = ["under a lamp (smooth, 2D)", "an edge in a pixel (2D)", "a moving edge (1D + 1D)", "pixel, time and lens (5D)"]
array rate[4] = [1.5, 0.75, 0.75, 0.5]
array rates[4] = ["N^{-3/2}", "N^{-3/4}", "N^{-3/4}", ""]
array below[4] = [0.4, 0.15, 0.15, 0]
array least[4] = [1e-7, 2e-4, 2e-4, 8e-4]
do for [against=1:2] {
  name = against == 1 ? "error" : "time"; width = 620 * count; height = 900
  load draw
  set termoption enhanced
  set multiplot layout 2,2*count margins 80./width, 1 - 20./width, 180./height, 1 - 32./height spacing 65./width, 105./height
  set logscale xy
  set format y "10^{%L}"
  if (against == 1) {
    set xtics (16, 64, 256, 1024, 4096)
    set xrange [11:6500]
    set xlabel "samples"
  } else {
    set format x "10^{%L}"
    set xrange [0.05:50000]
    set xlabel "µs of CPU time"
  }
  do for [row=0:1] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
    set title what[i].who(s)
    set ylabel (i % 2 == 1 && s == 1 ? "RMSE" : "")
    set yrange [least[i]:0.5]
    file = data[s]."/error-".scenes[i].".tsv"
    if (i == 4 && s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 4 Left reverse samplen 4 spacing 1.1 } else { unset key }
    unset label
    if (against == 1) {
      set label 1 "N^{-1/2}" at 700, 1.6*700**-0.5 left textcolor rgb ink
      if (i < 4) { set label 2 rates[i] at (i == 1 ? 180 : 70), (i == 1 ? 0.3 : 0.55)*below[i]*(i == 1 ? 180 : 70)**-rate[i] right textcolor rgb ink }
    }
    plot for [k=1:6] file using (column(against == 1 ? "N" : ways[k]."_us")):(column(ways[k])) with linespoints ls style(k) lw width_of(k) notitle, \
         for [k=1:6] keyentry with linespoints ls style(k) lw width_of(k) title is(ways[k]).(k == 6 ? " (stretch)" : ""), \
         (against == 1 ? 1.1*x**-0.5 : NaN) with lines ls theory notitle, \
         (against == 1 && i < 4 ? below[i]*x**-rate[i] : NaN) with lines ls theory+1 notitle
  } } }
  unset multiplot
}

# The error of each next2 -------------------------------------------------------------------------
name = "next2"; width = 620 * count; height = 400
load draw
set multiplot layout 1,2*count margins 70./width, 1 - 20./width, 130./height, 1 - 32./height spacing 70./width, 0
array scene[2] = ["under a lamp", "at an edge"]
set xrange [0.3:20.7]
set xtics (1, 4, 8, 12, 16, 20) format "%g" scale 1
set logscale y
set ytics autofreq format "10^{%L}" scale 1
set termoption enhanced
do for [s=1:count] {
  do for [i=1:2] {
    set title scene[i].", 1024 samples".who(s)
    set xlabel "the k-th next2() of a sample"
    set ylabel (i == 1 && s == 1 ? "RMSE" : "")
    set yrange [(i == 1 ? 2e-5 : 1e-3):3e-2]
    if (i == 1 && s == 1) { set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 4 } else { unset key }
    file = data[s]."/next2.tsv"
    plot file using "k":sprintf("scrambled_sobol_%d", i) with linespoints ls scrambled_sobol notitle, \
         keyentry with linespoints ls scrambled_sobol title "the kind sobol", \
         file using "k":sprintf("sobol_%d", i) with linespoints ls sobol notitle, \
         keyentry with linespoints ls sobol title "one sequence (it ends after 16 pairs)", \
         file using "k":sprintf("independent_%d", i) with lines ls independent title "independent"
  }
}
unset multiplot

# The variance by order ---------------------------------------------------------------------------
array colors[5] = ["#0072B2", "#56B4E9", "#F0E442", "#E69F00", "#D55E00"]
array orders[5] = ["one dimension at a time", "two together", "three", "four", "five"]
name = "anova"; width = 600; height = 500
load draw
set title "The variance of a sample by order"
set style data histograms
set style histogram rowstacked
set style fill solid 0.9 border rgb ink
set boxwidth 0.6
set yrange [0:1.09]
set ytics 0,0.2,1
set xrange [-0.6:5.6]
set ylabel "fraction of the variance"
set xtics ("lamp\n2D" 0, "spherical\nlight\n2D" 1, "penumbra\n2D" 2, "edge in\na pixel\n2D" 3, "moving\nedge\n1D + 1D" 4, "pixel,\ntime, lens\n5D" 5)
set bmargin at screen 160./height
set tmargin at screen 1 - 40./height
set key at screen 0.1,0.01 left bottom vertical maxrows 3 Left reverse samplen 2
plot for [k=1:5] data[1]."/anova.tsv" using k lc rgb colors[k] title orders[k], \
     data[1]."/anova.tsv" using 0:6 with points pt 9 ps 2 lc rgb "#AF3FBF" title "within one call"

# What a coordinate costs -------------------------------------------------------------------------
# On a logarithmic axis the length of a bar has no meaning, so each cost is a point, with a line between.
array samples[3] = [16, 256, 4096]
name = "speed"; width = 620 * count; height = 960
load draw
set multiplot layout 2,2*count margins 80./width, 1 - 20./width, 250./height, 1 - 32./height spacing 75./width, 130./height
do for [row=0:1] { do for [s=1:count] { do for [i=2*row+1:2*row+2] {
  if (i < 4) {
    set logscale y
    set format y "10^{%L}"
    set yrange [0.2:3000]
    set xrange [0.4:6.6]
    set xtics ("independent" 1, "stratified" 2, "blue noise" 3, "Halton" 4, "Sobol'" 5, "lattice" 6) rotate by 40 right
    set xlabel ""
    set title sprintf("%d samples, 4 dimensions", samples[i]).who(s)
    set ylabel (i % 2 == 1 && s == 1 ? "ns per coordinate" : "")
    set termoption enhanced
    unset key
    if (i == 3) { set label 1 "blue noise is not timed:\n4096²/2 candidates" at 3,200 center textcolor rgb ink } else { unset label 1 }
    file = data[s]."/speed-".samples[i].".tsv"
    plot file using ($0+1):"all":"generation":"all" with yerrorbars pt -1 lw 1 lc rgb "#999999" notitle, \
         for [k=1:6] file every ::k-1::k-1 using ($0+k):"all" with points ls style(k) ps 1.4 notitle, \
         file using ($0+1):"generation" with points pt 1 ps 1.6 lw 2 lc rgb ink notitle
  } else {
    unset label 1
    unset logscale y
    set format y "%g"
    set yrange [0:*]
    set xrange [1.5:8.5]
    set xtics norotate autofreq 2,2,8
    set xlabel "dimensions"
    set title "256 samples".who(s)
    set ylabel (s == 1 ? "ns per coordinate" : "") offset 0.5,0
    if (s == count) { set key at screen 0.5,0.01 center bottom vertical maxrows 4 Left reverse samplen 4 spacing 1.1 } else { unset key }
    file = data[s]."/speed-dims.tsv"
    plot for [k in "1 2 4 5"] file using "dims":ways[k+0]."_2" with linespoints ls style(k+0) notitle, \
         for [k in "1 2 4 5"] file using "dims":ways[k+0]."_1" with lines ls style(k+0) lw 1 notitle, \
         for [k=1:6] keyentry with linespoints ls style(k) title is(ways[k]).(k == 6 ? " (stretch)" : ""), \
         keyentry with points pt 1 ps 1.6 lw 2 lc rgb ink title "filling the columns", \
         keyentry with lines lw 1 lc rgb ink title "by next()"
  }
} } }
unset multiplot

# A picture by each kind, and its error-------------------------------------------------------------
columns = 5
array titles[5*count]
largest = 0
do for [s=1:count] {
  load data[s]."/samplers.gp"
  largest = range > largest ? range : largest
  do for [k=1:5] { titles[5*s-5+k] = drawn[k] }
}
range = largest > 0 ? largest : 1
headline = "A floor under a lamp, half in the shadow of a table: 16 samples per pixel"
sheet = "samplers"
load here."/render.gp"
