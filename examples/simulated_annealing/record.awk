# Simulated annealing of a travelling salesman's tour (Kirkpatrick, Gelatt and Vecchi, Science 220, 1983) by 2-opt moves
# (Lin 1965), in double: a tour a, b, ..., c, d becomes a, c, ..., b, d where
#
#   E_new - E_old = |ac| + |bd| - |ab| - |cd|  <=  T w,  w = -ln(uniform),
#
# which is the rule "with probability exp(-(E_new - E_old) / T)" without an exponential.
#
#   awk -v moves=200000 -v every=50 -f record.awk geyser.csv
#
# Cities are the file's points. Every `every`-th decision becomes a row: the two coordinates of a, b, c and d, T and w, and accepted (1: the move was).

function length_of(p, q,    dx, dy) { dx = x[p] - x[q]; dy = y[p] - y[q]; return sqrt(dx * dx + dy * dy) }
# Lehmer's generator with Park and Miller's constants: exact in double, the same everywhere.
function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
function record() {
  printf "%d,%s,%s,%s,%s,%s,%s,%s,%s,%.17g,%.17g,%d\n", move, x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d], temperature, w, accept
}
function reverse(from, to,    city) {
  while (from < to) { city = tour[from]; tour[from++] = tour[to]; tour[to--] = city }
}
function tour_length(    k, sum) {
  for (k = 0; k < cities; ++k) sum += length_of(tour[k], tour[(k + 1) % cities])
  return sum
}

BEGIN { FS = ","; seed = 20261120; print "move,ax,ay,bx,by,cx,cy,dx,dy,temperature,w,accepted" }
FNR > 1 { x[cities] = $1; y[cities] = $2; tour[cities] = cities; ++cities }
END {
  printf "%d cities, tour of %.1f", cities, tour_length() > "/dev/stderr"
  for (move = 1; move <= moves; ++move) {
    temperature = 10 * exp(-8 * move / moves)
    first = int(uniform() * (cities - 2))
    last = first + 2 + int(uniform() * (cities - 2 - first))
    a = tour[first]; b = tour[first + 1]; c = tour[last]; d = tour[(last + 1) % cities]
    w = -log(uniform())
    accept = length_of(a, c) + length_of(b, d) - (length_of(a, b) + length_of(c, d)) <= temperature * w
    if (move % every == 0) record()
    if (accept) { reverse(first + 1, last); ++accepted }
  }
  printf " becomes one of %.1f, %d of %d moves accepted\n", tour_length(), accepted, moves > "/dev/stderr"
}
