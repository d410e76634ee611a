#include "shapetonColonoscopyStages.h"

#include "shapetonColonDicomObjectOptions.h"
#include "shapetonColonoscopyResults.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonSha256.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
namespace names = colonoscopystage;

/** Shares of the run time of a series, for the progress. */
constexpr double shareOfInspection = 0.02;
constexpr double shareOfSegmentation = 0.5;
constexpr double shareOfFlattening = 0.25;
constexpr double shareOfLandmarks = 0.1;
constexpr double shareOfFolds = 0.06;

/** Passes options to the tools, spelled as in the provenance. */
class OptionPasser
{
public:
  OptionPasser(const CommandLine & commandLine, ColonoscopySeries series)
    : m_CommandLine(commandLine), m_Provenance(commandLine.GetProvenance()), m_Series(series)
  {}

  /** Passes options that apply to all series. */
  void
  Pass(Stage & stage, const std::vector<std::string> & options) const
  {
    constexpr std::string_view prefix = "option.";
    for (const auto & [key, value] : m_Provenance)
    {
      if (key.rfind(prefix, 0) == 0 && std::count(options.begin(), options.end(), key.substr(prefix.size())) > 0)
      {
        stage.Option(key.substr(prefix.size()), value);
      }
    }
  }

  /** Passes an option specific to this series. */
  void
  PassOwn(Stage & stage, const std::string & option) const
  {
    for (const auto & [key, value] : m_Provenance)
    {
      if (key == "option." + ParameterOfSeries(option, m_Series))
      {
        stage.Option(option, value);
      }
    }
  }

  void
  PassOwnInput(Stage & stage, const std::string & option) const
  {
    const std::string parameter = ParameterOfSeries(option, m_Series);
    if (m_CommandLine.IsGiven(parameter))
    {
      stage.Input(option, m_CommandLine.GetString(parameter));
    }
  }

  void
  PassSeedPoints(Stage & stage) const
  {
    for (const auto & p : m_CommandLine.GetPoints(ParameterOfSeries("seedPoint", m_Series)))
    {
      stage.Option("seedPoint", CsvTable::Number(p[0]) + ',' + CsvTable::Number(p[1]) + ',' + CsvTable::Number(p[2]));
    }
  }

  /** The input path of the series. */
  std::string
  Volume() const
  {
    return m_CommandLine.GetString(ParameterOfSeries("inputVolume", m_Series));
  }

  void
  PassDevice(Stage & stage) const
  {
    stage.Idle("device", m_CommandLine.GetString("device"));
  }

private:
  const CommandLine & m_CommandLine;
  Provenance          m_Provenance;
  ColonoscopySeries   m_Series;
};

bool
IsDicom(const std::string & path)
{
  return fs::is_directory(path) || !IsImageFile(path); // as in ReadVolume()
}

/** Creates a stage with the tool that it runs. */
Stage
NewStage(const char * name)
{
  return { name, names::ToolOf(name) };
}

/** Options of dicomResults. */
std::vector<std::string>
OptionsOfDicomResults()
{
  ColonDicomObjectOptions  options;
  std::vector<std::string> names;
  ColonDicomObjectOptions::VisitOptions(options,
                                        [&](const OptionInfo & info, auto &) { names.push_back(info.GetName()); });
  return names;
}

std::vector<std::string>
FilesOfDicomResults(const CommandLine & commandLine)
{
  std::vector<std::string> files{ "seg.dcm", "sr.dcm", "cad.dcm", "sc.dcm", "stl.dcm" };
  for (const auto & [option, file] : { std::pair("ohif", "sr-ohif.dcm"), std::pair("fhir", "fhir.json") })
  {
    if (commandLine.GetFlag(option))
    {
      files.push_back(file);
    }
  }
  return files;
}

Stage
Inspection(const OptionPasser & passer)
{
  Stage stage = NewStage(names::inspection);
  stage.Input("", passer.Volume()).Output("json", "series.json");
  return stage;
}

Stage
Segmentation(const OptionPasser & passer)
{
  Stage stage = NewStage(names::segmentation);
  stage.Input("", passer.Volume())
    .Output("", "")
    .Output("report", "report")
    .Option("keepPartial", "true") // for the reason of a failure in the report
    .Expect({ "lumen.nrrd", "centerline.vtp", "wall.vtp", "wall-repaired.vtp", "wall-simplified.vtp", "quality.json" });
  passer.Pass(stage, { "inputIsLumen", "topology", "faces", "resampleGaps", "deshear", "dropDuplicates" });
  passer.PassOwn(stage, "position");
  passer.PassOwn(stage, "seriesUID");
  passer.PassOwnInput(stage, "lumen");
  passer.PassSeedPoints(stage);
  return stage;
}

/** Passes the cleansed CT; returns false if there is none, as for a lumen mask. */
bool
PassCleansed(Stage & stage, const StagedRun & run)
{
  const std::string path = run.PathOf(names::segmentation, "cleansed.nrrd");
  const bool        exists = fs::exists(path);
  if (exists)
  {
    stage.Input("volume", path);
  }
  return exists;
}

Stage
Flattening(const OptionPasser & passer, const StagedRun & run)
{
  Stage stage = NewStage(names::flattening);
  stage.Input("", run.PathOf(names::segmentation, "wall-simplified.vtp"))
    .Output("", "flat.vtp")
    .Input("centerline", run.PathOf(names::segmentation, "centerline.vtp"))
    .Output("statistics", "flat.json")
    .Output("handles", "handles.vtp")
    .Output("picture", "flat.png")
    .Output("coordinateMap", "coordinates.nrrd")
    .Output("report", "report");
  if (PassCleansed(stage, run))
  {
    passer.PassDevice(stage);
  }
  passer.Pass(stage, { "metric", "time", "pixelSize" });
  return stage;
}

Stage
Landmarks(const OptionPasser & passer, const StagedRun & run)
{
  Stage stage = NewStage(names::landmarks);
  stage.Input("", run.PathOf(names::flattening, "flat.vtp"))
    .Input("", run.PathOf(names::segmentation, "centerline.vtp"))
    .Output("", "")
    .Output("report", "report")
    .Expect({ "landmarks.json", "segments.vtp" });
  PassCleansed(stage, run);
  passer.PassOwnInput(stage, "markers");
  passer.Pass(stage, { "flexureRule", "taeniaRule", "split" });
  return stage;
}

/** Identity of the curves without the provenance, so folds are not recomputed for options that do not change the
 * curves. */
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
Folds(const OptionPasser & passer, const StagedRun & run)
{
  Stage stage = NewStage(names::folds);
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
  return stage;
}

/** The stage that searches for candidates on the wall in a folder and writes their table. */
Stage
SearchForCandidates(const char * name, const OptionPasser & passer, const std::string & folder)
{
  Stage stage = NewStage(name);
  stage
    .InputFolder("",
                 folder,
                 { "segmentation/wall-repaired.vtp",
                   "segmentation/lumen.nrrd",
                   "segmentation/centerline.vtp",
                   "segmentation/cleansed.nrrd",
                   "segmentation/cleansing.nrrd",
                   "segmentation/catheter.vtp",
                   "flattening/flat.vtp",
                   "landmarks/segments.vtp",
                   "folds/labels.nrrd" })
    .Output("", "candidates.csv");
  passer.Pass(stage, { "sensitivity" });
  return stage;
}
} // namespace

std::string
FolderOfSeries(const std::string & outputFolder, ColonoscopySeries series)
{
  return series == ColonoscopySeries::First ? outputFolder : outputFolder + '/' + colonoscopySecondFolder;
}

std::string
ParameterOfSeries(const std::string & option, ColonoscopySeries series)
{
  if (series == ColonoscopySeries::First)
  {
    return option;
  }
  if (option == "inputVolume")
  {
    return "second";
  }
  const auto first = static_cast<char>(std::toupper(static_cast<unsigned char>(option.front())));
  return "second" + std::string(1, first) + option.substr(1);
}

std::vector<ColonoscopyStage>
StagesOfSeries(const CommandLine & commandLine, ColonoscopySeries series)
{
  const OptionPasser            passer(commandLine, series);
  std::vector<ColonoscopyStage> stages;
  if (IsDicom(passer.Volume()))
  {
    stages.push_back({ names::inspection, shareOfInspection, [=](const StagedRun &) { return Inspection(passer); } });
  }
  stages.push_back(
    { names::segmentation, shareOfSegmentation, [=](const StagedRun &) { return Segmentation(passer); } });
  stages.push_back(
    { names::flattening, shareOfFlattening, [=](const StagedRun & run) { return Flattening(passer, run); } });
  stages.push_back(
    { names::landmarks, shareOfLandmarks, [=](const StagedRun & run) { return Landmarks(passer, run); } });
  return stages;
}

ColonoscopyStage
StageOfFolds(const CommandLine & commandLine, ColonoscopySeries series)
{
  const OptionPasser passer(commandLine, series);
  return { names::folds, shareOfFolds, [=](const StagedRun & run) { return Folds(passer, run); } };
}

ColonoscopyStage
StageOfRegistration(const CommandLine & commandLine)
{
  const OptionPasser passer(commandLine, ColonoscopySeries::First);
  const std::string  folder = commandLine.GetString("outputFolder");
  const auto         make = [=](const StagedRun &) {
    Stage stage = NewStage(names::registration);
    for (const ColonoscopySeries series : { ColonoscopySeries::First, ColonoscopySeries::Second })
    {
      stage.InputFolder("",
                        FolderOfSeries(folder, series),
                        { "flattening/flat.vtp",
                          "segmentation/centerline.vtp",
                          "landmarks/landmarks.json",
                          "landmarks/folds-surface.vtp",
                          "landmarks/taeniae.vtp",
                          "folds/folds.csv" });
    }
    stage.Output("", "").Output("report", "report").Expect({ "registration.json", "matches.csv" });
    passer.Pass(stage, { "matching", "refine", "segmentWise" });
    passer.PassOwnInput(stage, "evaluate");
    return stage;
  };
  return { names::registration, 1.0, make };
}

ColonoscopyStage
StageOfSearch(const CommandLine & commandLine)
{
  const OptionPasser passer(commandLine, ColonoscopySeries::First);
  const std::string  folder = commandLine.GetString("outputFolder");
  return { names::search, 1.0, [=](const StagedRun &) { return SearchForCandidates(names::search, passer, folder); } };
}

ColonoscopyStage
StageOfPolyps(const CommandLine & commandLine, ColonoscopySeries series)
{
  const OptionPasser passer(commandLine, series);
  const std::string  folder = commandLine.GetString("outputFolder");
  const bool         hasOther = commandLine.IsGiven("second");
  const auto         make = [=](const StagedRun &) {
    Stage stage = SearchForCandidates(names::polyps, passer, FolderOfSeries(folder, series));
    stage.Output("markups", "candidates.mrk.json").Output("heads", "heads.nrrd").Output("report", "report");
    if (hasOther)
    {
      const std::string other = series == ColonoscopySeries::First
                                          ? FolderOfSeries(folder, ColonoscopySeries::Second) + '/' + names::polyps
                                          : folder + '/' + names::search;
      stage
        .InputFolder("registration",
                     folder + '/' + names::registration,
                     { "map-supine-to-prone.vtp", "map-prone-to-supine.vtp", "registration.json" })
        .Input("other", other + "/candidates.csv");
    }
    return stage;
  };
  return { names::polyps, 1.0, make };
}

ColonoscopyStage
StageOfViewer(const CommandLine & commandLine)
{
  const OptionPasser passer(commandLine, ColonoscopySeries::First);
  const std::string  folder = commandLine.GetString("outputFolder");
  const auto         make = [=](const StagedRun &) {
    std::vector<std::string> read{ "registration/map-supine-to-prone.vtp", "registration/map-prone-to-supine.vtp" };
    for (const std::string position : { "", "second/" })
    {
      for (const char * const file : { "segmentation/quality.json",
                                       "segmentation/lumen.nrrd",
                                       "segmentation/cleansed.nrrd",
                                       "segmentation/cleansing.nrrd",
                                       "segmentation/centerline.vtp",
                                       "segmentation/wall-repaired.vtp",
                                       "flattening/flat.vtp",
                                       "landmarks/segments.vtp",
                                       "landmarks/taeniae.vtp",
                                       "landmarks/flexures.vtp",
                                       "folds/labels.nrrd",
                                       "polyps/candidates.csv" })
      {
        read.push_back(position + file);
      }
    }
    Stage stage = NewStage(names::viewer);
    stage.InputFolder("", folder, read).Output("", "").Expect({ "viewer.html" });
    return stage;
  };
  return { names::viewer, 1.0, make };
}

void
CheckDicomResults(const CommandLine & commandLine)
{
  for (const std::string & option : OptionsOfDicomResults())
  {
    RequireParameter(commandLine.GetFlag("dicomResults") || !commandLine.IsGiven(option),
                     "the parameter \"" + option + "\" requires the parameter \"dicomResults\"");
  }
  for (const char * const input : { "inputVolume", "second" })
  {
    RequireParameter(!commandLine.GetFlag("dicomResults") || !commandLine.IsGiven(input) ||
                       IsDicom(commandLine.GetString(input)),
                     std::string("the parameter \"dicomResults\" requires a DICOM series as input: \"") +
                       commandLine.GetString(input) + "\" is not one");
  }
}

ColonoscopyStage
StageOfDicomResults(const CommandLine & commandLine, ColonoscopySeries series)
{
  const OptionPasser passer(commandLine, series);
  const std::string  folder = FolderOfSeries(commandLine.GetString("outputFolder"), series);
  const auto         files = FilesOfDicomResults(commandLine);
  const auto         make = [=](const StagedRun &) {
    Stage stage = NewStage(names::dicom);
    stage
      .InputFolder("",
                   folder,
                   { "segmentation/quality.json",
                     "segmentation/lumen.nrrd",
                     "segmentation/centerline.vtp",
                     "segmentation/wall-simplified.vtp",
                     "flattening/flat.vtp",
                     "flattening/flat.png",
                     "landmarks/landmarks.json",
                     "folds/labels.nrrd",
                     "polyps/candidates.csv",
                     "polyps/heads.nrrd" })
      .Output("", "")
      .Input("source", passer.Volume())
      .Expect(files);
    passer.Pass(stage, OptionsOfDicomResults());
    return stage;
  };
  return { names::dicom, 1.0, make };
}
} // namespace shapeton
