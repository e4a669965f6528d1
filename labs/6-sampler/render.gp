# Draws one sheet of ./lab render: a picture by each kind of sampler, and its error below. Called
# with
#   count, labels[i]          how many submissions stand below each other, what they are called
#   data[i]                   the folder of their data
#   columns, kinds[k]         the samplers beside each other
#   titles[(i-1)*columns+k]   of each picture; "" where there is none
#   headline                  of the sheet
#   sheet                     "samples" or "time"
#   white, range              the largest value of the picture, the largest error that is told apart
#   draw                      the look of every plot (common/draw.gp)
w = 256; h = 192; gap = 10; left = 30; top = 40; above = 42
name = sheet; width = left + (columns + 1) * (w + gap); height = top + count * (above + 2 * (h + gap) + 8)
load draw
set multiplot
unset key; unset tics; unset grid; unset colorbox
set border lw 0.5 lc rgb "#999999"
set xrange [-0.5:127.5]
set yrange [95.5:-0.5]  # rows from the top
set label 1 headline at screen 0.5, 1 - 0.5 * top / height center front font ",13" noenhanced

# A panel whose upper left corner is x, y pixels from that of the sheet.
place = "set lmargin at screen x*1./width; set rmargin at screen (x+w)*1./width; ".\
        "set tmargin at screen 1-y*1./height; set bmargin at screen 1-(y+h)*1./height"
grey = "set palette defined (0 'black', 1 'white'); set cbrange [0:white]"
diverging = "set palette defined (-1 '#0072B2', 0 'white', 1 '#D55E00'); set cbrange [-range:range]"

do for [s=1:count] {
  row = top + above + (s - 1) * (above + 2 * (h + gap) + 8)
  x = left; y = row
  @place
  @grey
  set label 2 labels[s] at screen 0.5*left/width, 1-(row+h)*1./height center rotate by 90 noenhanced
  set title "exact\n "
  plot data[s]."/exact.tsv" matrix with image
  unset label
  first = 1
  do for [k=1:columns] {
    if (titles[(s-1)*columns+k] ne "") {
      x = left + k * (w + gap); y = row
      @place
      @grey
      set title titles[(s-1)*columns+k] noenhanced
      plot data[s]."/".kinds[k]."-".sheet.".tsv" matrix with image
      y = row + h + gap
      @place
      @diverging
      set title ""
      if (first) {  # below the exact image there is no error: there stands the scale of the others
        set colorbox user horizontal origin (left+35.)/width, 1-(y+0.55*h)/height size (w-70.)/width, 16./height
        set cbtics nomirror out (sprintf("%.2g", -range) -range, "0" 0, sprintf("+%.2g", range) range) textcolor rgb "black"
        set label 3 "error" at screen (left+0.5*w)/width, 1-(y+0.4*h)/height center
      }
      first = 0
      plot data[s]."/".kinds[k]."-".sheet."-error.tsv" matrix with image
      unset colorbox; unset label
    }
  }
}
unset multiplot
