#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x8 * x9;
t = (x8 - e8) * (x9 - e9);
{ x8 in [0, 8191b-12] /\
  e8 in [-1b-12, 0] /\
  x9 in [0, 8191b-12] /\
  e9 in [-1b-12, 0]
  ->
  c in [0, 67092481b-24] /\
  c - t in [-16383b-24, 0] }
c - t -> x8 * e9 + x9 * e8 - e8 * e9;
