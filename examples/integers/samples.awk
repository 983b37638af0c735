# Samples of a receiver, i and q in int12, as CSV: Gaussian noise of 120 steps on each, and a tone
# of 600 in every fourth run of 64 samples. Random numbers: x -> 16807 x mod 2^31 - 1, from 1 on.
#   awk -f samples.awk > samples.csv
function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
function nearest(x) { return sprintf("%.0f", x) + 0 }
BEGIN {
  pi = 3.14159265358979; state = 1
  print "i,q"
  for (n = 0; n < 8192; ++n) {
    radius = 120 * sqrt(-2 * log(uniform())); angle = 2 * pi * uniform()
    tone = int(n / 64) % 4 == 3 ? 600 : 0
    i = nearest(tone * cos(n) + radius * cos(angle))
    print i "," nearest(tone * sin(n) + radius * sin(angle))
  }
}
