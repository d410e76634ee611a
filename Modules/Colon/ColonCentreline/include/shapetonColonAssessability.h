#ifndef shapetonColonAssessability_h
#define shapetonColonAssessability_h

#include "ColonCentrelineExport.h"

#include "shapetonColonLumenSegmentation.h"
#include "shapetonCurveSet.h"
#include "shapetonJson.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup ColonAssessability Where a colon can be assessed
 *
 * A stretch of the colon cannot be assessed where its wall is not seen. C-RADS (Zalis et al., Radiology 2005) has the
 * category C0 for this: preparation that hides lesions of 10 mm, or segments that are collapsed. The rules, point by
 * point of the centreline, the first that holds:
 *
 * - no lumen: the line is bridged: there is neither gas nor tagged fluid
 * - cut by the scan: the lumen goes on beyond the border of the image
 * - untagged fluid: straight below the line the lumen ends at a level of 150 mm^2 and more that is not tagged: what
 * lies under it is not seen. Flat walls passed for levels of up to 80 mm^2 in the examinations that were looked at
 * - narrow: the calibre is below 10 mm along 5 mm and more, as distension is counted; the lip of a single fold is
 *   thinner. Up to 40 mm at the beginning, the anal canal, are narrow by nature
 *
 * The border of 10 mm is that of MeasureDistension(); 150 mm^2, 5 mm and the shares of the verdicts are ours. Of a mask
 * without a CT fluid is not known, and that rule does not apply.
 * \ingroup ColonCentreline */
///@{

/** Why the wall is not seen at a point of the centreline. The numbers are those of the array notAssessable. */
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
ColonCentreline_EXPORT std::string
                       NameOf(ColonHindrance hindrance);
/** The hindrance of such a name; None for an empty one. Throws InputError for another. */
ColonCentreline_EXPORT ColonHindrance
HindranceOfName(const std::string & name);
/** The hindrance of a value of the array notAssessable; of one out of range the nearest. */
ColonCentreline_EXPORT ColonHindrance
HindranceOfValue(double value);
/** For example "calibre below 10 mm"; empty for None. */
ColonCentreline_EXPORT std::string
                       InWords(ColonHindrance hindrance);

/** Gives the centreline the point array notAssessable, a ColonHindrance for each point. `curve` needs the arrays of
 * TraceColonCentreline(). Throws InputError where one is missing. */
ColonCentreline_EXPORT void
MarkHindrances(const ColonLumen & lumen, CurveSet & curve);

/** A part of the centreline with one hindrance. */
struct HinderedStretch
{
  /** arcLength, mm, halfway between points. */
  double         begin{ 0.0 };
  double         end{ 0.0 };
  ColonHindrance hindrance{ ColonHindrance::None };
};

/** Whether a line has what FindHinderedStretches() needs. */
ColonCentreline_EXPORT bool
TellsHindrances(const CurveSet & curve);

/** In order along the line, by arcLength and notAssessable; of a line without the latter those by gap and radius.
 * Throws InputError where these are missing, too. */
ColonCentreline_EXPORT std::vector<HinderedStretch>
                       FindHinderedStretches(const CurveSet & curve);

ColonCentreline_EXPORT ColonHindrance
HindranceAt(const std::vector<HinderedStretch> & stretches, double arcLength);

/** Gives curves with the point array arcLength, such as taeniae, the point array notAssessable. */
ColonCentreline_EXPORT void
MarkHindrances(const std::vector<HinderedStretch> & stretches, CurveSet & curves);

/** How much of a part of the colon can be assessed. */
struct ColonAssessability
{
  /** Of its length, 0 to 1; 0 for no length. */
  double share{ 0.0 };
  /** mm, by ColonHindrance. */
  std::array<double, numberOfColonHindrances> lengths{};

  /** "assessable" from 0.9 of its length, "notAssessable" below 0.5, else "partly". */
  ColonCentreline_EXPORT std::string
                         Verdict() const;
  /** Those that have a length, the longest first. */
  ColonCentreline_EXPORT std::vector<ColonHindrance>
                         Hindrances() const;
};

/** Between two arcLengths. */
ColonCentreline_EXPORT ColonAssessability
Assess(const std::vector<HinderedStretch> & stretches, double begin, double end);

/** Keys: reason (its name), words. */
ColonCentreline_EXPORT Json
HindranceToJson(ColonHindrance hindrance);

/** Keys: assessableShare, verdict, reasons (a list of reason, words, length; the longest first). */
ColonCentreline_EXPORT Json
AssessabilityToJson(const ColonAssessability & assessability);

/** A list of begin, end, reason, words. */
ColonCentreline_EXPORT Json
StretchesToJson(const std::vector<HinderedStretch> & stretches);
///@}
} // namespace shapeton

#endif
