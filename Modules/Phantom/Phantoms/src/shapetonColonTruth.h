#ifndef shapetonColonTruth_h
#define shapetonColonTruth_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonField.h"

#include <vector>

namespace shapeton
{
/** Implementation of the ground truth of ColonAnatomy. */
CurveSet
ColonCenterlineTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonTaeniaTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonFoldTruth(const ColonPlan & plan, const ColonField & field);
std::vector<ColonPolyp>
ColonPolypTruth(const ColonPlan & plan, const ColonField & field);
std::vector<ColonDiverticulum>
ColonDiverticulumTruth(const ColonPlan & plan, const ColonField & field);
ColonValve
ColonValveTruth(const ColonPlan & plan, const ColonField & field);
Eigen::Vector3d
CecalPoleTruth(const ColonPlan & plan, const ColonField & field);
CurveSet
ColonCorrespondenceTruth(const ColonPlan & plan, const ColonField & field);
} // namespace shapeton

#endif
