#include "shapetonPolypSearch.h"

#include "shapetonCandidateList.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonSegments.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonPolypContent.h"
#include "shapetonPolypMorphology.h"
#include "shapetonScanResolution.h"
#include "shapetonExceptions.h"

namespace shapeton
{
namespace
{
void
PlaceOnFlatMap(const FlatColon & flat, std::vector<PolypCandidate> & candidates)
{
  const FlatColonLocator locator(flat.Grid());
  for (PolypCandidate & candidate : candidates)
  {
    candidate.uv = locator.Find(candidate.position).uv;
  }
}

/** Whether a point of the wall belongs to a fold; empty if folds are unknown. */
std::function<bool(const Eigen::Vector3d &)>
FoldTest(const PolypColon & colon)
{
  if (!colon.flat || !colon.folds)
  {
    return {};
  }
  const SurfaceMesh & flat = colon.flat->Surface();
  const auto          folds = std::make_shared<const std::vector<unsigned short>>(FoldsOfFaces(flat, *colon.folds));
  const auto          locator = std::make_shared<const SurfaceLocator>(flat.V, flat.F);
  return [=](const Eigen::Vector3d & point) { return (*folds)[locator->FindClosest(point).face] != 0; };
}

void
NameSegments(const SurfaceMesh & segments, std::vector<PolypCandidate> & candidates)
{
  const SurfaceArray * const segment = FindSurfaceArray(segments.cellArrays, "segment");
  if (segment == nullptr)
  {
    throw InputError("segments.vtp has no cell array segment; run ColonLandmarks again");
  }
  const SurfaceLocator locator(segments.V, segments.F);
  for (PolypCandidate & candidate : candidates)
  {
    candidate.segment = static_cast<int>(segment->values(locator.FindClosest(candidate.position).face, 0));
  }
}

/** Adds a remark to each candidate in a stretch where the wall is partly hidden. The wall at the candidate itself may
 * be visible. */
void
NoteHindrances(const CurveSet & centerline, std::vector<PolypCandidate> & candidates)
{
  const std::vector<HinderedStretch> stretches = FindHinderedStretches(centerline);
  for (PolypCandidate & candidate : candidates)
  {
    const ColonHindrance hindrance = HindranceAt(stretches, candidate.arcLength);
    AddRemark(hindrance == ColonHindrance::None ? "" : "in this stretch: " + InWords(hindrance), candidate);
  }
}

std::vector<PolypCandidate>
Find(const PolypColon & colon, const PolypSearchSettings & options)
{
  if (options.preset == PolypPreset::Published)
  {
    PublishedPolypOptions published;
    published.sensitivity = options.sensitivity;
    published.progress = options.progress.Part("Candidates", 0.0, 0.7);
    return FindPublishedPolypCandidates(colon.wall, colon.lumen, colon.ct, published);
  }
  PolypCandidateOptions ours;
  ours.sensitivity = options.sensitivity;
  ours.progress = options.progress.Part("Candidates", 0.0, 0.7);
  return FindPolypCandidates(colon.wall, ours);
}
} // namespace

std::vector<PolypCandidate>
SearchPolyps(const PolypColon & colon, const PolypSearchSettings & options)
{
  options.progress("Candidates", 0.0);
  std::vector<PolypCandidate> candidates = Find(colon, options);
  MeasureShapeDiffusion(colon.wall, colon.lumen, candidates, options.progress.Part("Shape diffusion", 0.7, 0.9));
  options.progress("Shape diffusion", 0.9);
  if (colon.ct)
  {
    MeasureContent(colon.wall, colon.ct, colon.lumen, candidates);
  }
  if (colon.original)
  {
    NoteResidue(colon.wall, colon.original, colon.lumen, candidates);
  }
  if (colon.flat)
  {
    PlaceOnFlatMap(*colon.flat, candidates);
  }
  if (colon.segments.NumberOfFaces() > 0)
  {
    NameSegments(colon.segments, candidates);
  }
  if (const auto valve = IleocecalValveOf(colon.centerline))
  {
    RankValveLast(*valve, candidates);
  }
  NoteIleocecalValve(ValveCandidatesOf(colon.centerline), candidates);
  if (!colon.centerline.curves.empty())
  {
    NoteAnalCanal(colon.centerline, candidates);
  }
  if (TellsHindrances(colon.centerline))
  {
    NoteHindrances(colon.centerline, candidates);
  }
  NoteSmallerThan(NotAssessableBelow(colon.centerline), candidates);
  if (!colon.catheter.curves.empty())
  {
    RankCatheterLast(colon.catheter, candidates);
  }
  if (!candidates.empty())
  {
    MeasureMorphology(colon.wall, FoldTest(colon), candidates);
    JoinFragments(colon.wall, candidates);
  }
  options.progress("Candidates", 1.0);
  return candidates;
}
} // namespace shapeton
