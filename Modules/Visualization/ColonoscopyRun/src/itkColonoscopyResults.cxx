#include "itkColonoscopyResults.h"

#include "itkSurfaceReader.h"
#include "itkToolError.h"
#include "itkVolumeReader.h"

#include "itkImageFileReader.h"
#include "itkNrrdImageIO.h"

#include <algorithm>
#include <map>

namespace itk
{
namespace
{
namespace names = colonoscopystage;

/** Reads the files of stages that are there. */
class StageFiles
{
public:
  StageFiles(const std::string & folder, const ColonoscopyResults & results) : m_Folder(folder), m_Results(results) {}

  template <typename TRead>
  void
  Read(const char * stage, const char * file, const TRead & read) const
  {
    const StageResult * const result = m_Results.Find(stage);
    if (result && result->Has(file))
    {
      read(m_Folder + '/' + stage + '/' + file);
    }
  }

private:
  std::string                m_Folder;
  const ColonoscopyResults & m_Results;
};

Image<unsigned short, 2>::Pointer
ReadLabels(const std::string & path)
{
  auto reader = ImageFileReader<Image<unsigned short, 2>>::New();
  reader->SetImageIO(NrrdImageIO::New());
  reader->SetFileName(path);
  try
  {
    reader->Update();
  }
  catch (const ExceptionObject & error)
  {
    throw InputError("\"" + path + "\" cannot be read (" + error.GetDescription() + "); remove it and run again");
  }
  return reader->GetOutput();
}

/** The centres (kind 0) among the feature points. */
std::vector<ColonoscopyFold>
FoldsOf(const CurveSet & features)
{
  const SurfaceArray * const   fold = FindSurfaceArray(features.cellArrays, "fold");
  const SurfaceArray * const   kind = FindSurfaceArray(features.cellArrays, "kind");
  const SurfaceArray * const   arcLength = FindSurfaceArray(features.cellArrays, "arcLength");
  const SurfaceArray * const   reliability = FindSurfaceArray(features.cellArrays, "reliability");
  std::vector<ColonoscopyFold> folds;
  for (Eigen::Index i = 0; fold && kind && arcLength && i < fold->values.rows(); ++i)
  {
    if (kind->values(i, 0) == 0.0)
    {
      folds.push_back({ static_cast<int>(fold->values(i, 0)),
                        arcLength->values(i, 0),
                        reliability ? reliability->values(i, 0) : 1.0 });
    }
  }
  return folds;
}

/** Of one segment's faces. */
struct Reach
{
  std::vector<double> distances;
  double              area{ 0.0 };

  double
  At(double share)
  {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), distances.begin() + place, distances.end());
    return distances[place];
  }
};

std::map<int, Reach>
ReachesOf(const SurfaceMesh & labelled, const SurfaceArray & segment, const SurfaceArray & arcLength)
{
  std::map<int, Reach> reaches;
  for (Eigen::Index face = 0; face < labelled.F.rows(); ++face)
  {
    const auto            corner = labelled.F.row(face);
    const Eigen::Vector3d a = labelled.V.row(corner[0]);
    const Eigen::Vector3d b = labelled.V.row(corner[1]);
    const Eigen::Vector3d c = labelled.V.row(corner[2]);
    Reach &               reach = reaches[static_cast<int>(segment.values(face, 0))];
    reach.area += 0.5 * (b - a).cross(c - a).norm();
    reach.distances.push_back(
      (arcLength.values(corner[0], 0) + arcLength.values(corner[1], 0) + arcLength.values(corner[2], 0)) / 3.0);
  }
  return reaches;
}
} // namespace

const StageResult *
ColonoscopyResults::Find(const std::string & stage) const
{
  const auto found =
    std::find_if(stages.begin(), stages.end(), [&](const StageResult & result) { return result.name == stage; });
  return found == stages.end() ? nullptr : &*found;
}

bool
ColonoscopyResults::IsDone(const std::string & stage) const
{
  const StageResult * const result = this->Find(stage);
  return result && result->status == 0;
}

std::string
NameOfColonSegment(int label)
{
  static const char * const known[] = { "rectum", "sigmoid", "descending", "transverse", "ascending", "caecum" };
  return label >= 1 && label <= 6 ? known[label - 1] : "segment " + std::to_string(label);
}

std::string
NameOfFlexure(int label)
{
  static const char * const known[] = { "rectosigmoid", "descending-sigmoid", "splenic", "hepatic" };
  return label >= 1 && label <= 4 ? known[label - 1] : "flexure " + std::to_string(label);
}

std::vector<ColonoscopySegment>
SegmentsOf(const SurfaceMesh & labelled)
{
  constexpr double                leftAside = 0.01;
  const SurfaceArray * const      segment = FindSurfaceArray(labelled.cellArrays, "segment");
  const SurfaceArray * const      arcLength = FindSurfaceArray(labelled.pointArrays, "arcLength");
  std::vector<ColonoscopySegment> segments;
  if (!segment || !arcLength)
  {
    return segments;
  }
  for (auto & [label, reach] : ReachesOf(labelled, *segment, *arcLength))
  {
    segments.push_back(
      { label, NameOfColonSegment(label), reach.At(leftAside), reach.At(1.0 - leftAside), reach.area });
  }
  for (std::size_t i = 1; i < segments.size(); ++i)
  {
    const double border = 0.5 * (segments[i - 1].end + segments[i].begin);
    segments[i - 1].end = border;
    segments[i].begin = border;
  }
  return segments;
}

ColonoscopyResults
ReadColonoscopyResults(const std::string & folder, const std::vector<StageResult> & stages)
{
  ColonoscopyResults results;
  results.stages = stages;
  const StageFiles files(folder, results);
  const auto       surface = [](SurfaceMesh & mesh) {
    return [&mesh](const std::string & path) { mesh = ReadSurface(path).mesh; };
  };
  const auto curves = [](CurveSet & set) { return [&set](const std::string & path) { set = ReadCurves(path); }; };
  const auto json = [](Json & document) {
    return [&document](const std::string & path) { document = ReadJson(path); };
  };
  files.Read(names::segmentation, "quality.json", json(results.quality));
  files.Read(names::segmentation, "centreline.vtp", curves(results.centreline));
  files.Read(names::segmentation, "wall-simplified.vtp", surface(results.wall));
  files.Read(
    names::segmentation, "cleansed.nrrd", [&](const std::string & path) { results.ct = ReadVolume(path).image; });
  files.Read(names::flattening, "flat.vtp", surface(results.flat));
  files.Read(names::flattening, "flat.json", json(results.flatStatistics));
  files.Read(names::landmarks, "landmarks.json", json(results.landmarks));
  files.Read(names::landmarks, "taeniae.vtp", curves(results.taeniae));
  files.Read(names::landmarks, "flexures.vtp", curves(results.flexures));
  files.Read(names::landmarks, "segments.vtp", surface(results.labelled));
  files.Read(names::folds, "labels.nrrd", [&](const std::string & path) { results.foldLabels = ReadLabels(path); });
  files.Read(names::folds, "features.vtp", curves(results.features));
  results.segments = SegmentsOf(results.labelled);
  results.folds = FoldsOf(results.features);
  return results;
}
} // namespace itk
