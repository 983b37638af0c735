# Blocks of 4 x 4 grey pixels, as CSV: b of a picture, and p and q of the picture before it, at
# the same place and two pixels to the right. The pictures show the atoms of a protein as spheres,
# and how near they are; between the two the protein turns by three degrees.
#   awk -f blocks.awk ../predicates/atoms.csv > blocks.csv
function draw(picture, degrees,    n, c, s, cx, cy, cz, u, v, d2, grey) {
  c = cos(degrees * pi / 180); s = sin(degrees * pi / 180)
  for (n = 1; n <= atoms; ++n) {
    cx = c * x[n] + s * z[n]; cy = y[n]; cz = c * z[n] - s * x[n]
    for (u = int((cx - radius + 20) / pixel); u <= (cx + radius + 20) / pixel; ++u)
      for (v = int((cy - radius + 20) / pixel); v <= (cy + radius + 20) / pixel; ++v) {
        d2 = (u * pixel - 20 - cx)^2 + (v * pixel - 20 - cy)^2
        if (d2 > radius^2) continue
        grey = int(128 + 5 * (cz + sqrt(radius^2 - d2)))
        if (grey > shade[picture, u, v]) shade[picture, u, v] = grey
      }
  }
}
function block(picture, u, v,    k, text) {
  for (k = 0; k < 16; ++k) text = text "," shade[picture, u + k % 4, v + int(k / 4)] + 0
  return text
}
function names(letter,    k, text) {
  for (k = 0; k < 16; ++k) text = text "," letter "_" k
  return text
}
BEGIN { FS = ","; pi = 3.14159265358979; radius = 1.7; pixel = 0.4 }
NR > 1 { n = ++atoms; x[n] = $1 / 1000 - 19; y[n] = $2 / 1000 - 36; z[n] = $3 / 1000 - 16 }
END {
  draw(1, 0); draw(2, 3)
  print substr(names("b") names("p") names("q"), 2)
  for (v = 0; v + 3 < 100; v += 2)
    for (u = 0; u + 5 < 100; u += 4) {
      b = block(2, u, v)
      if (b ~ /[1-9]/) print substr(b block(1, u, v) block(1, u + 2, v), 2)
    }
}
