#ifndef shapetonLungs_h
#define shapetonLungs_h

#include "shapetonColonStructurePart.h"

#include <vector>

namespace shapeton
{
/** Properties of a lung state. */
struct LungState
{
  double density;         ///< mean of the parenchyma, HU
  double gravityGradient; ///< relative change of the tissue's share per mm toward the dependent side
  double texture;         ///< relative amplitude of its texture
  double lift;            ///< elevation of the diaphragm relative to inspiration, mm
  bool   isEmphysema;     ///< with holes
};

/** inspiration, quietBreathing or emphysema; `density` of the parameters overrides that of the state. */
LungState
LungStateOf(const ColonPhantomParameters & parameters);

/** Lobes, airways and vessels of the lungs. The anatomy must outlive them. */
std::vector<ColonStructures::Part>
MakeLungParts(const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down);
} // namespace shapeton

#endif
