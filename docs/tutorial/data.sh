u='function u() { s = s * 16807 % 2147483647; return s / 2147483647 }'
awk "$u"' BEGIN { s = 2026; print "x,y,t"
  while (n++ < 1000) print 100*u() "," 100*u() "," 10*u() }' >particles.csv
awk "$u"' BEGIN { s = 777777; print "ox,oy,vx,vy,d"
  while (n++ < 400)
    print 100*u() "," 100*u() "," u()-0.5 "," u()-0.5 "," 0.5+1.5*u() }' >obstacles.csv
