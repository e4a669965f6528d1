# The style of all plots. Set name, width and height, then load draw. The background is transparent,
# and every color is a middle tone, so that a plot is readable on a light and on a dark page. A plot is
# at most 640 wide for one submission: its text then stays readable on a phone.
reset
set datafile missing "NaN"  # what could not be measured; gnuplot 5.4 crashes on labels at NaN
ink = "#808080"             # text and axes
soft = "#A0808080"          # lines of a grid
dot = "#2F80C8"             # points of a pattern
if (ext eq "svg") {
  set terminal svg size width,height font "sans,15"
} else {
  set terminal pngcairo transparent size width,height font "sans,11"
}
set output out."-".name.".".ext
# Labels are near their axes: with margins in pixels they would be cut off, or overlap their neighbors.
set title offset 0,-0.6 textcolor rgb ink noenhanced
set xlabel offset 0,0.5 textcolor rgb ink
set ylabel offset 1.2,0 textcolor rgb ink
set tics textcolor rgb ink
set key textcolor rgb ink
set grid lt 1 lw 0.5 lc rgb soft
set pointintervalbox 0.001  # otherwise points with error bars have a white disk behind them
set border lc rgb ink

# The methods that make points. Each has one color and one mark in all plots of the course. The colors
# (Okabe and Ito) can be distinguished with color blindness, marks and dashes also in gray prints.
# A plot draws column KEY of its data with "ls value(KEY)" and the title "value(KEY."_is")", which is
# defined with the data.
independent = 1;        set style line  1 lc rgb "#D55E00" lw 2 pt 4  dt 2
stratified = 2;         set style line  2 lc rgb "#0072B2" lw 2 pt 13 dt 1
jittered = 3;           set style line  3 lc rgb "#0072B2" lw 2 pt 6  dt 1
padded = 4;             set style line  4 lc rgb "#8F6FD0" lw 2 pt 7  dt 5
jittered_nd = 5;        set style line  5 lc rgb "#009E73" lw 2 pt 15 dt 3
latin_hypercube = 6;    set style line  6 lc rgb "#56B4E9" lw 2 pt 3  dt 3
multi_jittered = 7;     set style line  7 lc rgb "#CC79A7" lw 2 pt 12 dt 4
textbook = 8;           set style line  8 lc rgb "#808080" lw 2 pt 5  dt 1
few_candidates = 9;     set style line  9 lc rgb "#E69F00" lw 2 pt 14 dt 5
best_candidate = 10;    set style line 10 lc rgb "#009E73" lw 2 pt 11 dt 3
poisson_disk = 11;      set style line 11 lc rgb "#8F6FD0" lw 2 pt 13 dt 1
radical_inverse = 12;   set style line 12 lc rgb "#0072B2" lw 2 pt 5  dt 1
halton = 13;            set style line 13 lc rgb "#009E73" lw 2 pt 8  dt 3
hammersley = 14;        set style line 14 lc rgb "#CC79A7" lw 2 pt 14 dt 4
sobol = 15;             set style line 15 lc rgb "#8F6FD0" lw 2 pt 2  dt 1
rotated = 16;           set style line 16 lc rgb "#CC79A7" lw 2 pt 11 dt 4
scrambled_sobol = 17;   set style line 17 lc rgb "#E69F00" lw 2 pt 10 dt 5
scrambled_halton = 18;  set style line 18 lc rgb "#56B4E9" lw 2 pt 9  dt 3
hashed = 19;            set style line 19 lc rgb "#D55E00" lw 2 pt 7  dt 2
lattice = 20;           set style line 20 lc rgb "#B5532A" lw 2 pt 15 dt 1
# Lines that are not methods for points (integrands, algorithms for a variance): other + 1, ...
other = 20
set style line 21 lc rgb "#7B68C8" lw 2 pt 4  dt 2
set style line 22 lc rgb "#C0568A" lw 2 pt 6  dt 1
set style line 23 lc rgb "#2E9450" lw 2 pt 8  dt 3
set style line 24 lc rgb "#999933" lw 2 pt 12 dt 4
set style line 25 lc rgb "#B5532A" lw 2 pt 2  dt 1
set style line 26 lc rgb "#808080" lw 2 pt 10 dt 5
theory = 30  # for comparison: rates and exact values
set style line 30 lc rgb "#999999" lw 2 dt 2
set style line 31 lc rgb "#999999" lw 2 dt 3
set style line 32 lc rgb "#999999" lw 2 dt 4

# The title of a panel: what it shows and, if there are several submissions, the submission's name.
# Titles are not enhanced, since names may have underscores: write 10⁹, not 10^9. head(count) is the
# height of a title in pixels.
heading(text, s) = count > 1 ? text."\n".labels[s] : text
who(s) = count > 1 ? ", ".labels[s] : ""
head(panels) = panels > 1 ? 58. : 34.
# A panel for each submission, side by side: "eval panels(left, gap, bottom)", the space left of the
# first, between two, and below all, in pixels.
panels(left, gap, bottom) = sprintf("set multiplot layout 1,count ".\
  "margins %d./width, 1 - 25./width, %d./height, 1 - head(count)/height spacing %d./width, 0", \
  left, bottom, gap)
is(method) = value(method."_is")
