# The atoms of a PDB file in thousandths of an angstrom, which are the file's own digits, as CSV.
#   awk -f atoms.awk ../protein_clash/1A8O.pdb > atoms.csv
/^(ATOM  |HETATM)/ {
  for (c = 0; c < 3; ++c) {
    text = substr($0, 31 + 8 * c, 8)
    gsub(/[. ]/, "", text)
    printf "%d%s", text, c < 2 ? "," : "\n"
  }
}
/^ENDMDL/ { exit }
BEGIN { print "x,y,z" }
