# The results for four shapes, two neighbors each: ranks 1 and 2, ascending distances, one probability and answer per
# shape.
NR == 1 {
  if ($0 != "shape,rank,name,distance,probability,answer") { print "another header: " $0; wrong = 1 }
  next
}
$2 == 1 && !($5 >= 0 && $5 <= 1 && $6 != "") { print "no probability or answer: " $0; wrong = 1 }
$2 == 2 && !($1 == shape && $4 >= distance && $5 == "" && $6 == "") { print "no second neighbor of " shape ": " $0; wrong = 1 }
{ shape = $1; distance = $4; ++rows }
END {
  if (rows != 8) { print rows " rows, not 8"; wrong = 1 }
  exit wrong
}
