# Doxygen filter for .cxx files. Names each anonymous namespace after its file, because Doxygen 1.9 loses out-of-class member
# definitions in anonymous namespaces. Omits an include of a generated header.
FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\./, "_", name) }
/^namespace$/ { $0 = $0 " " name }
/^#include "shapetonShapePresets.h"$/ { $0 = "" }
{ print }
