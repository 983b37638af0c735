# Draws how two systems came to their verdicts, over the reach and the distance, as SVG. Files, in
# this order: particles.csv, obstacles.csv, what `verify --csv` wrote for the plan (a constant
# bound) and for lanes with a running bound. Of what a lane decided, one in eight is drawn.
BEGIN { FS = ","; side = 300; farthest = 40 }

FNR == 1 { file++; for (k = 1; k <= NF; k++) if (file > 2) column[$k] = k; next }
file == 1 { x[FNR - 2] = $1; y[FNR - 2] = $2; t[FNR - 2] = $3; next }
file == 2 {
  j = FNR - 2
  ox[j] = $1; oy[j] = $2; vx[j] = $3; vy[j] = $4; d[j] = $5
  next
}

{
  i = $column["i"]; j = $column["j"]
  kind = $column["recomputed"] == 1 ? "recomputed" : $column["verdict"]
  n = total[file, kind]++
  distance = sqrt((x[i] - ox[j] - vx[j] * t[i])^2 + (y[i] - oy[j] - vy[j] * t[i])^2)
  if (distance > farthest || (kind == "greater" && n % 8 != 0)) next
  points[file, kind] = points[file, kind] sprintf("M%.1f,%.1fh0", across(d[j]), upward(distance))
}

function across(reach) { return side * reach / 11 }
function upward(distance) { return side * (1 - distance / farthest) }

function dots(file, kind, colour, size) {
  printf "<path stroke=\"%s\" stroke-width=\"%s\" stroke-linecap=\"round\" d=\"%s\"/>\n", \
         colour, size, points[file, kind]
}

function legend(y, colour, words) {
  printf "<path stroke=\"%s\" stroke-width=\"6\" stroke-linecap=\"round\" d=\"M8,%dh0\"/>\n", \
         colour, y
  printf "<text x=\"20\" y=\"%d\">%s</text>\n", y + 4, words
}

function panel(file, left, title,   k) {
  printf "<g transform=\"translate(%d,34)\">\n", left
  printf "<text x=\"%d\" y=\"-12\" text-anchor=\"middle\" font-weight=\"bold\">%s</text>\n", \
         side / 2, title
  dots(file, "greater", "#aaa", 2.2)
  dots(file, "less", "#2f6fb0", 3)
  dots(file, "recomputed", "#e07b1a", 3)
  printf "<path stroke=\"#333\" d=\"M0,%d L%.1f,%.1f\"/>\n", side, across(11), upward(11)
  printf "<rect width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#333\"/>\n", side, side
  for (k = 0; k <= 10; k += 5)
    printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%d</text>\n", across(k), side + 16, k
  for (k = 0; k <= farthest; k += 10)
    printf "<text x=\"-6\" y=\"%.1f\" text-anchor=\"end\">%d</text>\n", upward(k) + 4, k
  printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">reach d</text>\n", side / 2, side + 34
  print "<g transform=\"translate(30,350)\">"
  legend(0, "#2f6fb0", total[file, "less"] + 0 " decided: within reach")
  legend(18, "#aaa", total[file, "greater"] + 0 " decided: farther away")
  legend(36, "#e07b1a", total[file, "recomputed"] + 0 " recomputed")
  print "</g></g>"
}

END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 730 440\" " \
        "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<title>Which comparisons a constant and a running bound leave to the reference</title>"
  print "<rect x=\"0\" y=\"0\" width=\"730\" height=\"440\" fill=\"#fff\"/>"
  print "<text transform=\"translate(18,184) rotate(-90)\" text-anchor=\"middle\">distance</text>"
  panel(3, 58, "constant bound (the plan)")
  panel(4, 414, "running bound of 4 digits")
  print "</svg>"
}
