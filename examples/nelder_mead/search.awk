# Nelder and Mead's simplex search (Computer Journal 7, 1965) in two dimensions, in double: the form and the
# coefficients of Lagarias et al. 1998 (SIAM J. Optim. 9, 112).
#
#   awk -v objective=rosenbrock -v starts=6 -f search.awk
#
# Every comparison of the objective at two points becomes a row: start (which search), step (which iteration), xa, ya,
# xb, yb, and less (1: the search found objective(xa, ya) < objective(xb, yb)). The order of operations is that of the
# scenes, so that a reference in binary64 decides as the search did. What each search came to goes to stderr.
#
# With -v digits=24 the search decides by 24 digits alone: every result of the objective is rounded to so many. A line for
# each search then says where it first decides otherwise than in double, and what it came to. With -v digits=24 -v follow=double the
# search goes on as in double, and the lines count how often 24 digits would have decided otherwise.

# To nearest, by Veltkamp's splitting.
function r(x,    c) { if (digits == 53) return x; c = splitter * x; return c - (c - x) }
function value(x, y,    s, t) {
  if (objective == "rosenbrock") { s = r(1 - x); t = r(r(y) - r(x * x)); return r(r(s * s) + r(100 * r(t * t))) }
  if (objective == "himmelblau") {
    s = r(r(r(x * x) + r(y)) - 11); t = r(r(r(x) + r(y * y)) - 7); return r(r(s * s) + r(t * t))
  }
  s = r(x * x); t = r(y * y)  # six-hump camel
  s = r(r(r(r(4 - r(r(2.1) * s)) + r(r(1 / 3) * r(s * s))) * s) + r(x * y))
  return r(s + r(r(r(4 * t) - 4) * t))
}
function value_in_double(x, y,    kept, result) {
  kept = digits; digits = 53; result = value(x, y); digits = kept
  return result
}

# Points 0, 1, 2 are the simplex, best first; 3 to 5 are candidates.
function sign(number) { return (number > 0) - (number < 0) }
function less(a, b,    is, would) {
  ++comparisons
  is = sign(value_in_double(x[a], y[a]) - value_in_double(x[b], y[b]))
  if (digits == 53) {
    printf "%d,%d,%.17g,%.17g,%.17g,%.17g,%d\n", start, step, x[a], y[a], x[b], y[b], is < 0
    return is < 0
  }
  would = sign(value(x[a], y[a]) - value(x[b], y[b]))
  misjudged += would != is  # ties that are none included
  if ((would < 0) != (is < 0) && !others++) first = sprintf("step %d, comparison %d", step, comparisons)
  return (follow == "double" ? is : would) < 0
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
  if (!digits) digits = 53
  splitter = 2 ^ (53 - digits) + 1
  if (digits == 53) print "start,step,xa,ya,xb,yb,less"
  for (start = 0; start < starts; ++start) {
    step = comparisons = others = 0; first = "never"
    x[0] = 4 * uniform() - 2; y[0] = 4 * uniform() - 2
    x[1] = x[0] + 0.5; y[1] = y[0]
    x[2] = x[0]; y[2] = y[0] + 0.5
    sift(1); sift(2)
    for (step = 1; step <= 200 && extent() > 1e-6; ++step) iterate()
    line = sprintf("%s, start %d: %d steps to (%.6f, %.6f), objective %.3g", objective, start, step - 1, x[0], y[0], value_in_double(x[0], y[0]))
    if (digits == 53) { print line > "/dev/stderr"; continue }
    printf "%s; in %d digits %d of %d otherwise, first at %s\n", line, digits, others, comparisons, first
  }
  if (digits < 53) printf "%s, %d digits: %d comparisons misjudged\n", objective, digits, misjudged
}
