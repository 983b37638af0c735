#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x0 * x1;
t = (x0 - e0) * (x1 - e1);
{ x0 in [3217b-12, 3217b-12] /\
  e0 in [13980533929816739769045285477420835621039767125767051b-192, 3495133482454184942261321369355208905259941781441763b-190] /\
  x1 in [2, 2] /\
  e1 in [0, 0]
  ->
  c in [3217b-11, 3217b-11] /\
  c - t in [13980533929816739769045285477420835621039767125767051b-191, 3495133482454184942261321369355208905259941781441763b-189] }
c - t -> x0 * e1 + x1 * e0 - e0 * e1;
