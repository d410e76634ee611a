#ifndef itkColonTruth_h
#define itkColonTruth_h

#include "itkColonAnatomy.h"
#include "itkColonField.h"

#include <vector>

namespace itk
{
/** What ColonAnatomy hands out as truth; see there. */
CurveSet
ColonCentrelineTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonTaeniaTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonFoldTruth(const ColonPlan & plan, const ColonField & field);
std::vector<ColonPolyp>
ColonPolypTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonCorrespondenceTruth(const ColonPlan & plan, const ColonField & field);
} // namespace itk

#endif
