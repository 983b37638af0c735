#@ -Eprecision=768
#@ -Echange-threshold=0
#@ -Edichotomy=0
#@ -Eno-auto-dichotomy
#@ -Wno-unbound-variable
# x: numbers as computed; e: their errors; c, t: the result and the true one.
c = x23 - x24;
t = (x23 - e23) - (x24 - e24);
{ x23 in [0, 1] /\
  e23 in [-6394590506027149160882874719960832282476814805949727383509b-201, 565759205630341b-61] /\
  x24 in [0, 4095b-11] /\
  e24 in [-1b-11, 0]
  ->
  c in [-4095b-11, 1] /\
  c - t in [-6394590506027149160882874719960832282476814805949727383509b-201, 1691659112472965b-61] }
c - t -> e23 - e24;
