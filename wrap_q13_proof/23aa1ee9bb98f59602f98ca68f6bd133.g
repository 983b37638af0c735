#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x2 + x3;
t = (x2 - e2) + (x3 - e3);
{ x2 in [-4095, 4095] /\
  e2 in [0, 0] /\
  x3 in [1800, 1800] /\
  e3 in [0, 0]
  ->
  c in [-2295, 5895] /\
  c - t in [0, 0] }
c - t -> e2 + e3;
