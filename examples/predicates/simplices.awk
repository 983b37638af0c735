# Tetrahedra of four consecutive atoms, a to d, as CSV, or with `-v plane=1` triangles of three,
# seen from above. b and c are exchanged where that makes the orientation positive.
#   awk -f simplices.awk atoms.csv > tetrahedra.csv
#   awk -v plane=1 -f simplices.awk atoms.csv > triangles.csv
BEGIN { FS = ","; print plane ? "ax,ay,bx,by,cx,cy" : "ax,ay,az,bx,by,bz,cx,cy,cz,dx,dy,dz" }
function orientation(a, b, c, d) {
  return (x[a] - x[d]) * ((y[b] - y[d]) * (z[c] - z[d]) - (z[b] - z[d]) * (y[c] - y[d])) + \
         (x[b] - x[d]) * ((y[c] - y[d]) * (z[a] - z[d]) - (z[c] - z[d]) * (y[a] - y[d])) + \
         (x[c] - x[d]) * ((y[a] - y[d]) * (z[b] - z[d]) - (z[a] - z[d]) * (y[b] - y[d]))
}
function orientation_in_plane(a, b, c) {
  return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])
}
function place(k) { return x[k] "," y[k] (plane ? "" : "," z[k]) }
NR > 1 { x[NR - 2] = $1; y[NR - 2] = $2; z[NR - 2] = $3 }
END {
  for (k = 0; k + 3 < NR - 1; ++k) {
    b = k + 1; c = k + 2
    turned = plane ? orientation_in_plane(k, b, c) : orientation(k, b, c, k + 3)
    if (turned < 0) { b = k + 2; c = k + 1 }
    print place(k) "," place(b) "," place(c) (plane ? "" : "," place(k + 3))
  }
}
