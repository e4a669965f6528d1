# Draws the bench. Called by ./lab bench with `data`, the folder of its numbers, and what every plot
# is given (labs/common/draw.gp).

array on[6] = ["smooth 1D", "smooth 2D", "smooth 4D", "kinks 2D", "edge 2D", "smooth 8D"]
array formula[6] = ["exp(x)", "exp(x + y)", "exp(w + x + y + z)", "two kinks", "an edge: a quarter of a disk", "exp of a sum of eight"]
array sigma[6] = [0.286, 0.419, 0.625, 0.534, 0.905, 1.0]
array what[6] = ["independent", "jittered", "multi-jittered", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
array called[6] = ["independent", "jittered", "multi-jittered; Latin hypercube", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
array many[6] = ["independent", "jittered, padded", "Latin hypercube", "Poisson disk", "Halton, scrambled", "Sobol', scrambled"]
# A library's line (peer[k] is its block, peerwhat[k] what it draws; both come from the bench) has
# the color of the method that it is to be compared with.
method(k) = sum [j=1:|what|] (what[j][1:4] eq peerwhat[k][1:4] ? j : 0)
second(k) = sum [j=1:k] (peerwhat[j] eq peerwhat[k] ? 1 : 0)
curves = data."/curves.tsv"
is_many(i) = i == 3 || i == 6
block(i, k) = "solutions|".(is_many(i) ? many[k] : what[k])."|".on[i]

do for [axis in "samples time"] {
  column_of = axis eq "samples" ? 1 : 2
  name = axis; width = 1180; height = 880
  load draw
  array style[6] = [independent, jittered, multi_jittered, poisson_disk, scrambled_halton, scrambled_sobol]
  set multiplot layout 2,3 margins 75./width, 1 - 15./width, 150./height, 1 - 36./height spacing 65./width, 90./height
  set logscale xy
  set format "10^{%L}"
  set yrange [1e-7:1]
  if (axis eq "samples") { set xrange [10:100000] } else { set xrange [0.05:10000] }
  set xlabel (axis eq "samples" ? "samples" : "microseconds, integrand included")
  do for [i=1:6] {
    set title formula[i]
    set ylabel (i % 3 == 1 ? "RMSE, relative" : "")
    if (i == 5) {
      set key at screen 0.5,0.01 center bottom vertical maxrows 4 Left reverse samplen 4
    } else {
      unset key
    }
    if (axis eq "samples") {
      plot for [k=1:6] curves index block(i, k) using column_of:3:4 with yerrorlines ls style[k] ps 0.8 title called[k]
    } else {
      plot for [k=1:6] curves index block(i, k) using column_of:3 with linespoints ls style[k] ps 0.8 title called[k], \
           for [k=1:|peer|] curves index peer[k]."|".on[i] using column_of:3 with lines ls style[method(k)] lw 2 dt 2+second(k) title peer[k][1:strstrt(peer[k], "|")-1].": ".peerwhat[k]
    }
  }
  unset multiplot
}

# Variance: time against digits -------------------------------------------------------------------
# who[i], the submissions, comes from the bench.
name = "variance"; width = 900; height = 560
load draw
set title "Variance of 4096 values from 1e9 to 1e9 + 1, in cache"
set logscale x
set xrange [0.1:50]
set yrange [-1.5:17.5]
set ytics 0,2,16
set xlabel "ns per value (less is better)"
set ylabel "decimal digits that are right (more is better)"
set key at graph 0.02,0.55 left Left reverse
set label "1.2 textbook\n1.3 two passes\n1.4 Welford\n1.5 merged parts\n1.8 moments" at graph 0.03,0.3
set datafile separator "\t"
plot for [i=1:|who|] data."/variances.tsv" index who[i] using 1:2 with points ls other+i ps 1.8 title who[i], \
     for [i=1:|who|] data."/variances.tsv" index who[i] using 1:2:3 with labels offset 0,(i % 2 == 1 ? 1 : -1) notitle
