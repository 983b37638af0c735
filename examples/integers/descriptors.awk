# Descriptors of atoms, as CSV: how many other atoms there are in each of 16 shells of one angstrom
# around the atom, less the mean of all atoms, in int8.
#   awk -f descriptors.awk ../predicates/atoms.csv > descriptors.csv
function nearest(x) { return sprintf("%.0f", x) + 0 }
BEGIN { FS = ","; shells = 16 }
NR > 1 { x[NR - 1] = $1 / 1000; y[NR - 1] = $2 / 1000; z[NR - 1] = $3 / 1000; n = NR - 1 }
END {
  for (i = 1; i <= n; ++i)
    for (j = 1; j <= n; ++j) {
      shell = int(sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2 + (z[i] - z[j])^2))
      if (i != j && shell < shells) { ++count[i, shell]; ++sum[shell] }
    }
  for (shell = 0; shell < shells; ++shell) printf "d_%d%s", shell, shell < shells - 1 ? "," : "\n"
  for (i = 1; i <= n; ++i)
    for (shell = 0; shell < shells; ++shell)
      printf "%s%s", nearest(count[i, shell] - sum[shell] / n), shell < shells - 1 ? "," : "\n"
}
