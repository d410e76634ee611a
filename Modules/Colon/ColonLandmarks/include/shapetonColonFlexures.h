#ifndef shapetonColonFlexures_h
#define shapetonColonFlexures_h

#include "ColonLandmarksExport.h"

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** How flexures are found. \ingroup ColonLandmarks */
enum class FlexureRule
{
  /** An ordered dynamic programme with a prior from published anatomy, then a snap to the apex. */
  Ordered,
  /** The bends in two projections, sorted by height (dissertation 4.2.2). */
  Published
};

/** A major bend of the colon, or a place where one was looked for. \ingroup ColonLandmarks */
struct ColonFlexure
{
  /** From the rectum on: 1 rectosigmoid, 2 descending-sigmoid, 3 splenic, 4 hepatic. */
  int  number{ 0 };
  bool isFound{ false };
  /** Why it was not found; empty otherwise. */
  std::string reason;
  /** On the centreline, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Along the centreline there, LPS, unit length, towards the caecum. */
  Eigen::Vector3d tangent{ Eigen::Vector3d::UnitZ() };
  /** mm. */
  double arcLength{ 0.0 };
  /** 0 to 1: of Ordered the probability, by the model, that the flexure lies within 30 mm; of Published 0.5 where all
   * four stand in anatomical order, as that rule measures none. */
  double confidence{ 0.0 };
};

/** The four flexures of a centreline, found or with the reason why not, in the order from the rectum. See
 * FindColonFlexures(). \ingroup ColonLandmarks */
struct ColonFlexures
{
  FlexureRule                 rule{ FlexureRule::Ordered };
  std::array<ColonFlexure, 4> flexures;
  /** The descending colon lies on the right: situs inversus, or an image with exchanged sides. Ordered alone looks. */
  bool isMirrored{ false };
  /** The course of the line is likelier that from the caecum to the rectum; confidences are low then. Ordered alone
   * looks. */
  bool    isBackwards{ false };
  Remarks warnings;

  /** How many were found. */
  ColonLandmarks_EXPORT int
  NumberFound() const;
};

/** "rectosigmoid", "descending-sigmoid", "splenic", "hepatic"; empty for other numbers. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT std::string
                      NameOfFlexure(int number);

/** "ordered", "published". \ingroup ColonLandmarks */
ColonLandmarks_EXPORT std::string
                      NameOf(FlexureRule rule);

/** The four flexures of a centreline that runs from the rectum to the caecum.
 *
 * Ordered: each place of the line (every 4 mm) has twelve features: the share of the length that lies before it, its
 * place in the bounding box of the line, the turning between chords of 35 and of 70 mm, and the directions 40 mm before
 * and behind. A flexure's score is the log-likelihood of a Gaussian with independent features; the length of the rectum
 * and the shares of the length between flexures have Gaussians, too. The stretch up to the splenic flexure scores by
 * how much likelier each of its points (place in the box, direction over 15 mm) lies in a descending colon, which runs
 * straight up along the left and posterior wall, than anywhere. The best four places in their order are found exactly
 * by dynamic programming, then the splenic and hepatic ones move to the place within 16 mm that is highest, depth
 * towards the back counting half as much (they are fixed to the posterior wall), the rectosigmoid one to the sharpest
 * within 14 mm, the descending-sigmoid one, where the straight run begins, to the mean of its places within 60 mm by
 * their probability. The same is done for the mirror
 * image of the line; it counts where its likelihood, summed over all places, times .001 is the greater one. A line that
 * runs from the caecum to the rectum has the probability .01 before it is looked at; confidences are multiplied by the
 * probability of the sense that counts.
 *
 * The prior states anatomy, no sample of centrelines and no phantom:
 * - lengths from the anal verge, cm: anal canal 4, rectum 12, sigmoid 40, descending 25, transverse 50, ascending 15,
 *   caecum 6 (Standring, ed.: Gray's Anatomy, 41st ed., 2016); ascending 20-25, descending 10-15, caecum 6 (SEER
 *   training module, US National Cancer Institute). The means lie between them. Total 189.5 +- 26.3 cm (Khashab et al.,
 *   Endoscopy 41, 2009, 505 adults, CT colonography), 150.3 +- 18.5 cm, 110 to 196 (Utano et al., Jpn J Radiol 40,
 * 2022, 295 patients). Standard deviations are a quarter to a third of the segment, more for the sigmoid, whose length
 *   varies most (Phillips et al., Ann R Coll Surg Engl 97, 2015).
 * - heights by vertebrae (Gray's Anatomy): rectosigmoid junction S3, end of the descending colon at the pelvic brim
 *   (S1 to S2), hepatic flexure L1 to L2, splenic flexure T12 and above all others; 18.5 cm of lumbar spine and 17 cm
 *   from the promontory to the anal verge turn them into shares of the box.
 * - sides and depth: rectum in the middle before the sacrum, descending colon at the left and back, transverse colon
 *   hanging forwards between its flexures, ascending colon at the right (same source).
 *
 * Source of the method: the programme is ours; "Published" is the rule of the dissertation, 4.2.2, which leaves
 * "comparable y" open; here that is 25 mm.
 *
 * A line shorter than 80 cm (the least length known, Hounnou et al., Surg Radiol Anat 24, 2002) is no whole colon: no
 * flexure is found, with the reason. So is one whose features lie too far from the prior. Warnings name what is
 * doubtful. \param centreline one curve with the point array arcLength. Throws InputError where it is missing, does not
 * ascend, or there is not one curve. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT ColonFlexures
FindColonFlexures(const CurveSet & centreline, FlexureRule rule = FlexureRule::Ordered);
} // namespace shapeton

#endif
