# Expectation-maximisation of a mixture of two Gaussians in two dimensions (Dempster, Laird and Rubin 1977), in double.
# Every iteration's parameters become a row, in the form in which a posterior is compared:
#
#   log(weight) - log(det S) / 2 - (x - m)' S^-1 (x - m) / 2  =  c - (p u^2 + q u v + r v^2),  (u, v) = x - m
#
#   awk -v iterations=40 -f record.awk geyser.csv
#
# Columns for component 1 and again for component 2: c, p, q, r, m_0, m_1.

function log_posterior(k, n,    u, v) {
  u = x[n] - mx[k]; v = y[n] - my[k]
  return c[k] - (p[k] * u * u + q[k] * u * v + r[k] * v * v)
}
function put_form(k,    det) {
  det = sxx[k] * syy[k] - sxy[k] * sxy[k]
  c[k] = log(weight[k]) - log(det) / 2
  p[k] = syy[k] / det / 2; q[k] = -sxy[k] / det; r[k] = sxx[k] / det / 2
}
function expectation(    n, ratio) {
  for (n = 0; n < count; ++n) {
    ratio = exp(log_posterior(2, n) - log_posterior(1, n))
    share[1, n] = 1 / (1 + ratio); share[2, n] = ratio / (1 + ratio)
  }
}
function maximisation(    k, n, sum, u, v) {
  for (k = 1; k <= 2; ++k) {
    sum = mx[k] = my[k] = sxx[k] = sxy[k] = syy[k] = 0
    for (n = 0; n < count; ++n) { sum += share[k, n]; mx[k] += share[k, n] * x[n]; my[k] += share[k, n] * y[n] }
    mx[k] /= sum; my[k] /= sum; weight[k] = sum / count
    for (n = 0; n < count; ++n) {
      u = x[n] - mx[k]; v = y[n] - my[k]
      sxx[k] += share[k, n] * u * u / sum; sxy[k] += share[k, n] * u * v / sum; syy[k] += share[k, n] * v * v / sum
    }
  }
}
function record(    k, line) {
  for (k = 1; k <= 2; ++k) {
    line = line sprintf("%s%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", k == 1 ? "" : ",", c[k], p[k], q[k], r[k], mx[k], my[k])
  }
  print line
}

BEGIN { FS = ","; print "c1,p1,q1,r1,m1_0,m1_1,c2,p2,q2,r2,m2_0,m2_1" }
FNR > 1 { x[count] = $1; y[count] = $2; ++count }
END {
  for (k = 1; k <= 2; ++k) { weight[k] = 0.5; sxx[k] = 1; sxy[k] = 0; syy[k] = 200 }
  mx[1] = 3; my[1] = 70; mx[2] = 4; my[2] = 71  # a poor guess, so that something is to be learnt
  for (step = 0; step < iterations; ++step) {
    put_form(1); put_form(2); record(); expectation(); maximisation()
  }
  printf "means (%.4f, %.4f) and (%.4f, %.4f), weights %.4f and %.4f\n", mx[1], my[1], mx[2], my[2], weight[1], weight[2] > "/dev/stderr"
}
