# Doubles next to (0.5, 0.5), on and beside the line through (12, 12) and (24, 24), as CSV, exactly.
# They are a part of the data of Kettner, Mehlhorn, Pion, Schirra and Yap, Classroom Examples of
# Robustness Problems in Geometric Computations (2008).
#   awk -f near_a_line.awk > near_a_line.csv
function near_half(k) { return sprintf("0x1.%013xp-1", k) }  # 1/2 and k last places
BEGIN {
  print "x,y"
  for (i = 0; i < 64; ++i)
    for (k = 0; k < 64; ++k) print near_half(i) "," near_half(k)
}
