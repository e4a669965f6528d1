# Draws the bench. Called by ./lab bench with `data`, the folder of its numbers, and what every plot
# is given (labs/common/draw.gp).

array on[6] = ["smooth 1D", "smooth 2D", "smooth 4D", "kinks 2D", "edge 2D", "smooth 8D"]
array formula[6] = ["exp(x)", "exp(x + y)", "exp(w + x + y + z)", "two kinks", "an edge: a quarter of a disk", "exp of a sum of eight"]
array what[6] = ["independent", "jittered", "multi-jittered", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
array called[6] = ["independent", "jittered", "multi-jittered; Latin hypercube", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
array many[6] = ["independent", "jittered, padded", "Latin hypercube", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
# The method that a library (peer[k] is its block, peerwhat[k] what it draws; both come from the bench)
# is to be compared with.
method(k) = sum [j=1:|what|] (what[j][1:4] eq peerwhat[k][1:4] ? j : 0)
curves = data."/curves.tsv"
is_many(i) = i == 3 || i == 6
block(i, k) = (is_many(i) ? many[k] : what[k])."|".on[i]

do for [axis in "samples time"] {
  column_of = axis eq "samples" ? 1 : 2
  name = axis; width = 620; height = 1190
  load draw
  set termoption enhanced
  array style[6] = [independent, jittered, multi_jittered, poisson_disk, scrambled_halton, scrambled_sobol]
  set multiplot layout 3,2 margins 80./width, 1 - 15./width, 205./height, 1 - 34./height spacing 65./width, 85./height
  set logscale xy
  set format "10^{%L}"
  set yrange [1e-7:1]
  if (axis eq "samples") { set xrange [10:100000] } else { set xrange [0.05:10000] }
  set xlabel (axis eq "samples" ? "samples" : "µs, integrand included")
  do for [i=1:6] {
    set title formula[i]
    set ylabel (i % 2 == 1 ? "RMSE, relative" : "")
    if (i == 6) { set key at screen 0.3,0.01 left bottom vertical maxrows 6 Left reverse samplen 3 } else { unset key }
    plot for [k=1:6] curves index block(i, k) using column_of:3 with linespoints ls style[k] ps 0.8 notitle, \
         for [k=1:6] keyentry with linespoints ls style[k] ps 0.8 title called[k]
  }
  unset multiplot
}

# Libraries, each next to the method of the course that it is to be compared with -----------------
array compared[4] = [1, 2, 5, 6]  # independent, jittered, Halton, Sobol'
name = "libraries"; width = 620; height = 860
load draw
set termoption enhanced
set multiplot layout 2,2 margins 80./width, 1 - 15./width, 205./height, 1 - 34./height spacing 65./width, 85./height
set logscale xy
set format "10^{%L}"
set xrange [0.05:10000]
set yrange [1e-6:1]
set xlabel "µs, integrand included"
do for [j=1:4] {
  m = compared[j]
  set title called[m]
  set ylabel (j % 2 == 1 ? "RMSE of exp(x + y)" : "")
  if (j == 4) { set key at screen 0.5,0.01 center bottom vertical maxrows 5 Left reverse samplen 3 } else { unset key }
  plot curves index block(2, m) using 2:3 with linespoints ls theory lw 2 dt 1 pt 7 ps 0.6 notitle, \
       for [k=1:|peer|] curves index (method(k) == m ? peer[k]."|".on[2] : "none") using 2:3 with linespoints ls other+1+(k-1)%6 ps 0.8 notitle, \
       keyentry with linespoints ls theory lw 2 dt 1 pt 7 ps 0.6 title "the solutions", \
       for [k=1:|peer|] keyentry with linespoints ls other+1+(k-1)%6 ps 0.8 title peer[k]
}
unset multiplot
