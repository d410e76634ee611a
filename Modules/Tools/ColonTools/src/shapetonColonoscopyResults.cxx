#include "shapetonColonoscopyResults.h"

#include "shapetonColonQuality.h"
#include "shapetonExaminationInputs.h"
#include "shapetonParallelFor.h"
#include "shapetonRegistrationFolder.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Reads the files of stages that were run. */
class StageFiles
{
public:
  StageFiles(const std::string & folder, const ColonoscopyResults & results) : m_Exam(folder), m_Results(results) {}

  const ExaminationFolder &
  Exam() const
  {
    return m_Exam;
  }

  bool
  Has(const ExaminationFile & file) const
  {
    return this->Has(file.stage, file.name);
  }
  bool
  Has(const char * stage, const std::string & name) const
  {
    const StageResult * const result = m_Results.Find(stage);
    return result && result->Has(name);
  }

  void
  Read(const ExaminationFile & file, Json & document) const
  {
    document = this->Has(file) ? ReadJson(m_Exam.PathOf(file)) : Json();
  }
  void
  Read(const ExaminationFile & file, CurveSet & curves) const
  {
    curves = this->Has(file) ? m_Exam.ReadCurvesOf(file) : CurveSet();
  }
  void
  Read(const ExaminationFile & file, SurfaceMesh & surface) const
  {
    surface = this->Has(file) ? m_Exam.ReadSurfaceOf(file) : SurfaceMesh();
  }

private:
  ExaminationFolder          m_Exam;
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
  std::vector<std::string> names{ "report/polyp-candidates-flat.png" };
  for (std::size_t i = 1; i <= polyps; ++i)
  {
    names.push_back("report/polyp-candidate-" + std::to_string(i) + ".png");
  }
  std::vector<std::string> paths;
  for (const std::string & name : names)
  {
    if (files.Has(colonoscopystage::polyps, name))
    {
      paths.push_back(files.Exam().GetFolder() + '/' + colonoscopystage::polyps + '/' + name);
    }
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

/** States the valve decided from both positions, if they were registered. */
void
StateValveOfBoth(const std::string & examinationFolder, int position, Json & quality)
{
  const std::string folder = examinationFolder + '/' + colonoscopystage::registration;
  if (const auto valve = ValveOfRegistration(folder, position); valve && quality.contains("ileocecalValve"))
  {
    StateValve(*valve, quality);
  }
}

void
ReadQuality(const StageFiles & files, ColonoscopyResults & results)
{
  files.Read(examination::quality, results.quality);
  const fs::path folder = fs::path(files.Exam().GetFolder()).lexically_normal();
  const bool     isSecond =
    folder.filename() == secondPositionFolder && fs::exists(folder.parent_path() / examination::registration.Path());
  if (results.IsDone(colonoscopystage::registration))
  {
    StateValveOfBoth(folder.string(), 0, results.quality);
  }
  else if (isSecond && results.IsDone(colonoscopystage::polyps))
  {
    StateValveOfBoth(folder.parent_path().string(), 1, results.quality);
  }
}

/** Reads the registration with the second position, and the results of the second position that reports on the first
 * one show. */
void
ReadPair(const ExaminationFolder & first, ColonoscopyResults & results)
{
  const ExaminationFolder second(first.GetFolder() + '/' + secondPositionFolder);
  results.pair = std::make_shared<const ColonoscopyPair>(
    ColonoscopyPair{ ReadColonPosition(first, "supine"),
                     ReadColonPosition(second, "prone"),
                     ReadRegistrationResults(first.GetFolder() + '/' + colonoscopystage::registration) });
  results.qualityOfSecond = second.ReadQuality();
  StateValveOfBoth(first.GetFolder(), 1, results.qualityOfSecond);
  results.polypsOfOther = second.ReadCandidates();
}

/** Runs in a separate thread, which must not start the processes that read images. */
void
ReadAllButImages(const StageFiles & files, ColonoscopyResults & results)
{
  files.Read(examination::series, results.inspection);
  ReadQuality(files, results);
  files.Read(examination::centerline, results.centerline);
  files.Read(examination::simplifiedWall, results.wall);
  if (files.Has(examination::flat))
  {
    results.flat = files.Exam().ReadFlatColon();
  }
  files.Read(examination::flatStatistics, results.flatStatistics);
  files.Read(examination::landmarks, results.landmarks);
  files.Read(examination::taeniae, results.taeniae);
  files.Read(examination::flexures, results.flexures);
  files.Read(examination::segments, results.labeled);
  files.Read(examination::foldFeatures, results.features);
  if (!results.landmarks.is_null())
  {
    results.segments = SegmentsOf(results.landmarks, LengthOfCenterline(results.centerline));
  }
  results.folds = FoldsOf(results.features);
  if (files.Has(examination::candidates))
  {
    results.polyps = files.Exam().ReadCandidates();
  }
  results.polypPictures = PicturesOfPolyps(files, results.polyps.size());
  if (results.IsDone(colonoscopystage::registration))
  {
    ReadPair(files.Exam(), results);
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
  WorkBeside       others = StartBeside([&] { ReadAllButImages(files, results); });
  if (files.Has(examination::cleansedCt))
  {
    results.ct = files.Exam().ReadCleansedCt();
  }
  if (files.Has(examination::cleansing))
  {
    results.original = files.Exam().ReadOriginalCt(results.ct);
  }
  if (files.Has(examination::lumen))
  {
    results.lumen = files.Exam().ReadLumen();
  }
  if (files.Has(examination::foldLabels))
  {
    results.foldLabels = files.Exam().ReadFolds();
  }
  others.Get();
  return results;
}
} // namespace shapeton
