#ifndef shapetonColonFlattening_h
#define shapetonColonFlattening_h

#include "ShapetonFlatColonExport.h"
#include "shapetonColonFlatteningOptions.h"
#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonConformalTube.h"
#include "shapetonCurveSet.h"
#include "shapetonJsonForward.h"
#include "shapetonSurfaceHandles.h"
#include "shapetonTubeUnfolding.h"

namespace shapeton
{
/** Options and other inputs of FlattenColon(), and the receiver of its progress. \ingroup ShapetonFlatColon */
struct ColonFlatteningSettings : ColonFlatteningOptions
{
  /** Curve near which to cut the tube, as in TubeOptions. */
  std::vector<Eigen::Vector3d> cut;
  /** Centerline from the rectum to the cecum; identifies the rectum if the surface does not name it. May be empty. */
  CurveSet centerline;
  /** Receives the stage name and the completed fraction of the whole run, from 0 to 1. */
  Progress progress;
};

/** Result of FlattenColon(). \ingroup ShapetonFlatColon */
struct ColonFlattening
{
  /** The flattened tube after preparation, with ears removed, with handles removed if requested, and with caps
   * replacing cut-off pouches (UnfoldedTube). */
  SurfaceMesh surface;
  TubeMap     map;
  /** Number of times u and v were computed; 1 if the first map had no folds. */
  int                   solves{ 0 };
  std::vector<PouchCap> caps;
  /** Number of faces removed by TrimEars(). */
  int ears{ 0 };
  /** Area of ears and cut-off pouches, as a fraction of the area of the prepared tube. */
  double     cutOffAreaFraction{ 0.0 };
  FlatMetric metric{ FlatMetric::HeatDiffusion };
  /** Diffusion time (mm^2); 0 for the Euclidean metric. */
  double time{ 0.0 };
  int    eigenpairs{ 0 };
  /** HeatDiffusionMetric::drownedEdges of the metric of the map. */
  int drownedEdges{ 0 };
  /** NarrowestLevelRadius() (mm); 0 if the time was set. */
  double narrowestRadius{ 0.0 };
  /** Source of the rectum end: "rectumLoop", "centerline" or "firstLoop". */
  std::string rectumFrom;
  int         genusBefore{ 0 };
  int         genusAfter{ 0 };
  /** Distortion in the metric of the map and in the Euclidean metric. */
  FlatDistortion  distortion;
  FlatDistortion  distortionInSpace;
  TriangleQuality quality;
  TriangleQuality qualityInSpace;
  /** Handles of the surface before removal; `flatPlace` is on the final map. */
  HandleDetection handles;
  /** Flipped faces more than 3 rings away from a handle. */
  int     flipsAwayFromHandles{ 0 };
  Remarks warnings;
};

/** Flattens a tube: preparation, metric, map, handle removal. Throws InputError with the prefix `what` if the surface
 * is not a tube or the time is unsuitable for the metric, and ParameterError for options out of range.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT ColonFlattening
FlattenColon(SurfaceMesh mesh, const std::string & what, const ColonFlatteningSettings & options = {});

/** Statistics as JSON. Keys: faces, genusBefore, genusAfter, metric, time (mm^2), eigenpairs (null: all), drownedEdges,
 * modulusU, modulusV, modulusGap (relative), circumference, length (mm), flips, flipsAwayFromHandles, solves, ears
 * (faces), caps (a list of neck in mm, area in mm^2 and place in LPS mm), cutOffAreaFraction, dilatation and
 * dilatationInSpace (median, p95, p99 over unflipped wall faces without caps, each counted once), triangleQuality and
 * triangleQualityInSpace (mean, shareBelowThreshold, histogram), handles (a list of genus, place, flatPlace, radius),
 * falseAlarms, rectumFrom, narrowestRadius (mm; null: not needed). Numbers are rounded to 9 significant digits.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT Json
ColonFlatteningToJson(const ColonFlattening & flattening);

/** Writes a VTP file with one point per handle, the arrays genus, uv and radius (mm), and `facts` as metadata. If there
 * are no handles, the file does not contain points. Throws OutputError. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT void
WriteHandles(const std::vector<SurfaceHandle> &                       handles,
             const std::vector<std::pair<std::string, std::string>> & facts,
             const std::string &                                      path);

/** Returns the points of a single curve. Throws InputError with the prefix `what` if there are several curves or the
 * curve is a single point. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<Eigen::Vector3d>
                         OnlyCurve(const CurveSet & curves, const std::string & what);
} // namespace shapeton

#endif
