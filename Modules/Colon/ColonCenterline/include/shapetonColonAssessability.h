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
 * A part of the colon cannot be assessed where its wall is not visible. C-RADS (Zalis et al., Radiology 2005) calls
 * this category C0: preparation that hides lesions of 10 mm, or collapsed segments. The first rule that holds at a
 * point of the centerline decides:
 *
 * - no lumen: the line is a bridge, without gas or tagged fluid
 * - cut by the scan: the lumen extends beyond the border of the image
 * - untagged fluid: straight below the line the lumen ends at an untagged level of 150 mm^2 or more, which hides the
 *   wall below it. Flat walls were mistaken for levels of up to 80 mm^2 in the examinations inspected
 * - narrow: the caliber is below 10 mm over 5 mm or more, as counted for distension; the lip of a single fold is
 *   thinner. Up to 40 mm at the beginning, the anal canal, are narrow by nature
 *
 * The limit of 10 mm is that of MeasureDistension(); 150 mm^2, 5 mm and the shares of the verdicts are our choice. The
 * fluid rule does not apply to a mask without a CT.
 * \ingroup ShapetonColonCenterline */
///@{

/** Why the wall is not visible at a point of the centerline. The values are those of the array notAssessable. */
enum class ColonHindrance
{
  None = 0,
  NoLumen = 1,
  CutByScan = 2,
  UntaggedFluid = 3,
  Narrow = 4
};
constexpr int numberOfColonHindrances = 5;

/** "none", "noLumen", "cutByScan", "untaggedFluid", "narrow". */
ShapetonColonCenterline_EXPORT std::string
                       NameOf(ColonHindrance hindrance);
/** The hindrance with this name; None for an empty name. Throws InputError for any other text. */
ShapetonColonCenterline_EXPORT ColonHindrance
HindranceOfName(const std::string & name);
/** The hindrance with this value in the array notAssessable; the nearest one for values out of range. */
ShapetonColonCenterline_EXPORT ColonHindrance
HindranceOfValue(double value);
/** For example "caliber below 10 mm"; empty for None. */
ShapetonColonCenterline_EXPORT std::string
                       InWords(ColonHindrance hindrance);

/** Adds the point array notAssessable, a ColonHindrance for each point, to the centerline. `curve` needs the arrays of
 * TraceColonCenterline(). Throws InputError when one is missing. */
ShapetonColonCenterline_EXPORT void
MarkHindrances(const ColonLumen & lumen, CurveSet & curve);

/** A part of the centerline with one hindrance. */
struct HinderedStretch
{
  /** First and last arcLength (mm), halfway between points. */
  double         begin{ 0.0 };
  double         end{ 0.0 };
  ColonHindrance hindrance{ ColonHindrance::None };
};

/** Whether a line has the arrays that FindHinderedStretches() needs. */
ShapetonColonCenterline_EXPORT bool
TellsHindrances(const CurveSet & curve);

/** The hindered stretches in order along the line, from arcLength and notAssessable; without the latter from gap and
 * radius. Throws InputError when these are missing, too. */
ShapetonColonCenterline_EXPORT std::vector<HinderedStretch>
                       FindHinderedStretches(const CurveSet & curve);

ShapetonColonCenterline_EXPORT ColonHindrance
HindranceAt(const std::vector<HinderedStretch> & stretches, double arcLength);

/** Adds the point array notAssessable to curves with the point array arcLength, such as taeniae coli. */
ShapetonColonCenterline_EXPORT void
MarkHindrances(const std::vector<HinderedStretch> & stretches, CurveSet & curves);

/** How much of a part of the colon can be assessed. */
struct ColonAssessability
{
  /** Assessable share of the length, 0 to 1; 0 for an empty part. */
  double share{ 0.0 };
  /** Hindered lengths (mm), indexed by ColonHindrance. */
  std::array<double, numberOfColonHindrances> lengths{};

  /** "assessable" if the share is at least 0.9, "notAssessable" below 0.5, else "partly". */
  ShapetonColonCenterline_EXPORT std::string
                         Verdict() const;
  /** The hindrances with a length above zero, longest first. */
  ShapetonColonCenterline_EXPORT std::vector<ColonHindrance>
                         Hindrances() const;
};

/** Assessability of the part between two arcLengths. */
ShapetonColonCenterline_EXPORT ColonAssessability
Assess(const std::vector<HinderedStretch> & stretches, double begin, double end);

/** Keys: reason (its name), words. */
ShapetonColonCenterline_EXPORT Json
HindranceToJson(ColonHindrance hindrance);

/** Keys: assessableShare, verdict, reasons (a list of reason, words, length; the longest first). */
ShapetonColonCenterline_EXPORT Json
AssessabilityToJson(const ColonAssessability & assessability);

/** A list of begin, end, reason, words. */
ShapetonColonCenterline_EXPORT Json
StretchesToJson(const std::vector<HinderedStretch> & stretches);
///@}
} // namespace shapeton

#endif
