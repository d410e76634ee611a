# Fails unless a table holds the first eigenvalues of the cylinder of cylinder.awk, (pi m / 40)^2 + (k / 10)^2, each with
# k > 0 twice, within one percent, the error of its mesh, and residuals below 1e-9.
BEGIN {
  FS = ","
  pi = 4 * atan2(1, 1)
  for (m = 0; m < 12; ++m)
    for (k = 0; k < 8; ++k)
      for (copy = 0; copy < (k > 0 ? 2 : 1); ++copy)
        truth[count++] = (pi * m / 40) ^ 2 + (k / 10) ^ 2
  for (i = 1; i < count; ++i)
    for (j = i; j > 0 && truth[j - 1] > truth[j]; --j) {
      swap = truth[j]; truth[j] = truth[j - 1]; truth[j - 1] = swap
    }
}
NR > 1 {
  difference = $2 - truth[$1]
  if (difference < 0) difference = -difference
  if (difference > 0.01 * truth[$1] + 1e-12 || $3 > 1e-9) { print "row", $0, "is not", truth[$1]; wrong = 1 }
  ++rows
}
END { exit wrong || rows != 30 }
