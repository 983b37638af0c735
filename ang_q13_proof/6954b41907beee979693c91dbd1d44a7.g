#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x4 - x6;
t = (x4 - e4) - (x6 - e6);
{ x4 in [0, 512] /\
  e4 in [0, 0] /\
  x6 in [0, 512] /\
  e6 in [0, 0]
  ->
  c in [-512, 512] /\
  c - t in [0, 0] }
c - t -> e4 - e6;
