#include "shapetonColonoscopyStages.h"

#include "shapetonColonDicomObjectOptions.h"
#include "shapetonColonExamination.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonSha256.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
namespace names = colonoscopystage;

/** Fractions of the run time of a series, for the progress. */
constexpr double shareOfInspection = 0.02;
constexpr double shareOfSegmentation = 0.5;
constexpr double shareOfFlattening = 0.25;
constexpr double shareOfLandmarks = 0.1;
constexpr double shareOfFolds = 0.06;

/** Passes options to the tools. */
class OptionPasser
{
public:
  OptionPasser(const CommandLine & commandLine, ColonoscopySeries series) : m_CommandLine(commandLine), m_Series(series)
  {}

  /** Passes options that apply to all series. */
  void
  Pass(Stage & stage, const std::vector<std::string> & options) const
  {
    for (const std::string & option : options)
    {
      this->PassAs(stage, option, option);
    }
  }

  /** Passes an option specific to this series. */
  void
  PassOwn(Stage & stage, const std::string & option) const
  {
    this->PassAs(stage, option, ParameterOfSeries(option, m_Series));
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
  void
  PassAs(Stage & stage, const std::string & option, const std::string & parameter) const
  {
    const std::string value = m_CommandLine.GetCanonical(parameter);
    if (!value.empty())
    {
      stage.Option(option, value);
    }
  }

  const CommandLine & m_CommandLine;
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
  return { name, ToolOfStage(name) };
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
  std::vector<std::string> files = FilesAlwaysWrittenBy(names::dicom);
  for (const auto & [option, file] :
       { std::pair("ohif", examination::dicomForOhif), std::pair("fhir", examination::fhirBundle) })
  {
    if (commandLine.GetFlag(option))
    {
      files.emplace_back(file.name);
    }
  }
  return files;
}

/** The path of a result of the first stages, for a later stage. */
std::string
PathIn(const StagedRun & run, const ExaminationFile & file)
{
  return run.PathOf(file.stage, file.name);
}

Stage
Inspection(const OptionPasser & passer)
{
  Stage stage = NewStage(names::inspection);
  stage.Input("", passer.Volume()).Output("json", examination::series.name);
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
    .Expect(FilesAlwaysWrittenBy(names::segmentation));
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
  const std::string path = PathIn(run, examination::cleansedCt);
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
  stage.Input("", PathIn(run, examination::simplifiedWall))
    .Output("", examination::flat.name)
    .Input("centerline", PathIn(run, examination::centerline))
    .Output("statistics", examination::flatStatistics.name)
    .Output("handles", examination::handles.name)
    .Output("picture", examination::flatPicture.name)
    .Output("coordinateMap", examination::coordinates.name)
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
  stage.Input("", PathIn(run, examination::flat))
    .Input("", PathIn(run, examination::centerline))
    .Output("", "")
    .Output("report", "report")
    .Expect(FilesAlwaysWrittenBy(names::landmarks));
  PassCleansed(stage, run);
  passer.PassOwnInput(stage, "markers");
  passer.Pass(stage, { "flexureRule", "taeniaRule", "split" });
  return stage;
}

/** Identity of the curves, excluding the provenance, so that folds are not recomputed for options that do not change
 * the curves. */
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
  stage.Input("", PathIn(run, examination::flat))
    .Output("", examination::foldLabels.name)
    .Output("features", examination::foldFeatures.name)
    .Output("table", examination::foldTable.name)
    .Output("picture", examination::foldPicture.name)
    .Output("markups", examination::foldMarkups.name)
    .Output("colorTable", examination::foldColors.name);
  if (fs::exists(PathIn(run, examination::taeniae)))
  {
    stage.Input("taeniae", PathIn(run, examination::taeniae), IdentityOfCurves);
  }
  passer.Pass(stage, { "pixelSize", "minimumLength", "minimumArea" });
  return stage;
}

/** The stage that searches for candidates on the wall in a folder and writes their table. */
Stage
SearchForCandidates(const char * name, const OptionPasser & passer, const std::string & folder)
{
  Stage stage = NewStage(name);
  stage.InputFolder("", folder, FilesReadBy(stage.GetProgram())).Output("", examination::candidates.name);
  passer.Pass(stage, { "sensitivity" });
  return stage;
}
} // namespace

std::string
FolderOfSeries(const std::string & outputFolder, ColonoscopySeries series)
{
  return series == ColonoscopySeries::First ? outputFolder : outputFolder + '/' + secondPositionFolder;
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
      stage.InputFolder("", FolderOfSeries(folder, series), FilesReadBy(stage.GetProgram()));
    }
    stage.Output("", "").Output("report", "report").Expect(FilesAlwaysWrittenBy(names::registration));
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
    stage.Output("markups", examination::candidateMarkups.name)
      .Output("heads", examination::heads.name)
      .Output("report", "report");
    if (hasOther)
    {
      const std::string other = series == ColonoscopySeries::First ? FolderOfSeries(folder, ColonoscopySeries::Second) +
                                                                       '/' + examination::candidates.Path()
                                                                           : folder + '/' + examination::searched.Path();
      stage
        .InputFolder(
          "registration",
          folder + '/' + names::registration,
          { examination::supineToProne.name, examination::proneToSupine.name, examination::registration.name })
        .Input("other", other);
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
    const std::vector<std::string> ofPosition = FilesReadBy(ToolOfStage(names::viewer));
    std::vector<std::string>       read = ofPosition;
    for (const std::string & path : ofPosition)
    {
      read.push_back(std::string(secondPositionFolder) + '/' + path);
    }
    Stage stage = NewStage(names::viewer);
    stage.InputFolder("", folder, read).Output("", "").Expect(FilesAlwaysWrittenBy(names::viewer));
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
    stage.InputFolder("", folder, FilesReadBy(stage.GetProgram()))
      .Output("", "")
      .Input("source", passer.Volume())
      .Expect(files);
    passer.Pass(stage, OptionsOfDicomResults());
    return stage;
  };
  return { names::dicom, 1.0, make };
}
} // namespace shapeton
