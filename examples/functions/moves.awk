# Turns the recorded moves of examples/simulated_annealing into those of a Metropolis test:
#   awk -F, -f moves.awk ../simulated_annealing/tour.csv >moves.csv
# u = exp(-w) is the uniform random number that the run drew.
NR == 1 { print "move,ax,ay,bx,by,cx,cy,dx,dy,temperature,u,accepted"; next }
{
  printf "%s", $1
  for (k = 2; k <= 9; ++k) printf ",%s", $k
  printf ",%s,%.17g,%s\n", $10, exp(-$11), $12
}
