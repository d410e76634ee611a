#ifndef shapetonCommandLine_h
#define shapetonCommandLine_h

#include "CommandLineExport.h"
#include "shapetonProgress.h"
#include "shapetonProvenance.h"
#include "shapetonRemarks.h"

#include "itkProcessObject.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** \class CommandLine
 * \brief The command line of a tool, declared by a 3D Slicer module description (XML) and by nothing else.
 *
 * The XML gives flags, positional order, types, defaults, enumerations, constraints, the text of --help, and what
 * Slicer shows. A tool is one call:
 * \code
 * #include "ToolXML.h" // generated from Tool.xml: ToolXML
 * int main(int argc, char * argv[])
 * {
 *   return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) { ... });
 * }
 * \endcode
 *
 * Arguments: options may stand anywhere; `--` ends them. A value follows its option or an equals sign (`--gamma 2`,
 * `--gamma=2`, `-g 2`); one that begins with two hyphens needs the latter. A boolean is a bare flag, or has `=true` or
 * `=false`. Negative numbers are values. Numbers are finite, with a full stop in every locale. Of a repeated option the
 * last counts, unless the XML says multiple="true". An unknown option, an empty file name, an argument too many or too
 * few is a ParameterError.
 *
 * Built in for every tool: --help (-h), --version, --xml, --quiet, --returnparameterfile FILE. The first of --help,
 * --version and --xml before a `--` is answered, whatever else is wrong. An option --threads N, when the XML declares
 * it, sets ITK's global number of threads before the body runs; 0 leaves it as it is.
 *
 * Exit status: 0 done, 2 wrong usage, 3 unsuitable input, 1 everything else. Of exceptions, ParameterError is
 * wrong usage, InputError unsuitable input; this class alone decides it. On failure stderr holds one line, on success
 * nothing. Where the message of an exception or a warning names a parameter as Exception says (`the parameter "p" =
 * 2`), it is told as the option (`--p 2`). stdout holds a progress bar on a terminal, Slicer's progress XML otherwise;
 * nothing with --quiet, or when the body reports neither progress nor warnings. Progress never goes back, and reaches 1
 * once: when the body has returned.
 *
 * Outputs are written to temporary names that Output() hands out and renamed after the body has returned: a failed or
 * killed run leaves neither a half-written file nor a damaged old one. What SIGKILL leaves is removed by the next run
 * that writes to the folder. A symbolic link stays and the file it names is replaced; a hard link is separated, so the
 * old result stays under its other name. The new file has the permissions of the old one, or those of the umask. Only
 * regular files are replaced, and no input of the run: a folder, a device, a pipe or a write-protected file is refused
 * before the work.
 *
 * \ingroup CommandLine
 */
class CommandLine_EXPORT CommandLine
{
public:
  using Body = std::function<void(CommandLine &)>;

  /** Parses, runs `body`, commits the outputs, reports. Returns the exit status of the tool. `xml` outlives the call.
   * The signals that end a program are handled so that they remove the temporary files first; those that are ignored
   * (nohup) or handled already stay as they are. */
  static int
  Run(const char * xml, int argc, const char * const argv[], const Body & body);

  CommandLine(const CommandLine &) = delete;
  CommandLine &
  operator=(const CommandLine &) = delete;

  /** \name Values, by the `name` of the parameter in the XML; the default of the XML where none was given.
   * Numbers, enumerations and constraints have been checked; a name the XML lacks throws std::logic_error. A number
   * that has neither a value nor a default throws ParameterError when it is asked for; a vector is empty then. */
  ///@{
  /** True when the parameter has a value other than its default: 3D Slicer passes the defaults as well. */
  bool
  IsGiven(const std::string & name) const;
  std::string
  GetString(const std::string & name) const;
  double
  GetDouble(const std::string & name) const;
  int
  GetInteger(const std::string & name) const;
  bool
  GetFlag(const std::string & name) const;
  std::vector<double>
  GetDoubles(const std::string & name) const;
  std::vector<int>
  GetIntegers(const std::string & name) const;
  std::vector<std::string>
  GetStrings(const std::string & name) const;
  /** Of a `point` that may be given several times: LPS, mm. */
  std::vector<std::array<double, 3>>
  GetPoints(const std::string & name) const;
  ///@}

  /** True when the XML declares the parameter. */
  bool
  Declares(const std::string & name) const;

  /** The absolute name to write an output to, in place of the final `path`; it has the same folder and the same
   * extension (".nii.gz" is one). Nothing lies there yet, and the body has to write it. Throws OutputError at once when
   * the final file cannot be written, ParameterError when two outputs have one name. */
  std::string
  Output(const std::string & path);

  /** Output(GetString(name)); empty when the option was not given. */
  std::string
  OutputOf(const std::string & name);

  /** Gives the file that was written to Output(path) its final name now, while the run goes on; after that
   * Output(path) may be asked for again. For what is watched meanwhile or needed after a crash, such as previews and
   * checkpoints. Throws OutputError. */
  void
  Publish(const std::string & path);

  /** Lets an output replace the file of this input parameter, which has been read: a checkpoint that a run goes on from
   * and replaces. */
  void
  AllowReplacing(const std::string & name);

  /** Makes a folder for outputs, parents included; throws OutputError. A folder made by a run that fails is removed
   * again when it is empty. */
  void
  MakeFolder(const std::string & path);

  /** Throws ParameterError where a folder for results is the input folder or lies in it: they would change what the
   * input holds. Throws InputError where the input is not there; `advice` says what to give. */
  static void
  RequireApart(const std::string & input, const std::string & outputFolder, const std::string & advice);

  /** The text with options in place of parameters: `the parameter "p" = 2` becomes `--p 2`. Every option has the name
   * of its parameter. */
  static std::string
  InOptions(const std::string & text);

  /** A remark on the result that is no failure: kept for the report and told on stdout, to Slicer or on the terminal.
   */
  void
  Warn(const std::string & message);
  /** Each of them. */
  void
  Warn(const Remarks & remarks);
  const Remarks &
  GetWarnings() const;

  /** Reports the progress of a filter as the stage [start, start + fraction] of the run. `filter` must not run after
   * the body. */
  void
  Watch(itk::ProcessObject * filter, const std::string & stage, double start = 0.0, double fraction = 1.0);

  /** Reports the progress of other work; `fraction` of the whole run, in [0, 1]. Progress that goes back is shown as
   * standing still. May be called from any thread. */
  void
  Progress(const std::string & stage, double fraction);

  /** A receiver whose whole is the part [begin, end] of the run. */
  shapeton::Progress
  PartOfProgress(double begin, double end);

  /** A value for --returnparameterfile; `name` must be an output parameter of a simple type, else std::logic_error. */
  void
  Return(const std::string & name, const std::string & value);

  /** States where an input comes from: `identity` is "sha256:..." or "seriesInstanceUID:...". When `name` is a
   * parameter, its identity stands in the provenance in place of its value, which may be a path. */
  void
  AddInput(const std::string & name, const std::string & identity);

  /** What a result says of its making: tool, version, inputs, repairs, the options that change it.
   * Options stand there with their defaults and in one spelling (`1e3` and `1000` are the same), booleans only when
   * true. Never threads, device, paths, dates, host or durations, so that equal runs give equal bytes. */
  Provenance
  GetProvenance() const;

  /** Adds a fact to the provenance, for example the repair that was made to the input. */
  void
  AddProvenance(const std::string & key, const std::string & value);

  /** Leaves an option out of the provenance, as `threads` is: it changes no result. */
  void
  LeaveOutOfProvenance(const std::string & name);

  /** Adds a key to the files of RecordRun(), for what need not be the same in equal runs, such as the device. */
  void
  AddRunFact(const std::string & key, const std::string & value);

  /** Asks for a JSON file at `path` that says how the run went: all that equal runs need not share. Its keys are tool,
   * version, arguments, host, threads, start (UTC), seconds, stages (seconds of each stage of the progress),
   * warnings and what AddRunFact() adds. By custom `<output>.run.json`. */
  void
  RecordRun(const std::string & path);

private:
  struct State;
  explicit CommandLine(const char * xml);
  ~CommandLine();

  std::unique_ptr<State> m_State;
};
} // namespace shapeton

#endif
