# The mixtures of two Gaussians that expectation-maximisation goes through, on the durations of
# ../em/geyser.csv, from all pairs of starting means of a grid:
#   awk -F, -f em.awk ../em/geyser.csv >mixtures.csv
# w is a component's weight, m its mean, t one over its standard deviation.
function density(x, w, m, t) { return w * t * exp(-((x - m) * t) ^ 2 / 2) }
function run(m1, m2,    w1, t1, w2, t2, step, k, a, p, n1, s1, q1, n2, s2, q2) {
  w1 = w2 = 0.5
  t1 = t2 = 2
  for (step = 0; step < 12; ++step) {
    printf "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", w1, m1, t1, w2, m2, t2
    n1 = s1 = q1 = n2 = s2 = q2 = 0
    for (k = 1; k <= points; ++k) {
      a = density(x[k], w1, m1, t1)
      p = a / (a + density(x[k], w2, m2, t2))
      n1 += p; s1 += p * x[k]; q1 += p * x[k] ^ 2
      n2 += 1 - p; s2 += (1 - p) * x[k]; q2 += (1 - p) * x[k] ^ 2
    }
    w1 = n1 / points; m1 = s1 / n1; t1 = 1 / sqrt(q1 / n1 - m1 ^ 2)
    w2 = n2 / points; m2 = s2 / n2; t2 = 1 / sqrt(q2 / n2 - m2 ^ 2)
  }
}
NR > 1 { x[++points] = $1 }
END {
  print "w1,m1,t1,w2,m2,t2"
  for (first = 1.75; first < 5; first += 0.5) {
    for (second = first + 0.5; second < 5; second += 0.5) run(first, second)
  }
}
