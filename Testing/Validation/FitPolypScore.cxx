// Fits the weights of PolypScore() to phantoms and prints them. Usage: FitPolypScore. The exams are from
// TrainingExams(), with 0.8 mm voxels; exams from CT take minutes each.
//
// Positive samples: for each polyp of at least 5.5 mm, the candidate with the greatest solid angle. Negative samples:
// candidates away from polyps, weighted by the score factor for content and catheter. Candidates at the
// ileocecal valve are excluded, because it has the shape of a polyp. Logistic regression by Newton's method, with a
// penalty of half the squared weights of the terms over their standard deviations.
#include "LogisticRegression.h"
#include "PolypTrial.h"

#include "shapetonPolypContent.h"

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

/** Only seeds below 100; the others are for validation. The true lumen adds negatives of the anatomy; CT adds negatives
 * caused by noise, segmentation and residue. */
std::vector<LandmarkCase>
TrainingExams()
{
  std::vector<LandmarkCase> exams;
  const char * const        presets[] = { "standard", "hard", "realistic" };
  for (unsigned int seed = 1; seed <= 15; ++seed)
  {
    exams.push_back(ValidationCase(presets[seed % 3], seed, seed % 2 == 0 ? "prone" : "supine", 0.8, false));
  }
  for (unsigned int seed = 1; seed <= 9; ++seed)
  {
    exams.push_back(ValidationCase(presets[seed % 3], seed, seed % 2 == 0 ? "supine" : "prone", 0.8, true));
  }
  return exams;
}

/** All candidates, judged by content and catheter. */
std::vector<PolypCandidate>
CandidatesOf(const ColonExam & exam)
{
  PolypCandidateOptions all;
  all.sensitivity = 1.0;
  std::vector<PolypCandidate> candidates = FindPolypCandidates(exam.wall, all);
  if (exam.ct)
  {
    MeasureContent(exam.wall, exam.ct, exam.lumen, candidates);
  }
  if (!exam.catheter.curves.empty())
  {
    RankCatheterLast(exam.catheter, candidates);
  }
  return candidates;
}

void
AddSample(const PolypCandidate & candidate, bool isPolyp, LogisticSamples & samples)
{
  const auto terms = TermsOf(candidate.features);
  Row        row;
  row << Eigen::Map<const Eigen::Matrix<double, 1, numberOfPolypTerms>>(terms.data()), 1.0;
  samples.Add(row.transpose(), isPolyp, isPolyp ? 1.0 : candidate.score / candidate.shapeScore);
}

void
AddExam(const ColonExam & exam, LogisticSamples & samples)
{
  constexpr double                    leastPolyp = 5.5; // mm
  const std::vector<PolypCandidate>   candidates = CandidatesOf(exam);
  const std::vector<ColonPolyp>       polyps = exam.anatomy->Polyps();
  std::vector<const PolypCandidate *> best(polyps.size(), nullptr);
  for (const PolypCandidate & candidate : candidates)
  {
    bool isAtPolyp = false;
    for (std::size_t i = 0; i < polyps.size(); ++i)
    {
      if (IsAt(candidate, polyps[i]))
      {
        isAtPolyp = true;
        const bool isGreater = best[i] == nullptr || candidate.features.solidAngle > best[i]->features.solidAngle;
        best[i] = isGreater ? &candidate : best[i];
      }
    }
    if (!isAtPolyp && !IsAtValve(*exam.anatomy, candidate))
    {
      AddSample(candidate, false, samples);
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
StandardDeviations(const LogisticSamples & samples)
{
  Row mean = Row::Zero(), square = Row::Zero();
  for (const Eigen::VectorXd & terms : samples.terms)
  {
    mean += terms.transpose() / static_cast<double>(samples.terms.size());
  }
  for (const Eigen::VectorXd & terms : samples.terms)
  {
    square += (terms.transpose() - mean).cwiseAbs2() / static_cast<double>(samples.terms.size());
  }
  Row deviations = square.cwiseSqrt();
  deviations[numberOfPolypTerms] = 1.0; // the constant
  return deviations;
}

Row
Fit(LogisticSamples samples)
{
  const Row deviations = StandardDeviations(samples);
  for (Eigen::VectorXd & terms : samples.terms)
  {
    terms = terms.cwiseQuotient(deviations.transpose());
  }
  Eigen::VectorXd penalties = Eigen::VectorXd::Ones(unknowns);
  penalties[numberOfPolypTerms] = 0.0; // the constant
  return FitLogistic(samples, penalties).transpose().cwiseQuotient(deviations);
}
} // namespace

int
main()
{
  LogisticSamples samples;
  for (const LandmarkCase & one : TrainingExams())
  {
    const ColonExam exam = MakeColonExam(one);
    if (!exam.failure.empty())
    {
      std::fprintf(stderr, "%s: %s\n", NameOfCase(one).c_str(), exam.failure.c_str());
      return 1;
    }
    AddExam(exam, samples);
  }
  const Row  weights = Fit(samples);
  const auto polyps = static_cast<int>(std::count(samples.outcomes.begin(), samples.outcomes.end(), 1.0));
  std::printf("%d polyps, %d other bulges\nshape index, ln roundness, ln hollowness, ln (curvedness / 0.25 per mm) "
              "from 0, constant:\n",
              polyps,
              static_cast<int>(samples.terms.size()) - polyps);
  for (int i = 0; i < unknowns; ++i)
  {
    std::printf("%.3f%s", weights[i], i + 1 < unknowns ? ", " : "\n");
  }
  return 0;
}
