#ifndef shapetonLungs_h
#define shapetonLungs_h

#include "shapetonColonStructurePart.h"

#include <vector>

namespace shapeton
{
/** What a state of the lungs is like. */
struct LungState
{
  double density;         ///< mean of the parenchyma, HU
  double gravityGradient; ///< relative change of the tissue's share per mm towards the dependent side
  double texture;         ///< relative amplitude of its unevenness
  double lift;            ///< how much higher the diaphragm stands than in inspiration, mm
  bool   isEmphysema;     ///< with holes
};

/** inspiration, quietBreathing or emphysema; `density` of the parameters replaces that of the state. */
LungState
LungStateOf(const ColonPhantomParameters & parameters);

/** Lobes, airways and vessels of the lungs. The anatomy has to outlive them. */
std::vector<ColonStructures::Part>
MakeLungParts(const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down);
} // namespace shapeton

#endif
