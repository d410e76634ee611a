#ifndef shapetonColonAssessability_h
#define shapetonColonAssessability_h

#include "ShapetonColonCenterlineExport.h"

#include "shapetonColonLumenSegmentation.h"
#include "shapetonCurveSet.h"
#include "shapetonJson.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup ColonAssessability Assessable parts of a colon
 *
 * The colon cannot be assessed where its wall is not visible: C-RADS category C0 (Zalis et al., Radiology 2005), for
 * inadequate preparation that hides lesions of 10 mm or more, or for collapsed segments. Each point of the centerline
 * is classified by the first rule that applies:
 *
 * - no lumen: the line is a bridge, without gas or tagged fluid
 * - cut by the scan: the lumen extends beyond the border of the image
 * - untagged fluid: directly below the line, the lumen ends at an untagged level of at least 150 mm^2, which hides the
 *   wall below it. In the inspected examinations, flat walls mistaken for levels had areas of up to 80 mm^2
 * - narrow: the caliber is below 10 mm over at least 5 mm, which is longer than a single fold. The first 40 mm are
 *   exempt, since the anal canal is narrow
 *
 * MeasureDistension() uses the same limit of 10 mm; 150 mm^2, 5 mm and the fractions that separate the verdicts are our
 * choice. The fluid rule requires a CT.
 * \ingroup ShapetonColonCenterline */
///@{

/** Reason why the wall is not visible at a point of the centerline; the values stored in the array notAssessable. */
enum class ColonHindrance
{
  None = 0,
  NoLumen = 1,
  CutByScan = 2,
  UntaggedFluid = 3,
  Narrow = 4
};
/** Number of values of ColonHindrance. \ingroup ShapetonColonCenterline */
constexpr int numberOfColonHindrances = 5;

/** "none", "noLumen", "cutByScan", "untaggedFluid", "narrow". */
ShapetonColonCenterline_EXPORT std::string
                               NameOf(ColonHindrance hindrance);
/** The hindrance with this name; None for an empty name. Throws InputError for an unknown name. */
ShapetonColonCenterline_EXPORT ColonHindrance
HindranceOfName(const std::string & name);
/** The hindrance for a value of the array notAssessable; values out of range are clamped. */
ShapetonColonCenterline_EXPORT ColonHindrance
HindranceOfValue(double value);
/** Description, for example "caliber below 10 mm"; empty for None. */
ShapetonColonCenterline_EXPORT std::string
                               InWords(ColonHindrance hindrance);

/** Adds the point array notAssessable (ColonHindrance) to the centerline. Throws InputError if `curve` lacks an array
 * that TraceColonCenterline() adds. */
ShapetonColonCenterline_EXPORT void
MarkHindrances(const ColonLumen & lumen, CurveSet & curve);

/** A stretch of the centerline with a single hindrance. */
struct HinderedStretch
{
  /** First and last arcLength (mm), halfway between points; for a stretch without lumen, the ends of the gap. */
  double         begin{ 0.0 };
  double         end{ 0.0 };
  ColonHindrance hindrance{ ColonHindrance::None };
};

/** Whether the arrays required by FindHinderedStretches() exist. */
ShapetonColonCenterline_EXPORT bool
TellsHindrances(const CurveSet & curve);

/** The hindered stretches in order along the line, from arcLength and notAssessable, or from arcLength, gap and radius
 * if notAssessable is missing. Throws InputError if required arrays are missing. */
ShapetonColonCenterline_EXPORT std::vector<HinderedStretch>
                               FindHinderedStretches(const CurveSet & curve);

ShapetonColonCenterline_EXPORT ColonHindrance
HindranceAt(const std::vector<HinderedStretch> & stretches, double arcLength);

/** Adds the point array notAssessable to curves with the point array arcLength, such as taeniae coli. */
ShapetonColonCenterline_EXPORT void
MarkHindrances(const std::vector<HinderedStretch> & stretches, CurveSet & curves);

/** The assessable fraction of a part of the colon. */
struct ColonAssessability
{
  /** Assessable fraction of the length, 0 to 1; 0 for an empty part. */
  double share{ 0.0 };
  /** Hindered lengths (mm), indexed by ColonHindrance. */
  std::array<double, numberOfColonHindrances> lengths{};

  /** "assessable" if the fraction is at least 0.9, "notAssessable" below 0.5, else "partly". */
  ShapetonColonCenterline_EXPORT std::string
                                 Verdict() const;
  /** The hindrances that occur, longest first. */
  ShapetonColonCenterline_EXPORT std::vector<ColonHindrance>
                                 Hindrances() const;
};

/** Assessability of the part between two arcLengths. */
ShapetonColonCenterline_EXPORT ColonAssessability
Assess(const std::vector<HinderedStretch> & stretches, double begin, double end);

/** Keys: reason (its name), words (a description). */
ShapetonColonCenterline_EXPORT Json
HindranceToJson(ColonHindrance hindrance);

/** Keys: assessableShare, verdict, reasons (a list of objects with the keys reason, words, length; longest first). */
ShapetonColonCenterline_EXPORT Json
AssessabilityToJson(const ColonAssessability & assessability);

/** A list of objects with the keys begin, end, reason, words. */
ShapetonColonCenterline_EXPORT Json
StretchesToJson(const std::vector<HinderedStretch> & stretches);
///@}
} // namespace shapeton

#endif
