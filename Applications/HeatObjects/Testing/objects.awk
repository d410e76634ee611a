# Objects of scene.json in voxels of 1 mm: 1 both balls (radius 11 and 8) and the cylinder between them (radius 1.2, about
# 9 mm not in a ball), 2 the large ball, 3 a box of 24 x 14 x 12, 4 the small ball; 2 and 4 in 1. `expected`: the numbers of the rows, in order.
NR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  next
}
function expect(what, truth, tolerance,   value) {
  value = $(column[what])
  if (value < truth - tolerance || value > truth + tolerance) {
    printf "object %s: %s is %s, not %s\n", $1, what, value, truth
    wrong = 1
  }
}
{
  pi = 3.14159265
  large = 4 / 3 * pi * 11 ^ 3
  small = 4 / 3 * pi * 8 ^ 3
  neck = 9 * pi * 1.2 ^ 2
  volume = $1 == 1 ? large + small + neck : $1 == 2 ? large : $1 == 3 ? 24 * 14 * 12 : small
  expect("object", substr(expected, NR - 1, 1), 0)
  expect("parent", $1 == 2 || $1 == 4 ? 1 : 0, 0)
  expect("volume", volume, $1 == 4 ? 0.04 * volume : 0.02 * volume) # object 4 contains a part of the cylinder
  expect("voxels", $(column["volume"]), 0)
  expect("x", $1 == 1 ? (13 * small - 15 * large) / (large + small) : $1 == 2 ? -15 : $1 == 3 ? 0 : 13, $1 == 4 ? 0.3 : 0.2)
  expect("y", 0, 0.05)
  expect("z", $1 == 3 ? 18 : -8, 0.05)
  expect("meanIntensity", 300, 2) # noise of 40 HU
  expect("cut", 0, 0)
  if ($(column["probability"]) < ($1 == 4 ? 0.3 : 0.9)) {
    print "object " $1 ": probability " $(column["probability"])
    wrong = 1
  }
  ++rows
}
END {
  if (rows != length(expected)) { print rows " rows, not " length(expected); wrong = 1 }
  exit wrong
}
