#ifndef shapetonColonCentreline_h
#define shapetonColonCentreline_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonCurveSet.h"
#include "ColonCentrelineExport.h"
#include "shapetonLumenDistance.h"

#include "itkPoint.h"

#include <array>
#include <optional>
#include <string>

namespace shapeton
{
/** What TraceColonCentreline() is to use: the cost of a path, where it begins, which pieces of the lumen count.
 * \ingroup ColonCentreline */
struct ColonCentrelineOptions
{
  /** One mm of path costs 1 / (d + 0.1 mm)^exponent, d the distance to the wall; from 1 to 8. */
  int exponent{ 3 };
  /** Where the line begins in the rectum, LPS in mm; found in the lumen when not given. */
  std::optional<itk::Point<double, 3>> start;
  /** Points of the colon, LPS in mm: the pieces of lumen next to them are used, however small. */
  std::vector<itk::Point<double, 3>> seedPoints;
  /** Smallest piece of lumen that is used, ml. */
  double minimumVolume{ 5.0 };
  /** A smaller piece, from a fifth of that volume on, is used when its box has at least this diagonal, mm. */
  double minimumExtent{ 60.0 };
  /** Distance between points of the line, mm, from 0.2 to 10. */
  double step{ 1.0 };
  /** Standard deviation of the smoothing along the line, mm, from 0 to 20. */
  double smoothing{ 4.0 };
  /** Radius that a bridge over a gap gets, mm. */
  double gapRadius{ 2.0 };
  /** Told the share that is done, from 0 to 1. */
  Progress progress;
};

/** A stretch without lumen that the line bridges. \ingroup ColonCentreline */
struct CentrelineGap
{
  /** arcLength, mm. */
  double                begin{ 0.0 };
  double                end{ 0.0 };
  itk::Point<double, 3> from;
  itk::Point<double, 3> to;
  /** Straight distance of the ends of the lumen, mm. */
  double distance{ 0.0 };
  /** The order of the pieces is in doubt: longer than a collapsed stretch is known to be (150 mm), or, in a ColonModel,
   * outside of the scan. */
  bool isDoubtful{ false };
};

/** A piece of lumen. \ingroup ColonCentreline */
struct CentrelinePiece
{
  /** Rank by volume among the components of the lumen, from 1. */
  int component{ 0 };
  /** ml. */
  double volume{ 0.0 };
  bool   isUsed{ false };
  /** arcLength, mm, where it is used. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** Why it is not used. */
  std::string           reason;
  itk::Point<double, 3> place;
};

/** A place where two loops of the colon touch and their lumens are connected. \ingroup ColonCentreline */
struct CentrelineMerge
{
  itk::Point<double, 3> place;
  /** Radius of the hole at its widest, mm. */
  double clearance{ 0.0 };
  /** What a path through the hole would leave out, mm. */
  double loop{ 0.0 };
};

/** The middle line of a colon from the rectum to the caecum, with the gaps it bridges and the pieces of lumen it joins.
 * \ingroup ColonCentreline */
struct ColonCentreline
{
  /** One curve from the rectum to the caecum, LPS in mm. Point arrays: arcLength (mm from the rectal end), radius (of
   * the largest ball inside the lumen across the line, mm; the bridge's in gaps), gap (1 on a bridge, else 0). Field
   * arrays: lengths (mm, for the exponents 2, 3 and 4), gaps (begin, end), merges (x, y, z, clearance, loop). */
  CurveSet curve;
  /** mm. */
  double                     length{ 0.0 };
  std::vector<CentrelineGap> gaps;
  /** From the rectum to the caecum; those that are not used at the end. */
  std::vector<CentrelinePiece> pieces;
  /** The widest first, one for each place. */
  std::vector<CentrelineMerge> merges;
  /** Of the line for the exponents 2, 3 and 4, mm. */
  std::array<double, 3> lengths{};
  /** Share of the volume of the used pieces that lies beside the line, not in side branches; 0 to 1. Beside: the
   * straight way to the line within the lumen is at most 10 mm + twice the radius there. */
  double coverage{ 0.0 };
  /** In words, with places. */
  Remarks warnings;
  /** Empty, or why the mask is not that of a colon: its line has far more gaps and holes, or its sections are far
   * larger than those of any colon. */
  std::string failure;
};

/** \brief The centreline of the colon from a mask of its lumen.
 *
 * 1. Distance to the wall; pieces are the components of the lumen.
 * 2. Each piece is cut into cells of about one inscribed ball. The widest passages between cells make a tree; passages
 *    that would close long rings are holes in septa between loops that touch, and no path goes through them.
 * 3. The path of a piece is the cheapest one (cost of one mm 1 / (d + 0.1 mm)^3, Dijkstra on 26 neighbours) between its
 *    two ends: the places with d >= 8 mm that are farthest along such paths, prolonged into tapering ends where another
 *    piece follows.
 * 4. The rectum is the end of a piece that lies most caudal, posterior and in the middle between left and right. The
 *    order of the other pieces is that of the shortest joins of their ends, each end once, exact for 14 pieces.
 * 5. The path is moved to the middle of the lumen, smoothed and resampled; gaps are bridged by cubic curves.
 *
 * Patient axes are those of LPS, whatever the axes of the image. Equal input gives equal output for any number of
 * threads. Time is linear in voxels.
 *
 * Source: Bitter et al., Penalized-distance volumetric skeleton algorithm (2001), for the path; the cells and their
 * tree are ours.
 *
 * Throws InputError when there is no lumen of use, with what was found; ParameterError for options out of range.
 * \ingroup ColonCentreline */
ColonCentreline_EXPORT ColonCentreline
TraceColonCentreline(const LumenMask * lumen, const ColonCentrelineOptions & options = {});
} // namespace shapeton

#endif
