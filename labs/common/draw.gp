# The look of every plot. Set name, width and height, then load draw. Colours of Okabe and Ito,
# which colour-blind eyes tell apart, and a point and a dash of its own for each line, for those who
# print in grey. A white ground of its own, so that it reads on dark pages too.
reset
set datafile missing "NaN"  # what could not be measured; gnuplot 5.4 crashes on labels at NaN
if (ext eq "svg") {
  set terminal svg size width,height background "white" font "sans,14"
} else {
  set terminal pngcairo size width,height background "white" font "sans,11"
}
set output out."-".name.".".ext
# Near their axes: with margins in pixels they would be cut off, or lie on what is beside them.
set title offset 0,-0.6
set xlabel offset 0,0.5
set ylabel offset 1.2,0
# By number, or by the name of a method (common/methods.gp).
set style line 1 lc rgb "#D55E00" lw 2 pt 4  dt 2
set style line 2 lc rgb "#0072B2" lw 2 pt 6  dt 1
set style line 3 lc rgb "#009E73" lw 2 pt 8  dt 3
set style line 4 lc rgb "#CC79A7" lw 2 pt 12 dt 4
set style line 5 lc rgb "#000000" lw 2 pt 2  dt 1
set style line 6 lc rgb "#E69F00" lw 2 pt 10 dt 5
set style line 7 lc rgb "#56B4E9" lw 2 pt 3  dt 3
set style line 8 lc rgb "#CC79A7" lw 2 pt 14 dt 4
set style line 9 lc rgb "#999999" lw 1 dt 2  # for comparison: rates, what is exact
set style line 10 lc rgb "#CC79A7" lw 2 pt 1 dt 4
set style line 11 lc rgb "#009E73" lw 2 pt 1 dt 3
set style line 12 lc rgb "#000000" lw 2 pt 3 dt 1
set style line 13 lc rgb "#E69F00" lw 2 pt 1 dt 5
set style line 14 lc rgb "#56B4E9" lw 2 pt 14 dt 4
set style line 15 lc rgb "#000000" lw 2 pt 1 dt 3
set grid lt 1 lw 0.5 lc rgb "#DDDDDD"
set border lc rgb "#444444"
