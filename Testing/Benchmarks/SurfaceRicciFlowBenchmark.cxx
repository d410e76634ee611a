// Discrete Ricci flow by vertex scaling with flips compared with Newton's method for conformal equivalence without
// flips (CETM), on colon-like tubes. usage: SurfaceRicciFlowBenchmark [faces...]; default: 12000 55000
#include "FlatteningTrial.h"
#include "NewtonFlattening.h"

#include "shapetonSurfaceRicciFlow.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace
{
using namespace shapeton;

template <typename TBody>
double
BestSeconds(const TBody & body)
{
  constexpr int times = 5;
  double        best = 1e300;
  for (int i = 0; i < times; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    body();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void
PrintBound(const char * text, double value, double asked)
{
  std::printf("  %-66s %10.4g   asked <= %g   %s\n", text, value, asked, value <= asked ? "met" : "NOT MET");
}

/** Times both methods from edge lengths to the plane, and shows whether their moduli agree. */
void
CompareTimes(int faces)
{
  const TubeCase   plain(GenerateTube(faces, 0, 1));
  const TubeMap    map = plain.Flatten(plain.lengths);
  const CutSurface cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
  NewtonFlattening newton;
  const double     byNewton = BestSeconds(
    [&] { newton = FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut); });
  SurfaceRicciFlow flow;
  const double     ours = BestSeconds([&] { flow = FlowSurface(plain.tube.mesh, {}, "the tube"); });
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
  std::vector<int> numbers;
  for (int i = 1; i < argc; ++i)
  {
    numbers.push_back(std::atoi(argv[i]));
    if (numbers.back() < 2000)
    {
      std::fprintf(stderr, "usage: %s [NUMBER OF FACES >= 2000]...\n", argv[0]);
      return 2;
    }
  }
  for (const int faces : numbers.empty() ? std::vector<int>{ 12000, 55000 } : numbers)
  {
    CompareTimes(faces);
  }
  return EXIT_SUCCESS;
}
