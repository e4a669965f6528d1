# Draws one sheet of ./lab render: a picture by each kind of sampler, with its error below. A row has
# three pictures, so that the sheet can be read on a phone. Called with
#   count, labels[i]          the number of submissions, drawn below each other, and their names
#   data[i]                   the folder of their data
#   columns, kinds[k]         the samplers of a sheet
#   titles[(i-1)*columns+k]   of each picture; "" where there is none
#   headline                  of the sheet
#   sheet                     "samples" or "time"
#   white, range              the largest value of the picture, and the error at the end of the scale
#   draw                      the style of all plots (common/draw.gp)
w = 256; h = 192; gap = 10; top = 50; above = 62
left = count > 1 ? 40 : gap       # room for a submission's name
band = above + 2 * h + gap        # a row of pictures, and the row of their errors
bands = (columns + 3) / 3         # the exact picture is the first
name = sheet; width = left + 3 * (w + gap); height = top + count * bands * (band + 8)
load draw
big = ext eq "svg" ? ",20" : ",15"
set multiplot
unset key; unset tics; unset grid; unset colorbox
set border lw 0.5
set title font big
set xrange [-0.5:127.5]
set yrange [95.5:-0.5]  # rows from the top
set label 1 headline at screen 0.5, 1 - 0.5 * top / height center front font big textcolor rgb ink noenhanced

# Places a panel whose upper left corner is x, y pixels from the corner of the sheet.
place = "set lmargin at screen x*1./width; set rmargin at screen (x+w)*1./width; ".\
        "set tmargin at screen 1-y*1./height; set bmargin at screen 1-(y+h)*1./height"
gray = "set palette defined (0 'black', 1 'white'); set cbrange [0:white]"
diverging = "set palette defined (-1 '#0072B2', 0 'white', 1 '#D55E00'); set cbrange [-range:range]"

do for [s=1:count] {
  row = top + above + (s - 1) * bands * (band + 8)
  x = left; y = row
  @place
  @gray
  if (count > 1) { set label 2 labels[s] at screen 0.5*left/width, 1-(row+h)*1./height center rotate by 90 textcolor rgb ink noenhanced }
  set title "exact\n "
  plot data[s]."/exact.tsv" matrix with image
  unset label
  first = 1
  do for [k=1:columns] {
    if (titles[(s-1)*columns+k] ne "") {
      x = left + (k % 3) * (w + gap); y = row + (k / 3) * (band + 8)
      @place
      @gray
      set title titles[(s-1)*columns+k]
      plot data[s]."/".kinds[k]."-".sheet.".tsv" matrix with image
      y = y + h + gap
      @place
      @diverging
      set title ""
      if (first) {  # the exact picture has no error: the scale of the others is below it
        set colorbox user horizontal origin (left+35.)/width, 1-(y+0.55*h)/height size (w-70.)/width, 16./height
        set cbtics nomirror out (sprintf("%.2g", -range) -range, "0" 0, sprintf("+%.2g", range) range) font big textcolor rgb ink
        set label 3 "error" at screen (left+0.5*w)/width, 1-(y+0.35*h)/height center font big textcolor rgb ink
      }
      first = 0
      plot data[s]."/".kinds[k]."-".sheet."-error.tsv" matrix with image
      unset colorbox; unset label
    }
  }
}
unset multiplot
