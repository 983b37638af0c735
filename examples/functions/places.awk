# Places of the time zone database (public domain), in radians:
#   awk -f places.awk /usr/share/zoneinfo/zone1970.tab >places.csv
# A line has country codes, latitude and longitude as +-DDMM+-DDDMM or with seconds, a name.
function radians(text, degrees_digits,    sign, degrees, minutes, seconds) {
  sign = substr(text, 1, 1) == "-" ? -1 : 1
  degrees = substr(text, 2, degrees_digits)
  minutes = substr(text, 2 + degrees_digits, 2)
  seconds = substr(text, 4 + degrees_digits, 2)
  return sign * (degrees + minutes / 60 + seconds / 3600) * atan2(0, -1) / 180
}
BEGIN { FS = "\t"; print "lat,lon,name" }
/^#/ { next }
{
  match(substr($2, 2), /[-+]/)
  printf "%.17g,%.17g,%s\n", radians(substr($2, 1, RSTART), 2), radians(substr($2, RSTART + 1), 3), $3
}
