#include "shapetonColonoscopyResults.h"

#include "shapetonHaustralFoldFiles.h"
#include "shapetonRegistrationFiles.h"
#include "shapetonPolypSearch.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonParallelFor.h"
#include "shapetonReadImage.h"

#include "shapetonJson.h"

#include "itkNrrdImageIO.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace shapeton
{
namespace
{
namespace names = colonoscopystage;

/** Reads the existing files of stages. */
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

/** Indices of the centers (kind 0) among the feature points. */
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

/** Pictures in the report of ColonPolyps: the flat colon, and one per candidate. */
std::vector<std::string>
PicturesOfPolyps(const StageFiles & files, std::size_t polyps)
{
  std::vector<std::string> paths;
  const auto               add = [&](const std::string & path) { paths.push_back(path); };
  files.Read(names::polyps, "report/polyp-candidates-flat.png", add);
  for (std::size_t i = 1; i <= polyps; ++i)
  {
    files.Read(names::polyps, ("report/polyp-candidate-" + std::to_string(i) + ".png").c_str(), add);
  }
  return paths;
}

/** mm; 0 if the curve lacks the value. */
double
LengthOfCenterline(const CurveSet & centerline)
{
  const SurfaceArray * const distance = FindSurfaceArray(centerline.pointArrays, "arcLength");
  return distance && distance->values.size() > 0 ? distance->values.maxCoeff() : 0.0;
}

/** Runs in a separate thread, which must not start the processes that read images. */
void
ReadAllButImages(const StageFiles & files, const std::string & folder, ColonoscopyResults & results)
{
  const auto surface = [](SurfaceMesh & mesh) {
    return [&mesh](const std::string & path) { mesh = ReadSurface(path).mesh; };
  };
  const auto curves = [](CurveSet & set) { return [&set](const std::string & path) { set = ReadCurves(path); }; };
  const auto json = [](Json & document) {
    return [&document](const std::string & path) { document = ReadJson(path); };
  };
  files.Read(names::inspection, "series.json", json(results.inspection));
  files.Read(names::segmentation, "quality.json", json(results.quality));
  files.Read(names::segmentation, "centerline.vtp", curves(results.centerline));
  files.Read(names::segmentation, "wall-simplified.vtp", surface(results.wall));
  files.Read(names::flattening, "flat.vtp", [&](const std::string & path) {
    results.flat = std::make_shared<FlatColon>(ReadSurface(path).mesh);
  });
  files.Read(names::flattening, "flat.json", json(results.flatStatistics));
  files.Read(names::landmarks, "landmarks.json", json(results.landmarks));
  files.Read(names::landmarks, "taeniae.vtp", curves(results.taeniae));
  files.Read(names::landmarks, "flexures.vtp", curves(results.flexures));
  files.Read(names::landmarks, "segments.vtp", surface(results.labeled));
  files.Read(names::folds, "features.vtp", curves(results.features));
  if (!results.landmarks.is_null())
  {
    results.segments = SegmentsOf(results.landmarks, LengthOfCenterline(results.centerline));
  }
  results.folds = FoldsOf(results.features);
  files.Read(
    names::polyps, "candidates.csv", [&](const std::string & path) { results.polyps = ReadPolypCandidates(path); });
  results.polypPictures = PicturesOfPolyps(files, results.polyps.size());
  if (results.IsDone(names::registration))
  {
    const std::string second = folder + '/' + colonoscopySecondFolder;
    results.pair = std::make_shared<const ColonoscopyPair>(
      ColonoscopyPair{ ReadColonPosition(folder, "supine"),
                       ReadColonPosition(second, "prone"),
                       ReadRegistrationResults(folder + '/' + names::registration) });
    results.qualityOfSecond = ReadJson(second + "/segmentation/quality.json");
    if (const std::string table = second + "/polyps/candidates.csv"; std::filesystem::exists(table))
    {
      results.polypsOfOther = ReadPolypCandidates(table);
    }
  }
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

ColonoscopyResults
ReadColonoscopyResults(const std::string & folder, const std::vector<StageResult> & stages)
{
  ColonoscopyResults results;
  results.stages = stages;
  const StageFiles files(folder, results);
  WorkBeside       others = StartBeside([&] { ReadAllButImages(files, folder, results); });
  files.Read(
    names::segmentation, "cleansed.nrrd", [&](const std::string & path) { results.ct = ReadImageFile(path).image; });
  files.Read(names::segmentation, "cleansing.nrrd", [&](const std::string & path) {
    results.original = UncleansedCt(results.ct, path);
  });
  files.Read(names::segmentation, "lumen.nrrd", [&](const std::string & path) {
    results.lumen =
      ReadImage<itk::Image<unsigned char, 3>>(path, itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
  });
  files.Read(names::folds, "labels.nrrd", [&](const std::string & path) { results.foldLabels = ReadFoldLabels(path); });
  others.Get();
  return results;
}
} // namespace shapeton
