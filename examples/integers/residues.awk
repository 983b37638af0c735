# Atoms in thousandths of an angstrom around their mean, in int16, as CSV; or with `-v residues=1`
# the protein's residues: the mean m of their atoms, and on each axis a weight w in uint16, 2^33
# divided by the variance, at most 65535.
#   awk -f residues.awk ../protein_clash/1A8O.pdb > atoms.csv
#   awk -v residues=1 -f residues.awk ../protein_clash/1A8O.pdb > residues.csv
function nearest(x) { return sprintf("%.0f", x) + 0 }
function mean(r, axis) { return sum[r, axis] / size[r] }
function weight(r, axis,    variance, w) {
  variance = squares[r, axis] / size[r] - mean(r, axis)^2
  w = variance > 0 ? 2^33 / variance : 65535
  return w < 65535 ? w : 65535
}
/^ATOM/ || /^HETATM/ && substr($0, 18, 3) != "HOH" {
  residue = substr($0, 22, 6)
  if (residue != before) { ++count; before = residue }
  ++atoms; of[atoms] = count; ++size[count]
  for (axis = 0; axis < 3; ++axis) {
    place[atoms, axis] = 1000 * substr($0, 31 + 8 * axis, 8)
    all[axis] += place[atoms, axis]
  }
}
/^ENDMDL/ { exit }
END {
  for (n = 1; n <= atoms; ++n)
    for (axis = 0; axis < 3; ++axis) {
      x = place[n, axis] = nearest(place[n, axis] - all[axis] / atoms)
      sum[of[n], axis] += x; squares[of[n], axis] += x * x
    }
  print residues ? "m_0,m_1,m_2,w_0,w_1,w_2" : "x_0,x_1,x_2"
  if (!residues) for (n = 1; n <= atoms; ++n) print place[n, 0] "," place[n, 1] "," place[n, 2]
  else
    for (r = 1; r <= count; ++r)
      print nearest(mean(r, 0)) "," nearest(mean(r, 1)) "," nearest(mean(r, 2)) "," \
        nearest(weight(r, 0)) "," nearest(weight(r, 1)) "," nearest(weight(r, 2))
}
