#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x0 * x1;
t = (x0 - e0) * (x1 - e1);
{ x0 in [0, 255] /\
  e0 in [0, 0] /\
  x1 in [257b-16, 257b-16] /\
  e1 in [-667220327295957771496812955748565121b-143, -1334440654591915542993625911497130241b-144]
  ->
  c in [0, 65535b-16] /\
  c - t in [-170141183460469231731687303715884105855b-143, 0] }
c - t -> x0 * e1 + x1 * e0 - e0 * e1;
