// Times of a row of Table 5.1 of the dissertation, and of the methods that its section 5.3 compares, in one run on one
// surface. usage: FlatteningPeers WALL.vtp ROW.json. WALL is a tube with or without handles.
#include "FigureProgram.h"
#include "HarmonicForms.h"
#include "Times.h"

#include "shapetonColonFlattening.h"
#include "shapetonExceptions.h"
#include "shapetonHandleLoops.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonJson.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonSurfaceSpectrum.h"

using namespace shapeton;

namespace
{
/** A tube with its default metric. */
struct Wall
{
  explicit Wall(const std::string & path)
  {
    SurfaceReadOptions reading;
    reading.takesOneComponent = true;
    mesh = PrepareTube(ReadRepairedSurface(path, reading).mesh, path).mesh;
    mesh = TrimEars(mesh, SurfaceConnectivity(mesh)).mesh;
    const ColonFlattening flattening = FlattenColon(mesh, path);
    time = flattening.time;
    genus = flattening.genusBefore;
  }

  SurfaceMesh mesh;
  double      time{ 0.0 }; ///< mm^2; 0 for the Euclidean metric
  int         genus{ 0 };
};

/** The published metric, from 50 eigenpairs. */
void
MetricOf50(const Wall & wall, const SurfaceConnectivity & connectivity)
{
  constexpr int          pairs = 50;
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(connectivity, wall.mesh.V);
  const double           time = wall.time > 0.0 ? wall.time : 1.0; // does not change the duration
  TruncatedHeatDiffusionMetric(laplacian, ComputeSurfaceSpectrum(laplacian, pairs), time, pairs);
}

/** Times of the flattening of the dissertation. */
TubeMap
TimeFlattening(const Wall & wall, const SurfaceConnectivity & connectivity, int times, Json & row)
{
  Eigen::VectorXd lengths = EdgeLengths(connectivity, wall.mesh.V);
  if (wall.time > 0.0)
  {
    row["metric"] = SecondsOf([&] { lengths = ComputeHeatDiffusionMetric(wall.mesh, wall.time).edgeLengths; }, times);
  }
  row["metricOf50"] = SecondsOf([&] { MetricOf50(wall, connectivity); });
  const TubeEnds ends = FindTubeEnds(wall.mesh, connectivity, "the wall");
  TubeMap        map;
  row["flattening"] = SecondsOf([&] { map = FlattenTube(wall.mesh, connectivity, lengths, ends); }, times);
  return map;
}

/** Times of the harmonic forms of all handles, beside those of flattening by one Laplace equation (5.3.1). */
void
TimeForms(const Wall & wall, const SurfaceConnectivity & connectivity, Json & row)
{
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(connectivity, wall.mesh.V);
  HarmonicForms          forms;
  row["forms"] = SecondsOf([&] { forms = FindHarmonicForms(wall.mesh, connectivity, laplacian); });
  row["formsSolved"] = forms.forms.cols();
  const HarmonicErrors errors = ErrorsOf(forms, wall.mesh, connectivity, laplacian);
  row["formsClosure"] = errors.closure;
  row["formsDivergence"] = errors.divergence;
}

/** Times of the removal of handles, by curvature on the flat map, and by loops (5.3.2, 5.4.3). */
void
TimeRemoval(const Wall & wall, const SurfaceConnectivity & connectivity, const TubeMap & map, Json & row)
{
  HandleRemoval removal;
  row["removalByCurvature"] = SecondsOf([&] {
    const HandleDetection detection = DetectHandles(connectivity, map.flat);
    removal = RemoveHandles(wall.mesh, connectivity, detection.handles);
  });
  row["genusAfterCurvature"] = removal.genus;
  HandleCuts cuts;
  row["removalByLoops"] = SecondsOf([&] { cuts = CutHandles(wall.mesh); });
  row["genusAfterLoops"] = cuts.genus;
}

void
TimeRicciFlow(const Wall & wall, const std::string & path, Json & row)
{
  try
  {
    SurfaceRicciFlow flow;
    row["ricciFlow"] = SecondsOf([&] { flow = FlowSurface(wall.mesh, {}, path); });
    row["ricciSteps"] = flow.steps;
    row["ricciFlips"] = flow.flips;
  }
  catch (const Exception & error)
  {
    row["ricciFailure"] = error.what();
  }
}

void
Measure(const std::string & path, const std::string & output)
{
  constexpr int             few = 100000; // faces that are measured several times
  const Wall                wall(path);
  const SurfaceConnectivity connectivity(wall.mesh);
  Json                      row{ { "faces", wall.mesh.NumberOfFaces() }, { "genus", wall.genus } };
  const TubeMap             map = TimeFlattening(wall, connectivity, wall.mesh.NumberOfFaces() < few ? 5 : 1, row);
  if (wall.genus > 0)
  {
    TimeForms(wall, connectivity, row);
    TimeRemoval(wall, connectivity, map, row);
  }
  TimeRicciFlow(wall, path, row);
  WriteJson(row, output);
}
} // namespace

int
main(int argc, char * argv[])
{
  return RunFigureProgram(argc, argv, { 2, 2 }, "WALL.vtp ROW.json", [](const std::vector<std::string> & arguments) {
    Measure(arguments[0], arguments[1]);
  });
}
