#include "shapetonCommandLine.h"
#include "shapetonArguments.h"
#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonModuleDescription.h"
#include "shapetonModuleHelp.h"
#include "shapetonOutputFiles.h"
#include "shapetonParallelFor.h"
#include "shapetonParameterValue.h"
#include "shapetonPrintable.h"
#include "shapetonProgressDisplay.h"
#include "shapetonReadOptions.h"
#include "shapetonThreadOptions.h"
#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"

#include "itkCommand.h"
#include "itkProcessObject.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <set>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

void
FlushStdout()
{
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) || !std::cout)
  {
    throw OutputError("cannot write to the standard output; free some space or redirect it");
  }
}

/** An absolute path without "..", also of what does not exist yet. */
std::filesystem::path
Resolved(const std::string & path)
{
  std::error_code             error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(absolute, error);
  return error ? std::filesystem::path(path) : resolved; // reported when it is opened
}

bool
IsInside(const std::string & path, const std::string & folder)
{
  const std::filesystem::path relative = Resolved(path).lexically_relative(Resolved(folder));
  return !relative.empty() && *relative.begin() != "..";
}

struct Failure
{
  int         status;
  std::string message;
};

int
Report(const std::string & program, const Failure & failure)
{
  std::fprintf(stderr, "%s: %s\n", Printable(program).c_str(), Printable(failure.message).c_str());
  return failure.status;
}

// Call from a catch block.
Failure
DescribeException()
{
  const char * const noMemory = "not enough memory; use a smaller volume or fewer outputs at once";
  const char * const noThread = "not enough memory for another thread; use a smaller volume or fewer --threads";
  try
  {
    throw;
  }
  catch (const ParameterError & error)
  {
    return { 2, CommandLine::InOptions(error.what()) };
  }
  catch (const InputError & error)
  {
    return { 3, CommandLine::InOptions(error.what()) };
  }
  catch (const OutputError & error)
  {
    return { 1, CommandLine::InOptions(error.what()) };
  }
  catch (const std::bad_alloc &)
  {
    return { 1, noMemory };
  }
  catch (const itk::MemoryAllocationError &)
  {
    return { 1, noMemory };
  }
  catch (const std::system_error & error)
  {
    const bool isThread = error.code() == std::errc::resource_unavailable_try_again; // no memory for its stack
    return { 1, isThread ? noThread : error.what() };
  }
  catch (const itk::ExceptionObject & error)
  {
    const std::string description = error.GetDescription();
    const bool isThread = description.find("pthread_create has failed") != std::string::npos; // of ITK's threader
    return { 1, isThread ? noThread : WithoutItkPrefix(description) };
  }
  catch (const std::exception & error)
  {
    return { 1, WithoutItkPrefix(error.what()) };
  }
  catch (...)
  {
    return { 1, "an unknown failure; report this as a bug" };
  }
}

/** ITK would read an invalid number as one thread. */
void
RequireThreadVariable()
{
  constexpr const char * name = "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS";
  const std::string      given = std::getenv(name) ? std::getenv(name) : "1";
  const bool             isNumber = given.find_first_not_of("0123456789") == std::string::npos;
  RequireParameter(isNumber && given.find_first_not_of('0') != std::string::npos,
                   std::string("the environment variable ") + name + " is " + Quoted(given) +
                     ", not a number of threads; set it to 1 or more, or remove it");
}

// ISO 8601, UTC.
std::string
TimeText(std::chrono::system_clock::time_point point)
{
  return UniversalTimeText(std::chrono::system_clock::to_time_t(point), "%Y-%m-%dT%H:%M:%SZ");
}
} // namespace

struct CommandLine::State
{
  const char *                                xml{ nullptr };
  ModuleDescription                           module;
  std::string                                 program;
  std::vector<std::string>                    arguments; // unchanged
  Arguments                                   parsed;
  std::string                                 returnFile; // temporary name
  std::map<std::string, std::string>          returned;
  std::vector<std::string>                    warnings;
  Provenance                                  facts;
  Provenance                                  runFacts;
  std::vector<std::string>                    runRecords; // temporary names
  OutputFiles                                 outputs;
  std::set<std::string>                       replaceable;                 // inputs that an output may replace
  std::set<std::string>                       idle{ "threads", "device" }; // options that do not affect results
  ProgressDisplay                             display;
  const std::chrono::system_clock::time_point start{ std::chrono::system_clock::now() };
  const std::chrono::steady_clock::time_point steadyStart{ std::chrono::steady_clock::now() };

  const Parameter &
  Find(const std::string & name) const
  {
    const auto parameter = std::find_if(
      module.parameters.begin(), module.parameters.end(), [&](const Parameter & p) { return p.name == name; });
    if (parameter == module.parameters.end())
    {
      throw std::logic_error("the module description has no parameter \"" + name + '"');
    }
    return *parameter;
  }

  /** A double may exceed the range of int. */
  void
  CheckInteger(const std::string & name) const
  {
    if (!this->Find(name).IsInteger())
    {
      throw std::logic_error("\"" + name + "\" is not an integer parameter");
    }
  }

  /** Null if the default applies. */
  const std::vector<std::string> *
  FindGiven(const std::string & name) const
  {
    const auto values = parsed.given.find(name);
    return values == parsed.given.end() ? nullptr : &values->second;
  }

  /** An output must not be in the folder of a series that is read, where it could replace a slice. */
  void
  RequireOutsideSeries(const std::string & path) const
  {
    for (const auto & parameter : module.parameters)
    {
      const bool   isRead = parameter.tag == "image" && parameter.channel == "input";
      const auto * values = isRead ? this->FindGiven(parameter.name) : nullptr;
      for (const auto & value : values ? *values : std::vector<std::string>())
      {
        std::error_code error;
        if (std::filesystem::is_directory(value, error))
        {
          RequireApart(value, path, "");
        }
      }
    }
  }

  /** An output must not replace an input of the same run. */
  void
  RequireNoInput(const std::string & path) const
  {
    this->RequireOutsideSeries(path);
    for (const auto & parameter : module.parameters)
    {
      const auto * values = parameter.channel == "input" && parameter.IsPath() && replaceable.count(parameter.name) == 0
                              ? this->FindGiven(parameter.name)
                              : nullptr;
      for (const auto & value : values ? *values : std::vector<std::string>())
      {
        std::error_code error;
        if (std::filesystem::equivalent(value, path, error) ||
            std::filesystem::equivalent(value, Resolved(path), error)) // through a folder that is made later
        {
          throw ParameterError("the output " + Quoted(path) + " is an input of this run; use another name");
        }
      }
    }
  }

  /** Inputs are recorded by identity; output locations and devices do not affect the result. */
  bool
  IsInProvenance(const Parameter & parameter) const
  {
    const bool isStated = std::any_of(facts.begin(), facts.end(), [&](const auto & fact) {
      return fact.first == "input." + parameter.name || fact.first == "option." + parameter.name;
    });
    return !parameter.IsPath() && parameter.channel != "output" && idle.count(parameter.name) == 0 && !isStated;
  }

  std::string
  ProvenanceOf(const Parameter & parameter) const
  {
    const auto * values = this->FindGiven(parameter.name);
    if (!values)
    {
      return parameter.defaultValue.empty() ? "" : CanonicalValue(parameter, parameter.defaultValue);
    }
    std::string text;
    for (const auto & value : *values)
    {
      text += (text.empty() ? "" : ",") + CanonicalValue(parameter, value);
    }
    return text;
  }

  void
  Answer(const std::string & question) const
  {
    const std::string answer = question == "--xml"       ? xml
                               : question == "--version" ? module.version + '\n'
                                                         : HelpText(module, program);
    std::fputs(answer.c_str(), stdout);
    FlushStdout();
  }

  void
  Prepare(const CommandLine & commandLine)
  {
    parsed = ParseArguments(module, arguments);
    display.SetMode(parsed.quiet ? ProgressDisplay::Mode::Off : ProgressDisplay::ModeOfStdout());
    if (parsed.echo)
    {
      this->Echo();
    }
    if (!parsed.returnFile.empty())
    {
      this->RequireNoInput(parsed.returnFile);
      returnFile = outputs.Add(parsed.returnFile);
    }
    RequireThreadVariable();
    ThreadOptions options;
    ReadOptions(commandLine, options);
    if (options.threads > 0)
    {
      SetNumberOfThreads(static_cast<unsigned int>(options.threads));
    }
  }

  /** As programs of the Slicer execution model do. */
  void
  Echo() const
  {
    std::string text = "Command Line Arguments\n";
    for (const auto & parameter : module.parameters)
    {
      text += "    " + parameter.name + ": " + Printable(this->ProvenanceOf(parameter)) + '\n';
    }
    std::fputs(text.c_str(), stdout);
  }

  void
  Finish()
  {
    display.Complete();
    display.End();
    FlushStdout();
    for (const auto & record : runRecords)
    {
      WriteJson(this->RunRecord(), record);
    }
    if (!returnFile.empty())
    {
      WriteFileBytes(returnFile, this->ReturnText());
    }
    outputs.Commit();
    for (const auto & page : outputs.GetPages())
    {
      display.Print("Page: " + page);
    }
  }

  std::string
  ReturnText() const
  {
    std::string text;
    for (const auto & value : returned)
    {
      text += value.first + " = " + value.second + '\n';
    }
    return text;
  }

  Json
  RunRecord() const
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - steadyStart;
    Json                                record;
    record["tool"] = program;
    record["version"] = module.version;
    record["arguments"] = arguments;
    record["host"] = HostName();
    record["threads"] = NumberOfThreads();
    record["start"] = TimeText(start);
    record["seconds"] = elapsed.count();
    record["stages"] = Json::object();
    for (const auto & [stage, seconds] : display.StageSeconds())
    {
      record["stages"][stage] = seconds;
    }
    record["warnings"] = warnings;
    for (const auto & [key, value] : runFacts)
    {
      record[key] = value;
    }
    return record;
  }
};

CommandLine::CommandLine(const char * xml) : m_State(std::make_unique<State>())
{
  m_State->xml = xml;
  m_State->module = ParseModuleDescription(xml);
}

CommandLine::~CommandLine()
{
  m_State->display.End(); // the error message starts on a new line
}

int
CommandLine::Run(const char * xml, int argc, const char * const argv[], const Body & body)
{
  OpenMissingStandardStreams();
  itk::Object::GlobalWarningDisplayOff(); // ITK's warnings would be printed to stderr of a successful run
  const std::string path = argc > 0 ? argv[0] : "";
  std::string       program = path.substr(path.find_last_of('/') + 1);
  program = program.empty() ? "tool" : program;
  try
  {
    CommandLine commandLine(xml);
    State &     state = *commandLine.m_State;
    state.program = program;
    state.arguments.assign(argv + std::min(argc, 1), argv + argc);
    if (const std::string question = FindQuestion(state.arguments); !question.empty())
    {
      state.Answer(question);
      return 0;
    }
    try
    {
      state.Prepare(commandLine);
      body(commandLine);
      state.Finish();
      return 0;
    }
    catch (...)
    {
      const Failure failure = DescribeException();
      return Report(program, { failure.status, state.outputs.InFinalNames(failure.message) });
    }
  }
  catch (...)
  {
    return Report(program, DescribeException());
  }
}

bool
CommandLine::Declares(const std::string & name) const
{
  const auto & parameters = m_State->module.parameters;
  return std::any_of(parameters.begin(), parameters.end(), [&](const Parameter & p) { return p.name == name; });
}

bool
CommandLine::IsGiven(const std::string & name) const
{
  m_State->Find(name);
  return m_State->FindGiven(name) != nullptr;
}

std::string
CommandLine::GetString(const std::string & name) const
{
  const auto & parameter = m_State->Find(name);
  const auto * values = m_State->FindGiven(name);
  return values ? values->back() : parameter.defaultValue;
}

double
CommandLine::GetDouble(const std::string & name) const
{
  const auto &      parameter = m_State->Find(name);
  const std::string text = this->GetString(name);
  if (text.empty())
  {
    throw ParameterError(parameter.Display() + " is missing; it has no default");
  }
  return ParseNumber(parameter, text);
}

int
CommandLine::GetInteger(const std::string & name) const
{
  m_State->CheckInteger(name);
  return static_cast<int>(this->GetDouble(name));
}

bool
CommandLine::GetFlag(const std::string & name) const
{
  return this->GetString(name) == "true";
}

std::vector<std::string>
CommandLine::GetStrings(const std::string & name) const
{
  const auto * values = m_State->FindGiven(name);
  return m_State->Find(name).multiple && values ? *values : SplitAtCommas(this->GetString(name));
}

std::vector<double>
CommandLine::GetDoubles(const std::string & name) const
{
  std::vector<double> numbers;
  for (const auto & text : this->GetStrings(name))
  {
    numbers.push_back(ParseNumber(m_State->Find(name), text));
  }
  return numbers;
}

std::vector<std::array<double, 3>>
CommandLine::GetPoints(const std::string & name) const
{
  std::vector<std::array<double, 3>> points;
  const Parameter &                  parameter = m_State->Find(name);
  const auto * const                 values = m_State->FindGiven(name);
  for (std::size_t i = 0; values && i < values->size(); ++i)
  {
    const auto numbers = SplitAtCommas((*values)[i]); // three, already validated
    points.push_back(
      { ParseNumber(parameter, numbers[0]), ParseNumber(parameter, numbers[1]), ParseNumber(parameter, numbers[2]) });
  }
  return points;
}

std::vector<int>
CommandLine::GetIntegers(const std::string & name) const
{
  m_State->CheckInteger(name);
  const std::vector<double> numbers = this->GetDoubles(name);
  return std::vector<int>(numbers.begin(), numbers.end());
}

std::string
CommandLine::Output(const std::string & path)
{
  m_State->RequireNoInput(path);
  return m_State->outputs.Add(path);
}

void
CommandLine::LeaveOutOfProvenance(const std::string & name)
{
  m_State->Find(name);
  m_State->idle.insert(name);
}

std::string
CommandLine::GetCanonical(const std::string & name) const
{
  const Parameter & parameter = m_State->Find(name);
  const std::string value = m_State->ProvenanceOf(parameter);
  return parameter.tag != "boolean" || value == "true" ? value : "";
}

void
CommandLine::AllowReplacing(const std::string & name)
{
  m_State->Find(name);
  m_State->replaceable.insert(name);
}

void
CommandLine::Publish(const std::string & path)
{
  m_State->outputs.Publish(path);
}

std::string
CommandLine::OutputOf(const std::string & name)
{
  return this->IsGiven(name) ? this->Output(this->GetString(name)) : std::string();
}

std::string
CommandLine::MainOutput(const std::string & name)
{
  const std::string path = this->OutputOf(name);
  this->RecordRun(this->GetString(name) + ".run.json");
  return path;
}

void
CommandLine::MakeFolder(const std::string & path)
{
  m_State->RequireOutsideSeries(path);
  m_State->outputs.MakeFolder(path);
}

std::string
CommandLine::MakeFolderOf(const std::string & name)
{
  const std::string path = this->GetString(name);
  if (!path.empty())
  {
    this->MakeFolder(path);
  }
  return path;
}

void
CommandLine::MakeParentFolder(const std::string & path)
{
  m_State->RequireOutsideSeries(path);
  m_State->outputs.MakeParentFolder(path);
}

void
CommandLine::RequireNoOthers(const std::string &           folder,
                             const std::string &           prefix,
                             const std::set<std::string> & names)
{
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    RequireParameter(name.compare(0, prefix.size(), prefix) != 0 || names.count(name) > 0,
                     "the folder " + Quoted(folder) + " contains " + name +
                       " of another run; use another folder or remove it");
  }
}

void
CommandLine::RequireOutside(const std::string & option, const std::string & folder) const
{
  RequireParameter(!this->IsGiven(option) || !IsInside(this->GetString(option), folder),
                   "--" + option + " is inside the folder of the series; choose a place outside");
}

void
CommandLine::RequireApart(const std::string & input, const std::string & outputFolder, const std::string & advice)
{
  namespace fs = std::filesystem;
  if (!fs::exists(input))
  {
    throw InputError("\"" + input + "\" does not exist; " + advice);
  }
  RequireParameter(!fs::is_directory(input) || !IsInside(outputFolder, input),
                   "an output is inside the input folder; choose a place outside");
}

std::string
CommandLine::InOptions(const std::string & message)
{
  return SpellParameters(message,
                         [](const std::string & name, bool hasValue) { return "--" + name + (hasValue ? " " : ""); });
}

void
CommandLine::Warn(const std::string & message)
{
  m_State->warnings.push_back(InOptions(message));
  m_State->display.Comment(m_State->warnings.back());
}

void
CommandLine::Warn(const Remarks & remarks)
{
  for (const std::string & remark : remarks)
  {
    this->Warn(remark);
  }
}

const Remarks &
CommandLine::GetWarnings() const
{
  return m_State->warnings;
}

void
CommandLine::Watch(itk::ProcessObject * filter, const std::string & stage, double start, double fraction)
{
  auto & display = m_State->display;
  filter->AddObserver(itk::ProgressEvent(), [=, &display](const itk::EventObject &) {
    const double progress = std::min(1.0, static_cast<double>(filter->GetProgress()));
    display.Update(stage, progress, start + fraction * progress);
  });
}

void
CommandLine::Progress(const std::string & stage, double fraction)
{
  m_State->display.Update(stage, fraction, fraction);
}

Progress
CommandLine::PartOfProgress(double begin, double end)
{
  return [this, begin, end](const std::string & stage, double share) {
    this->Progress(stage, begin + share * (end - begin));
  };
}

void
CommandLine::Return(const std::string & name, const std::string & value)
{
  const auto & parameter = m_State->Find(name);
  if (parameter.channel != "output" || parameter.IsPath())
  {
    throw std::logic_error("\"" + name + "\" is not an output parameter of a simple type");
  }
  m_State->returned[name] = Printable(value);
}

void
CommandLine::AddInput(const std::string & name, const std::string & identity)
{
  this->AddProvenance("input." + name, identity);
}

void
CommandLine::AddProvenance(const std::string & key, const std::string & value)
{
  m_State->facts.emplace_back(key, value);
}

Provenance
CommandLine::GetProvenance() const
{
  Provenance provenance = { { "tool", m_State->program }, { "version", m_State->module.version } };
  provenance.insert(provenance.end(), m_State->facts.begin(), m_State->facts.end());
  for (const auto & parameter : m_State->module.parameters)
  {
    const std::string value = m_State->IsInProvenance(parameter) ? this->GetCanonical(parameter.name) : "";
    if (!value.empty())
    {
      provenance.emplace_back("option." + parameter.name, value);
    }
  }
  return provenance;
}

void
CommandLine::WriteDocument(const Json & content, const std::string & path) const
{
  Json document;
  document["provenance"] = ProvenanceToJson(this->GetProvenance());
  document["warnings"] = this->GetWarnings();
  document.update(content);
  WriteJson(document, path);
}

void
CommandLine::AddRunFact(const std::string & key, const std::string & value)
{
  m_State->runFacts.emplace_back(key, value);
}

void
CommandLine::RecordRun(const std::string & path)
{
  m_State->runRecords.push_back(this->Output(path));
}
} // namespace shapeton
