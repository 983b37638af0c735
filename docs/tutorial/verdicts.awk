# Draws how a system came to its verdicts, over the reach and the distance, as SVG. Files, in this
# order: particles.csv, obstacles.csv, and the table that `verify --csv` wrote. One in eight of the
# pairs that a lane found farther away is drawn.
BEGIN { FS = ","; side = 300; farthest = 8; longest = 2.2 }

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
  n = total[kind]++
  distance = sqrt((x[i] - ox[j] - vx[j] * t[i])^2 + (y[i] - oy[j] - vy[j] * t[i])^2)
  if (distance > farthest || (kind == "greater" && n % 8 != 0)) next
  points[kind] = points[kind] sprintf("M%.1f,%.1fh0", across(d[j]), upward(distance))
}

function across(reach) { return side * reach / longest }
function upward(distance) { return side * (1 - distance / farthest) }

function dots(kind, colour, size) {
  printf "<path stroke=\"%s\" stroke-width=\"%s\" stroke-linecap=\"round\" d=\"%s\"/>\n", \
         colour, size, points[kind]
}

function legend(y, colour, words) {
  printf "<path stroke=\"%s\" stroke-width=\"6\" stroke-linecap=\"round\" d=\"M8,%dh0\"/>\n", \
         colour, y
  printf "<text x=\"20\" y=\"%d\">%s</text>\n", y + 4, words
}

END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\" " \
        "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<title>Which comparisons lanes of six bits leave to the reference</title>"
  print "<rect x=\"0\" y=\"0\" width=\"600\" height=\"400\" fill=\"#fff\"/>"
  print "<text transform=\"translate(18,170) rotate(-90)\" text-anchor=\"middle\">distance</text>"
  print "<g transform=\"translate(58,20)\">"
  dots("greater", "#aaa", 2.2)
  dots("less", "#2f6fb0", 3)
  dots("recomputed", "#e07b1a", 2.2)
  printf "<path stroke=\"#333\" d=\"M0,%d L%.1f,%.1f\"/>\n", side, side, upward(longest)
  printf "<rect width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#333\"/>\n", side, side
  for (k = 0; k <= 2; k++)
    printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%d</text>\n", across(k), side + 16, k
  for (k = 0; k <= farthest; k += 2)
    printf "<text x=\"-6\" y=\"%.1f\" text-anchor=\"end\">%d</text>\n", upward(k) + 4, k
  printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">reach d</text>\n", side / 2, side + 34
  print "<g transform=\"translate(315,30)\">"
  legend(0, "#2f6fb0", total["less"] + 0 " decided: within reach")
  legend(18, "#aaa", total["greater"] + 0 " decided: farther away")
  legend(36, "#e07b1a", total["recomputed"] + 0 " recomputed")
  print "</g></g></svg>"
}
