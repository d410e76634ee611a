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
  double gravityGradient; ///< relative change of the tissue fraction per mm toward the dependent side
  double texture;         ///< relative amplitude of the texture
  double lift;            ///< elevation of the diaphragm relative to inspiration, mm
  bool   isEmphysema;     ///< with holes
};

/** State inspiration, quietBreathing or emphysema; `lungDensity` of the parameters overrides the density. */
LungState
LungStateOf(const ColonPhantomParameters & parameters);

/** Lobes, airways and vessels of the lungs. The anatomy must outlive the parts. */
std::vector<ColonStructures::Part>
MakeLungParts(const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down);
} // namespace shapeton

#endif
