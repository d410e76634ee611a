#ifndef shapetonColonFlexures_h
#define shapetonColonFlexures_h

#include "ShapetonColonLandmarksExport.h"

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonPelvis.h"

#include <array>
#include <optional>
#include <string>

namespace shapeton
{
/** Method that finds the flexures. \ingroup ShapetonColonLandmarks */
enum class FlexureRule
{
  /** Ordered dynamic programming with a prior from published anatomy, followed by a shift to the apex. */
  Ordered,
  /** Bends in two projections, sorted by height (dissertation 4.2.2). */
  Published
};

/** A major bend of the colon, whether found or not. \ingroup ShapetonColonLandmarks */
struct ColonFlexure
{
  /** Number, counted from the rectum: 1 rectosigmoid, 2 descending-sigmoid, 3 splenic, 4 hepatic. */
  int  number{ 0 };
  bool isFound{ false };
  /** Reason why it was not found; empty otherwise. */
  std::string reason;
  /** Position on the centerline, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Unit tangent of the centerline toward the cecum, LPS. */
  Eigen::Vector3d tangent{ Eigen::Vector3d::UnitZ() };
  /** Distance along the centerline, mm. */
  double arcLength{ 0.0 };
  /** 0 to 1. Ordered: probability that the flexure is within 30 mm along the line, calibrated on phantoms. Published:
   * 0.5 if all four are in anatomical order, since that method does not provide a probability. */
  double confidence{ 0.0 };
};

/** The four flexures of a centerline in order from the rectum, with the reason for each missing one. See
 * FindColonFlexures(). \ingroup ShapetonColonLandmarks */
struct ColonFlexures
{
  FlexureRule                 rule{ FlexureRule::Ordered };
  std::array<ColonFlexure, 4> flexures;
  /** Whether the descending colon is on the right: situs inversus or a flipped image. Set only by Ordered. */
  bool isMirrored{ false };
  /** Whether the line is probably reversed (cecum to rectum), which lowers confidences. Set only by Ordered. */
  bool isBackwards{ false };
  /** Whether the descending-sigmoid flexure was determined by the pelvic bones, not by the course of the line. Set only
   * by Ordered. */
  bool    isJunctionFromBones{ false };
  Remarks warnings;

  /** Number of flexures found. */
  ShapetonColonLandmarks_EXPORT int
  NumberFound() const;
};

/** "rectosigmoid", "descending-sigmoid", "splenic", "hepatic"; empty for other numbers. \ingroup ShapetonColonLandmarks
 */
ShapetonColonLandmarks_EXPORT std::string
                              NameOfFlexure(int number);

/** "ordered", "published". \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::string
                              NameOf(FlexureRule rule);

/** Finds the four flexures of a centerline from the rectum to the cecum.
 *
 * Ordered: twelve features are computed every 4 mm along the line: the fraction of the length before the point, its
 * position in the bounding box of the line, the angles between chords of 35 and of 70 mm, and the directions 40 mm
 * before and after it. The score of a flexure is the log-likelihood of a Gaussian with independent features. The length
 * of the rectum and the length fractions between flexures are Gaussian as well. Each point up to the splenic flexure is
 * also scored by a likelihood ratio (position in the box, direction over 15 mm) of the descending colon to the whole
 * colon. The descending colon runs straight along the left posterior wall; its lower part, the iliac colon, runs
 * obliquely in front of the iliac bone. If the pelvis is known, the descending-sigmoid flexure, which is at the pelvic
 * brim, is also scored by its height above the promontory and its distance to the left of it. Dynamic programming finds
 * the optimal four ordered points. Then the splenic and hepatic flexures, which are fixed to the posterior wall, are
 * shifted to the highest point within 16 mm, with posterior depth weighted by one half. The rectosigmoid flexure is
 * shifted to the sharpest bend within 14 mm. The descending-sigmoid flexure, the start of the straight part, is set to
 * the probability-weighted mean of its candidates within 60 mm. Confidences are posterior probabilities, tempered and
 * blurred as calibrated on phantoms (constants in the source). The mirror image of the line is scored as well, and is
 * chosen if its total likelihood times .001 is greater than that of the line. The prior probability of a line from the
 * cecum to the rectum is .01; confidences are multiplied by the probability of the chosen direction.
 *
 * The prior is based on published anatomy, not on centerlines or phantoms:
 * - lengths from the anal verge, cm: anal canal 4, rectum 12, sigmoid 40, descending 25, transverse 50, ascending 15,
 *   cecum 6 (Standring, ed.: Gray's Anatomy, 41st ed., 2016); ascending 20-25, descending 10-15, cecum 6 (SEER
 *   training module, US National Cancer Institute). The means of the prior are between these values. The descending
 *   colon includes the iliac colon, 12 to 15 cm in the iliac fossa (Gray's Anatomy, 20th ed., 1918). Total 189.5 +-
 *   26.3 cm (Khashab et al., Endoscopy 41, 2009, 505 adults, CT colonography), 150.3 +- 18.5 cm, 110 to 196 (Utano et
 *   al., Jpn J Radiol 40, 2022, 295 patients). Standard deviations are a quarter to a third of the segment length, more
 *   for the sigmoid, whose length varies most (Phillips et al., Ann R Coll Surg Engl 97, 2015).
 * - heights by vertebrae (Gray's Anatomy): rectosigmoid junction S3, end of the descending colon at the pelvic brim
 *   (S1 to S2), hepatic flexure L1 to L2, splenic flexure T12 and above all others. Heights relative to the box assume
 *   18.5 cm of lumbar spine and 17 cm from the promontory to the anal verge. The brim is inclined: where the colon
 *   crosses it, it is 11 to 17 cm above the verge.
 * - sides and depth: rectum in the midline in front of the sacrum, descending colon left and posterior, transverse
 *   colon hanging forward between its flexures, ascending colon right (same source).
 *
 * Source: Ordered is original work. Published is the rule of the dissertation, 4.2.2; its "comparable y" is not defined
 * there and is taken as 25 mm here.
 *
 * No flexure is found, and the reason is reported, if the line is shorter than 80 cm (minimum for a whole colon,
 * Hounnou et al., Surg Radiol Anat 24, 2002) or its features are too far from the prior. Doubtful results cause
 * warnings. \param centerline one curve with the point array arcLength. Throws InputError unless there is exactly one
 * curve with an ascending arcLength. \param pelvis from FindPelvis(); empty if the pelvis is not in view or no CT is
 * available. Not used by Published. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonFlexures
FindColonFlexures(const CurveSet &              centerline,
                  FlexureRule                   rule = FlexureRule::Ordered,
                  const std::optional<Pelvis> & pelvis = std::nullopt);
} // namespace shapeton

#endif
