#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x2 + x3;
t = (x2 - e2) + (x3 - e3);
{ x2 in [-16383b-11, 16383b-11] /\
  e2 in [-511b-20, 511b-20] /\
  x3 in [3217b-10, 3217b-10] /\
  e3 in [1552151067107796449244451840616254309b-137, 3104302134215592898488903681232508619b-138]
  ->
  c in [-9949b-11, 22817b-11] /\
  c - t in [-83352287163653704932486224134790755483b-137, 172913178595738595661950255632046528203b-138] }
c - t -> e2 + e3;
