# Small open surfaces as OFF: awk -v shape=annulus|holes|square -f surfaces.awk > F.off
# annulus: an eccentric one, the circles |z| = 0.3 and 1 after z -> (z + 0.4) / (1 + 0.4 z), times 50 mm; modulus 2 pi / ln(1 / 0.3).
# holes: a square of 40 mm with two square holes. square: 40 mm, 16 x 16 cells.
function annulus(   i, j, r, x, y, a, d, turn) {
  turn = 8 * atan2(1, 1) / around
  a = 0.4
  print around * (rings + 1), 2 * around * rings, 0
  for (j = 0; j <= rings; ++j)
    for (i = 0; i < around; ++i) {
      r = exp(log(0.3) * (1 - j / rings))
      x = r * cos(turn * (i + j / 2))
      y = r * sin(turn * (i + j / 2))
      d = (1 + a * x) ^ 2 + (a * y) ^ 2
      printf "%.9f %.9f 0\n", 50 * ((x + a) * (1 + a * x) + a * y * y) / d, 50 * (y * (1 + a * x) - (x + a) * a * y) / d
    }
  for (j = 0; j < rings; ++j)
    for (i = 0; i < around; ++i) {
      print 3, j * around + i, (j + 1) * around + i, j * around + (i + 1) % around
      print 3, j * around + (i + 1) % around, (j + 1) * around + i, (j + 1) * around + (i + 1) % around
    }
}
function isHole(i, j) { return shape == "holes" && j >= 6 && j < 10 && ((i >= 3 && i < 6) || (i >= 10 && i < 12)) }
function square(   i, j, faces, corner) {
  for (j = 0; j < 16; ++j)
    for (i = 0; i < 16; ++i)
      faces += isHole(i, j) ? 0 : 2
  print 17 * 17, faces, 0
  for (j = 0; j <= 16; ++j)
    for (i = 0; i <= 16; ++i)
      print 2.5 * i, 2.5 * j, 0
  for (j = 0; j < 16; ++j)
    for (i = 0; i < 16; ++i)
      if (!isHole(i, j)) {
        corner = 17 * j + i
        print 3, corner, corner + 1, corner + 18
        print 3, corner, corner + 18, corner + 17
      }
}
BEGIN {
  around = 120
  rings = 30
  print "OFF"
  if (shape == "annulus") annulus(); else square()
}
