# Fails unless two tables have the same rows, eigenvalues equal within 1e-8 of the largest: awk -f compare.awk A.csv B.csv
BEGIN { FS = "," }
FNR == NR { baseline[FNR] = $2; rows = FNR; largest = $2; next }
FNR == 1 { wrong = $0 != "number,eigenvalue,residual"; next }
{
  difference = $2 - baseline[FNR]
  if (difference < 0) difference = -difference
  if ($1 != FNR - 2 || difference > 1e-8 * largest) { print "row", $0, "against", baseline[FNR]; wrong = 1 }
}
END { exit wrong || FNR != rows }
