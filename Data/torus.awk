# Writes the surface of a torus around the z axis as OFF: awk -f torus.awk > Torus.off
function number(value,   text) {
  text = sprintf("%.6f", value)
  return text == "-0.000000" ? "0.000000" : text
}
BEGIN {
  ringRadius = 20 # mm
  tubeRadius = 8
  around = 48     # vertices around the ring
  across = 24     # and around the tube
  twoPi = 8 * atan2(1, 1)
  print "OFF"
  print "# Torus around the z axis, radii 20 and 8 mm, LPS. Made by torus.awk of Shapeton, CC0."
  print around * across, 2 * around * across, 0
  for (i = 0; i < around; ++i) {
    for (j = 0; j < across; ++j) {
      r = ringRadius + tubeRadius * cos(twoPi * j / across)
      print number(r * cos(twoPi * i / around)), number(r * sin(twoPi * i / around)),
            number(tubeRadius * sin(twoPi * j / across))
    }
  }
  for (i = 0; i < around; ++i) {
    for (j = 0; j < across; ++j) {
      a = i * across + j
      b = (i + 1) % around * across + j
      c = (i + 1) % around * across + (j + 1) % across
      d = i * across + (j + 1) % across
      print 3, a, b, c
      print 3, a, c, d
    }
  }
}
