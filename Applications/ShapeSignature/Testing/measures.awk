# Measures of the shapes of Figure 3.4 in a volume of 80 mm: label 1 a cube of side 0.24, 2 and 3 cuboids of
# 0.36 x 0.18 x 0.18 and 0.28 x 0.14 x 0.14, 4 a sphere of radius 0.12.
NR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  next
}
function expect(what, truth, relative,   value) {
  value = $(column[what])
  if (value < truth * (1 - relative) || value > truth * (1 + relative)) {
    printf "label %s: %s is %s, not %s\n", $1, what, value, truth
    wrong = 1
  }
}
{
  side = $1 == 1 ? 0.24 * 80 : $1 == 2 ? 0.18 * 80 : 0.14 * 80
  pi = 3.14159265
  if ($1 == 4) {
    r = 0.12 * 80
    expect("volume", 4 / 3 * pi * r ^ 3, 0.03)
    expect("surface", 4 * pi * r ^ 2, 0.03)
  } else {
    length_ = $1 == 1 ? side : 2 * side
    expect("volume", length_ * side ^ 2, 0.1) # a layer of voxels more or less
    expect("surface", 2 * side ^ 2 + 4 * side * length_, 0.09)
  }
  expect("elongation", $1 == 2 || $1 == 3 ? 2 : 1, 0.08)
  expect("meanIntensity", 1000, 1e-6)
  ++rows
}
END {
  if (rows != 4) { print rows " rows, not 4"; wrong = 1 }
  exit wrong
}
