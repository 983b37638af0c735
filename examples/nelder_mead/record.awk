# Nelder and Mead's simplex search (Computer Journal 7, 1965) in two dimensions, in double: the form and
# the coefficients of Lagarias et al. 1998 (SIAM J. Optim. 9, 112). Every comparison of the objective at two points that a
# search makes becomes a row: is objective(xa, ya) less than objective(xb, yb)?
#
#   awk -v objective=rosenbrock -v starts=12 -f record.awk
#
# Columns: start (which search), step (which iteration), xa, ya, xb, yb. The order of operations in `value` is
# that of the scenes, so that a reference in binary64 decides as this search did.

function value(x, y,    s, t) {
  if (objective == "rosenbrock") { s = 1 - x; t = y - x * x; return s * s + 100 * (t * t) }
  if (objective == "himmelblau") { s = x * x + y - 11; t = x + y * y - 7; return s * s + t * t }
  s = x * x; t = y * y  # six-hump camel
  return (4 - 2.1 * s + (1 / 3) * (s * s)) * s + x * y + (4 * t - 4) * t
}

# Points 0, 1, 2 are the simplex, best first; 3 to 5 are candidates.
function less(a, b) {
  printf "%d,%d,%.17g,%.17g,%.17g,%.17g\n", start, step, x[a], y[a], x[b], y[b]
  return value(x[a], y[a]) < value(x[b], y[b])
}
function copy(to, from) { x[to] = x[from]; y[to] = y[from] }
function place(point, share) {  # on the line from the worst vertex through the centre of the others
  x[point] = cx + share * (cx - x[2]); y[point] = cy + share * (cy - y[2])
}
function sift(last,    k) {  # a vertex moves up while it is better than its neighbour
  for (k = last; k > 0 && less(k, k - 1); --k) { copy(6, k); copy(k, k - 1); copy(k - 1, 6) }
}
function shrink(    k) {
  for (k = 1; k <= 2; ++k) { x[k] = x[0] + 0.5 * (x[k] - x[0]); y[k] = y[0] + 0.5 * (y[k] - y[0]) }
  sift(1); sift(2)
}
function accept(point) { copy(2, point); sift(2) }
function iterate() {
  cx = 0.5 * (x[0] + x[1]); cy = 0.5 * (y[0] + y[1])
  place(3, 1)  # reflection
  if (less(3, 0)) {
    place(4, 2)  # expansion
    accept(less(4, 3) ? 4 : 3)
  } else if (less(3, 1)) {
    accept(3)
  } else if (less(3, 2)) {
    place(5, 0.5)  # contraction outside: no worse than the reflection
    if (less(3, 5)) shrink(); else accept(5)
  } else {
    place(5, -0.5)  # contraction inside
    if (less(5, 2)) accept(5); else shrink()
  }
}
function extent(    k, d, e) {
  for (k = 1; k <= 2; ++k) {
    d = x[k] - x[0]; if (d < 0) d = -d; if (d > e) e = d
    d = y[k] - y[0]; if (d < 0) d = -d; if (d > e) e = d
  }
  return e
}
# Lehmer's generator with Park and Miller's constants: exact in double, the same everywhere.
function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }

BEGIN {
  seed = 20261120
  print "start,step,xa,ya,xb,yb"
  for (start = 0; start < starts; ++start) {
    step = 0
    x[0] = 4 * uniform() - 2; y[0] = 4 * uniform() - 2
    x[1] = x[0] + 0.5; y[1] = y[0]
    x[2] = x[0]; y[2] = y[0] + 0.5
    sift(1); sift(2)
    for (step = 1; step <= 200 && extent() > 1e-6; ++step) iterate()
    printf "%s, start %d: %d steps, x = %.9f, y = %.9f, value %.3g\n", objective, start, step - 1, x[0], y[0], value(x[0], y[0]) > "/dev/stderr"
  }
}
