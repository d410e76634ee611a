#ifndef shapetonColonCenterline_h
#define shapetonColonCenterline_h

#include "shapetonColonCenterlineOptions.h"
#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonCurveSet.h"
#include "ShapetonColonCenterlineExport.h"
#include "shapetonLumenDistance.h"

#include "itkPoint.h"

#include <array>
#include <string>

namespace shapeton
{
/** Settings of TraceColonCenterline(). \ingroup ShapetonColonCenterline */
struct ColonCenterlineSettings : ColonCenterlineOptions
{
  /** Called with the completed fraction, 0 to 1. */
  Progress progress;
};

/** A stretch without lumen, bridged by the line. \ingroup ShapetonColonCenterline */
struct CenterlineGap
{
  /** First and last arcLength, mm. */
  double                begin{ 0.0 };
  double                end{ 0.0 };
  itk::Point<double, 3> from;
  itk::Point<double, 3> to;
  /** Straight distance between the ends of the lumen, mm. */
  double distance{ 0.0 };
  /** Whether the order of the pieces is uncertain: the gap exceeds the longest known collapsed stretch (150 mm) or, in
   * a ColonModel, is outside the scan. */
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
  /** Reason why the piece is not used; empty for a used piece. */
  std::string           reason;
  itk::Point<double, 3> place;
};

/** A contact between two loops of the colon where their lumens are connected. \ingroup ShapetonColonCenterline */
struct CenterlineMerge
{
  itk::Point<double, 3> place;
  /** Radius of the hole at its widest, mm. */
  double clearance{ 0.0 };
  /** Length of the colon that a path through the hole would bypass, mm. */
  double loop{ 0.0 };
};

/** The centerline of a colon from the rectum to the cecum, with the bridged gaps and the joined pieces of lumen.
 * \ingroup ShapetonColonCenterline */
struct ColonCenterline
{
  /** One curve from the rectum to the cecum, LPS in mm. Point arrays: arcLength (mm from the rectal end), radius (mm;
   * that of the largest inscribed ball centered in the cross-section; in gaps, that of the bridge), gap (1 on a bridge,
   * else 0). Field arrays: lengths (mm, for the exponents 2, 3 and 4), gaps (begin, end), merges (x, y, z, clearance,
   * loop). */
  CurveSet curve;
  /** Length of the line, mm. */
  double                     length{ 0.0 };
  std::vector<CenterlineGap> gaps;
  /** In order from the rectum to the cecum; unused pieces last. */
  std::vector<CenterlinePiece> pieces;
  /** Widest first, one per contact. */
  std::vector<CenterlineMerge> merges;
  /** Lengths of the line for the exponents 2, 3 and 4, mm. */
  std::array<double, 3> lengths{};
  /** Fraction of the used volume near the line rather than in side branches, 0 to 1. A voxel is near if its path to the
   * line within the lumen is at most 10 mm plus twice the local radius. */
  double coverage{ 0.0 };
  /** Warnings, with positions. */
  Remarks warnings;
  /** Reason why the mask cannot be a colon: far too many gaps and holes, or cross-sections that are far too large;
   * empty otherwise. */
  std::string failure;
};

/** \brief Computes the centerline of the colon from a mask of its lumen.
 *
 * 1. Compute the distance to the wall and the connected components (pieces) of the lumen.
 * 2. Partition each piece into cells, each about the size of an inscribed ball. The widest passages between cells form
 *    a tree. Passages that would close long rings are holes in septa between touching loops and are excluded from
 *    paths.
 * 3. Find the minimal path of each piece (cost 1 / (d + 0.1 mm)^3 per mm, Dijkstra on 26 neighbors) between its two
 *    ends: the points with d >= 8 mm farthest apart along such paths, extended into tapering ends where another piece
 *    follows.
 * 4. Start at the rectum, the most caudal, posterior and medial end of a piece, and order the other pieces by the
 *    shortest joins between their ends, using each piece once; exact for up to 14 pieces.
 * 5. Center, smooth and resample the path; bridge gaps with cubic curves.
 *
 * Anatomical directions refer to LPS for any image orientation. The result does not depend on the number of threads.
 * Time is linear in the number of voxels.
 *
 * Source: Bitter et al., Penalized-distance volumetric skeleton algorithm (2001), for the path; the cells and their
 * tree are original work.
 *
 * Throws InputError if no usable lumen is found, and ParameterError for options out of range.
 * \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT ColonCenterline
TraceColonCenterline(const LumenMask * lumen, const ColonCenterlineSettings & options = {});
} // namespace shapeton

#endif
