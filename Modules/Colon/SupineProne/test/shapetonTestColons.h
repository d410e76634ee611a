#ifndef shapetonTestColons_h
#define shapetonTestColons_h

#include "shapetonColonPositionFiles.h"
#include "shapetonFlatTestTubes.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonJson.h"
#include "shapetonRegistrationErrors.h"
#include "shapetonSurfaceWriter.h"

#include <algorithm>
#include <filesystem>

/** Synthetic colons in several positions: straight tubes with three bands and folds between them. */
namespace tubecolons
{
using flattubes::pi;
constexpr double radius = 20.0;
constexpr double length = 600.0;
constexpr double firstArc = 10.0; ///< distance at the start of the test tubes, mm

struct Fold
{
  double s;    ///< mm
  double turn; ///< of the center
};

inline double
Uneven(int i)
{
  const double value = std::sin(12.9898 * i + 78.233) * 43758.5453;
  return value - std::floor(value);
}

/** Folds between three bands at turns 0, 1/3 and 2/3, with uneven gaps. */
inline std::vector<Fold>
FoldsOfPatient(int patient)
{
  std::vector<Fold> folds;
  for (int row = 0; row < 3; ++row)
  {
    int k = 1000 * patient + 100 * row;
    for (double s = 12.0 + 20.0 * Uneven(k); s < length - 12.0; s += 14.0 + 26.0 * Uneven(++k))
    {
      folds.push_back({ s, (row + 0.5) / 3.0 });
    }
  }
  return folds;
}

/** Maps a point of the first position to the second. */
struct Movement
{
  double rotation{ 0.0 };   ///< turns
  double stretch{ 0.0 };    ///< maximum, mm
  double turnBehind{ 0.0 }; ///< additional rotation of the second half, turns
  double
  S(double s) const
  {
    return s + stretch * std::sin(2.0 * pi * s / length);
  }
  shapeton::CylinderPlace
  operator()(const shapeton::CylinderPlace & place) const
  {
    return { this->S(place.s), place.turn + rotation + (place.s > 0.5 * length ? turnBehind : 0.0) };
  }
};

inline flattubes::TubeForm
Form()
{
  return { 60, 300, 2.0 * pi * radius, length };
}

/** The tube with folds 5 mm high. */
inline shapeton::SurfaceMesh
MakeWall(const std::vector<shapeton::CylinderPlace> & folds)
{
  return flattubes::MakeFlatTube(Form(), [&](double u, double angle) {
    double depth = 0.0;
    for (const shapeton::CylinderPlace & place : folds)
    {
      const double around = shapeton::TurnDifference(angle / (2.0 * pi), place.turn) * Form().circumference;
      const double along = (u - place.s) / 2.5;
      depth = std::max(depth, 5.0 * std::exp(-along * along) / (1.0 + std::exp((std::abs(around) - 17.0) / 1.5)));
    }
    return flattubes::OnCylinder(radius - depth, u, -angle);
  });
}

inline shapeton::HaustralFold
MakeFold(int label, const shapeton::CylinderPlace & place)
{
  constexpr double halfExtent = 0.13; // turns
  const auto       uvAt = [&](double turn) {
    return Eigen::Vector2d(place.s, (turn - std::floor(turn)) * Form().circumference);
  };
  const auto pointAt = [&](double turn, double depth) {
    return flattubes::OnCylinder(radius - depth, place.s, -2.0 * pi * turn);
  };
  shapeton::HaustralFold fold;
  fold.label = label;
  fold.centerUv = uvAt(place.turn);
  fold.center = pointAt(place.turn, 5.0);
  fold.endUv = { uvAt(place.turn - halfExtent), uvAt(place.turn + halfExtent) };
  fold.ends = { pointAt(place.turn - halfExtent, 2.0), pointAt(place.turn + halfExtent, 2.0) };
  fold.length = 34.0;
  fold.area = 150.0;
  fold.height = 5.0;
  fold.reliability = 1.0;
  fold.arcLength = firstArc + place.s;
  return fold;
}

/** Three bands; the first is at `firstTurn`. */
inline shapeton::CurveSet
MakeTaeniae(double firstTurn, bool isReversed)
{
  shapeton::CurveSet taeniae;
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    taeniae.curves.emplace_back();
    for (int i = 0; i <= 60; ++i)
    {
      const int    vertex = static_cast<int>(taeniae.V.rows());
      const double u = 5.0 + (length - 10.0) * i / 60.0;
      const double turn = (isReversed ? -1.0 : 1.0) * (taenia / 3.0 + firstTurn);
      taeniae.V.conservativeResize(vertex + 1, 3);
      taeniae.V.row(vertex) = flattubes::OnCylinder(radius, u, -2.0 * pi * turn);
      taeniae.curves.back().push_back(vertex);
    }
  }
  return taeniae;
}

inline shapeton::CurveSet
MakeCenterline()
{
  shapeton::CurveSet centerline;
  centerline.curves.emplace_back();
  centerline.V.resize(121, 3);
  centerline.pointArrays = { { "arcLength", shapeton::SurfaceArray::ValueMatrix(121, 1), false } };
  for (int i = 0; i <= 120; ++i)
  {
    centerline.V.row(i) << 0.0, 0.0, length * i / 120.0;
    centerline.pointArrays[0].values(i, 0) = firstArc + length * i / 120.0;
    centerline.curves[0].push_back(i);
  }
  return centerline;
}

/** A colon with these folds before the movement, starting at the cecum if `isReversed`. Uses the curvature of the
 * grid. */
inline shapeton::ColonPositionFiles
MakeExamination(const std::string &       name,
                const std::vector<Fold> & folds,
                const Movement &          movement,
                bool                      isReversed = false)
{
  std::vector<shapeton::CylinderPlace> places;
  for (const Fold & fold : folds)
  {
    const shapeton::CylinderPlace moved = movement({ fold.s, fold.turn });
    places.push_back(isReversed ? shapeton::CylinderPlace{ length - moved.s, -moved.turn } : moved);
  }
  std::stable_sort(places.begin(), places.end(), [](const auto & a, const auto & b) { return a.s < b.s; });
  shapeton::ColonPositionFiles files;
  files.position.name = name;
  files.position.flat = std::make_shared<shapeton::FlatColon>(MakeWall(places));
  files.position.centerline = MakeCenterline();
  files.position.taeniae = MakeTaeniae(movement.rotation, isReversed);
  for (const shapeton::CylinderPlace & place : places)
  {
    files.position.folds.push_back(MakeFold(static_cast<int>(files.position.folds.size()) + 1, place));
  }
  for (int flexure = 0; flexure < 4; ++flexure)
  {
    files.position.flexures[flexure] = firstArc + movement.S(length * (flexure + 1) / 5.0);
  }
  const char * const names[] = { "rectum", "sigmoid", "descending", "transverse", "ascending" };
  for (int segment = 0; segment < 5; ++segment)
  {
    files.segments.push_back({ segment + 1,
                               names[segment],
                               segment == 0 ? 0.0 : files.position.flexures[segment - 1],
                               segment == 4 ? firstArc + length : files.position.flexures[segment],
                               1.0 });
  }
  return files;
}

/** The colon of a patient. */
inline shapeton::ColonPositionFiles
MakeExamination(const std::string & name, int patient, const Movement & movement, bool isReversed = false)
{
  return MakeExamination(name, FoldsOfPatient(patient), movement, isReversed);
}

inline shapeton::ColonPosition
MakePosition(const std::string & name, int patient, const Movement & movement, bool isReversed = false)
{
  return MakeExamination(name, patient, movement, isReversed).position;
}

/** The parts of landmarks.json that registration requires. */
inline shapeton::Json
LandmarksOf(const shapeton::ColonPositionFiles & files)
{
  shapeton::Json document;
  document["flexures"] = shapeton::Json::array();
  for (int i = 0; i < 4; ++i)
  {
    document["flexures"].push_back({ { "number", i + 1 },
                                     { "found", std::isfinite(files.position.flexures[i]) },
                                     { "arcLength", files.position.flexures[i] },
                                     { "confidence", files.position.flexureConfidence[i] } });
  }
  document["segments"] = shapeton::Json::array();
  for (const shapeton::ColonSegmentExtent & segment : files.segments)
  {
    document["segments"].push_back({ { "number", segment.label },
                                     { "name", segment.name },
                                     { "area", segment.area },
                                     { "begin", segment.begin },
                                     { "end", segment.end } });
  }
  return document;
}

/** Writes the files of a VirtualColonoscopy folder that registration reads. */
inline void
WriteExamination(const shapeton::ColonPositionFiles & files, const std::string & folder)
{
  for (const char * stage : { "segmentation", "flattening", "landmarks", "folds" })
  {
    std::filesystem::create_directories(folder + '/' + stage);
  }
  shapeton::WriteCurves(files.position.centerline, folder + "/segmentation/centerline.vtp");
  const shapeton::SurfaceMesh & flat = files.position.flat->Surface();
  shapeton::WriteSurface(flat, folder + "/flattening/flat.vtp");
  shapeton::WriteJson(LandmarksOf(files), folder + "/landmarks/landmarks.json");
  shapeton::WriteCurves(files.position.taeniae, folder + "/landmarks/taeniae.vtp");
  shapeton::SurfaceMesh  withCurvature = flat;
  shapeton::SurfaceArray curvature{ "meanCurvature", shapeton::SurfaceArray::ValueMatrix(flat.V.rows(), 1), false };
  for (Eigen::Index i = 0; i < flat.V.rows(); ++i)
  {
    curvature.values(i, 0) = 1.0 / flat.V.row(i).head<2>().norm() - 1.0 / radius; // highest on folds
  }
  withCurvature.pointArrays.push_back(curvature);
  shapeton::WriteSurface(withCurvature, folder + "/landmarks/folds-surface.vtp");
  shapeton::HaustralFolds folds;
  folds.folds = files.position.folds;
  shapeton::TableOfFolds(folds).Write(folder + "/folds/folds.csv");
}

/** Wall points between the folds, in the first position and after the movement. */
inline std::vector<shapeton::PointPair>
KnownPoints(const Movement & movement)
{
  std::vector<shapeton::PointPair> pairs;
  for (double s = 20.0; s < length - 20.0; s += 7.0)
  {
    for (int taenia = 0; taenia < 12; ++taenia)
    {
      const shapeton::CylinderPlace moved = movement({ s, taenia / 12.0 });
      pairs.push_back({ flattubes::OnCylinder(radius, s, -2.0 * pi * taenia / 12.0),
                        flattubes::OnCylinder(radius, moved.s, -2.0 * pi * moved.turn) });
    }
  }
  return pairs;
}
} // namespace tubecolons

#endif
