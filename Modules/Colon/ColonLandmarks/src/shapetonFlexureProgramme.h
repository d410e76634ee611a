#ifndef shapetonFlexureProgramme_h
#define shapetonFlexureProgramme_h

#include "shapetonCentrelineShape.h"

#include <array>

namespace shapeton
{
/** The best places of the four flexures, before any snap to an apex. */
struct FlexurePlaces
{
  /** Points of the shape. */
  std::array<int, 4> at{};
  /** The probability, by the model, that the flexure lies within 30 mm. */
  std::array<double, 4> confidence{};
  /** Mean squared deviation of the flexure's features from the prior. */
  std::array<double, 4> meanDeviation{};
  /** The descending colon lies on the right. */
  bool isMirrored{ false };
  /** The line is likelier to run from the caecum to the rectum. */
  bool isBackwards{ false };
};

/** Likelihoods of flexures, of the sections between them and of their lengths, as shapetonColonFlexures.h describes;
 * the best places in their order, found exactly. Of the line as it is and its mirror image the likelier one counts;
 * confidences allow for the other one and for the line run backwards. */
FlexurePlaces
FindFlexurePlaces(const CentrelineShape & shape);
} // namespace shapeton

#endif
