# Lloyd's algorithm on the numeric columns of a CSV file with a header: prints the centres as CSV.
#   awk -v k=3 -v columns=4 -v rounds=100 -f lloyd.awk iris.csv > centres.csv
# The first centres are rows 0, n/k, 2n/k, ...; each round gives every row to its nearest centre (the
# first of equals) and moves each centre to the mean of its rows. It stops after `rounds`, or when no
# row changes its centre; the last line on stderr says which.
BEGIN { FS = "," }
NR > 1 { for (c = 1; c <= columns; ++c) point[NR - 2, c] = $c; n = NR - 1 }
END {
  for (j = 0; j < k; ++j)
    for (c = 1; c <= columns; ++c) centre[j, c] = point[int(j * n / k), c]
  for (round = 1; round <= rounds; ++round) {
    changed = assign()
    if (changed == 0) break
    move()
  }
  for (c = 1; c <= columns; ++c) printf "c_%d%s", c - 1, c < columns ? "," : "\n"
  for (j = 0; j < k; ++j)
    for (c = 1; c <= columns; ++c) printf "%.17g%s", centre[j, c], c < columns ? "," : "\n"
  if (changed == 0) print "converged after " round - 1 " rounds" > "/dev/stderr"
  else print "stopped after " rounds " rounds" > "/dev/stderr"
}

function assign(    row, j, c, best, least, distance, changes) {
  for (row = 0; row < n; ++row) {
    for (j = 0; j < k; ++j) {
      distance = 0
      for (c = 1; c <= columns; ++c) distance += (point[row, c] - centre[j, c]) ^ 2
      if (j == 0 || distance < least) { best = j; least = distance }
    }
    if (!(row in owner) || owner[row] != best) ++changes
    owner[row] = best
  }
  return changes + 0
}

function move(    row, j, c, rows, sum) {
  for (row = 0; row < n; ++row) {
    ++rows[owner[row]]
    for (c = 1; c <= columns; ++c) sum[owner[row], c] += point[row, c]
  }
  for (j = 0; j < k; ++j)
    for (c = 1; c <= columns; ++c) if (rows[j] > 0) centre[j, c] = sum[j, c] / rows[j]
}
