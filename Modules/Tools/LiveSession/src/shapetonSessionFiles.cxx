#include "shapetonSessionFiles.h"

#include "ToolXMLs.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonHeatResultFiles.h"
#include "shapetonLabelFiles.h"
#include "shapetonParticleResultFiles.h"
#include "shapetonOperatingSystem.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonShapeAnalysis.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

/** A word of a shell command. */
std::string
InQuotes(const std::string & text)
{
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

void
Append(std::vector<std::string> & words, const std::vector<std::string> & more)
{
  words.insert(words.end(), more.begin(), more.end());
}

/** The options that heat and shapetons share. */
std::vector<std::string>
CommonArguments(const ParticleDiffusionOptions & options, std::uint64_t timeStep)
{
  std::vector<std::string> arguments{ "--preset",    "published",
                                      "--p",         CsvTable::Number(options.p),
                                      "--smoothing", CsvTable::Number(options.smoothing),
                                      "--timeSteps", std::to_string(timeStep) };
  if (options.intensityWindow)
  {
    const auto & [lower, upper] = *options.intensityWindow;
    arguments.push_back("--intensityWindow=" + CsvTable::Number(lower) + "," + CsvTable::Number(upper));
  }
  return arguments;
}

std::vector<std::string>
WalkArguments(const ParticleDiffusionOptions & options, std::uint64_t timeStep)
{
  auto arguments = CommonArguments(options, timeStep);
  Append(arguments,
         { "--shapetons",
           std::to_string(options.shapetons),
           "--distance",
           CsvTable::Number(options.distance),
           "--directionSampling",
           NameOf(options.directionSampling),
           "--pathRule",
           NameOf(options.pathRule),
           "--placement",
           NameOf(options.placement),
           "--seed",
           std::to_string(options.seed) });
  return arguments;
}

/** The flag of an option of another tool. */
std::string
Flag(const std::string & name)
{
  return "--" + name;
}

std::string
VolumeNameOf(const SavedResult & result)
{
  return result.name + (result.isHeat ? "-heat.nrrd" : "-density.nrrd");
}

std::string
LabelsNameOf(const SavedResult & result)
{
  return result.name + "-labels.nrrd";
}

std::vector<std::string>
VolumeNamesOf(const SavedResult & result)
{
  std::vector<std::string> names{ VolumeNameOf(result) };
  if (result.wantLabels)
  {
    names.push_back(LabelsNameOf(result));
  }
  return names;
}
} // namespace

SessionFiles::SessionFiles(const Volume & volume, const LiveSessionSettings & settings)
  : m_Volume(volume)
  , m_Input(fs::absolute(settings.input).lexically_normal().string())
  , m_ReadingArguments(settings.readingArguments)
  , m_Folder(settings.folder)
{}

void
SessionFiles::Note(const std::string & change)
{
  m_Lines.push_back("# " + change);
}

/** The tool's own command line yields the same provenance, temporary names and record of the run. */
void
SessionFiles::RunTool(const char * xml, const std::string & tool, const Arguments & arguments, const Body & body) const
{
  std::vector<const char *> words{ tool.c_str() };
  std::transform(arguments.begin(), arguments.end(), std::back_inserter(words), [](const std::string & word) {
    return word.c_str();
  });
  words.push_back("--quiet");
  std::exception_ptr failure;
  const int          status =
    CommandLine::Run(xml, static_cast<int>(words.size()), words.data(), [&](CommandLine & commandLine) {
      try
      {
        body(commandLine);
      }
      catch (...)
      {
        failure = std::current_exception();
        throw;
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  if (status != 0)
  {
    throw OutputError("the files of " + tool + " cannot be written to the session's folder; see its standard error");
  }
}

void
SessionFiles::AddInput(CommandLine & commandLine) const
{
  commandLine.AddInput("inputVolume", m_Volume.identity);
  for (const std::string & repair : m_Volume.repairs)
  {
    commandLine.AddProvenance("repair", repair);
  }
}

void
SessionFiles::NoteCommand(const std::string &              tool,
                          const std::vector<std::string> & inResults,
                          const Arguments &                arguments)
{
  std::string line = tool + " \"$input\"";
  for (const std::string & name : inResults)
  {
    line += " " + (name.rfind("--", 0) == 0 ? name : "\"$results\"/" + InQuotes(name));
  }
  for (const std::string & argument : arguments)
  {
    line += " " + (argument.rfind("--", 0) == 0 ? argument : InQuotes(argument));
  }
  m_Lines.push_back(line);
}

void
SessionFiles::AddMask(const std::string & option, const std::string & file, Arguments & arguments) const
{
  if (!file.empty())
  {
    arguments.insert(arguments.end(), { Flag(option), m_Folder.PathOf(file).string() });
  }
}

void
SessionFiles::NoteMask(const std::string & option, const std::string & file)
{
  if (!file.empty())
  {
    m_Lines.back() += " " + Flag(option) + " \"$session\"/" + InQuotes(file);
  }
}

std::vector<std::string>
SessionFiles::Save(const SavedResult & result, const ParticleDiffusionOptions & options, const VisitsType * visits)
{
  const auto shape = AnalyzeVisits(visits, result.timeStep, result.wantLabels);
  auto       inResults = VolumeNamesOf(result);
  auto       arguments = WalkArguments(options, result.timeStep);
  Arguments  all{ m_Input, m_Folder.PathOf(inResults[0]).string() };
  if (result.wantLabels)
  {
    inResults.insert(inResults.begin() + 1, Flag("labels"));
    all.insert(all.end(), { Flag("labels"), m_Folder.PathOf(LabelsNameOf(result)).string() });
  }
  this->AddMask("mask", result.mask, all);
  Append(arguments, m_ReadingArguments);
  Append(all, arguments);
  this->RunTool(ShapetonDiffusionXML, "ShapetonDiffusion", all, [&](CommandLine & commandLine) {
    const ParticleResultFiles files(commandLine);
    commandLine.LeaveOutOfProvenance("previewEvery"); // as ParticleMonitor does
    this->AddInput(commandLine);
    if (!result.mask.empty())
    {
      ReadMask(commandLine, "mask", m_Volume.image); // for its identity
    }
    files.WriteDensity(visits, result.timeStep);
    files.WriteLabels(shape);
  });
  this->NoteCommand("ShapetonDiffusion", inResults, arguments);
  this->NoteMask("mask", result.mask);
  auto names = VolumeNamesOf(result);
  Append(names, this->WriteLines(result, shape.quantity.greatestVisits));
  return names;
}

std::vector<std::string>
SessionFiles::Save(const SavedResult & result, const ParticleDiffusionOptions & options, const HeatType * heat)
{
  auto      inResults = VolumeNamesOf(result);
  auto      arguments = CommonArguments(options, result.timeStep);
  Arguments all{ m_Input, m_Folder.PathOf(inResults[0]).string() };
  if (result.wantLabels)
  {
    inResults.insert(inResults.begin() + 1, Flag("labels"));
    all.insert(all.end(), { Flag("labels"), m_Folder.PathOf(LabelsNameOf(result)).string() });
  }
  this->AddMask("barrier", result.barrier, all);
  Append(arguments, m_ReadingArguments);
  Append(all, arguments);
  this->RunTool(CumulativeHeatDiffusionXML, "CumulativeHeatDiffusion", all, [&](CommandLine & commandLine) {
    const HeatResultFiles files(commandLine);
    this->AddInput(commandLine);
    ReadDomain(commandLine, m_Volume.image); // for the identity of the barrier
    HeatReportContent content;
    content.heat = heat;
    content.timeStep = result.timeStep;
    const auto shape = result.wantLabels ? AnalyzeHeat(heat, result.timeStep) : ShapeAnalysis();
    content.classes = shape.classes;
    files.Write(content, shape.labels);
  });
  this->NoteCommand("CumulativeHeatDiffusion", inResults, arguments);
  this->NoteMask("barrier", result.barrier);
  auto names = VolumeNamesOf(result);
  if (result.objects)
  {
    Append(names, this->WriteObjects(result, *result.objects, {}));
  }
  if (!result.selection.empty())
  {
    Append(names, this->WriteObjects(result, *result.offered, result.selection));
  }
  Append(names, this->WriteLines(result, 1.0));
  return names;
}

std::vector<std::string>
SessionFiles::WriteObjects(const SavedResult & result, const HeatObjectList & list, const std::vector<int> & selection)
{
  const bool        isAll = selection.empty();
  const std::string heat = VolumeNameOf(result);
  const std::string name = result.name + (isAll ? "-objects" : "-object");
  const std::string labels = name + ".nrrd";
  const std::string table = name + ".csv";
  auto              arguments = m_ReadingArguments;
  std::vector<int>  numbers = selection;
  if (isAll)
  {
    numbers.resize(list.objects.size());
    std::iota(numbers.begin(), numbers.end(), 1);
  }
  else
  {
    std::string text;
    for (const int number : numbers)
    {
      text += (text.empty() ? "" : ",") + std::to_string(number);
    }
    Append(arguments, { Flag("objects"), text });
  }
  Arguments all{ m_Input };
  for (const std::string & file : { heat, labels, table })
  {
    all.push_back(m_Folder.PathOf(file).string());
  }
  this->AddMask("barrier", result.barrier, all);
  Append(all, arguments);
  this->RunTool(HeatObjectsXML, "HeatObjects", all, [&](CommandLine & commandLine) {
    const SegmentFiles files(commandLine, "labels");
    const std::string  tableFile = commandLine.OutputOf("table");
    this->AddInput(commandLine);
    commandLine.AddInput("heatVolume", ReadVolume(commandLine.GetString("heatVolume")).identity);
    ReadDomain(commandLine, m_Volume.image); // for the identity of the barrier
    HeatObjectTable(list, numbers, m_Volume.image).Write(tableFile);
    const auto image = isAll ? list.labels : LabelsOfObjects(list, numbers);
    files.WriteObjects(image, numbers);
  });
  this->NoteCommand("HeatObjects", { heat, labels, table }, arguments);
  this->NoteMask("barrier", result.barrier);
  return { labels, table };
}

std::vector<std::string>
SessionFiles::WriteLines(const SavedResult & result, double unit)
{
  if (!result.lines)
  {
    return {};
  }
  const std::string json = result.name + ".json";
  const std::string property = result.name + ".vp";
  const std::string jsonFile = m_Folder.PathOf(json).string();
  WriteTransferFunction({ result.isHeat ? "heat" : "density", result.timeStep, *result.lines }, jsonFile);
  result.lines->WriteVolumeProperty(m_Folder.PathOf(property).string(), unit);
  const std::string bytes = ReadFileBytes(jsonFile);
  m_Lines.push_back("cat > \"$results\"/" + InQuotes(json) + " << 'END'\n" + bytes + "END");
  this->NoteCommand("HeatTransferFunction", { VolumeNameOf(result), property, Flag("from"), json }, {});
  return { json, property };
}

SessionFiles::HeatType::Pointer
SessionFiles::AsWritten(const HeatType * heat) const
{
  auto written = HeatType::New();
  written->Graft(heat);
  auto voxel = HeatType::New(); // has the axes, spacing and origin of the heat
  voxel->CopyInformation(heat);
  voxel->SetRegions(HeatType::SizeType{ { 1, 1, 1 } });
  voxel->Allocate(true);
  const std::string path = (m_Folder.GetPath() / (".grid-" + std::to_string(ProcessNumber()) + ".nrrd")).string();
  try
  {
    WriteVolume(voxel.GetPointer(), path);
    VolumeReadOptions reading;
    reading.allowSingleSlice = true;
    const Volume volume = ReadVolume(path, reading);
    written->SetSpacing(volume.image->GetSpacing());
    written->SetOrigin(volume.image->GetOrigin());
    written->SetDirection(volume.image->GetDirection());
  }
  catch (const Exception &)
  {} // nothing can be saved in this folder
  std::error_code ignored;
  fs::remove(path, ignored);
  return written;
}

std::string
SessionFiles::SaveMask(const StartMask * mask, const std::string & name)
{
  std::string file;
  do
  {
    file = name + "-" + std::to_string(++m_Masks) + ".nrrd";
  } while (fs::exists(m_Folder.PathOf(file))); // masks of earlier sessions are needed by their scripts
  WriteVolume(mask, m_Folder.PathOf(file).string());
  return file;
}

std::string
SessionFiles::GetScript() const
{
  std::string text = "#!/bin/sh\n"
                     "# Repeats a session of ShapetonSession: writes the files that it saved, with the same bytes.\n"
                     "# usage: sh SCRIPT [FOLDER for the results; default: that of the session]\n"
                     "set -eu\n";
  text += "input=" + InQuotes(m_Input) + "\n";
  text += "session=" + InQuotes(m_Folder.GetPath().string()) + "\n";
  text += "results=${1:-$session}\n\n";
  for (const std::string & line : m_Lines)
  {
    text += line + "\n";
  }
  return text;
}

void
SessionFiles::SaveScript(const std::string & name) const
{
  WriteFileBytes(m_Folder.PathOf(name).string(), this->GetScript());
}
} // namespace shapeton
