#ifndef shapetonColonFlattening_h
#define shapetonColonFlattening_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonConformalTube.h"
#include "shapetonCurveSet.h"
#include "shapetonJsonForward.h"
#include "shapetonSurfaceHandles.h"
#include "shapetonTubeUnfolding.h"

namespace shapeton
{
/** The lengths of edges that a flat map keeps conformally. \ingroup ConformalFlattening */
enum class FlatMetric
{
  /** Straight lengths of edges. */
  Euclidean,
  /** Heat diffusion distances of all eigenpairs. */
  HeatDiffusion,
  /** Those of the first eigenpairs, as published. */
  TruncatedHeatDiffusion
};

/** Metric, handles and cut for FlattenColon(). \ingroup ConformalFlattening */
struct ColonFlatteningOptions
{
  FlatMetric metric{ FlatMetric::HeatDiffusion };
  /** Time of diffusion, mm^2; 0: DefaultDiffusionTime(), or the Euclidean metric where IsTooCoarseForDiffusion(). */
  double time{ 0.0 };
  /** Of TruncatedHeatDiffusion. */
  int eigenpairs{ 50 };
  /** Detects handles on the Euclidean map and cuts them out, several times if need be, before the map is made. */
  bool        removeHandles{ false };
  TubeOptions tube;
  /** From the rectum to the caecum; tells the rectum where the surface does not name it. May be empty. */
  CurveSet centreline;
  /** Told the stage and the share of the whole, from 0 to 1. */
  Progress progress;
};

/** A flattened colon with what was measured. \ingroup ConformalFlattening */
struct ColonFlattening
{
  /** The tube that was flattened: prepared, without ears, without handles if they were removed, and with caps where
   * pouches were cut off (UnfoldedTube). */
  SurfaceMesh surface;
  TubeMap     map;
  /** How often u and v of the map were computed: once, where it had no folds. */
  int                   solves{ 0 };
  std::vector<PouchCap> caps;
  /** Faces that TrimEars() removed. */
  int ears{ 0 };
  /** The part of the area of the prepared tube that ears and cut off pouches had. */
  double     cutOffAreaFraction{ 0.0 };
  FlatMetric metric{ FlatMetric::HeatDiffusion };
  /** mm^2; 0 for the Euclidean metric. */
  double time{ 0.0 };
  int    eigenpairs{ 0 };
  /** HeatDiffusionMetric::drownedEdges of the map's metric. */
  int drownedEdges{ 0 };
  /** NarrowestLevelRadius(), mm; 0 where the time was given. */
  double narrowestRadius{ 0.0 };
  /** What told which end is the rectum: "rectumLoop", "centreline" or "firstLoop". */
  std::string rectumFrom;
  int         genusBefore{ 0 };
  int         genusAfter{ 0 };
  /** In the metric of the map, and in space. */
  FlatDistortion  distortion;
  FlatDistortion  distortionInSpace;
  TriangleQuality quality;
  TriangleQuality qualityInSpace;
  /** On the surface before removal; `flatPlace` is on the final map. */
  HandleDetection handles;
  /** Flipped faces farther than 3 rings from a handle. */
  int     flipsAwayFromHandles{ 0 };
  Remarks warnings;
};

/** From a tube to its flat map: preparation, metric, map, handles. Throws InputError that begins with `what` where the
 * surface is no tube, and for a time that suits no metric; ParameterError for a time below 0 or not finite.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT ColonFlattening
FlattenColon(SurfaceMesh mesh, const std::string & what, const ColonFlatteningOptions & options = {});

/** The statistics for programs. Keys: faces, genusBefore, genusAfter, metric, time (mm^2), eigenpairs (null: all),
 * drownedEdges, modulusU, modulusV, modulusGap (relative), circumference, length (mm), flips, flipsAwayFromHandles,
 * solves, ears (faces), caps (a list of neck in mm, area in mm^2 and place in LPS mm), cutOffAreaFraction, dilatation
 * and dilatationInSpace (median, p95, p99: of faces of the wall, not of caps, that are not flipped, each counting
 * once), triangleQuality and triangleQualityInSpace (mean, shareBelowThreshold, histogram), handles (a list of genus,
 * place, flatPlace, radius), falseAlarms, rectumFrom, narrowestRadius (mm; null: not needed). Numbers are rounded to 9
 * significant digits. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT Json
ColonFlatteningToJson(const ColonFlattening & flattening);

/** Writes the handles as points of a VTP file with the arrays genus, uv and radius (mm), and these facts; no points
 * where there are no handles. Throws OutputError. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT void
WriteHandles(const std::vector<SurfaceHandle> &                       handles,
             const std::vector<std::pair<std::string, std::string>> & facts,
             const std::string &                                      path);

/** The points of the only curve. Throws InputError that begins with `what` where there are several curves, or it is a
 * point. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<Eigen::Vector3d>
                           OnlyCurve(const CurveSet & curves, const std::string & what);
} // namespace shapeton

#endif
