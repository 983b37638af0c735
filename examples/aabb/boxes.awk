# The axis-aligned box of every residue (waters are residues, too) of a PDB file: all of its atoms, each a
# ball of its van der Waals radius (Bondi 1964), in angstrom. Of several models the first; alternate
# locations all count.
#   awk -f boxes.awk ../protein_clash/1A8O.pdb > boxes.csv
BEGIN {
  radius["H"] = 1.20; radius["C"] = 1.70; radius["N"] = 1.55
  radius["O"] = 1.52; radius["S"] = 1.80; radius["SE"] = 1.90
}

/^ENDMDL/ { exit }

/^(ATOM  |HETATM)/ {
  element = substr($0, 77, 2)
  gsub(/ /, "", element)
  if (!(element in radius)) {
    printf "boxes.awk: line %d: no radius for element \"%s\"\n", NR, element > "/dev/stderr"
    failed = 1
    exit 1
  }
  residue = substr($0, 22, 6) " " substr($0, 18, 3)
  gsub(/ +/, " ", residue)
  if (!(residue in known)) order[count++] = residue
  for (k = 0; k < 3; ++k) {
    centre = substr($0, 31 + 8 * k, 8) + 0
    low = centre - radius[element]
    high = centre + radius[element]
    if (!(residue in known) || low < lo[residue, k]) lo[residue, k] = low
    if (!(residue in known) || high > hi[residue, k]) hi[residue, k] = high
  }
  known[residue] = 1
}

END {
  if (failed) exit 1
  print "residue,lo_0,lo_1,lo_2,hi_0,hi_1,hi_2"
  for (n = 0; n < count; ++n) {
    r = order[n]
    printf "%s,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f\n", r, lo[r, 0], lo[r, 1], lo[r, 2], hi[r, 0], hi[r, 1], hi[r, 2]
  }
}
