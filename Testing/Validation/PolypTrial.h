#ifndef PolypTrial_h
#define PolypTrial_h

#include "LandmarkTrial.h"

#include "shapetonPolypCandidates.h"

#include <vector>

/** Detectable polyp of a phantom and its best candidate. */
struct PolypTruth
{
  shapeton::ColonPolyp polyp;
  /** Highest score of a candidate at the polyp; 0 without one. */
  double score{ 0.0 };
  /** Diameter of that candidate (mm). */
  double diameter{ 0.0 };
};

/** Results of an exam. */
struct PolypExam
{
  std::string name;
  /** Polyps outside of collapsed sections. */
  std::vector<PolypTruth> truths;
  /** Scores of false positive candidates, and of the subset at the ileocecal valve. */
  std::vector<double> falseScores;
  std::vector<double> valveScores;
};

/** Maximum distance (mm) of a matching candidate from the head or base of a polyp, in addition to the polyp's radius.
 * */
constexpr double polypReach = 3.0;

/** Whether a candidate is at a polyp. */
bool
IsAt(const shapeton::PolypCandidate & candidate, const shapeton::ColonPolyp & polyp);

/** Whether a candidate is at the true ileocecal valve. */
bool
IsAtValve(const shapeton::ColonAnatomy & anatomy, const shapeton::PolypCandidate & candidate);

/** Compares candidates, in any order, with the truth, including the true valve. */
PolypExam
ComparePolyps(const LandmarkCase &                          one,
              const shapeton::ColonAnatomy &                anatomy,
              const std::vector<shapeton::PolypCandidate> & candidates);

/** Polyps outside of collapsed sections. */
std::vector<shapeton::ColonPolyp>
VisiblePolyps(const shapeton::ColonAnatomy & anatomy);

/** Type and size range of polyps. */
struct PolypGroup
{
  bool   isFlat;
  double least; ///< mm
  double below; ///< mm

  bool
  Holds(const shapeton::ColonPolyp & polyp) const
  {
    return (polyp.kind == "flat") == isFlat && polyp.diameter >= least && polyp.diameter < below;
  }
};

struct PolypCount
{
  int found{ 0 };
  int present{ 0 };

  double
  LowerBound() const;
};

/** Counts the polyps of a group that have a candidate with at least this score. */
PolypCount
CountFound(const std::vector<PolypExam> & exams, const PolypGroup & group, double score);

int
CountFrom(const std::vector<double> & scores, double least);

/** Formats the fraction found, with its lower 95 % bound. */
std::string
ShareWithBound(const PolypCount & count);

/** Lower end of Wilson's two-sided 95 % interval of a fraction; 0 without samples. */
double
WilsonLowerBound(int part, int whole);

#endif
