#include "shapetonColonPair.h"

#include "shapetonFoldProbability.h"
#include "shapetonExceptions.h"

namespace shapeton
{
ColonPair::ColonPair(const ColonPosition & first, const ColonPosition & second)
  : source(first)
  , target(second)
  , sourceCylinder(std::make_shared<ColonCylinder>(*first.flat, first.centerline))
  , targetCylinder(std::make_shared<ColonCylinder>(*second.flat, second.centerline))
  , sourceFolds(FoldProbability(first))
  , targetFolds(FoldProbability(second))
{}

void
FindFrame(ColonPair & pair, bool isSegmentWise, std::vector<std::string> & warnings)
{
  pair.frame = FlexureFrame(pair.source, *pair.sourceCylinder, pair.target, *pair.targetCylinder, warnings);
  if (isSegmentWise)
  {
    pair.breaks.assign(pair.frame.from.begin() + 1, pair.frame.from.end() - 1);
  }
  pair.sourceTaeniae = AnglesOfTaeniae(pair.source, *pair.sourceCylinder, warnings);
  pair.targetTaeniae = AnglesOfTaeniae(pair.target, *pair.targetCylinder, warnings);
  const bool hasFlexures = pair.frame.from.size() > 2;
  if (!hasFlexures && !pair.AreTaeniaeKnown())
  {
    throw InputError("the positions have no landmarks in common, neither flexures nor taeniae: " + pair.source.name +
                     " and " + pair.target.name + "; find them with ColonLandmarks");
  }
}

bool
IsExcluded(const ColonPosition & position, const ColonCylinder & cylinder, const CylinderPlace & place)
{
  const int column = cylinder.Grid().PixelOfUv(cylinder.UvOfPlace(place)).column;
  return !position.isExcluded.empty() && position.isExcluded[column] != 0;
}
} // namespace shapeton
