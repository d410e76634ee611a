#ifndef shapetonFlexureProgram_h
#define shapetonFlexureProgram_h

#include "shapetonCenterlineShape.h"
#include "shapetonPelvis.h"

#include <array>
#include <optional>

namespace shapeton
{
/** The optimal points of the four flexures, before the shift to an apex. */
struct FlexurePlaces
{
  /** Indices of points in the shape. */
  std::array<int, 4> at{};
  /** Model probability that the flexure is within 30 mm. */
  std::array<double, 4> confidence{};
  /** Mean squared deviation of the features of each flexure from the prior. */
  std::array<double, 4> meanDeviation{};
  /** Whether the bones support the position of the descending-sigmoid flexure. */
  bool isAtBrim{ false };
  /** Whether the descending colon is on the right. */
  bool isMirrored{ false };
  /** Whether the line is probably directed from the cecum to the rectum. */
  bool isBackwards{ false };
};

/** Finds the optimal ordered points from the likelihoods of flexures, sections and lengths described in
 * shapetonColonFlexures.h. The line or its mirror image is used, whichever is more likely; confidences account for both
 * and for the reversed line. The pelvis, if known, contributes to the descending-sigmoid flexure. */
FlexurePlaces
FindFlexurePlaces(const CenterlineShape & shape, const std::optional<Pelvis> & pelvis);
} // namespace shapeton

#endif
