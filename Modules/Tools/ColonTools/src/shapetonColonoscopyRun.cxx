#include "shapetonColonoscopyRun.h"

#include "shapetonColonFigures.h"
#include "shapetonColonoscopyPresentation.h"
#include "shapetonColonoscopyStages.h"
#include "shapetonExaminationFolder.h"
#include "shapetonJson.h"
#include "shapetonStageRecord.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"
#include "shapetonSceneFiles.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Options of the registration; they do not affect the results of a single series. */
const std::vector<std::string> optionsOfPair{ "matching", "refine", "segmentWise", "evaluate" };

/** Final stages, if requested. */
std::vector<ColonoscopyStage>
LastStages(const CommandLine & commandLine, ColonoscopySeries series)
{
  std::vector<ColonoscopyStage> stages;
  if (commandLine.GetFlag("dicomResults"))
  {
    stages.push_back(StageOfDicomResults(commandLine, series));
  }
  if (commandLine.GetFlag("viewer") && series == ColonoscopySeries::First) // one page for both series
  {
    stages.push_back(StageOfViewer(commandLine));
  }
  return stages;
}

/** Where the stages begin in the progress of the whole run, and their fraction of it. */
struct PartOfProgress
{
  double begin;
  double share;
};

/** Runs the stages of one series in its folder. */
class SeriesRun
{
public:
  SeriesRun(CommandLine & commandLine, const std::string & toolFolder, ColonoscopySeries series)
    : m_CommandLine(commandLine)
    , m_Series(series)
    , m_Folder(FolderOfSeries(commandLine.GetString("outputFolder"), series))
    , m_Run(MadeFolder(commandLine, m_Folder), toolFolder)
  {}

  void
  AddInputs()
  {
    for (const char * const option : { "inputVolume", "lumen", "markers" })
    {
      const std::string parameter = ParameterOfSeries(option, m_Series);
      if (m_CommandLine.IsGiven(parameter))
      {
        m_CommandLine.AddInput(parameter, m_Run.Identify(m_CommandLine.GetString(parameter)));
      }
    }
  }

  /** A finished examination is not replaced by that of another input, which may be a mistake. */
  void
  RequireSameInput()
  {
    const auto record = ReadStageRecord(m_Folder + "/stages/" + colonoscopystage::segmentation + ".json");
    if (!record || record->result.status != 0)
    {
      return;
    }
    const std::string input = m_Run.Identify(m_CommandLine.GetString(ParameterOfSeries("inputVolume", m_Series)));
    const Json        arguments = Json::parse(record->signature).at("arguments");
    const bool        wasLumen =
      std::find(arguments.begin(), arguments.end(), Json::array({ "inputIsLumen", "true" })) != arguments.end();
    const bool isSame = record->IdentityOfInput() == input && wasLumen == m_CommandLine.GetFlag("inputIsLumen");
    RequireParameter(isSame,
                     "the folder \"" + m_Folder +
                       "\" contains the examination of another input, or of this one with "
                       "another value of the parameter \"inputIsLumen\"; use a new folder, or remove this one first");
  }

  /** Runs all stages until one fails. */
  bool
  Run(const std::vector<ColonoscopyStage> & stages, const PartOfProgress & part)
  {
    double begin = part.begin;
    for (const ColonoscopyStage & stage : stages)
    {
      this->Record(this->Compute(stage, { begin, part.share }, NumberOfThreads()));
      if (this->Status() != 0)
      {
        return false;
      }
      begin += stage.share * part.share;
    }
    return true;
  }

  /** Runs two independent stages, in parallel if there are enough threads to share; both run even if one fails. Reports
   * the progress of the second one, which takes longer. */
  bool
  RunBoth(const ColonoscopyStage & shorter, const ColonoscopyStage & longer, const PartOfProgress & part)
  {
    const unsigned int threads = NumberOfThreads();
    StageResult        first;
    WorkBeside         beside;
    if (threads > 1)
    {
      beside = StartBeside([&] { first = m_Run.Run(StageWithThreads(shorter, threads / 2)); });
      m_CommandLine.Progress(this->Prefix() + shorter.name, part.begin);
    }
    else
    {
      first = this->Compute(shorter, part, threads);
    }
    StageResult second =
      this->Compute(longer, { part.begin + shorter.share * part.share, part.share }, threads - threads / 2);
    beside.Get();
    this->Record(std::move(first));
    this->Record(std::move(second));
    return this->Status() == 0;
  }

  /** Runs two stages one after the other; the second one runs even if the first one fails, because it does not require
   * the first one's results. */
  bool
  RunInTurn(const ColonoscopyStage & first, const ColonoscopyStage & second, const PartOfProgress & part)
  {
    StageResult before = this->Compute(first, part, NumberOfThreads());
    StageResult after = this->Compute(second, { part.begin + first.share * part.share, part.share }, NumberOfThreads());
    this->Record(std::move(before));
    this->Record(std::move(after));
    return this->Status() == 0;
  }

  /** Exit status of the first failed stage; 0 if there is none. */
  int
  Status() const
  {
    const auto failed =
      std::find_if(m_Results.begin(), m_Results.end(), [](const StageResult & result) { return result.status != 0; });
    return failed == m_Results.end() ? 0 : failed->status;
  }

  /** Error message of the first failed stage; "" if there is none. */
  std::string
  Failure() const
  {
    if (this->Status() == 0)
    {
      return "";
    }
    std::vector<std::string> kept;
    for (const StageResult & stage : m_Results)
    {
      if (stage.status == 0 || !stage.files.empty())
      {
        kept.push_back(stage.status == 0 ? stage.name : "a part of " + stage.name);
      }
    }
    std::string text;
    for (const StageResult & stage : m_Results)
    {
      if (stage.status != 0)
      {
        text += (text.empty() ? "the stage " : "; so did ") + stage.name + " (" + stage.program + ")" +
                (m_Series == ColonoscopySeries::Second ? " of the second series" : "") +
                (text.empty() ? " failed: " : ": ") + stage.message;
      }
    }
    return text + "; kept: " + (kept.empty() ? "nothing" : Joined(kept, ", ")) + ", report.html";
  }

  ColonoscopyPresentation
  Presentation() const
  {
    return { m_Folder,        m_Results,
             m_Warnings,      m_CommandLine.GetProvenance(),
             this->Failure(), m_Series == ColonoscopySeries::Second };
  }

private:
  static const std::string &
  MadeFolder(CommandLine & commandLine, const std::string & folder)
  {
    commandLine.MakeFolder(folder);
    commandLine.MakeFolder(folder + "/stages");
    const std::string version = folder + '/' + examination::format.name;
    WriteExaminationVersion(commandLine.Output(version));
    commandLine.Publish(version);
    return folder;
  }

  Stage
  StageWithThreads(const ColonoscopyStage & stage, unsigned int threads)
  {
    return stage.make(m_Run).Idle("threads", std::to_string(threads));
  }

  StageResult
  Compute(const ColonoscopyStage & stage, const PartOfProgress & part, unsigned int threads)
  {
    const std::string name = this->Prefix() + stage.name;
    m_CommandLine.Progress(name, part.begin);
    return m_Run.Run(this->StageWithThreads(stage, threads), [&](const std::string & step, double done) {
      m_CommandLine.Progress(name + ": " + step, part.begin + done * stage.share * part.share);
    });
  }

  void
  Record(StageResult && result)
  {
    for (const std::string & warning : result.warnings)
    {
      m_Warnings.push_back(result.name + ": " + warning);
      m_CommandLine.Warn(this->Prefix() + m_Warnings.back());
    }
    m_Results.push_back(std::move(result));
  }

  std::string
  Prefix() const
  {
    return m_Series == ColonoscopySeries::Second ? "second: " : "";
  }

  CommandLine &            m_CommandLine;
  ColonoscopySeries        m_Series;
  std::string              m_Folder;
  StagedRun                m_Run;
  std::vector<StageResult> m_Results;
  std::vector<std::string> m_Warnings;
};

void
LeaveOut(const std::vector<std::string> & options, Provenance & provenance)
{
  const auto isOne = [&](const std::pair<std::string, std::string> & fact) {
    return std::count(options.begin(), options.end(), fact.first.substr(fact.first.find('.') + 1)) > 0;
  };
  provenance.erase(std::remove_if(provenance.begin(), provenance.end(), isOne), provenance.end());
}

/** Files that 3D Slicer loads as nodes. */
SceneFiles
SceneFilesOf(CommandLine & commandLine)
{
  RequireParameter(!commandLine.GetFlag("inputIsLumen") ||
                     !(commandLine.IsGiven("cleansedVolume") || commandLine.IsGiven("lumenLabels")),
                   "the input is a lumen mask: the parameters \"cleansedVolume\" and \"lumenLabels\" require a CT");
  return { commandLine,
           { { "cleansedVolume", examination::cleansedCt.Path() },
             { "lumenLabels", examination::lumen.Path() },
             { "wallModel", examination::segments.Path() },
             { "centerlineCurve", examination::slicerCenterline.Path() },
             { "candidatePoints", examination::candidateMarkups.Path() },
             { "candidateTable", examination::candidates.Path() },
             { "flatPicture", examination::flatPicture.Path() } } };
}

/** Throws the exception for the failed stage. */
[[noreturn]] void
ThrowFailure(int status, const std::string & failure)
{
  switch (status)
  {
    case 2:
      throw ParameterError(failure);
    case 3:
      throw InputError(failure);
    default:
      throw OutputError(failure);
  }
}

void
RunOne(CommandLine & commandLine, SeriesRun & only)
{
  constexpr ColonoscopySeries first = ColonoscopySeries::First;
  constexpr PartOfProgress    series{ 0.0, 0.9 }, foldsAndPolyps{ 0.79, 0.13 }, last{ 0.93, 0.01 };
  ColonoscopyPresenter        presenter(commandLine);
  if (only.Run(StagesOfSeries(commandLine, first), series) &&
      only.RunInTurn(StageOfFolds(commandLine, first), StageOfPolyps(commandLine, first), foldsAndPolyps))
  {
    presenter.WriteLimitations(only.Presentation());
    only.Run(LastStages(commandLine, ColonoscopySeries::First), last);
  }
  presenter.WriteReport(only.Presentation());
  if (only.Status() != 0)
  {
    ThrowFailure(only.Status(), only.Failure());
  }
}

/** Without the options of both positions. */
ColonoscopyPresentation
PresentationOfSecond(const SeriesRun & second)
{
  ColonoscopyPresentation presentation = second.Presentation();
  LeaveOut(optionsOfPair, presentation.provenance);
  LeaveOut({ "viewer" }, presentation.provenance);
  return presentation;
}

/** The presentation of the first series with what failed in the second one; a run stops at the first failed stage. */
ColonoscopyPresentation
PresentationOfPair(const SeriesRun & first, const SeriesRun & second)
{
  ColonoscopyPresentation presentation = first.Presentation();
  presentation.failure += second.Failure();
  return presentation;
}

/** The report of the first series includes the results of both, so it is written last. */
void
RunTwo(CommandLine & commandLine, SeriesRun & first, SeriesRun & second)
{
  constexpr PartOfProgress ofFirst{ 0.0, 0.4 }, ofSecond{ 0.4, 0.4 }, ofPair{ 0.8, 0.035 };
  constexpr PartOfProgress polypsOfSecond{ 0.87, 0.02 }, polypsOfFirst{ 0.89, 0.02 };
  constexpr PartOfProgress lastOfSecond{ 0.91, 0.01 }, lastOfFirst{ 0.92, 0.01 };
  const auto               withFolds = [&](ColonoscopySeries series) {
    std::vector<ColonoscopyStage> stages = StagesOfSeries(commandLine, series);
    stages.push_back(StageOfFolds(commandLine, series));
    return stages;
  };
  ColonoscopyPresenter presenter(commandLine);
  const bool           hasFirst = first.Run(withFolds(ColonoscopySeries::First), ofFirst);
  if (hasFirst && second.Run(withFolds(ColonoscopySeries::Second), ofSecond) &&
      first.RunBoth(StageOfSearch(commandLine), StageOfRegistration(commandLine), ofPair) &&
      second.Run({ StageOfPolyps(commandLine, ColonoscopySeries::Second) }, polypsOfSecond) &&
      first.Run({ StageOfPolyps(commandLine, ColonoscopySeries::First) }, polypsOfFirst) &&
      second.Run(LastStages(commandLine, ColonoscopySeries::Second), lastOfSecond))
  {
    ColonoscopyPresenter(commandLine).WriteLimitations(PresentationOfSecond(second));
    presenter.WriteLimitations(PresentationOfPair(first, second));
    first.Run(LastStages(commandLine, ColonoscopySeries::First), lastOfFirst);
  }
  if (hasFirst)
  {
    ColonoscopyPresenter(commandLine).WriteReport(PresentationOfSecond(second));
  }
  const ColonoscopyPresentation presentation = PresentationOfPair(first, second);
  presenter.WriteReport(presentation);
  if (!presentation.failure.empty())
  {
    ThrowFailure(std::max(first.Status(), second.Status()), presentation.failure);
  }
}
} // namespace

void
RunColonoscopy(CommandLine & commandLine, const std::string & toolFolder)
{
  const std::string folder = commandLine.GetString("outputFolder");
  const bool        hasSecond = commandLine.IsGiven("second");
  CheckDicomResults(commandLine); // before the stages
  RequireDeviceForCt(commandLine, !commandLine.GetFlag("inputIsLumen"));
  for (const char * const input : { "inputVolume", "second" })
  {
    if (commandLine.IsGiven(input))
    {
      CommandLine::RequireApart(
        commandLine.GetString(input), folder, "use a folder with a DICOM series, a DICOM file or a volume");
    }
  }
  if (!commandLine.GetFlag("dicomResults"))
  {
    commandLine.LeaveOutOfProvenance("dates");
  }
  const SceneFiles sceneFiles = SceneFilesOf(commandLine);
  SeriesRun        first(commandLine, toolFolder, ColonoscopySeries::First);
  commandLine.RecordRun(folder + "/run.json");
  commandLine.Progress("reading", 0.0);
  first.RequireSameInput();
  first.AddInputs();
  if (!hasSecond)
  {
    commandLine.LeaveOutOfProvenance("secondPosition");
    for (const std::string & option : optionsOfPair)
    {
      commandLine.LeaveOutOfProvenance(option);
    }
    RunOne(commandLine, first);
  }
  else
  {
    SeriesRun second(commandLine, toolFolder, ColonoscopySeries::Second);
    second.RequireSameInput();
    second.AddInputs();
    RunTwo(commandLine, first, second);
  }
  sceneFiles.CopyFrom(folder);
}
} // namespace shapeton
