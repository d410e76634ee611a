#ifndef shapetonStagedRun_h
#define shapetonStagedRun_h

#include "ShapetonColonToolsExport.h"

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonStage.h"
#include "shapetonStageRecord.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** \class StagedRun
 * \brief Runs tools one after another in one folder, skipping those with up-to-date results.
 *
 * A stage is complete if it has a record in FOLDER/stages. The record stores the signature of the stage (program,
 * version, options, identities of its inputs) and the SHA-256 of each file that the tool wrote. If the signature and
 * all files are unchanged, the tool is not run again.
 *
 * The tool writes to a hidden folder whose files are renamed into FOLDER/NAME on success; then the record is written.
 * Thus a run killed at any time, even by SIGKILL, can be resumed and ends with the same files. A failed stage keeps
 * the older result, or the partial results that the tool itself saved. Only files that this class put into FOLDER/NAME
 * are ever removed.
 *
 * The tool runs as a child process that receives SIGTERM when this process dies. A second run in the same folder is
 * rejected, even while a child of a killed run is still exiting.
 *
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT StagedRun
{
public:
  /** `folder` must exist; `toolFolder` contains the programs. Throws OutputError if the folder cannot be written to or
   * another run is using it. */
  StagedRun(const std::string & folder, const std::string & toolFolder);
  ~StagedRun();
  StagedRun(const StagedRun &) = delete;
  StagedRun &
  operator=(const StagedRun &) = delete;

  /** Runs a stage; progress shows the step of the tool and the fraction of the stage. A tool that fails or is missing
   * does not throw: see StageResult::status. Throws OutputError if the folder cannot be written to, InputError for an
   * input that cannot be read. Two threads may run two stages if neither uses a result of the other. */
  StageResult
  Run(const Stage & stage, const Progress & progress = {});

  /** IdentityOf(), cached per path; two threads that request the same path at the same time may both compute it. */
  std::string
  Identify(const std::string & path);

  /** Path of a file of a stage. */
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
  std::mutex                         m_Mutex;      ///< guards m_Identities
  std::map<std::string, std::string> m_Identities; ///< cache, to read each file once
};

/** The folder of the running program. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::string
                          FolderOfThisProgram();
} // namespace shapeton

#endif
