# Doxygen's filter of .cxx files. An anonymous namespace gets the name of its file: Doxygen 1.9 loses members of classes
# in anonymous namespaces that are defined outside of their class. A header that the build generates is left out.
FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\./, "_", name) }
/^namespace$/ { $0 = $0 " " name }
/^#include "shapetonShapePresets.h"$/ { $0 = "" }
{ print }
