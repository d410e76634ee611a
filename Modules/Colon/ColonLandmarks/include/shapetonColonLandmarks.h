#ifndef shapetonColonLandmarks_h
#define shapetonColonLandmarks_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonLandmarkOptions.h"
#include "shapetonColonSegments.h"
#include "shapetonColonTaeniae.h"
#include "shapetonIleocecalValve.h"
#include "shapetonSurfaceFolds.h"
#include "shapetonTaeniaNames.h"

#include "shapetonJsonForward.h"

#include <array>
#include <memory>
#include <optional>

namespace shapeton
{
/** Settings of FindColonLandmarks(). \ingroup ShapetonColonLandmarks */
struct ColonLandmarkSettings : ColonLandmarkOptions
{
  /** Manually marked points on taeniae coli; LPS, mm. */
  std::vector<Eigen::Vector3d> markers;
  /** From FindPelvis(); improves the descending-sigmoid flexure. */
  std::optional<Pelvis> pelvis;
  /** Called with the stage and the completed fraction, 0 to 1. */
  Progress progress;
  /** Order of the found taeniae (1 to 3), for the same numbers as in another position; see CommonTaeniae. */
  std::array<int, 3> taeniaNumbers{ { 1, 2, 3 } };
};

/** The landmarks of a colon. \ingroup ShapetonColonLandmarks */
struct ColonLandmarks
{
  /** The wall with the cut closed; vertices and faces below refer to it. */
  std::shared_ptr<const ColonWallTube> tube;
  ColonFlexures                        flexures;
  ColonSegments                        segments;
  /** The pelvis in the settings. */
  std::optional<Pelvis> pelvis;
  /** The ileocecal valve stored with the centerline. */
  std::optional<IleocecalValve> valve;
  /** Position of the valve on the map, mm. */
  Eigen::Vector2d valveUv{ Eigen::Vector2d::Zero() };
  SurfaceFolds    folds;
  ColonTaeniae    taeniae;
  TaeniaNames     taeniaNames;
  /** Stretches where the wall is not visible; empty if the array notAssessable is missing. */
  std::optional<std::vector<HinderedStretch>> hindered;
  /** End of the centerline, mm. */
  double  lengthOfCenterline{ 0.0 };
  Remarks warnings;
};

/** Finds flexures, segments, surface folds and taeniae coli from the output of FlattenTube() and the centerline. For
 * each missing landmark, a warning states the reason. Throws InputError if the surface is not a flat tube, or the
 * centerline does not match it. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonLandmarks
FindColonLandmarks(const FlatColon & flat, const CurveSet & centerline, const ColonLandmarkSettings & options = {});

/** Assessability of segment 1 to 6; empty if a border or the hindrances are unknown.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::optional<ColonAssessability>
                              AssessabilityOfSegment(const ColonLandmarks & landmarks, int segment);

/** \name Contents of landmark files */
///@{
/** Loops at the flexures found, each ending with its first vertex; cell arrays flexure, arcLength (mm), confidence.
 * Empty if no flexure was found. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT CurveSet
FlexureCurves(const ColonLandmarks & landmarks);
/** The flat surface with the cell array segment. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT SurfaceMesh
SegmentSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** The flat surface with the cell array fold and the point array meanCurvature (1/mm). \ingroup ShapetonColonLandmarks
 */
ShapetonColonLandmarks_EXPORT SurfaceMesh
FoldSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** Stable keys: flexureRule, mirrored, backwards, flexures (a list of number, name, found, reason, position, arcLength,
 * uv, confidence, for the descending-sigmoid flexure decidedBy: bone or course, and notAssessable where the wall is not
 * visible: HindranceToJson()), pelvis (found, leftCrest, rightCrest, promontory, reason), cecum (the same as a flexure,
 * with source: ileocecalValve or estimated), ileocecalValve (found, position, arcLength, uv, length, width,
 * confidence), segments (a list of number, name, begin, end, length, area, and, with the array notAssessable, the keys
 * of AssessabilityToJson()), segmentsNotFound (names), notAssessable (StretchesToJson()), surfaceFolds (number,
 * leastCurvature in 1/mm, area), taeniae. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT Json
ColonLandmarksToJson(const ColonLandmarks & landmarks);
///@}
} // namespace shapeton

#endif
