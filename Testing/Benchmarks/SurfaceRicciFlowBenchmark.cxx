// Discrete Ricci flow by vertex scaling with flips compared with Newton's method for conformal equivalence without
// flips (CETM), on colon-like tubes. usage: SurfaceRicciFlowBenchmark [faces...]; default: 12000 55000
#include "FlatteningTrial.h"
#include "NewtonFlattening.h"
#include "Times.h"

#include "shapetonSurfaceRicciFlow.h"

namespace
{
using namespace shapeton;

constexpr int times = 5;

/** Times both methods from edge lengths to the plane, and shows whether their moduli agree. */
void
CompareTimes(int faces)
{
  const TubeCase   plain(GenerateTube(faces, 0, 1));
  const TubeMap    map = plain.Flatten(plain.lengths);
  const CutSurface cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
  NewtonFlattening newton;
  const double     byNewton = SecondsOf(
    [&] { newton = FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut); }, times);
  SurfaceRicciFlow flow;
  const double     ours = SecondsOf([&] { flow = FlowSurface(plain.tube.mesh, {}, "the tube"); }, times);
  std::printf("%d faces: Ricci flow %.3f s (%d steps, %d flips), Newton-CETM %.3f s (%d steps%s); modulus %.6f, %.6f\n",
              plain.tube.mesh.NumberOfFaces(),
              ours,
              flow.steps,
              flow.delaunayFlips + flow.flips,
              byNewton,
              newton.iterations,
              newton.hasConverged ? "" : ", STALLED",
              flow.modulus,
              newton.modulus);
  PrintBound("time relative to Newton-CETM", ours / byNewton, 2.0);
  PrintBound("curvature error, radians", flow.residual, 1e-10);
}
} // namespace

int
main(int argc, char * argv[])
{
  for (const int faces : NumbersOfFaces(argc, argv, { 12000, 55000 }))
  {
    CompareTimes(faces);
  }
  return EXIT_SUCCESS;
}
