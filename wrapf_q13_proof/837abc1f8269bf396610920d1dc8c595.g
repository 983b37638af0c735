#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x0 - x1;
t = (x0 - e0) - (x1 - e1);
{ x0 in [-4, 8191b-11] /\
  e0 in [-511b-20, 0] /\
  x1 in [-4, 8191b-11] /\
  e1 in [-511b-20, 0]
  ->
  c in [-16383b-11, 16383b-11] /\
  c - t in [-511b-20, 511b-20] }
c - t -> e0 - e1;
