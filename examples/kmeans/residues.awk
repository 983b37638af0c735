# The centres of the residues of a PDB file (waters left out): the mean of their atoms, as CSV.
#   awk -f residues.awk ../protein_clash/1A8O.pdb > residues.csv
/^(ATOM  |HETATM)/ && substr($0, 18, 3) != "HOH" {
  residue = substr($0, 22, 6)  # chain, number, insertion code
  if (!(residue in atoms)) order[++n] = residue
  ++atoms[residue]
  for (c = 0; c < 3; ++c) sum[residue, c] += substr($0, 31 + 8 * c, 8)
}
/^ENDMDL/ { exit }
END {
  print "x,y,z"
  for (k = 1; k <= n; ++k) {
    r = order[k]
    printf "%.6f,%.6f,%.6f\n", sum[r, 0] / atoms[r], sum[r, 1] / atoms[r], sum[r, 2] / atoms[r]
  }
}
