# Atoms that may have decayed: a uniform number, the time that was waited, and the half-life of one of
# 24 nuclides (NUBASE 2020, rounded), both in days. The time of every other atom is near its
# half-life, the others' is any time.
#   awk -v seed=1 -v count=5000 -f decay.awk >decay.csv
# rand() is Park and Miller's generator (CACM 31, 1988), so that any awk gives the same.
function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
BEGIN {
  state = seed
  # Po-212, Po-214, Po-215, Po-216, Rn-219, Rn-220, Po-218, Bi-214, Pb-214, Bi-212, F-18, Tc-99m
  seconds = "2.95e-7 1.635e-4 1.781e-3 0.144 3.96 55.6 185.8 1194 1624 3633 6586 21624"
  # Pb-212, Na-24, Rn-222, I-131, P-32, Th-234, Co-60, H-3, Sr-90, Cs-137, Ra-226, C-14
  seconds = seconds " 38200 53850 330230 693377 1232755 2082240 166344192 388781623 911996928"
  nuclides = split(seconds " 949252608 50492160000 179877600000", half_life, " ")
  print "u,t,h"
  for (k = 0; k < count; ++k) {
    h = half_life[1 + int(nuclides * uniform())] / 86400
    t = k % 2 ? h * exp(4 * uniform() - 2) : 1e-12 * exp(log(1e19) * uniform())
    printf "%.9g,%.9g,%.9g\n", uniform(), t, h
  }
}
