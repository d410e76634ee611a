#ifndef shapetonColonLandmarks_h
#define shapetonColonLandmarks_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonSegments.h"
#include "shapetonColonTaeniae.h"
#include "shapetonIleocaecalValve.h"
#include "shapetonSurfaceFolds.h"

#include "shapetonJsonForward.h"

#include <memory>
#include <optional>

namespace shapeton
{
/** Rules and hints for FindColonLandmarks(). \ingroup ColonLandmarks */
struct ColonLandmarkOptions
{
  FlexureRule flexureRule{ FlexureRule::Ordered };
  TaeniaRule  taeniaRule{ TaeniaRule::Joint };
  /** Points on taeniae that a person has marked; LPS, mm. */
  std::vector<Eigen::Vector3d> markers;
  /** Told the stage and the share of the whole, from 0 to 1. */
  Progress progress;
};

/** The landmarks of a colon. \ingroup ColonLandmarks */
struct ColonLandmarks
{
  /** The wall without its cut; what walks and faces below refer to. */
  std::shared_ptr<const ColonWallTube> tube;
  ColonFlexures                        flexures;
  ColonSegments                        segments;
  /** As the centreline tells it. */
  std::optional<IleocaecalValve> valve;
  /** Its place on the map, mm. */
  Eigen::Vector2d valveUv{ Eigen::Vector2d::Zero() };
  SurfaceFolds    folds;
  ColonTaeniae    taeniae;
  /** Where the wall is not seen; nothing where the centreline does not tell. */
  std::optional<std::vector<HinderedStretch>> hindered;
  /** mm: the end of the centreline. */
  double  lengthOfCentreline{ 0.0 };
  Remarks warnings;
};

/** Flexures, segments, folds on the surface and taeniae of a flat colon, as FlattenTube() gives it, with its
 * centreline. A landmark that is not found is absent, and the warnings say why. Throws InputError where the surface is
 * no flat tube, or the centreline does not belong to it. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT ColonLandmarks
FindColonLandmarks(const FlatColon & flat, const CurveSet & centreline, const ColonLandmarkOptions & options = {});

/** How much of a segment, 1 to 6, can be assessed; nothing where a border or the hindrances are not known.
 * \ingroup ColonLandmarks */
ColonLandmarks_EXPORT std::optional<ColonAssessability>
                      AssessabilityOfSegment(const ColonLandmarks & landmarks, int segment);

/** \name What the files of landmarks hold */
///@{
/** The loops of the flexures that were found, each closed by its first vertex; cell arrays flexure, arcLength (mm),
 * confidence. No curve where none was found. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT CurveSet
FlexureCurves(const ColonLandmarks & landmarks);
/** The flat surface with the cell array segment. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT SurfaceMesh
SegmentSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** The flat surface with the cell array fold and the point array meanCurvature (1/mm). \ingroup ColonLandmarks */
ColonLandmarks_EXPORT SurfaceMesh
FoldSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks);
/** Keys, whose names stay: flexureRule, mirrored, backwards, flexures (a list of number, name, found, reason, position,
 * arcLength, uv, confidence, and notAssessable where the wall is not seen there: HindranceToJson()), caecum (the same,
 * with source: ileocaecalValve or estimated), ileocaecalValve (found, position, arcLength, uv, length, width,
 * confidence), segments (a list of number, name, begin, end, length, area, and where the centreline tells those of
 * AssessabilityToJson()), segmentsNotFound (names), notAssessable (StretchesToJson()), surfaceFolds (number,
 * leastCurvature in 1/mm, area), taeniae. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT Json
ColonLandmarksToJson(const ColonLandmarks & landmarks);
///@}
} // namespace shapeton

#endif
