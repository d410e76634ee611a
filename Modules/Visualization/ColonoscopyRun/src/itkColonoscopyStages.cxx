#include "itkColonoscopyStages.h"

#include "itkColonoscopyResults.h"
#include "itkCommandLine.h"
#include "itkCsvTable.h"
#include "itkSha256.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace fs = std::filesystem;

namespace itk
{
namespace
{
namespace names = colonoscopystage;

/** Hands options on to the tools, in the one spelling that provenance has for each. */
class OptionPasser
{
public:
  explicit OptionPasser(const CommandLine & commandLine)
    : m_CommandLine(commandLine), m_Provenance(commandLine.GetProvenance())
  {}

  void
  Pass(Stage & stage, const std::vector<std::string> & options) const
  {
    for (const auto & [key, value] : m_Provenance)
    {
      if (key.rfind("option.", 0) == 0 && std::count(options.begin(), options.end(), key.substr(7)) > 0)
      {
        stage.Option(key.substr(7), value);
      }
    }
  }

  void
  PassInput(Stage & stage, const std::string & name) const
  {
    if (m_CommandLine.IsGiven(name))
    {
      stage.Input(name, m_CommandLine.GetString(name));
    }
  }

  void
  PassThreads(Stage & stage) const
  {
    stage.Idle("threads", m_CommandLine.GetString("threads"));
  }

private:
  const CommandLine &     m_CommandLine;
  CommandLine::Provenance m_Provenance;
};

const std::vector<std::string> readingOptions{ "seriesUID", "resampleGaps", "deshear", "dropDuplicates" };

bool
IsDicom(const std::string & path)
{
  const std::vector<std::string> others{ ".nrrd", ".nhdr", ".nii", ".gz", ".mha", ".mhd" };
  std::string                    extension = fs::path(path).extension().string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return fs::is_directory(path) || std::count(others.begin(), others.end(), extension) == 0;
}

Stage
Inspection(const CommandLine & commandLine)
{
  Stage stage(names::inspection, "DicomSeriesInspector");
  stage.Input("", commandLine.GetString("inputVolume")).Output("json", "series.json");
  OptionPasser(commandLine).PassThreads(stage);
  return stage;
}

Stage
Segmentation(const CommandLine & commandLine)
{
  const OptionPasser passer(commandLine);
  Stage              stage(names::segmentation, "ColonSegmentation");
  stage.Input("", commandLine.GetString("inputVolume"))
    .Output("", "")
    .Output("report", "report")
    .Option("keepPartial", "true") // so that the report shows why it failed
    .Expect({ "lumen.nrrd", "centreline.vtp", "wall.vtp", "wall-repaired.vtp", "wall-simplified.vtp", "quality.json" });
  passer.Pass(stage, { "inputIsLumen", "position", "faces" });
  passer.Pass(stage, readingOptions);
  passer.PassInput(stage, "lumen");
  for (const auto & p : commandLine.GetPoints("seedPoint"))
  {
    stage.Option("seedPoint", CsvTable::Number(p[0]) + ',' + CsvTable::Number(p[1]) + ',' + CsvTable::Number(p[2]));
  }
  passer.PassThreads(stage);
  return stage;
}

Stage
Flattening(const CommandLine & commandLine, const StagedRun & run)
{
  const OptionPasser passer(commandLine);
  Stage              stage(names::flattening, "ColonFlattening");
  stage.Input("", run.PathOf(names::segmentation, "wall-simplified.vtp"))
    .Output("", "flat.vtp")
    .Input("centreline", run.PathOf(names::segmentation, "centreline.vtp"))
    .Output("statistics", "flat.json")
    .Output("handles", "handles.vtp")
    .Output("picture", "flat.png")
    .Output("coordinateMap", "coordinates.nrrd")
    .Output("report", "report");
  if (fs::exists(run.PathOf(names::segmentation, "cleansed.nrrd")))
  {
    stage.Input("volume", run.PathOf(names::segmentation, "cleansed.nrrd"));
  }
  passer.Pass(stage, { "metric", "time", "removeHandles", "pixelSize" });
  passer.PassThreads(stage);
  return stage;
}

Stage
Landmarks(const CommandLine & commandLine, const StagedRun & run)
{
  const OptionPasser passer(commandLine);
  Stage              stage(names::landmarks, "ColonLandmarks");
  stage.Input("", run.PathOf(names::flattening, "flat.vtp"))
    .Input("", run.PathOf(names::segmentation, "centreline.vtp"))
    .Output("", "")
    .Output("report", "report")
    .Expect({ "landmarks.json", "segments.vtp" });
  passer.PassInput(stage, "markers");
  passer.Pass(stage, { "flexureRule", "taeniaRule", "split" });
  passer.PassThreads(stage);
  return stage;
}

/** What the curves are, without the facts on how they were made: another option that leaves them as they are does not
 * ask for new folds. */
std::string
IdentityOfCurves(const std::string & path)
{
  const CurveSet     curves = ReadCurves(path);
  std::ostringstream text;
  const auto         add = [&](const SurfaceArray & array) {
    text << array.name << ' ' << array.values.rows() << ' ' << array.values.cols() << '\n';
    for (Eigen::Index i = 0; i < array.values.size(); ++i)
    {
      text << CsvTable::Number(array.values.data()[i]) << '\n';
    }
  };
  add({ "V", curves.V, false });
  for (const std::vector<int> & curve : curves.curves)
  {
    text << "curve";
    for (const int vertex : curve)
    {
      text << ' ' << vertex;
    }
    text << '\n';
  }
  for (const auto * arrays : { &curves.pointArrays, &curves.cellArrays, &curves.fieldArrays })
  {
    std::for_each(arrays->begin(), arrays->end(), add);
  }
  return "sha256:" + Sha256OfBytes(text.str());
}

Stage
Folds(const CommandLine & commandLine, const StagedRun & run)
{
  const OptionPasser passer(commandLine);
  Stage              stage(names::folds, "ColonFolds");
  stage.Input("", run.PathOf(names::flattening, "flat.vtp"))
    .Output("", "labels.nrrd")
    .Output("features", "features.vtp")
    .Output("table", "folds.csv")
    .Output("picture", "folds.png")
    .Output("markups", "features.mrk.json")
    .Output("colorTable", "labels.ctbl");
  if (fs::exists(run.PathOf(names::landmarks, "taeniae.vtp")))
  {
    stage.Input("taeniae", run.PathOf(names::landmarks, "taeniae.vtp"), IdentityOfCurves);
  }
  passer.Pass(stage, { "pixelSize", "minimumLength", "minimumArea" });
  passer.PassThreads(stage);
  return stage;
}
} // namespace

std::vector<ColonoscopyStage>
StagesOfColonoscopy(const CommandLine & commandLine)
{
  std::vector<ColonoscopyStage> stages;
  if (IsDicom(commandLine.GetString("inputVolume")))
  {
    stages.push_back({ names::inspection, 0.02, [&](const StagedRun &) { return Inspection(commandLine); } });
  }
  stages.push_back({ names::segmentation, 0.5, [&](const StagedRun &) { return Segmentation(commandLine); } });
  stages.push_back({ names::flattening, 0.25, [&](const StagedRun & run) { return Flattening(commandLine, run); } });
  stages.push_back({ names::landmarks, 0.1, [&](const StagedRun & run) { return Landmarks(commandLine, run); } });
  stages.push_back({ names::folds, 0.06, [&](const StagedRun & run) { return Folds(commandLine, run); } });
  return stages;
}
} // namespace itk
