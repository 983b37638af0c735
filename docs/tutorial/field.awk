# Draws obstacles.csv and particles.csv, in this order, as SVG: a square of 100 by 100.
BEGIN {
  FS = ","
  side = 420
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 450\" " \
        "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<title>1000 particles and 400 moving obstacles</title>"
  print "<defs><marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" " \
        "markerWidth=\"6\" markerHeight=\"6\" orient=\"auto\">" \
        "<path d=\"M0,1 L10,5 L0,9 z\" fill=\"#c05a10\"/></marker>" \
        "<clipPath id=\"inside\">" \
        "<rect x=\"15\" y=\"15\" width=\"420\" height=\"420\"/></clipPath></defs>"
  print "<rect x=\"0\" y=\"0\" width=\"700\" height=\"450\" fill=\"#fff\"/>"
  print "<g clip-path=\"url(#inside)\">"
}

function across(x) { return 15 + side * x / 100 }
function upward(y) { return 15 + side * (1 - y / 100) }

FNR == 1 { file++; next }

file == 1 {
  printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#fdeedd\" stroke=\"#c05a10\"/>\n", \
         across($1), upward($2), side * $5 / 100
  arrows = arrows sprintf("<path stroke=\"#c05a10\" marker-end=\"url(#arrow)\" " \
                          "d=\"M%.1f,%.1f L%.1f,%.1f\"/>\n", across($1), upward($2), \
                          across($1 + 10 * $3), upward($2 + 10 * $4))
  next
}

{ points = points sprintf("M%.1f,%.1fh0", across($1), upward($2)) }

END {
  print arrows
  print "<path stroke=\"#335\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"" points "\"/>"
  print "</g>"
  print "<rect x=\"15\" y=\"15\" width=\"420\" height=\"420\" fill=\"none\" stroke=\"#333\"/>"
  print "<path stroke=\"#335\" stroke-width=\"4\" stroke-linecap=\"round\" d=\"M468,40h0\"/>"
  print "<text x=\"488\" y=\"44\">particle i: seen at (x, y)</text>"
  print "<text x=\"488\" y=\"60\">at a time t of its own</text>"
  print "<circle cx=\"468\" cy=\"92\" r=\"11\" fill=\"#fdeedd\" stroke=\"#c05a10\"/>"
  print "<text x=\"488\" y=\"90\">obstacle j: centre (ox, oy)</text>"
  print "<text x=\"488\" y=\"106\">at time 0, reach d</text>"
  print "<path stroke=\"#c05a10\" marker-end=\"url(#arrow)\" d=\"M457,136 L480,136\"/>"
  print "<text x=\"488\" y=\"140\">its way until time 10</text>"
  print "<text x=\"488\" y=\"156\">at velocity (vx, vy)</text>"
  print "</svg>"
}
