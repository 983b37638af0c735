#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x13 - x14;
t = (x13 - e13) - (x14 - e14);
{ x13 in [0, 1800] /\
  e13 in [0, 0] /\
  x14 in [0, 2047] /\
  e14 in [0, 0]
  ->
  c in [-2047, 1800] /\
  c - t in [0, 0] }
c - t -> e13 - e14;
