#include "PolypTrial.h"
#include "Tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
/** Whether the true colon is collapsed at a distance along its centerline. */
bool
IsCollapsedAt(const CurveSet & centerline, double arcLength)
{
  const Eigen::VectorXd distances = PointValues(centerline, "arcLength", "the centerline");
  const Eigen::VectorXd collapsed = PointValues(centerline, "collapsed", "the centerline");
  Eigen::Index          nearest = 0;
  (distances.array() - arcLength).abs().minCoeff(&nearest);
  return collapsed[nearest] != 0.0;
}
} // namespace

bool
IsAt(const PolypCandidate & candidate, const ColonPolyp & polyp)
{
  const double distance =
    std::min((candidate.position - polyp.position).norm(), (candidate.position - polyp.base).norm());
  return distance <= 0.5 * polyp.diameter + polypReach;
}

bool
IsAtValve(const ColonAnatomy & anatomy, const PolypCandidate & candidate)
{
  const ColonValve valve = anatomy.Valve();
  return (candidate.position - valve.position).norm() <= 0.5 * valve.length + polypReach;
}

std::vector<ColonPolyp>
VisiblePolyps(const ColonAnatomy & anatomy)
{
  const CurveSet          centerline = anatomy.Centerline();
  std::vector<ColonPolyp> visible;
  for (const ColonPolyp & polyp : anatomy.Polyps())
  {
    if (!IsCollapsedAt(centerline, polyp.arcLength))
    {
      visible.push_back(polyp);
    }
  }
  return visible;
}

PolypExam
ComparePolyps(const LandmarkCase & one, const ColonAnatomy & anatomy, const std::vector<PolypCandidate> & candidates)
{
  PolypExam exam;
  exam.name = NameOfCase(one);
  for (const ColonPolyp & polyp : VisiblePolyps(anatomy))
  {
    PolypTruth truth{ polyp, 0.0, 0.0 };
    for (const PolypCandidate & candidate : candidates)
    {
      if (IsAt(candidate, polyp) && candidate.score > truth.score)
      {
        truth.score = candidate.score;
        truth.diameter = candidate.diameter;
      }
    }
    exam.truths.push_back(truth);
  }
  const std::vector<ColonPolyp> polyps = anatomy.Polyps();
  for (const PolypCandidate & candidate : candidates)
  {
    if (std::none_of(polyps.begin(), polyps.end(), [&](const ColonPolyp & polyp) { return IsAt(candidate, polyp); }))
    {
      exam.falseScores.push_back(candidate.score);
      if (IsAtValve(anatomy, candidate))
      {
        exam.valveScores.push_back(candidate.score);
      }
    }
  }
  return exam;
}

double
WilsonLowerBound(int part, int whole)
{
  if (whole == 0)
  {
    return 0.0;
  }
  constexpr double z = 1.959964;
  const double     n = whole, p = part / n;
  return (p + z * z / (2.0 * n) - z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n))) / (1.0 + z * z / n);
}

double
PolypCount::LowerBound() const
{
  return WilsonLowerBound(found, present);
}

PolypCount
CountFound(const std::vector<PolypExam> & exams, const PolypGroup & group, double score)
{
  PolypCount count;
  for (const PolypExam & exam : exams)
  {
    for (const PolypTruth & truth : exam.truths)
    {
      if (group.Holds(truth.polyp))
      {
        ++count.present;
        count.found += truth.score >= score ? 1 : 0;
      }
    }
  }
  return count;
}

int
CountFrom(const std::vector<double> & scores, double least)
{
  return static_cast<int>(std::count_if(scores.begin(), scores.end(), [&](double score) { return score >= least; }));
}

std::string
ShareWithBound(const PolypCount & count)
{
  return RatioOf(count.found, count.present) + ", lower 95 % bound " + Rounded(count.LowerBound());
}
