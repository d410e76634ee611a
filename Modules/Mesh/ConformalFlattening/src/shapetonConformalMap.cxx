#include "shapetonConformalMap.h"

#include "shapetonBoundedWeights.h"
#include "shapetonConformalLayout.h"
#include "shapetonCsvTable.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"
#include "shapetonOpenEndedProgress.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Relative gap between the moduli, larger than mesh discretization alone produces. */
constexpr double wideGap = 0.1;
/** Warn if the inner circle is smaller than this fraction of the outer one. */
constexpr double smallestCircle = 0.01;

std::string
CountOfBoundaries(std::size_t number)
{
  return std::to_string(number) + (number == 1 ? " boundary" : " boundaries");
}

int
ElementOfBoundary(int number, std::size_t count, const char * role)
{
  if (number < 1 || number > static_cast<int>(count))
  {
    throw InputError("boundary " + std::to_string(number) + ", chosen as the " + role +
                     " boundary, does not exist; the surface has " + CountOfBoundaries(count) +
                     ", number 1 is the longest");
  }
  return number - 1;
}

void
RequireBoundaries(const ConformalMapSettings & options, std::size_t count)
{
  if (count == 0)
  {
    throw InputError("the surface has no boundary, but a map to the plane requires one; cut it open: one boundary for "
                     "a rectangle, two or more for an annulus");
  }
  if (count == 1 && options.domain != ConformalDomain::Rectangle)
  {
    throw InputError(
      "an annulus requires an outer and an inner boundary, but the surface has 1 boundary; map it to a rectangle, or "
      "cut a hole");
  }
  if (count > 2 && options.domain == ConformalDomain::Annulus)
  {
    throw InputError("an annulus has two boundaries, but the surface has " + std::to_string(count) +
                     "; map it to an annulus with slits (domain slit), or fill its holes");
  }
  if (count > 1 && !options.corners.empty())
  {
    throw InputError("corners require a surface with one boundary, but it has " + std::to_string(count));
  }
  if (count == 1 && options.innerBoundary != 0)
  {
    throw InputError("the surface has 1 boundary, so there is no inner boundary");
  }
}

/** The outer and inner boundary. */
void
ChooseBoundaries(const ConformalMapSettings & options, ConformalMap & map)
{
  const std::size_t count = map.loops.size();
  map.outer = options.outerBoundary == 0 ? 0 : ElementOfBoundary(options.outerBoundary, count, "outer");
  if (count > 1)
  {
    map.inner =
      options.innerBoundary == 0 ? (map.outer == 0 ? 1 : 0) : ElementOfBoundary(options.innerBoundary, count, "inner");
    if (map.inner == map.outer)
    {
      throw InputError("boundary " + std::to_string(map.inner + 1) + " cannot be both the outer and the inner one");
    }
  }
}

std::array<int, 4>
CornersOf(const ConformalMapSettings & options, const BoundaryLoop & boundary, const SurfaceMesh & mesh)
{
  const SurfaceArray * const own = FindSurfaceArray(mesh.fieldArrays, CutCorners);
  if (options.corners.empty() && own != nullptr && own->values.size() == 4)
  {
    const auto & values = own->values;
    return {
      static_cast<int>(values(0)), static_cast<int>(values(1)), static_cast<int>(values(2)), static_cast<int>(values(3))
    };
  }
  if (options.corners.empty())
  {
    return SpreadCorners(boundary, mesh.V);
  }
  if (options.corners.size() != 4)
  {
    throw InputError("a rectangle has 4 corners, not " + std::to_string(options.corners.size()));
  }
  return { options.corners[0], options.corners[1], options.corners[2], options.corners[3] };
}

void
MapToRectangle(const SurfaceMesh &          mesh,
               const SurfaceConnectivity &  connectivity,
               const Eigen::VectorXd &      lengths,
               const ConformalMapSettings & options,
               const std::vector<int> &     weightLevels,
               const Progress &             progress,
               ConformalMap &               map)
{
  const auto             corners = CornersOf(options, map.loops[0], mesh);
  const QuadrilateralMap quadrilateral =
    MapQuadrilateral(connectivity, lengths, map.loops[0], corners, weightLevels, progress);
  map.corners.assign(quadrilateral.corners.begin(), quadrilateral.corners.end());
  map.modulusU = quadrilateral.modulusU;
  map.modulusV = quadrilateral.modulusV;
  map.ears = EarsOfSides(mesh.F, quadrilateral);
  map.flat = LayOutRectangle(mesh, connectivity, quadrilateral);
}

void
MapToAnnulus(const SurfaceMesh &          mesh,
             const SurfaceConnectivity &  connectivity,
             const Eigen::VectorXd &      lengths,
             const ConformalMapSettings & options,
             const std::vector<int> &     weightLevels,
             const Progress &             progress,
             ConformalMap &               map)
{
  const SlitMapSolver solver(
    mesh, connectivity, lengths, map.loops, map.outer, weightLevels, progress.Part("", 0.0, 0.4));
  const std::vector<int> & inners = solver.InnerLoops();
  const auto               partOf = [&](std::size_t i) { // the chosen map is computed first
    const double number = options.domain == ConformalDomain::Slit ? static_cast<double>(inners.size()) : 1.0;
    return progress.Part("", 0.4 + 0.6 * i / number, 0.4 + 0.6 * (i + 1) / number);
  };
  const SlitMap chosen = solver.Map(map.inner, partOf(0));
  map.modulusU = chosen.modulusU;
  map.modulusV = chosen.modulusV;
  map.ears = EarsOfLoops(mesh.F, LoopOfVertices(map.loops, mesh.NumberOfVertices()));
  if (options.domain != ConformalDomain::Slit)
  {
    map.slitMaps.push_back(chosen);
  }
  else
  {
    std::size_t made = 1;
    for (const int inner : inners)
    {
      map.slitMaps.push_back(inner == map.inner ? chosen : solver.Map(inner, partOf(made++)));
    }
  }
  map.flat = options.domain == ConformalDomain::Rectangle ? LayOutStrip(mesh, connectivity, chosen)
                                                          : LayOutAnnulus(mesh, connectivity, chosen);
  if (options.domain == ConformalDomain::Slit)
  {
    AddSlitMaps(map.slitMaps, map.flat);
  }
}

bool
TouchesSlit(const Eigen::Vector3i & face, const std::vector<int> & loopOf, const ConformalMap & map)
{
  return std::any_of(face.begin(), face.end(), [&](int vertex) {
    return loopOf[vertex] != -1 && loopOf[vertex] != map.outer && loopOf[vertex] != map.inner;
  });
}

std::vector<char>
EarMarks(const ConformalMap & map)
{
  std::vector<char> isEar(map.flat.F.rows(), 0);
  for (const int face : map.ears)
  {
    isEar[face] = 1;
  }
  return isEar;
}

/** Counts flipped faces except ears, and marks those away from slits. On a surface without handles they are avoidable.
 */
std::vector<char>
CountFlips(const FaceMatrix & sourceFaces, const SurfaceConnectivity & connectivity, ConformalMap & map)
{
  const std::vector<int>  loopOf = LoopOfVertices(map.loops, connectivity.NumberOfVertices());
  const std::vector<char> isEar = EarMarks(map);
  std::vector<char>       isNeedless(isEar.size(), 0);
  for (std::size_t face = 0; face < isEar.size(); ++face)
  {
    if (map.distortion.isFlipped[face] && !isEar[face])
    {
      const bool isAtSlit = TouchesSlit(sourceFaces.row(static_cast<Eigen::Index>(face)), loopOf, map);
      ++map.flips;
      map.flipsAtSlits += isAtSlit ? 1 : 0;
      isNeedless[face] = !isAtSlit && map.genus == 0;
    }
  }
  return isNeedless;
}

void
Warn(ConformalMap & map)
{
  if (map.genus > 0)
  {
    map.warnings.push_back("the surface has " + std::to_string(map.genus) + (map.genus == 1 ? " handle" : " handles") +
                           ": the map is conformal away from small handles");
  }
  if (!map.ears.empty())
  {
    map.warnings.push_back(std::to_string(map.ears.size()) + (map.ears.size() == 1 ? " face has" : " faces have") +
                           " all corners on one boundary and are mapped to zero area");
  }
  if (map.flips > 0)
  {
    map.warnings.push_back(std::to_string(map.flips) + (map.flips == 1 ? " face is" : " faces are") + " flipped, " +
                           std::to_string(map.flipsAtSlits) + " of them at slits");
  }
  if (map.ModulusGap() > wideGap)
  {
    map.warnings.push_back("the two moduli differ by " + CsvTable::Rounded(100.0 * map.ModulusGap(), 2) +
                           " %, so the map is not conformal everywhere: " +
                           (map.genus > 0 ? "handles are not small; remove them" : "use a finer mesh"));
  }
  if (map.domain != ConformalDomain::Rectangle &&
      map.slitMaps.front().logRadiusOfLoops.minCoeff() < std::log(smallestCircle))
  {
    map.warnings.push_back(
      "the inner circle is less than a hundredth of the outer one; use the domain rectangle for a better view");
  }
}

/** Assigns the boundaries to the circles. */
ConformalMap
ChosenDomain(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const ConformalMapSettings & options)
{
  ConformalMap map;
  map.domain = options.domain;
  map.genus = connectivity.Components().front().genus.value_or(0);
  map.loops = BoundaryLoopsByLength(connectivity, mesh.V);
  RequireBoundaries(options, map.loops.size());
  ChooseBoundaries(options, map);
  return map;
}

/** Maps to the chosen domain and computes the distortion. */
ConformalMap
MapOnce(const SurfaceMesh &          mesh,
        const SurfaceConnectivity &  connectivity,
        const Eigen::VectorXd &      lengths,
        const ConformalMapSettings & options,
        const std::vector<int> &     weightLevels,
        const Progress &             progress,
        ConformalMap                 map)
{
  if (map.loops.size() == 1)
  {
    MapToRectangle(mesh, connectivity, lengths, options, weightLevels, progress, map);
  }
  else
  {
    MapToAnnulus(mesh, connectivity, lengths, options, weightLevels, progress, map);
  }
  map.distortion =
    MeasureFlatDistortion(map.flat.F, FlatCoordinates(map.flat, "the map"), SidesOfFaces(connectivity, lengths));
  map.dilatation = QuantilesOfDilatation(map.distortion, EarMarks(map));
  return map;
}

/** Recomputes a map that has avoidable flips, clamping the weights at flipped faces and finally everywhere. */
ConformalMap
MapSoundSurface(const SurfaceMesh &          mesh,
                const SurfaceConnectivity &  connectivity,
                const ConformalMapSettings & options)
{
  const Eigen::VectorXd lengths =
    options.edgeLengths.size() == 0 ? EdgeLengths(connectivity, mesh.V) : options.edgeLengths;
  const ConformalMap chosen = ChosenDomain(mesh, connectivity, options);
  OpenEndedProgress  maps(options.progress, 0.25);
  ConformalMap       map = MapOnce(mesh, connectivity, lengths, options, {}, maps.NextStep(), chosen);
  std::vector<char>  isFlipped = CountFlips(mesh.F, connectivity, map);
  std::vector<int>   levels(mesh.NumberOfVertices(), 0);
  for (int solve = 1; solve < mostSolves && std::count(isFlipped.begin(), isFlipped.end(), 1) > 0; ++solve)
  {
    RaiseWeightLevels(mesh.F, EdgeGraph(connectivity), isFlipped, RingsOfSolve(solve), levels);
    const int least = solve + 1 == mostSolves ? 1 : 0;
    std::transform(levels.begin(), levels.end(), levels.begin(), [&](int level) { return std::max(level, least); });
    map = MapOnce(mesh, connectivity, lengths, options, levels, maps.NextStep(), chosen);
    map.solves = solve + 1;
    isFlipped = CountFlips(mesh.F, connectivity, map);
  }
  Warn(map);
  options.progress(1.0);
  return map;
}
} // namespace

double
ConformalMap::ModulusGap() const
{
  return modulusU / modulusV - 1.0;
}

ConformalMap
MapConformally(const SurfaceMesh & mesh, const ConformalMapSettings & options, const std::string & what)
{
  CheckOptions(options);
  RequireSound(mesh, what);
  const SurfaceConnectivity connectivity(mesh);
  RequireOneManifold(connectivity, what);
  if (!connectivity.IsOriented())
  {
    throw InputError(what + ": neighboring faces have opposite orientations; repair the surface");
  }
  try
  {
    return MapSoundSurface(mesh, connectivity, options);
  }
  catch (const InputError & error)
  {
    throw InputError(what + ": " + error.what());
  }
}
} // namespace shapeton
