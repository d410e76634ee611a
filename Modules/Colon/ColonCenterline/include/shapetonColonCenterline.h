#ifndef shapetonColonCenterline_h
#define shapetonColonCenterline_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonCurveSet.h"
#include "ShapetonColonCenterlineExport.h"
#include "shapetonLumenDistance.h"

#include "itkPoint.h"

#include <array>
#include <optional>
#include <string>

namespace shapeton
{
/** Options of TraceColonCenterline(): path cost, starting point, and the choice of lumen pieces.
 * \ingroup ShapetonColonCenterline */
struct ColonCenterlineOptions
{
  /** One mm of path costs 1 / (d + 0.1 mm)^exponent, d the distance to the wall; from 1 to 8. */
  int exponent{ 3 };
  /** Start of the line in the rectum, LPS in mm; detected automatically if not given. */
  std::optional<itk::Point<double, 3>> start;
  /** Points in the colon, LPS in mm: the nearest pieces of lumen are used, whatever their size. */
  std::vector<itk::Point<double, 3>> seedPoints;
  /** Smallest piece of lumen to use, ml. */
  double minimumVolume{ 5.0 };
  /** A piece of at least a fifth of that volume is also used if the diagonal of its box is at least this, mm. */
  double minimumExtent{ 60.0 };
  /** Distance between points of the line, mm, from 0.2 to 10. */
  double step{ 1.0 };
  /** Standard deviation of the smoothing along the line, mm, from 0 to 20. */
  double smoothing{ 4.0 };
  /** Radius assigned to bridges over gaps, mm. */
  double gapRadius{ 2.0 };
  /** Called with the completed fraction, 0 to 1. */
  Progress progress;
};

/** A stretch without lumen that the line bridges. \ingroup ShapetonColonCenterline */
struct CenterlineGap
{
  /** First and last arcLength, mm. */
  double                begin{ 0.0 };
  double                end{ 0.0 };
  itk::Point<double, 3> from;
  itk::Point<double, 3> to;
  /** Straight distance between the ends of the lumen, mm. */
  double distance{ 0.0 };
  /** The order of the pieces is uncertain: the gap is longer than known collapsed stretches (150 mm), or, in a
   * ColonModel, outside the scan. */
  bool isDoubtful{ false };
};

/** A piece of lumen. \ingroup ShapetonColonCenterline */
struct CenterlinePiece
{
  /** Rank by volume among the components of the lumen, from 1. */
  int component{ 0 };
  /** Volume, ml. */
  double volume{ 0.0 };
  bool   isUsed{ false };
  /** First and last arcLength (mm) of a used piece. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** Why the piece is not used; empty for a used piece. */
  std::string           reason;
  itk::Point<double, 3> place;
};

/** A place where two loops of the colon touch and their lumens are connected. \ingroup ShapetonColonCenterline */
struct CenterlineMerge
{
  itk::Point<double, 3> place;
  /** Radius of the hole at its widest, mm. */
  double clearance{ 0.0 };
  /** Length that a path through the hole would skip, mm. */
  double loop{ 0.0 };
};

/** The centerline of a colon from the rectum to the cecum, with the gaps it bridges and the pieces of lumen it joins.
 * \ingroup ShapetonColonCenterline */
struct ColonCenterline
{
  /** One curve from the rectum to the cecum, LPS in mm. Point arrays: arcLength (mm from the rectal end), radius (mm;
   * the largest ball inside the lumen across the line, or the bridge radius in gaps), gap (1 on a bridge, else 0).
   * Field arrays: lengths (mm, for the exponents 2, 3 and 4), gaps (begin, end), merges (x, y, z, clearance, loop). */
  CurveSet curve;
  /** Length of the line, mm. */
  double                     length{ 0.0 };
  std::vector<CenterlineGap> gaps;
  /** From the rectum to the cecum; unused pieces last. */
  std::vector<CenterlinePiece> pieces;
  /** Widest first, one for each place. */
  std::vector<CenterlineMerge> merges;
  /** Lengths of the line for the exponents 2, 3 and 4, mm. */
  std::array<double, 3> lengths{};
  /** Share of the used volume near the line rather than in side branches, 0 to 1. Near: the straight way to the line
   * within the lumen is at most 10 mm + twice the radius there. */
  double coverage{ 0.0 };
  /** Warnings, with positions. */
  Remarks warnings;
  /** Empty, or why the mask is not a colon: its line has far more gaps and holes, or its sections are far larger than
   * in any colon. */
  std::string failure;
};

/** \brief The centerline of the colon from a mask of its lumen.
 *
 * 1. Distance to the wall; pieces are the components of the lumen.
 * 2. Each piece is cut into cells of about one inscribed ball. The widest passages between cells form a tree. Passages
 *    that would close long rings are holes in septa between touching loops; no path uses them.
 * 3. The path of a piece is the cheapest one (1 mm costs 1 / (d + 0.1 mm)^3, Dijkstra on 26 neighbors) between its two
 *    ends: the places with d >= 8 mm that are farthest along such paths, extended into tapering ends where another
 *    piece follows.
 * 4. The rectum is the most caudal, posterior and medial end of a piece. The other pieces are ordered by the shortest
 *    joins of their ends, each end used once; exact for up to 14 pieces.
 * 5. The path is moved to the middle of the lumen, smoothed and resampled; gaps are bridged by cubic curves.
 *
 * Directions are those of LPS, whatever the axes of the image. Equal input gives equal output for any number of
 * threads. Time is linear in voxels.
 *
 * Source: Bitter et al., Penalized-distance volumetric skeleton algorithm (2001), for the path; the cells and their
 * tree are ours.
 *
 * Throws InputError, with the findings, when no usable lumen is found; ParameterError for options out of range.
 * \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT ColonCenterline
TraceColonCenterline(const LumenMask * lumen, const ColonCenterlineOptions & options = {});
} // namespace shapeton

#endif
