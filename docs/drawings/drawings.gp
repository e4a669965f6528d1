# Drawings of the handouts that show no submission's output. docs/refresh.sh calls this with
#   draw    the look of every plot (labs/common/draw.gp)
#   place   where the drawings go: LAB-NAME.svg
#   data    the folder of relaxed.tsv and relaxed-power.tsv (relaxed.awk)
ext = "svg"
count = 1

# Importance weights: the samples of x² by two densities ------------------------------------------
out = place."/2"; name = "weights"; width = 600; height = 385
load draw
set multiplot layout 1,2 margins 45./width, 1 - 15./width, 115./height, 1 - 34./height spacing 45./width, 0
set xrange [0:1]
set xtics 0,0.5
set ytics 0,0.5
set yrange [0:2.2]
set xlabel "x"
set key at screen 10./width,0.01 left bottom maxrows 2 Left reverse samplen 2
array title_of[2] = ["uniform, p(x) = 1", "p(x) = 2x"]
do for [k=1:2] {
  p(x) = k == 1 ? 1 : 2 * x
  place_of(u) = k == 1 ? u : sqrt(u)
  set title title_of[k]
  set samples 201
  if (k == 2) { unset key }
  plot p(x) with lines ls theory title "density p", \
       x**2 with lines lw 2 lc rgb dot title "g(x) = x²", \
       1./3 with lines lt 1 lw 1 lc rgb ink title "1/3", \
       [t=0:9] '+' using (place_of((t+0.5)/10)):(place_of((t+0.5)/10)**2/p(place_of((t+0.5)/10))) every 20 with impulses lw 1 lc rgb "#D55E00" notitle, \
       [t=0:9] '+' using (place_of((t+0.5)/10)):(place_of((t+0.5)/10)**2/p(place_of((t+0.5)/10))) every 20 with points pt 7 ps 0.8 lc rgb "#D55E00" title "g/p of samples"
}
unset multiplot

# The order in which van der Corput's points arrive -----------------------------------------------
out = place."/5"; name = "order"; width = 500; height = 420
load draw
inverse(i) = (i & 1) / 2. + ((i >> 1) & 1) / 4. + ((i >> 2) & 1) / 8. + ((i >> 3) & 1) / 16.
bits(i) = sprintf("%d%d%d%d", (i >> 3) & 1, (i >> 2) & 1, (i >> 1) & 1, i & 1)
set lmargin at screen 95. / width
set rmargin at screen 1 - 25. / width
set tmargin at screen 1 - 34. / height
set bmargin at screen 60. / height
set title "The first 16 indices, and their radical inverses in base 2"
set xrange [-0.02:1]
set yrange [15.6:-0.6]
set xtics ("0" 0, "1/4" 0.25, "1/2" 0.5, "3/4" 0.75, "1" 1)
set ytics ()
do for [i=0:15] { set ytics add (sprintf("%2d = %s", i, bits(i)) i) }
set grid noy
set xlabel "φ₂(index): the digits mirrored"
unset key
set samples 2
plot for [i=0:15] for [j=0:i] '+' using (inverse(j)):(i) every ::0::0 with points \
  pt 7 ps (j == i ? 1.1 : 0.6) lc rgb (j == i ? "#D55E00" : "#80808080")

# Why scrambled points have smaller errors: the errors in eight strata ------------------------------
# A bar is the error of a stratum: from its mean to the value at its point.
out = place."/5"; name = "owen"; width = 620; height = 330
load draw
array place_in[8] = [0.62, 0.13, 0.91, 0.34, 0.78, 0.05, 0.55, 0.41]
g(x) = 0.15 + 0.75 * x**2
mean_of(k) = (0.15 * 0.125 + 0.25 * ((k / 8.)**3 - ((k - 1) / 8.)**3)) * 8
at(k, i) = (k - 1 + (i == 1 ? 0 : place_in[k])) / 8.
set multiplot layout 1,2 margins 15./width, 1 - 15./width, 45./height, 1 - 34./height spacing 25./width, 0
set xrange [0:1]
set yrange [0:1]
set xtics ("0" 0, "1/8" 0.125, "1/4" 0.25, "1/2" 0.5, "1" 1)
unset ytics
set grid xtics
unset key
set samples 101
do for [i=1:2] {
  set title (i == 1 ? "plain points" : "scrambled points")
  do for [k=1:8] {
    set object k rect from (k - 1) / 8.,mean_of(k) to k / 8.,g(at(k, i)) fc rgb "#D55E00" fs solid 0.35 noborder
  }
  plot g(x) with lines lw 2 lc rgb dot, \
       for [k=1:8] [t=0:1] '+' using ((k - 1 + t) / 8.):(mean_of(k)) with lines lw 1 lc rgb ink, \
       for [k=1:8] [t=0:0] '+' using (at(k, i)):(g(at(k, i))) every ::0::0 with points pt 7 ps 0.9 lc rgb dot
}
unset multiplot
unset object

# Time and lens, in the same order and in independent orders --------------------------------------
out = place."/6"; name = "lens"; width = 600; height = 340
load draw
n = 64
array order[n]
array shift[2 * n]
r = rand(7)
do for [i=1:n] { order[i] = i - 1; shift[i] = rand(0); shift[n + i] = rand(0) }
do for [i=1:n-1] {
  j = n + 1 - i
  k = 1 + int(rand(0) * j)
  t = order[j]; order[j] = order[k]; order[k] = t
}
set multiplot layout 1,2 margins 60./width, 1 - 15./width, 60./height, 1 - 34./height spacing 45./width, 0
set size square
set xrange [0:1]
set yrange [0:1]
set xtics 0,0.5
set ytics 0,0.5
set xlabel "time"
set ylabel "position on the lens" offset 2.5,0
unset key
do for [k=1:2] {
  if (k == 2) { set ylabel "" }
  set title (k == 1 ? "the same order" : "independent permutations")
  plot order using (($1 - 1 + shift[int($1)]) / n):(((k == 1 ? $1 - 1 : $2) + shift[n + int($1)]) / n) \
    with points pt 7 ps 0.7 lc rgb dot
}
unset multiplot

# Designing a spectrum ----------------------------------------------------------------------------
out = place."/4"; name = "design"; width = 600; height = 400
load draw
set multiplot layout 1,2 margins 10./width, 1 - 15./width, 120./height, 1 - 34./height spacing 60./width, 0
set size square
set xrange [0:1]
set yrange [0:1]
unset tics
unset grid
unset key
set title "256 relaxed points"
plot data."/relaxed.tsv" using 1:2 with points pt 7 ps 0.5 lc rgb dot
set size nosquare
set grid
set tics
set title "their power, and two designs"
set xrange [0:2]
set yrange [0:4]
set xtics 0,0.5
set ytics 0,1
set xlabel "frequency |k| / √N"
set ylabel "power" offset 2,0
set key at screen 0.5,0.01 center bottom vertical maxrows 3 Left reverse samplen 3
step(x) = x < 0.564 ? 0 : 1
ring(x) = x < 0.75 ? 0 : x < 0.898 ? 2 : 1
set samples 1001
plot data."/relaxed-power.tsv" using 1:2 with linespoints lw 2 pt 6 ps 0.5 lc rgb dot title "relaxed points", \
     step(x) with lines lw 2 lc rgb "#009E73" title "power 0 up to 0.56, then 1", \
     ring(x) with lines lw 2 dt 2 lc rgb "#D55E00" title "power 0 up to 0.75: a ring of 2 pays for it"
unset multiplot

# The mean of N uniform numbers --------------------------------------------------------------------
# Its density (Irwin-Hall), with a bar of one standard deviation, 1/sqrt(12 N), to either side.
out = place."/2"; name = "means"; width = 560; height = 400
load draw
set lmargin at screen 70. / width
set rmargin at screen 1 - 15. / width
set tmargin at screen 1 - 34. / height
set bmargin at screen 95. / height
set xlabel "mean"
set ylabel "density"
choose(n, k) = gamma(n + 1.) / gamma(k + 1.) / gamma(n - k + 1.)
density(n, x) = n == 1 ? 1 : n / gamma(n) * sum [k=0:n] (k < n * x ? (-1)**k * choose(n, k) * (n * x - k)**(n - 1) : 0)
# For 16, by symmetry from the side where no digits cancel.
mean_density(n, x) = density(n, x < 0.5 ? x : 1 - x)
set title "The mean of N uniform numbers"
set xrange [0:1]
set yrange [0:6]
set xtics 0,0.25
set ytics 0,2
set samples 401
set key at screen 10./width,0.01 left bottom maxrows 1 Left reverse samplen 2
array many[3] = [1, 4, 16]
array high[3] = [0.5, 1.2, 2.8]
do for [i=1:3] {
  set arrow from 0.5 - 1/sqrt(12. * many[i]),high[i] to 0.5 + 1/sqrt(12. * many[i]),high[i] heads lw 2 lc rgb ink
  set label sprintf("N = %d: ± σ/√%d", many[i], many[i]) at (i == 1 ? 0.76 : 0.68),high[i] + (i == 1 ? 0.9 : i == 2 ? 1.3 : 1.1) left textcolor rgb ink
}
plot for [i=1:3] mean_density(many[i], x) with lines ls other+i title sprintf("N = %d", many[i])
unset arrow
unset label

# Why the mean of g/p is the integral of g ----------------------------------------------------------
# Ten points in the middle of ten strips of equal probability under p(x) = 2x.
out = place."/2"; name = "strips"; width = 600; height = 350
load draw
set multiplot layout 1,2 margins 45./width, 1 - 15./width, 60./height, 1 - 34./height spacing 45./width, 0
edge(k) = sqrt(k / 10.)
point(k) = sqrt((k + 0.5) / 10.)
set xrange [0:1]
set xtics 0,0.5
set xlabel "x"
set style fill solid 0.3 border
unset key
do for [i=1:2] {
  set yrange [0:(i == 1 ? 2.2 : 1.1)]
  set ytics 0,(i == 1 ? 1 : 0.5)
  set title (i == 1 ? "p(x) = 2x: ten strips of 1/10" : "g(x) = x²: a bar for each")
  do for [k=0:9] {
    x0 = edge(k); x1 = edge(k + 1); h = point(k)**2
    if (i == 1) {
      set object k + 1 polygon from x0,0 to x1,0 to x1,2*x1 to x0,2*x0 to x0,0 fc rgb (k % 2 ? "#D55E00" : dot) fs solid 0.3 border lc rgb ink
    } else {
      set object k + 1 rect from x0,0 to x1,h fc rgb (k % 2 ? "#D55E00" : dot) fs solid 0.3 border lc rgb ink
    }
  }
  plot (i == 1 ? 2 * x : x**2) with lines lw 2 lc rgb dot
}
unset multiplot
unset object
