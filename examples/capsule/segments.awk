# The protein's backbone as capsules: a segment from each alpha carbon to the next of the chain, of the carbon's van der
# Waals radius (1.70 angstrom, Bondi 1964).
#
#   awk -f segments.awk ../protein_clash/1A8O.pdb
#
# Columns: residue (the number of the first), a_0 .. a_2 and b_0 .. b_2 (the ends), s (the radius).

function number(column) { return substr($0, column, 8) + 0 }

BEGIN { print "residue,a_0,a_1,a_2,b_0,b_1,b_2,s" }
/^ENDMDL/ { exit }
(/^ATOM/ || /^HETATM/) && substr($0, 13, 4) == " CA " && substr($0, 17, 1) ~ /[ A]/ {
  residue = substr($0, 23, 4) + 0
  point = number(31) "," number(39) "," number(47)
  if (residue == last + 1) print last "," before "," point ",1.7"
  last = residue; before = point
}
