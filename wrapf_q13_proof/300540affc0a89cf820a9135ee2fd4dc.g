#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x14 - x15;
t = (x14 - e14) - (x15 - e15);
{ x14 in [0, 12865b-12] /\
  e14 in [-704069922905878788492674997789656323365b-140, 704069922905878788492674997789656323365b-140] /\
  x15 in [-1, 8191b-13] /\
  e15 in [-127b-20, 0]
  ->
  c in [-8191b-13, 16961b-12] /\
  c - t in [-704069922905878788492674997789656323365b-140, 872881878370563104351458494445260084517b-140] }
c - t -> e14 - e15;
