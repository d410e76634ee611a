#ifndef shapetonColonLandmarks_h
#define shapetonColonLandmarks_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonSegments.h"
#include "shapetonColonTaeniae.h"
#include "shapetonIleocecalValve.h"
#include "shapetonSurfaceFolds.h"

#include "shapetonJsonForward.h"

#include <memory>
#include <optional>

namespace shapeton
{
/** Options of FindColonLandmarks(). \ingroup ShapetonColonLandmarks */
struct ColonLandmarkOptions
{
  FlexureRule flexureRule{ FlexureRule::Ordered };
  TaeniaRule  taeniaRule{ TaeniaRule::Joint };
  /** Manually marked points on taeniae coli; LPS, mm. */
  std::vector<Eigen::Vector3d> markers;
  /** Called with the stage and the completed fraction, 0 to 1. */
  Progress progress;
};

/** The landmarks of a colon. \ingroup ShapetonColonLandmarks */
struct ColonLandmarks
{
  /** The wall without its cut; walks and faces below refer to it. */
  std::shared_ptr<const ColonWallTube> tube;
  ColonFlexures                        flexures;
  ColonSegments                        segments;
  /** The valve stored with the centerline. */
  std::optional<IleocecalValve> valve;
  /** Position of the valve on the map, mm. */
  Eigen::Vector2d valveUv{ Eigen::Vector2d::Zero() };
  SurfaceFolds    folds;
  ColonTaeniae    taeniae;
  /** Stretches where the wall is not visible; empty if the centerline has no such array. */
  std::optional<std::vector<HinderedStretch>> hindered;
  /** End of the centerline, mm. */
  double  lengthOfCenterline{ 0.0 };
  Remarks warnings;
};

/** Finds flexures, segments, folds on the surface and taeniae coli of a flat colon from FlattenTube() and its
 * centerline. A landmark that is not found is absent, and a warning states why. Throws InputError when the surface is
 * not a flat tube, or the centerline belongs to another surface. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonLandmarks
FindColonLandmarks(const FlatColon & flat, const CurveSet & centerline, const ColonLandmarkOptions & options = {});

/** Assessable part of a segment, 1 to 6; empty if a border or the hindrances are unknown.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::optional<ColonAssessability>
                      AssessabilityOfSegment(const ColonLandmarks & landmarks, int segment);

/** \name Contents of landmark files */
///@{
/** Loops of the flexures found, each closed by its first vertex; cell arrays flexure, arcLength (mm), confidence. Empty
 * if no flexure was found. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT CurveSet
FlexureCurves(const ColonLandmarks & landmarks);
/** The flat surface with the cell array segment. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT SurfaceMesh
SegmentSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** The flat surface with the cell array fold and the point array meanCurvature (1/mm). \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT SurfaceMesh
FoldSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** Stable keys: flexureRule, mirrored, backwards, flexures (a list of number, name, found, reason, position, arcLength,
 * uv, confidence, and notAssessable where the wall is not visible: HindranceToJson()), cecum (the same, with source:
 * ileocecalValve or estimated), ileocecalValve (found, position, arcLength, uv, length, width, confidence), segments
 * (a list of number, name, begin, end, length, area, and, if the centerline has the array, those of
 * AssessabilityToJson()), segmentsNotFound (names), notAssessable (StretchesToJson()), surfaceFolds (number,
 * leastCurvature in 1/mm, area), taeniae. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT Json
ColonLandmarksToJson(const ColonLandmarks & landmarks);
///@}
} // namespace shapeton

#endif
