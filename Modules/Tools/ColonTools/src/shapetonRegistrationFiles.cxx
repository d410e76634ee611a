#include "shapetonRegistrationFiles.h"

#include "shapetonCommandLine.h"
#include "shapetonExaminationFiles.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonSurfaceWriter.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Rejects the folder of an examination or of one of its stages, where file names would collide. */
void
RequireOwnFolder(const std::string & folder, const std::string & examination)
{
  const fs::path own = fs::weakly_canonical(fs::path(folder) / ".");
  const fs::path whole = fs::weakly_canonical(fs::path(examination) / ".");
  bool           isTaken = own == whole;
  for (const char * stage : { colonoscopystage::inspection,
                              colonoscopystage::segmentation,
                              colonoscopystage::flattening,
                              colonoscopystage::landmarks,
                              colonoscopystage::folds,
                              "slicer",
                              "stages" })
  {
    const fs::path relative = own.lexically_relative(whole / stage);
    isTaken = isTaken || own == whole / stage || (!relative.empty() && *relative.begin() != "..");
  }
  RequireParameter(!isTaken,
                   "the output folder \"" + folder + "\" is the folder of the examination \"" + examination +
                     "\" or of one of its stages; use a separate folder");
}

} // namespace

RegistrationFiles::RegistrationFiles(CommandLine &                    commandLine,
                                     const std::string &              folder,
                                     const std::vector<std::string> & examinations)
  : m_CommandLine(commandLine)
  , m_Folder(folder)
  , m_Scene(commandLine,
            { { "supineModel", examination::supineToProne.name },
              { "proneModel", examination::proneToSupine.name },
              { "matchTable", examination::matches.name } })
{
  for (const std::string & examination : examinations)
  {
    RequireOwnFolder(folder, examination);
  }
  commandLine.MakeFolder(folder);
  commandLine.RecordRun(this->PathOf("run.json"));
}

std::string
RegistrationFiles::PathOf(const std::string & name) const
{
  return m_Folder + '/' + name;
}

void
RegistrationFiles::WriteFile(const std::string &                                   name,
                             const std::function<void(const std::string & path)> & write) const
{
  const std::string path = m_CommandLine.Output(this->PathOf(name));
  write(path);
  m_Scene.Copy(name, path);
}

void
RegistrationFiles::Write(const RegistrationResults & results) const
{
  this->WriteFile(examination::supineToProne.name, [&](const std::string & path) {
    WriteSurface(results.supineToProne, m_CommandLine.GetProvenance(), path);
  });
  this->WriteFile(examination::proneToSupine.name, [&](const std::string & path) {
    WriteSurface(results.proneToSupine, m_CommandLine.GetProvenance(), path);
  });
  this->WriteFile(examination::matches.name, [&](const std::string & path) { TableOfMatches(results).Write(path); });
  this->WriteErrors(results);
  m_CommandLine.WriteDocument(results.document, m_CommandLine.Output(this->PathOf(examination::registration.name)));
}

void
RegistrationFiles::WriteErrors(const RegistrationResults & results) const
{
  if (results.points.empty())
  {
    std::error_code ignored;
    fs::remove(this->PathOf(examination::errors.name), ignored);
    return;
  }
  TableOfErrors(results).Write(m_CommandLine.Output(this->PathOf(examination::errors.name)));
}

} // namespace shapeton
