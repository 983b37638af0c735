#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x11 - x3;
t = (x11 - e11) - (x3 - e3);
{ x11 in [0, 3600] /\
  e11 in [0, 0] /\
  x3 in [1800, 1800] /\
  e3 in [0, 0]
  ->
  c in [-1800, 1800] /\
  c - t in [0, 0] }
c - t -> e11 - e3;
