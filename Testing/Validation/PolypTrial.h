#ifndef PolypTrial_h
#define PolypTrial_h

#include "LandmarkTrial.h"

#include "shapetonPolypCandidates.h"

#include <vector>

/** A polyp of a phantom that could be found, and what was. */
struct PolypTruth
{
  shapeton::ColonPolyp polyp;
  /** Of the candidate with the highest score at it; 0 for none. */
  double score{ 0.0 };
  /** Of that candidate, mm. */
  double diameter{ 0.0 };
};

/** What was found in an exam. */
struct PolypExam
{
  std::string name;
  /** Outside of collapsed stretches. */
  std::vector<PolypTruth> truths;
  /** Scores of candidates that are at no polyp, and of those at the ileocaecal valve among them. */
  std::vector<double> falseScores;
  std::vector<double> valveScores;
};

/** How far from a polyp's head or base, beyond its radius, a candidate may be that has found it, mm. */
constexpr double polypReach = 3.0;

/** Whether a candidate is at a polyp. */
bool
IsAt(const shapeton::PolypCandidate & candidate, const shapeton::ColonPolyp & polyp);

/** Whether a candidate is at the true ileocaecal valve. */
bool
IsAtValve(const shapeton::ColonAnatomy & anatomy, const shapeton::PolypCandidate & candidate);

/** Compares candidates, in any order, with the truth. The valve is the true one. */
PolypExam
ComparePolyps(const LandmarkCase &                          one,
              const shapeton::ColonAnatomy &                anatomy,
              const std::vector<shapeton::PolypCandidate> & candidates);

/** Polyps outside of collapsed stretches. */
std::vector<shapeton::ColonPolyp>
VisiblePolyps(const shapeton::ColonAnatomy & anatomy);

/** The lower end of Wilson's 95 % interval (two-sided) of a share; 0 for none. */
double
WilsonLowerBound(int part, int whole);

#endif
