# Pairs of muons as a trigger sees them, by a simple model: transverse momenta fall exponentially
# from 3 GeV (mean 12), pseudorapidities are uniform in [-2.4, 2.4], azimuths in [-pi, pi].
#   awk -v seed=1 -v count=5000 -f events.awk >events.csv
# rand() is Park and Miller's generator (CACM 31, 1988), so that any awk gives the same.
function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
function momentum(    p) { do p = 3 - 12 * log(uniform()); while (p >= 64); return p }
BEGIN {
  state = seed
  pi = atan2(0, -1)
  print "pt1,eta1,phi1,pt2,eta2,phi2"
  for (k = 0; k < count; ++k) {
    for (muon = 0; muon < 2; ++muon) {
      printf "%s%.9g,%.9g,%.9g", muon ? "," : "", momentum(), 4.8 * uniform() - 2.4, 2 * pi * uniform() - pi
    }
    printf "\n"
  }
}
