// Fits the weights of PolypScore() to phantoms and prints them: FitPolypScore, without arguments. The exams are those
// of TrainingExams(), with 0.8 mm voxels; from CT each takes minutes, unless SHAPETON_LANDMARK_CACHE holds it.
//
// Positive: of the bulges at a polyp of 5.5 mm and more the one with the greatest solid angle. Negative: bulges at no
// polyp; but those wider than 14 mm with a shape index above 0.82, which the ileocaecal valve is, are left out: it has
// the shape of a polyp. Logistic regression by Newton's method, with the penalty of half the squared weights of the
// terms over their standard deviations.
#include "PolypTrial.h"

#include "shapetonWallBulges.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace shapeton;

namespace
{
constexpr int unknowns = numberOfPolypTerms + 1;
using Row = Eigen::Matrix<double, 1, unknowns>;

struct Samples
{
  std::vector<Row>    terms; ///< and 1
  std::vector<double> isPolyp;
};

LandmarkCase
MakeCase(const std::string & preset, unsigned int seed, const std::string & position, bool isFromCt)
{
  LandmarkCase one;
  one.parameters = ColonPhantomPreset(preset);
  one.parameters.seed = seed;
  one.parameters.position = position;
  one.isFromCt = isFromCt;
  return one;
}

/** Seeds below 100 alone: the others are for validation. From the true lumen there are more negatives of the anatomy,
 * and from CT those that noise and segmentation make. */
std::vector<LandmarkCase>
TrainingExams()
{
  std::vector<LandmarkCase> exams;
  for (unsigned int seed = 1; seed <= 10; ++seed)
  {
    const bool isProne = seed == 7 || seed == 8 || seed == 10;
    exams.push_back(MakeCase(seed % 2 == 1 ? "standard" : "hard", seed, isProne ? "prone" : "supine", false));
  }
  for (unsigned int seed = 1; seed <= 4; ++seed)
  {
    exams.push_back(MakeCase("hard", seed, seed % 2 == 1 ? "supine" : "prone", true));
  }
  exams.push_back(MakeCase("standard", 1, "prone", true));
  exams.push_back(MakeCase("standard", 2, "supine", true));
  return exams;
}

std::vector<char>
NoWall(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity)
{
  std::vector<char>          isLeftOut(wall.NumberOfVertices(), 0);
  const SurfaceArray * const bridged = FindSurfaceArray(wall.cellArrays, "bridged");
  for (int face = 0; bridged != nullptr && face < wall.NumberOfFaces(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      isLeftOut[wall.F(face, k)] |= bridged->values(face, 0) != 0.0;
    }
  }
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int vertex : loop)
    {
      isLeftOut[vertex] = 1;
    }
  }
  return isLeftOut;
}

/** The polyp that a bulge is at: its place in the list, or -1. */
int
PolypAt(const WallBulge & bulge, const std::vector<ColonPolyp> & polyps)
{
  constexpr double reach = 2.0; // mm
  int              nearest = -1;
  double           least = reach;
  for (std::size_t i = 0; i < polyps.size(); ++i)
  {
    const double distance =
      std::min((bulge.centre - polyps[i].position).norm(), (bulge.centre - polyps[i].base).norm()) -
      0.5 * polyps[i].diameter;
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

void
AddSample(const WallBulge & bulge, bool isPolyp, Samples & samples)
{
  const auto terms = TermsOf(FeaturesOf(bulge));
  Row        row;
  row << Eigen::Map<const Eigen::Matrix<double, 1, numberOfPolypTerms>>(terms.data()), 1.0;
  samples.terms.push_back(row);
  samples.isPolyp.push_back(isPolyp ? 1.0 : 0.0);
}

void
AddExam(const LandmarkExam & exam, Samples & samples)
{
  constexpr double             leastPolyp = 5.5, leastValve = 14.0, valveShape = 0.82;
  const SurfaceConnectivity    connectivity(exam.wall);
  const double                 time = MatchedSmoothingTime(exam.wall, PolypCandidateOptions().smoothingTime);
  const SurfaceShape           shape = MeasureSurfaceShape(exam.wall.V, connectivity, exam.wall.F, time);
  const std::vector<WallBulge> bulges =
    FindWallBulges(exam.wall, connectivity, shape, NoWall(exam.wall, connectivity), 0.01);
  const std::vector<ColonPolyp>  polyps = exam.anatomy->Polyps();
  std::vector<const WallBulge *> best(polyps.size(), nullptr);
  for (const WallBulge & bulge : bulges)
  {
    const int polyp = PolypAt(bulge, polyps);
    if (polyp >= 0)
    {
      best[polyp] = best[polyp] == nullptr || bulge.solidAngle > best[polyp]->solidAngle ? &bulge : best[polyp];
    }
    else if (bulge.greatestWidth <= leastValve || bulge.shapeIndex <= valveShape)
    {
      AddSample(bulge, false, samples);
    }
  }
  for (std::size_t i = 0; i < polyps.size(); ++i)
  {
    if (best[i] != nullptr && polyps[i].diameter >= leastPolyp)
    {
      AddSample(*best[i], true, samples);
    }
  }
}

Row
StandardDeviations(const Samples & samples)
{
  Row mean = Row::Zero(), square = Row::Zero();
  for (const Row & row : samples.terms)
  {
    mean += row / static_cast<double>(samples.terms.size());
  }
  for (const Row & row : samples.terms)
  {
    square += (row - mean).cwiseAbs2() / static_cast<double>(samples.terms.size());
  }
  Row deviations = square.cwiseSqrt();
  deviations[numberOfPolypTerms] = 1.0; // of the constant
  return deviations;
}

Row
Fit(const Samples & samples)
{
  const Row deviations = StandardDeviations(samples);
  Row       weights = Row::Zero();
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    Row                                       gradient = -weights;
    Eigen::Matrix<double, unknowns, unknowns> hessian = Eigen::Matrix<double, unknowns, unknowns>::Identity();
    gradient[numberOfPolypTerms] = 0.0;
    hessian(numberOfPolypTerms, numberOfPolypTerms) = 1e-9;
    for (std::size_t i = 0; i < samples.terms.size(); ++i)
    {
      const Row    row = samples.terms[i].cwiseQuotient(deviations);
      const double p = 1.0 / (1.0 + std::exp(-row.dot(weights)));
      gradient += (samples.isPolyp[i] - p) * row;
      hessian += p * (1.0 - p) * row.transpose() * row;
    }
    const Row step = hessian.ldlt().solve(gradient.transpose()).transpose();
    weights += step * std::min(1.0, 2.0 / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
  }
  return weights.cwiseQuotient(deviations);
}
} // namespace

int
main()
{
  Samples samples;
  for (const LandmarkCase & one : TrainingExams())
  {
    const LandmarkExam exam = MakeLandmarkExam(one);
    if (!exam.failure.empty())
    {
      std::fprintf(stderr, "%s: %s\n", NameOfCase(one).c_str(), exam.failure.c_str());
      return 1;
    }
    AddExam(exam, samples);
  }
  const Row  weights = Fit(samples);
  const auto polyps = static_cast<int>(std::count(samples.isPolyp.begin(), samples.isPolyp.end(), 1.0));
  std::printf("%d polyps, %d other bulges\n"
              "shape index, ln roundness, ln hollowness, ln (curvedness / 0.25 per mm) from 0, constant:\n",
              polyps,
              static_cast<int>(samples.terms.size()) - polyps);
  for (int i = 0; i < unknowns; ++i)
  {
    std::printf("%.3f%s", weights[i], i + 1 < unknowns ? ", " : "\n");
  }
  return 0;
}
