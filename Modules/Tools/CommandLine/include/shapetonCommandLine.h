#ifndef shapetonCommandLine_h
#define shapetonCommandLine_h

#include "ShapetonCommandLineExport.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonProvenance.h"
#include "shapetonRemarks.h"

#include "itkProcessObject.h"

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace shapeton
{
/** \class CommandLine
 * \brief The command line of a tool, declared entirely by a 3D Slicer module description (XML).
 *
 * The XML declares flags, positional order, types, defaults, enumerations, constraints, and the text of --help and of
 * Slicer's panel. A tool is one call:
 * \code
 * #include "ToolXML.h" // generated from Tool.xml: ToolXML
 * int main(int argc, char * argv[])
 * {
 *   return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) { ... });
 * }
 * \endcode
 *
 * Arguments: options may be anywhere; `--` ends them. A value follows its option or an equals sign (`--gamma 2`,
 * `--gamma=2`, `-g 2`); a value that begins with two hyphens requires the equals sign. A boolean is a bare flag, or has
 * `=true` or `=false`. Negative numbers are values. Numbers must be finite, with a decimal point in every locale. An
 * unknown option, an empty file name, a wrong number of arguments, or an option given twice without multiple="true" in
 * the XML is a ParameterError.
 *
 * Every tool has --help (-h), --version, --xml, --quiet, --returnparameterfile FILE; for module hosts also --echo,
 * which prints the values, and --processinformationaddress ADDRESS, which has no effect in a separate process. The
 * first of
 * --help, --version and --xml before a `--` is executed even if other arguments are wrong. An option --threads N, if
 * the XML declares it, sets ITK's global number of threads before the body runs; 0 keeps the default.
 *
 * Exit status: 0 success, 1 other failure, 2 wrong usage (ParameterError), 3 unsuitable input (InputError). Only this
 * class sets it. On failure stderr contains one line; on success it is empty. If the message of an exception or a
 * warning contains a parameter in the form `the parameter "p" = 2`, it is printed as the option (`--p 2`). On a
 * terminal, stdout shows a progress bar, warnings, and at the end the names of written pages; otherwise Slicer's
 * progress XML. It shows nothing with --quiet, or if the body reports nothing. Progress never decreases, and reaches 1
 * once, after the body has returned.
 *
 * Outputs are written to temporary names returned by Output() and renamed after the body has returned, so a failed or
 * killed run leaves neither a half-written file nor a damaged old one. Temporary files left after SIGKILL are removed
 * by the next run that writes to the folder. Missing folders are created, and removed after a failure. A symbolic link
 * is kept and its target is replaced. A hard link is separated, so the file's other name keeps the old result. The new
 * file has the permissions of the old one, or the default of the umask. Only regular files that are not inputs of the
 * run are replaced: a folder, a device, a pipe, a write-protected file or a name in the folder of an input volume is
 * rejected before the work starts.
 *
 * \ingroup ShapetonCommandLine
 */
class ShapetonCommandLine_EXPORT CommandLine
{
public:
  using Body = std::function<void(CommandLine &)>;

  /** Parses the arguments, runs `body`, commits the outputs and reports. Returns the exit status. `xml` must outlive
   * the call. Handlers of termination signals remove temporary files first; signals that are ignored
   * (nohup) or already handled are not changed. */
  static int
  Run(const char * xml, int argc, const char * const argv[], const Body & body);

  CommandLine(const CommandLine &) = delete;
  CommandLine &
  operator=(const CommandLine &) = delete;

  /** \name Values by the `name` of the parameter in the XML; the default from the XML if no value was given. Numbers,
   * enumerations and constraints have been checked. Throws std::logic_error for a name that is not in the XML. Reading
   * a number with neither a value nor a default throws ParameterError; a vector is then empty. */
  ///@{
  /** True if the parameter differs from its default; 3D Slicer passes the defaults as well. */
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
  /** Values of a repeatable `point`: LPS, mm. */
  std::vector<std::array<double, 3>>
  GetPoints(const std::string & name) const;
  /** The value in the spelling of the provenance (`1e3` and `1000` are the same), for the command line of another tool;
   * "" if there is neither a value nor a default, or for a flag that is not set. */
  std::string
  GetCanonical(const std::string & name) const;
  ///@}

  /** True if the XML declares the parameter. */
  bool
  Declares(const std::string & name) const;

  /** Returns an absolute temporary name for the output `path`, in the same folder and with the same extension
   * (".nii.gz" counts as one). The file does not exist yet; the body must write it. Throws OutputError immediately if
   * the final file cannot be written, ParameterError if two outputs have the same name. */
  std::string
  Output(const std::string & path);

  /** Output(GetString(name)); empty if the option was not given. */
  std::string
  OutputOf(const std::string & name);

  /** OutputOf() for the main result, with the record of the run next to it; see RecordRun(). */
  std::string
  MainOutput(const std::string & name);

  /** Renames the file written to Output(path) to its final name while the run continues; Output(path) may then be
   * called again. For files that are watched during the run or needed after a crash, such as previews and checkpoints.
   * Throws OutputError. */
  void
  Publish(const std::string & path);

  /** Allows an output to replace the file of this input parameter, which must have been read already; for example, a
   * resumed run replaces its checkpoint. */
  void
  AllowReplacing(const std::string & name);

  /** Creates a folder for outputs, including parents; throws OutputError, and ParameterError in a DICOM series that is
   * read, which it would spoil. If the run fails, a folder created here is removed again if empty. */
  void
  MakeFolder(const std::string & path);

  /** Returns the folder that a parameter names, after MakeFolder(); empty if the option was not given. */
  std::string
  MakeFolderOf(const std::string & name);

  /** MakeFolder() of the parent of a file or folder that is written without Output(). */
  void
  MakeParentFolder(const std::string & path);

  /** Throws ParameterError if the name of a file in the folder begins with `prefix` but is not in `names`: a later step
   * would take this file of another run for one of this run. */
  static void
  RequireNoOthers(const std::string & folder, const std::string & prefix, const std::set<std::string> & names);

  /** Throws ParameterError if the output of an option is inside a folder that only one other output may use. */
  void
  RequireOutside(const std::string & option, const std::string & folder) const;

  /** Throws ParameterError if a result folder is the input folder or inside it, which would change the input. Throws
   * InputError if the input does not exist; `advice` completes the message. */
  static void
  RequireApart(const std::string & input, const std::string & outputFolder, const std::string & advice);

  /** Replaces parameters in the text with options: `the parameter "p" = 2` becomes `--p 2`. Every option has the name
   * of its parameter. */
  static std::string
  InOptions(const std::string & text);

  /** Reports a warning: stored for reports, and printed on stdout for Slicer or the terminal. */
  void
  Warn(const std::string & message);
  /** Reports each warning. */
  void
  Warn(const Remarks & remarks);
  const Remarks &
  GetWarnings() const;

  /** Maps the progress of a filter to the stage [start, start + fraction] of the run. `filter` must not run after the
   * body returns. */
  void
  Watch(itk::ProcessObject * filter, const std::string & stage, double start = 0.0, double fraction = 1.0);

  /** Reports the progress of other work; `fraction` of the whole run, in [0, 1]. A decreasing fraction is shown as the
   * previous one. May be called from any thread. */
  void
  Progress(const std::string & stage, double fraction);

  /** A progress receiver that maps [0, 1] to the part [begin, end] of the run. */
  shapeton::Progress
  PartOfProgress(double begin, double end);

  /** Sets a value for --returnparameterfile; `name` must be an output parameter of a simple type, else
   * std::logic_error.
   */
  void
  Return(const std::string & name, const std::string & value);

  /** Records the identity of an input: "sha256:..." or "seriesInstanceUID:...". If `name` is a parameter, the
   * provenance contains the identity instead of the value, which may be a path. */
  void
  AddInput(const std::string & name, const std::string & identity);

  /** Provenance of a result: tool, version, inputs, repairs, and the options that affect it. Options include defaults
   * and have a canonical spelling (`1e3` and `1000` are the same); booleans are listed only if true. Threads, device,
   * paths, dates, host and durations are excluded, so identical runs yield identical bytes. */
  Provenance
  GetProvenance() const;

  /** Writes a JSON document: provenance, warnings and the entries of `content`. Throws OutputError. */
  void
  WriteDocument(const Json & content, const std::string & path) const;

  /** Adds a fact to the provenance, for example a repair of the input. */
  void
  AddProvenance(const std::string & key, const std::string & value);

  /** Excludes an option that does not affect results, such as `threads`, from the provenance. */
  void
  LeaveOutOfProvenance(const std::string & name);

  /** Adds a key to the files of RecordRun(), for facts that may differ between identical runs, such as the device. */
  void
  AddRunFact(const std::string & key, const std::string & value);

  /** Requests a JSON file at `path` that records the run, including all data that may differ between identical runs.
   * Its keys are tool, version, arguments, host, threads, start (UTC), seconds, stages (seconds of each progress
   * stage), warnings and the keys of AddRunFact(). Usually `<output>.run.json`. */
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
