#include "FigureTools.h"
#include "GeneratedSurfaces.h"
#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonDiffusionTime.h"
#include "shapetonHeatKernel.h"

using namespace shapeton;

namespace
{
/** Evaluates (5.6) at each vertex from the distances of all vertices to p and to q. */
Eigen::VectorXd
DetourOf(const Eigen::VectorXd & fromP, const Eigen::VectorXd & fromQ, int q)
{
  return (fromP + fromQ).array() - fromP[q];
}

/** One of the two hands with its measurements. */
struct Hand
{
  Hand(const SurfaceMesh & surface, int pairs)
    : mesh(surface)
    , connectivity(mesh)
    , p(VertexAt(mesh, LittleFingertip()))
    , q(VertexAt(mesh, ThumbNail()))
    , geodesicFromP(GeodesicDistances(mesh, connectivity, p))
    , geodesicFromQ(GeodesicDistances(mesh, connectivity, q))
    , spectrum(ComputeSurfaceSpectrum(MakeSurfaceLaplacian(connectivity, mesh.V), pairs))
  {}
  Eigen::VectorXd
  Geodesic() const
  {
    return DetourOf(geodesicFromP, geodesicFromQ, q);
  }
  Eigen::VectorXd
  Diffusion(double t) const
  {
    return DetourOf(DiffusionDistances(spectrum, p, t), DiffusionDistances(spectrum, q, t), q);
  }

  SurfaceMesh         mesh;
  SurfaceConnectivity connectivity;
  int                 p;
  int                 q;
  Eigen::VectorXd     geodesicFromP;
  Eigen::VectorXd     geodesicFromQ;
  SurfaceSpectrum     spectrum;
};

void
DrawHands(const Hand & touching, const Hand & apart, double t, const std::string & path)
{
  const PictureSheet::Layout layout{ 2, 2, 400, 460, false };
  PictureSheet               sheet("Figure 5.2: detour by way of each point, little finger to thumb", layout);
  auto                       options = ViewOf(layout);
  const Hand * const         hands[] = { &touching, &apart };
  const char * const         names[] = { "thumb and index finger touch", "cut apart" };
  const double               farGeodesic = touching.Geodesic().maxCoeff();
  const double               farDiffusion = touching.Diffusion(t).maxCoeff();
  options.elevation = 12.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Hand &   hand = *hands[i];
    const CurveSet way = WayDown(hand.mesh, hand.connectivity, hand.geodesicFromP, hand.q);
    sheet.Put(0,
              i,
              std::string("geodesic, ") + names[i],
              DrawValues(hand.mesh, hand.Geodesic(), 0.0, farGeodesic, options, &way));
    sheet.Put(1,
              i,
              std::string("diffusion, ") + names[i],
              DrawValues(hand.mesh, hand.Diffusion(t), 0.0, farDiffusion, options));
  }
  sheet.Write(path);
}
} // namespace

void
ValidateDistancesOfHands(const ValidationSettings & settings, ValidationReport & report)
{
  const double  edge = settings.quick ? 3.0 : 1.8;
  const int     pairs = settings.quick ? 100 : 300;
  const CutPair hands = MakeHand(edge);
  const Hand    touching(hands.whole, pairs);
  const Hand    apart(hands.cut, pairs);
  const auto    common = touching.mesh.NumberOfVertices(); // the cut adds vertices after these
  const auto    changeOf = [&](const Eigen::VectorXd & a, const Eigen::VectorXd & b) {
    return RelativeChange(a, b.head(common));
  };
  const double geodesic = changeOf(touching.Geodesic(), apart.Geodesic());
  const double h = EdgeLengths(touching.connectivity, touching.mesh.V).mean();
  report.AddText("A hand whose thumb touches the index finger (" + std::to_string(touching.mesh.NumberOfFaces()) +
                 " faces, genus " + std::to_string(*touching.connectivity.Components()[0].genus) +
                 "), and the same hand cut apart there (genus " +
                 std::to_string(*apart.connectivity.Components()[0].genus) +
                 "). f(x) = d(p, x) + d(x, q) - d(p, q) (5.6), with p the tip of the little finger and q the nail of "
                 "the thumb. Change: root mean square of the difference between the two f, divided by the root mean "
                 "square of f, over all vertices. Diffusion distances are from " +
                 std::to_string(pairs) + " eigenpairs.\n\n![](figure-5.2.png)");
  CsvTable table({ "distance", "t, mm^2", "t / h^2", "change of f", "change of d(p, q)", "below a third of geodesic" });
  table.AddRow(Cells() << "geodesic"
                       << ""
                       << "" << Percent(geodesic)
                       << Percent(std::abs(apart.geodesicFromP[apart.q] / touching.geodesicFromP[touching.q] - 1.0))
                       << "");
  double           pictured = 0.0;
  std::string      earliest;                   // change at the first time
  constexpr double asLongAsAFingertip = 100.0; // mm^2; at longer times heat crosses the contact
  for (const double t : { 8.0 * h * h, 100.0, 300.0, 1000.0, 3000.0 })
  {
    const double change = changeOf(touching.Diffusion(t), apart.Diffusion(t));
    const double whole = DiffusionDistance(touching.spectrum, touching.p, touching.q, t);
    const double cut = DiffusionDistance(apart.spectrum, apart.p, apart.q, t);
    const bool   isHeld = t <= asLongAsAFingertip;
    table.AddRow(
      Cells() << "diffusion" << Rounded(t) << Rounded(t / (h * h)) << Percent(change)
              << Percent(std::abs(cut / whole - 1.0))
              << (isHeld ? report.Check(change < geodesic / 3.0) : (change < geodesic / 3.0 ? "yes" : "no")));
    pictured = isHeld ? t : pictured;
    earliest = earliest.empty() ? Percent(change) : earliest;
  }
  report.AddText("Change of f: " + Percent(geodesic) + " with geodesic distances, " + earliest +
                 " with diffusion distances at t = 8 h^2. Bound up to t = 100 mm^2: a third of the geodesic change.");
  report.AddRows("times", table);
  report.AddText(
    "The claim holds for diffusion times as in flattening, for which the diffusion length 2 sqrt(t) is shorter than a "
    "fingertip. At longer times, heat crosses the contact, and f depends on it at least as much as with geodesics.");
  DrawHands(touching, apart, pictured, settings.outputFolder + "/figure-5.2.png");
}
