#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x0 - x1;
t = (x0 - e0) - (x1 - e1);
{ x0 in [0, 4095] /\
  e0 in [0, 0] /\
  x1 in [0, 4095] /\
  e1 in [0, 0]
  ->
  c in [-4095, 4095] /\
  c - t in [0, 0] }
c - t -> e0 - e1;
