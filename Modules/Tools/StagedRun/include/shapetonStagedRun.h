#ifndef shapetonStagedRun_h
#define shapetonStagedRun_h

#include "StagedRunExport.h"

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonStage.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** How a stage ended. \ingroup StagedRun */
struct StagedRun_EXPORT StageResult
{
  std::string name;
  std::string program;
  std::string version;
  /** The exit status of the tool; 0 done. Of a tool that a signal ended, 1. */
  int status{ 0 };
  /** Of a tool that failed: what it said. */
  std::string message;
  /** Remarks of the tool; those of the first time where it was not run again. */
  Remarks warnings;
  /** Names in the stage's folder and SHA-256, in alphabetical order; records of single runs (*.run.json) are left out,
   * for they differ from run to run. */
  std::vector<std::pair<std::string, std::string>> files;
  /** What was computed before still holds. */
  bool isResumed{ false };

  bool
  Has(const std::string & file) const;
};

/** \class StagedRun
 * \brief Runs tools one after another in one folder, and only those whose result is not there yet.
 *
 * A stage is done when its record in FOLDER/stages says so: the record holds the signature of the stage (program,
 * version, options, identities of its inputs) and the SHA-256 of each file that the tool wrote. Where the signature is
 * the same and all files are unchanged, the tool is not run again.
 *
 * The tool writes to a hidden folder whose files are renamed into FOLDER/NAME when it is done; then the record is
 * written. So a run that is killed at any time, even by SIGKILL, is taken up by the next one and ends with the same
 * files, and a stage that fails leaves the older result as it was, or, where the tool itself keeps partial results,
 * these. Of FOLDER/NAME only files that this class has put there are ever removed.
 *
 * The tool runs as a child process that dies with this one: it gets SIGTERM. Two runs in one folder at a time are
 * refused, also while a child of a killed run is still dying.
 *
 * \ingroup StagedRun */
class StagedRun_EXPORT StagedRun
{
public:
  /** `folder` is there; the programs lie in `toolFolder`. Throws OutputError where the folder cannot be written to, or
   * another run is at work in it. */
  StagedRun(const std::string & folder, const std::string & toolFolder);
  ~StagedRun();
  StagedRun(const StagedRun &) = delete;
  StagedRun &
  operator=(const StagedRun &) = delete;

  /** Progress names the step of the tool and the share of the stage. A tool that fails, or is missing, is no exception
   * here: see StageResult::status. Throws OutputError where the folder cannot be written to, InputError for an input
   * that cannot be read. Two threads may run two stages, neither of which takes a result of the other. */
  StageResult
  Run(const Stage & stage, const Progress & progress = {});

  /** IdentityOf(), which a run asks once for each path, or once for each of two threads that ask at a time. */
  std::string
  Identify(const std::string & path);

  /** Where a file of a stage lies. */
  std::string
  PathOf(const std::string & stage, const std::string & file) const;

private:
  std::string
  SignatureOf(const Stage & stage, const std::string & version);
  std::string
  IdentityOfInput(const Stage::Argument & argument);
  std::vector<std::pair<std::string, std::string>>
  ResultsReadBy(const Stage & stage);
  std::string
  VersionOf(const std::string & program);
  bool
  IsUnchanged(const StageResult & result) const;
  StageResult
  Compute(const Stage & stage, const std::string & scratch, const Progress & progress) const;

  class Lock;
  std::unique_ptr<Lock>              m_Lock;
  std::string                        m_Folder;
  std::string                        m_ToolFolder;
  std::mutex                         m_Mutex;      ///< of m_Identities
  std::map<std::string, std::string> m_Identities; ///< of the files of stages, so that each is read once
};

/** The folder of the running program. \ingroup StagedRun */
StagedRun_EXPORT std::string
                 FolderOfThisProgram();
} // namespace shapeton

#endif
