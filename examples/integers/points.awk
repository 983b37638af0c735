# The atoms of a protein as seen from above, in tenths of an angstrom, as CSV; or with `-v lines=1`
# the lines through consecutive alpha carbons, from a to b.
#   awk -f points.awk ../protein_clash/1A8O.pdb > points.csv
#   awk -v lines=1 -f points.awk ../protein_clash/1A8O.pdb > lines.csv
function tenths(column) { return sprintf("%d", 10 * substr($0, column, 8) + 0.5) }
BEGIN { print lines ? "ax,ay,bx,by" : "x,y" }
/^(ATOM  |HETATM)/ {
  point = tenths(31) "," tenths(39)
  if (!lines) print point
  else if (substr($0, 13, 4) == " CA ") {
    if (before != "") print before "," point
    before = point
  }
}
/^ENDMDL/ { exit }
