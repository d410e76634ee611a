# Objects of scene.json in several windows of intensity: each ball is an object of one window, in an object of another one.
NR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  if ($0 !~ /timeStep,windowLower,windowUpper,heat,.*,cut,meanHeat$/) { print "columns: " $0; wrong = 1 }
  next
}
{
  lower[$1] = $(column["windowLower"])
  if (!(lower[$1] < $(column["windowUpper"]))) { print "object " $1 " has no window"; wrong = 1 }
  x = $(column["x"])
  z = $(column["z"])
  isBall = z > -9 && z < -7 && (x > 12 && x < 14 || x > -16 && x < -14)
  if (isBall && $2 > 0 && lower[$2] != lower[$1]) { ++balls }
}
END {
  if (balls != 2) { print balls " balls, not 2"; wrong = 1 }
  exit wrong
}
