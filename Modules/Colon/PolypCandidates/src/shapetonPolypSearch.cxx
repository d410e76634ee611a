#include "shapetonPolypSearch.h"

#include "shapetonCandidateList.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonSegments.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonPolypContent.h"
#include "shapetonPolypMorphology.h"
#include "shapetonReadImage.h"
#include "shapetonScanResolution.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonImageFile.h"
#include "shapetonParallelFor.h"

#include "itkNrrdImageIO.h"

#include <cmath>
#include <filesystem>

namespace shapeton
{
namespace
{
bool
IsThere(const std::string & path)
{
  return std::filesystem::exists(path);
}

void
RequireThere(const std::string & path)
{
  if (!IsThere(path))
  {
    throw InputError("\"" + path + "\" was not found; give a folder written by VirtualColonoscopy");
  }
}

SurfaceMesh
ReadPart(const std::string & path, const std::string & name, const std::string & cost, PolypColon & colon)
{
  if (!IsThere(path))
  {
    colon.warnings.push_back("\"" + path + "\" was not found: " + cost);
    return {};
  }
  SurfaceReadOptions any;
  any.component = -1;
  Surface surface = ReadSurface(path, any);
  colon.facts.emplace_back(name, surface.identity);
  return std::move(surface.mesh);
}

void
ReadVolumes(const std::string & segmentation, PolypColon & colon)
{
  colon.lumen =
    ReadImage<PolypLumenImage>(segmentation + "lumen.nrrd", itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
  if (IsThere(segmentation + "cleansed.nrrd"))
  {
    colon.ct = ReadImageFile(segmentation + "cleansed.nrrd").image;
  }
  if (colon.ct && IsThere(segmentation + "cleansing.nrrd"))
  {
    colon.original = UncleansedCt(colon.ct, segmentation + "cleansing.nrrd");
  }
}

double
LengthOf(const CurveSet & centerline)
{
  const SurfaceArray * const distance = FindSurfaceArray(centerline.pointArrays, "arcLength");
  return distance && distance->values.size() > 0 ? distance->values.maxCoeff()
                                                 : std::numeric_limits<double>::quiet_NaN();
}

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

/** Adds remarks to candidates in stretches where wall is hidden: their own wall may be visible. */
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

itk::Image<float, 3>::Pointer
UncleansedCt(const itk::Image<float, 3> * cleansed, const std::string & path)
{
  const auto image = ReadImageFile(path).image;
  if (!HaveSameGrid(image, cleansed))
  {
    throw InputError("\"" + path + "\" does not belong to the cleansed CT beside it; run ColonSegmentation again");
  }
  const std::size_t   voxels = image->GetLargestPossibleRegion().GetNumberOfPixels();
  float * const       values = image->GetBufferPointer();
  const float * const rest = cleansed->GetBufferPointer();
  ParallelForBlocks(voxels, [=](std::size_t i) { values[i] += rest[i]; });
  return image;
}

PolypColon
ReadPolypColon(const std::string & folder)
{
  const std::string segmentation = folder + "/segmentation/";
  PolypColon        colon;
  RequireCurrentFileNames(folder);
  RequireThere(segmentation + "wall-repaired.vtp");
  RequireThere(segmentation + "lumen.nrrd");
  WorkBeside wall = StartBeside([&] { colon.wall = ReadPart(segmentation + "wall-repaired.vtp", "wall", "", colon); });
  ReadVolumes(segmentation, colon);
  wall.Get();
  if (IsThere(segmentation + "centerline.vtp"))
  {
    colon.centerline = ReadCurves(segmentation + "centerline.vtp");
    RequireSound(colon.centerline, '"' + segmentation + "centerline.vtp\"");
  }
  if (IsThere(segmentation + "catheter.vtp"))
  {
    colon.catheter = ReadCurves(segmentation + "catheter.vtp");
  }
  SurfaceMesh flat =
    ReadPart(folder + "/flattening/flat.vtp", "flat", "candidates have neither a map position nor a picture", colon);
  if (flat.NumberOfFaces() > 0)
  {
    colon.flat = std::make_shared<FlatColon>(std::move(flat));
  }
  if (IsThere(folder + "/folds/labels.nrrd"))
  {
    colon.folds = ReadFoldLabels(folder + "/folds/labels.nrrd");
  }
  colon.segments = ReadPart(folder + "/landmarks/segments.vtp", "segments", "segments are not named", colon);
  return colon;
}

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
  else
  {
    NoteIleocecalValve(LengthOf(colon.centerline), candidates);
  }
  NoteRectalCatheter(candidates);
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
