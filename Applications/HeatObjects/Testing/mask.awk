# Arguments: signatures of a selection (ShapeSignature), then the table of the objects at the selected point. The mask has
# one label, 1, with as many voxels as the first object (selected=Click) or the second one (selected=Climb).
FNR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  next
}
NR == FNR {
  ++labels
  if ($(column["label"]) != 1) { print "label " $(column["label"]); wrong = 1 }
  voxels = $(column["voxels"])
  next
}
FNR == (selected == "Click" ? 2 : 3) {
  if ($(column["voxels"]) != voxels) { print voxels " voxels, not " $(column["voxels"]); wrong = 1 }
  ++compared
}
END { exit wrong || labels != 1 || compared != 1 }
