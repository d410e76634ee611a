# A cylinder of radius 10 mm and height 40 mm, open at both ends, as OFF: awk -f cylinder.awk > Cylinder.off
BEGIN {
  around = 64
  along = 42
  turn = 8 * atan2(1, 1) / around
  print "OFF"
  print around * (along + 1), 2 * around * along, 0
  for (j = 0; j <= along; ++j)
    for (i = 0; i < around; ++i)
      printf "%.9f %.9f %.9f\n", 10 * cos(turn * (i + j / 2)), 10 * sin(turn * (i + j / 2)), 40 * j / along
  for (j = 0; j < along; ++j)
    for (i = 0; i < around; ++i) {
      a = j * around + i
      b = j * around + (i + 1) % around
      print 3, a, b, a + around
      print 3, b, b + around, a + around
    }
}
