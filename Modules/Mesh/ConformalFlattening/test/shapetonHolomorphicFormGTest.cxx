#include "shapetonHolomorphicForm.h"

#include "shapetonExceptions.h"
#include "shapetonPlanarDomains.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

/** f and its conjugate as a complex number at a corner of a face. */
std::complex<double>
At(const HolomorphicForm & form, int vertex)
{
  return { form.values(vertex, 0), form.values(vertex, 1) };
}

/** Fraction of the energy of the form in its antiholomorphic part. */
double
ShareNotHolomorphic(const HolomorphicForm & form)
{
  double with = 0.0;
  double without = 0.0;
  for (Eigen::Index face = 0; face < form.mesh.F.rows(); ++face)
  {
    std::complex<double> z[3];
    std::complex<double> w[3];
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = form.mesh.F(face, k);
      z[k] = { form.mesh.V(vertex, 0), form.mesh.V(vertex, 1) };
      w[k] = At(form, vertex);
    }
    const auto   z1 = z[1] - z[0];
    const auto   z2 = z[2] - z[0];
    const auto   w1 = w[1] - w[0];
    const auto   w2 = w[2] - w[0];
    const auto   along = w1 * std::conj(z2) - w2 * std::conj(z1);
    const auto   against = w2 * z1 - w1 * z2;
    const double twiceArea = std::abs(std::imag(std::conj(z1) * z2));
    with += std::norm(against) / twiceArea;
    without += std::norm(along) / twiceArea;
  }
  return with / (with + without);
}
} // namespace

TEST(HolomorphicForm, OfAnAnnulusIsTheLogarithm)
{
  const PolarGrid    grid;
  const ConformalMap map = MapConformally(grid.Mesh(), {}, "the annulus");
  const auto         forms = HolomorphicFormsOf(map);
  ASSERT_EQ(forms.size(), 1U);
  for (int ring = 0; ring <= grid.rings; ++ring)
  {
    for (int place = 0; place < grid.around; place += 7)
    {
      const double share = 1.0 - static_cast<double>(ring) / grid.rings;
      EXPECT_NEAR(forms[0].values(grid.At(ring, place), 0), share, 1e-11);
    }
  }
  // One turn of the conjugate is the flux: 2 pi / ln(1 / 0.3), entirely across the cut.
  const double turn = forms[0].values.col(1).maxCoeff() - forms[0].values.col(1).minCoeff();
  const double flux = -2.0 * Pi / std::log(grid.inner);
  EXPECT_NEAR(turn, flux, 5e-3 * flux);
  EXPECT_LT(ShareNotHolomorphic(forms[0]), 0.002);
}

TEST(HolomorphicForm, IsOneOnItsBoundaryZeroOnOthersAndHolomorphic)
{
  const PolarGrid    grid;
  const SurfaceMesh  mesh = WithSlits(grid.Mesh(), { Arc(grid, 8, 5, 35), Arc(grid, 16, 50, 80) });
  const ConformalMap map = MapConformally(mesh, {}, "the annulus");
  const auto         forms = HolomorphicFormsOf(map);
  ASSERT_EQ(forms.size(), 3U);
  for (std::size_t j = 0; j < forms.size(); ++j)
  {
    EXPECT_EQ(forms[j].inner, map.slitMaps[j].inner);
    for (std::size_t loop = 0; loop < map.loops.size(); ++loop)
    {
      for (const int vertex : map.loops[loop].vertices)
      {
        EXPECT_NEAR(forms[j].values(vertex, 0), static_cast<int>(loop) == forms[j].inner ? 1.0 : 0.0, 1e-10);
      }
    }
    EXPECT_LT(ShareNotHolomorphic(forms[j]), 0.02) << j; // mostly at the slit ends
  }
}

TEST(HolomorphicForm, NeedsTheSlitMaps)
{
  ConformalMapSettings options;
  options.domain = ConformalDomain::Annulus;
  EXPECT_THROW(HolomorphicFormsOf(MapConformally(PolarGrid().Mesh(), options, "the annulus")), ParameterError);
}
