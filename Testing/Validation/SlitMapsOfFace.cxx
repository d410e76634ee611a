#include "FigureTools.h"
#include "GeneratedSurfaces.h"
#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonConformalMapPicture.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonHolomorphicForm.h"

#include <cmath>

using namespace shapeton;

namespace
{
void
DrawFace(const SurfaceMesh & mesh, const ConformalMap & map, const std::string & path)
{
  const PictureSheet::Layout layout{ 3, 3, 360, 360, false };
  PictureSheet               sheet("Figure 5.3: a face with three holes", layout);
  const auto                 options = ViewOf(layout);
  const auto                 checks = PolarCheckerboard(36);
  const auto                 uv = FlatCoordinates(map.flat, "the map");
  const HolomorphicForm      form = HolomorphicFormsOf(map).front();
  const PlanePattern         plain = [](double, double) { return MakeColor(226, 178, 164); };
  const Eigen::MatrixX2d     turned = form.values.rowwise().reverse();
  sheet.Put(0, 0, "outer boundary yellow, three inner ones", DrawPattern(mesh, uv, plain, map.loops, options));
  sheet.Put(0, 1, "checkerboard of the slit map 2", DrawPattern(mesh, uv, checks, map.loops, options));
  sheet.Put(
    0, 2, "slit map 2: boundary 2 is the inner circle", DrawPattern(PlaneOf(mesh, uv), uv, checks, map.loops, options));
  sheet.Put(1,
            0,
            "level sets of f, 1 on boundary 2",
            DrawPattern(form.mesh, form.values, LevelSets(0.0, 1.0, 0.05), {}, options));
  const double least = turned.col(0).minCoeff();
  const double most = turned.col(0).maxCoeff();
  sheet.Put(1,
            1,
            "level sets of its conjugate",
            DrawPattern(form.mesh, turned, LevelSets(least, most, (most - least) / 40), {}, options));
  sheet.Put(
    1, 2, "both: the holomorphic form", DrawPattern(form.mesh, form.values, Checkerboard(0.05), map.loops, options));
  for (std::size_t k = 1; k < map.slitMaps.size(); ++k)
  {
    const std::string      number = std::to_string(map.slitMaps[k].inner + 1);
    const auto * const     other = FindSurfaceArray(map.flat.pointArrays, "slitMap" + number);
    const Eigen::MatrixX2d places = other->values;
    sheet.Put(2, k - 1, "slit map " + number, DrawPattern(PlaneOf(mesh, places), places, checks, map.loops, options));
  }
  sheet.Put(2,
            2,
            "checkerboard of slit map 4",
            DrawPattern(mesh, FindSurfaceArray(map.flat.pointArrays, "slitMap4")->values, checks, map.loops, options));
  sheet.Write(path);
}

/** Largest deviation of a boundary from a circle around the middle, relative to its radius. */
double
DeviationFromCircles(const ConformalMap & map, const SurfaceArray::ValueMatrix & places)
{
  double largest = 0.0;
  for (const BoundaryLoop & loop : map.loops)
  {
    const double radius = places.row(loop.vertices.front()).norm();
    for (const int vertex : loop.vertices)
    {
      largest = std::max(largest, std::abs(places.row(vertex).norm() / radius - 1.0));
    }
  }
  return largest;
}

void
AddMaps(const std::string &     metric,
        const ConformalMap &    map,
        double                  mostGap,
        CsvTable &              table,
        std::array<double, 3> & largest,
        ValidationReport &      report)
{
  for (const SlitMap & slit : map.slitMaps)
  {
    const auto &    places = FindSurfaceArray(map.flat.pointArrays, "slitMap" + std::to_string(slit.inner + 1))->values;
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(slit.turnsOfLoops.size());
    wanted[map.outer] = 1.0;
    wanted[slit.inner] = -1.0;
    const double periods = (slit.turnsOfLoops - wanted).cwiseAbs().maxCoeff();
    const double circles = DeviationFromCircles(map, places);
    const double gap = slit.modulusU / slit.modulusV - 1.0;
    largest = { { std::max(largest[0], gap), std::max(largest[1], periods), std::max(largest[2], circles) } };
    table.AddRow(Cells() << metric << slit.inner + 1 << Rounded(slit.modulusU, 5) << Rounded(slit.modulusV, 5)
                         << Rounded(100.0 * gap, 2) << Rounded(periods, 1) << Rounded(circles, 1)
                         << report.Check(gap > 0.0 && gap < mostGap && periods < 1e-9 && circles < 1e-12));
  }
}
} // namespace

void
ValidateSlitMapsOfFace(const ValidationSettings & settings, ValidationReport & report)
{
  const double              mostGap = settings.quick ? 0.06 : 0.03; // the ends of slits converge with the edge
  const SurfaceMesh         mesh = MakeFace(settings.quick ? 5.0 : 2.0);
  const SurfaceConnectivity connectivity(mesh);
  const Eigen::VectorXd     lengths = EdgeLengths(connectivity, mesh.V);
  const double              t = 8.0 * lengths.mean() * lengths.mean();
  ConformalMapSettings      options;
  const ConformalMap        euclidean = MapConformally(mesh, options, "the face");
  options.edgeLengths = ComputeHeatDiffusionMetric(mesh, t).edgeLengths;
  const ConformalMap diffusion = MapConformally(mesh, options, "the face");
  report.AddText(
    "A head defined by a formula, with open eyes and mouth, cut off at the back: " +
    std::to_string(mesh.NumberOfFaces()) + " faces, " + std::to_string(euclidean.loops.size()) +
    " boundaries. Slit maps in the Euclidean metric (figure) and in the heat diffusion metric, t = 8 h^2 = " +
    Rounded(t) + " mm^2.\n\n![](figure-5.3.png)");
  const std::string     most = Rounded(100.0 * mostGap, 1) + " %";
  CsvTable              table({ "metric",
                                "inner circle",
                                "modulus from u",
                                "from v",
                                "gap, %",
                                "error of the periods, turns",
                                "deviation of boundaries from circles",
                                "gap below " + most + ", periods and circles exact" });
  std::array<double, 3> largest{};
  AddMaps("Euclidean", euclidean, mostGap, table, largest, report);
  AddMaps("heat diffusion", diffusion, mostGap, table, largest, report);
  report.AddText("Largest gap: " + Rounded(100.0 * largest[0], 2) + " % (bound " + most +
                 "); error of the periods: " + Rounded(largest[1], 1) +
                 " turns (1e-9); deviation of boundaries from circles: " + Rounded(largest[2], 1) + " (1e-12).");
  report.AddRows("maps", table);
  CsvTable distortion({ "metric", "dilatation, median", "95 %", "99 %", "flips", "at slits", "none elsewhere" });
  for (const ConformalMap * map : { &euclidean, &diffusion })
  {
    distortion.AddRow(Cells() << (map == &euclidean ? "Euclidean" : "heat diffusion")
                              << Rounded(map->dilatation.median, 4) << Rounded(map->dilatation.p95, 4)
                              << Rounded(map->dilatation.p99, 4) << map->flips << map->flipsAtSlits
                              << report.Check(map->flips == map->flipsAtSlits));
  }
  report.AddText("Distortion of slit map 2 in each metric; flips are allowed only at slits:");
  report.AddRows("distortion", distortion);
  DrawFace(mesh, euclidean, settings.outputFolder + "/figure-5.3.png");
}
