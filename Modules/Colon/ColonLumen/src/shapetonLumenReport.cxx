#include "shapetonLumenReport.h"

#include "shapetonColonPieces.h"
#include "shapetonColonVolume.h"
#include "shapetonPi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace shapeton
{
namespace
{
constexpr double LeastPieceMl = 0.05;     // chosen: smaller pieces are not listed
constexpr double LeastLeftOutMl = 1.0;    // of gas; chosen: keeps the list short
constexpr double LeastBrightMl = 10.0;    // chosen: keeps the list short
constexpr double LeastBrightRadius = 7.0; // mm; chosen: wider than most small bowel
/** Chosen on few data: an unprepared abdomen contains 298 ml of lumen this wide. */
constexpr double UsableMl = 400.0; // or UsableShare of the body if that is less
constexpr double UsableShare = 0.02;
constexpr double UsableRadius = 10.0; // mm

itk::Point<double, 3>
ToPoint(const Eigen::Vector3d & x)
{
  itk::Point<double, 3> p;
  for (int a = 0; a < 3; ++a)
  {
    p[a] = x[a];
  }
  return p;
}

std::string
Rounded(double value, int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(digits);
  text << value;
  return text.str();
}

/** Sums over one connected part. */
struct PieceSums
{
  double          gas{ 0.0 };
  double          fluid{ 0.0 };
  double          gasHU{ 0.0 };
  Eigen::Vector3d place{ 0.0, 0.0, 0.0 };
  float           deepest{ 0.0F };
};
} // namespace

void
WriteLabels(const ColonImage * image, const LumenVoxels & voxels, ColonLumen & lumen)
{
  unsigned char * out = lumen.labels->GetBufferPointer();
  ForEachVoxel(image, voxels.grid, [&](std::size_t to, std::size_t from) {
    const auto c = voxels.classes[from];
    out[to] = IsColonLumen(c) ? c : 0;
  });
}

void
DescribePieces(const LumenVoxels & voxels, ColonLumen & lumen)
{
  const auto &    grid = voxels.grid;
  const VoxelRuns set = CollectRuns(grid, [&](std::size_t p) { return IsColonLumen(voxels.classes[p]); });
  const RunLabels labels = LabelRuns(set);
  ClassVolume     mask(voxels.classes.size());
  std::transform(voxels.classes.begin(), voxels.classes.end(), mask.begin(), IsColonLumen);
  const auto             d = SquaredDistanceToBackground(grid, mask);
  std::vector<PieceSums> sums(labels.number + 1);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    auto & sum = sums[labels.ofRun[r]];
    for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
    {
      const auto p = grid.Index(i, j, k);
      const bool isGas = voxels.classes[p] == ColonGas;
      (isGas ? sum.gas : sum.fluid) += 1.0;
      sum.gasHU += isGas ? voxels.hu[p] : 0.0;
      sum.place += Eigen::Vector3d(i, j, k);
      sum.deepest = std::max(sum.deepest, d[p]);
    }
  });
  const double ml = grid.VoxelVolume() * 1e-3;
  for (const auto & sum : sums)
  {
    if ((sum.gas + sum.fluid) * ml >= LeastPieceMl)
    {
      lumen.pieces.push_back({ sum.gas * ml,
                               sum.fluid * ml,
                               std::sqrt(std::min(sum.deepest, GreatestSquaredDistance)),
                               sum.gas > 0.0 ? sum.gasHU / sum.gas : 0.0,
                               ToPoint(grid.Position(Eigen::Vector3d(sum.place / (sum.gas + sum.fluid)))) });
    }
  }
  std::stable_sort(lumen.pieces.begin(), lumen.pieces.end(), [](const LumenPiece & p, const LumenPiece & q) {
    return p.gasMl + p.fluidMl > q.gasMl + q.fluidMl;
  });
}

void
DescribeLevels(const ColonEvidence & evidence, const LumenVoxels &, ColonLumen & lumen)
{
  const GravitySteps fall(evidence.grid, evidence.gravity);
  for (const auto & level : evidence.levels)
  {
    ColonLevel found;
    found.center =
      ToPoint(fall.across[0] * level.center[0] + fall.across[1] * level.center[1] + fall.direction * level.depth);
    found.area = level.area;
    found.tilt = std::atan(level.slope.norm()) * DegreesPerRadian;
    found.fluidHU = level.Fluid();
    found.isTagged = level.IsTagged(evidence.thresholds.tissue);
    found.isColon = evidence.isColon[level.gas];
    lumen.levels.push_back(found);
  }
}

void
DescribeOtherBright(const LumenVoxels & voxels, ColonLumen & lumen)
{
  const auto   set = CollectRuns(voxels.grid, [&](std::size_t p) { return voxels.classes[p] == OtherBright; });
  const auto   labels = LabelRuns(set);
  const auto   pieces = PiecesOfRuns(set, labels);
  const double voxelMl = 1e-3 * voxels.grid.VoxelVolume();
  for (int p = 1; p <= labels.number; ++p)
  {
    const double ml = voxelMl * static_cast<double>(pieces[p].voxels);
    if (ml < LeastBrightMl)
    {
      continue;
    }
    const auto deepest = FindDeepestVoxel(voxels.grid, set, labels, p, pieces[p]);
    if (deepest.radius < LeastBrightRadius)
    {
      continue;
    }
    const auto   middle = voxels.grid.Index(deepest.voxel[0], deepest.voxel[1], deepest.voxel[2]);
    ColonLeftOut rest;
    rest.what = "other bright matter";
    rest.why = "as bright as tagged fluid, inscribed radius " + Rounded(deepest.radius, 1) +
               " mm, no level of the colon above it: small bowel, bone, or fluid-filled colon (add it by a seed point)";
    rest.ml = ml;
    rest.inscribedRadius = deepest.radius;
    rest.meanHU = voxels.hu[middle];
    rest.center = ToPoint(voxels.grid.Position(middle));
    lumen.leftOut.push_back(rest);
  }
}

/** One voxel per cell of 5 mm for each piece of gas classified as small bowel. */
std::vector<std::vector<itk::Point<double, 3>>>
PlacesOfThinGas(const ColonEvidence & evidence)
{
  constexpr double                                cell = 5.0; // mm; chosen
  std::vector<std::vector<itk::Point<double, 3>>> places(evidence.gas.pieces.size());
  std::set<std::array<int, 4>>                    cells;
  const auto cellOf = [&](int voxel, int axis) { return static_cast<int>(voxel * evidence.grid.spacing[axis] / cell); };
  ForEachRun(evidence.gas.set, [&](std::size_t r, int j, int k) {
    const int piece = evidence.gas.labels.ofRun[r];
    if (evidence.kind[piece] != SmallBowelKind)
    {
      return;
    }
    for (int i = evidence.gas.set.runs[r].begin; i < evidence.gas.set.runs[r].end; ++i)
    {
      if (cells.insert({ piece, cellOf(i, 0), cellOf(j, 1), cellOf(k, 2) }).second)
      {
        places[piece].push_back(ToPoint(evidence.grid.Position(Eigen::Vector3d(i, j, k))));
      }
    }
  });
  return places;
}

/** Explains the classification of a piece of gas. */
std::string
ReasonOf(const ColonEvidence & evidence, std::size_t piece)
{
  const GasPiece &    gas = evidence.gas.pieces[piece];
  const std::string & kind = evidence.kind[piece];
  if (kind == LungKind)
  {
    const double vessels = evidence.lung[piece].vessels; // 0 for pieces too small to measure
    return "mean " + Rounded(gas.radius > 0.0 ? gas.inside : gas.mean, 0) + " HU" +
           (vessels > 0.0 ? ", with " + Rounded(vessels, 1) + " cross sections of vessels per 100 cm^2" : "");
  }
  if (kind == OutsideKind)
  {
    return "it is open to the outside, or separated from it by a thin shell";
  }
  if (kind == AirwayKind)
  {
    return "it is next to the cranial half of the lungs";
  }
  return "inscribed radius " + Rounded(gas.radius, 1) + " mm, " + Rounded(gas.ml, 1) +
         " ml, no level on fluid of the colon";
}

void
DescribeRest(const ColonEvidence & evidence, ColonLumen & lumen)
{
  const auto places = PlacesOfThinGas(evidence);
  lumen.thresholds = evidence.thresholds;
  lumen.noise = evidence.noise;
  lumen.smoothing = evidence.smoothing;
  lumen.isTagged = evidence.isTagged;
  for (std::size_t p = 1; p < evidence.gas.pieces.size(); ++p)
  {
    const auto & piece = evidence.gas.pieces[p];
    if (evidence.isColon[p] || piece.ml < LeastLeftOutMl)
    {
      continue;
    }
    ColonLeftOut rest;
    rest.what = evidence.kind[p];
    rest.why = ReasonOf(evidence, p);
    rest.ml = piece.ml;
    rest.inscribedRadius = piece.radius;
    rest.meanHU = piece.mean;
    rest.center = ToPoint(piece.center);
    rest.places = places[p];
    lumen.leftOut.push_back(rest);
  }
  std::stable_sort(lumen.leftOut.begin(), lumen.leftOut.end(), [](const ColonLeftOut & p, const ColonLeftOut & q) {
    return p.ml > q.ml;
  });
}

namespace
{
/** The largest piece of lung, or 0. */
std::size_t
LargestLung(const ColonEvidence & evidence)
{
  std::size_t largest = 0;
  for (std::size_t p = 1; p < evidence.kind.size(); ++p)
  {
    const bool isLarger = largest == 0 || evidence.gas.pieces[p].ml > evidence.gas.pieces[largest].ml;
    largest = evidence.kind[p] == LungKind && isLarger ? p : largest;
  }
  return largest;
}

/** Volume (ml) of gas inside the body but outside the colon. */
struct GasLeftOut
{
  double thinBowel{ 0.0 };
  double lung{ 0.0 };
};

GasLeftOut
MeasureOtherGas(const ColonEvidence & evidence)
{
  GasLeftOut other;
  for (std::size_t p = 1; p < evidence.gas.pieces.size(); ++p)
  {
    const auto & piece = evidence.gas.pieces[p];
    const bool   isThin = evidence.isCandidate[p] && !evidence.isColon[p] && piece.radius >= 3.0;
    other.thinBowel += isThin ? piece.ml : 0.0;
    other.lung += evidence.kind[p] == LungKind ? piece.ml : 0.0;
  }
  return other;
}
} // namespace

void
JudgeLumen(const ColonEvidence & evidence, ColonLumen & lumen)
{
  double ml = 0.0;
  double radius = 0.0;
  for (const auto & piece : lumen.pieces)
  {
    ml += piece.gasMl + piece.fluidMl;
    radius = std::max(radius, piece.inscribedRadius);
  }
  const double usable = std::min(UsableMl, UsableShare * evidence.bodyMl);
  if (ml >= usable && radius >= UsableRadius)
  {
    return;
  }
  const GasLeftOut other = MeasureOtherGas(evidence);
  const auto       lung = LargestLung(evidence);
  if (lung > 0 && other.lung > ml + other.thinBowel)
  {
    lumen.failure = "no distended colon found: the largest gas is lung, " + Rounded(other.lung, 0) + " ml (" +
                    ReasonOf(evidence, lung) + "); only " + Rounded(ml, 0) +
                    " ml of other gas and fluid are as wide as a colon; at least " + Rounded(usable, 0) +
                    " ml are required; give a CT of abdomen and pelvis with a distended colon";
    return;
  }
  if (other.thinBowel < 1.0 && ml < 1.0)
  {
    lumen.failure = "no colon found: no gas inside the body could be bowel; give a CT of the abdomen in "
                    "Hounsfield units (air is -1000)";
    return;
  }
  lumen.failure = "the colon is not distended or tagged enough: " + Rounded(ml, 0) +
                  " ml of lumen with an inscribed radius of at most " + Rounded(radius, 1) + " mm were found, and " +
                  Rounded(other.thinBowel, 0) + " ml of gas in thinner bowel; at least " + Rounded(usable, 0) +
                  " ml of lumen and a radius of " + Rounded(UsableRadius, 0) + " mm are required" +
                  (lumen.isTagged ? "" : "; no tagged fluid was found under the gas");
}
} // namespace shapeton
