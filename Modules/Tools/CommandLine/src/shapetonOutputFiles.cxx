#include "shapetonOutputFiles.h"
#include "shapetonFileErrors.h"
#include "shapetonTemporaryName.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
void
CheckName(const std::string & path)
{
  if (path.empty())
  {
    throw ParameterError("the name of an output is empty");
  }
  const fs::path name = fs::path(path).filename();
  if (name.empty() || name == "." || name == "..")
  {
    ThrowCannotWrite(path, "it is a folder", "use a file name");
  }
}

// Resolves the path to the file to replace: a symbolic link is kept and its target is replaced, as with `cp`.
fs::path
ResolveTarget(const std::string & path)
{
  std::error_code error;
  fs::path        target = fs::absolute(path);
  for (int depth = 0; depth < 40 && fs::is_symlink(fs::symlink_status(target, error)); ++depth)
  {
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  const fs::path folder = fs::canonical(target.parent_path(), error);
  if (error)
  {
    ThrowCannotWrite(path, error.value());
  }
  return folder / target.filename();
}

void
CheckTarget(const std::string & path, const fs::path & target)
{
  std::error_code error;
  const auto      status = fs::status(target, error);
  if (fs::is_directory(status))
  {
    ThrowCannotWrite(path, "it is a folder", "use a file name");
  }
  if (!fs::status_known(status))
  {
    ThrowCannotWrite(path, error.value());
  }
  if (!fs::exists(status))
  {
    return;
  }
  if (!fs::is_regular_file(status))
  {
    ThrowCannotWrite(path, "it is not a regular file", "use the name of a regular file");
  }
  if (const int denied = ErrorOfAccess(target.string(), FileAccess::overwrite))
  {
    ThrowCannotWrite(path, std::generic_category().message(denied), "use another name or allow writing to the file");
  }
}

// Fails before the computation, not after it; the check leaves no files.
void
CheckCreation(const std::string & path, const std::string & temporary)
{
  if (const int error = ErrorOfCreation(temporary))
  {
    ThrowCannotWrite(path, error);
  }
}

int
Sync(const fs::path & path)
{
  const int  error = ErrorOfSync(path.string());
  const bool isMissing = error == EINVAL || error == ENOSYS || error == EOPNOTSUPP; // on FUSE, network
  return isMissing ? 0 : error;
}

// Keeps the permissions of the old file, so a private result does not become world-readable.
void
KeepPermissions(const fs::path & target, const std::string & temporary)
{
  std::error_code error;
  const auto      status = fs::status(target, error);
  if (fs::exists(status))
  {
    fs::permissions(temporary, status.permissions() & fs::perms::all, error);
  }
}

std::vector<fs::path>
MissingFolders(const fs::path & target)
{
  std::error_code       error;
  std::vector<fs::path> missing;
  for (fs::path folder = target; !fs::exists(folder, error) && folder.has_relative_path();
       folder = folder.parent_path())
  {
    missing.insert(missing.begin(), folder);
  }
  return missing;
}
} // namespace

OutputFiles::OutputFiles() { RemovalAtDeath::InstallHandlers(); }

OutputFiles::~OutputFiles()
{
  std::error_code error;
  for (const File & file : m_Files)
  {
    fs::remove(file.temporary, error);
  }
  for (auto folder = m_Folders.rbegin(); folder != m_Folders.rend(); ++folder)
  {
    fs::remove(folder->path, error); // only when empty
  }
}

// Removes leftovers of runs that could not clean up (SIGKILL, power failure).
void
OutputFiles::RemoveLeftovers(const fs::path & folder)
{
  if (!m_TidyFolders.insert(folder).second)
  {
    return;
  }
  std::error_code       error;
  std::vector<fs::path> leftovers;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    if (IsLeftover(entry->path().filename().string()))
    {
      leftovers.push_back(entry->path());
    }
  }
  for (const fs::path & leftover : leftovers)
  {
    fs::remove(leftover, error);
  }
}

std::string
OutputFiles::Add(const std::string & path)
{
  CheckName(path);
  this->MakeParentFolder(path);
  const fs::path target = ResolveTarget(path);
  CheckTarget(path, target);
  if (std::any_of(m_Files.begin(), m_Files.end(), [&](const File & file) { return file.target == target; }))
  {
    throw ParameterError("two outputs have the same name \"" + path + "\"; use different names");
  }
  this->RemoveLeftovers(target.parent_path());
  const std::string temporary = TemporaryNameFor(target, m_Added++).string();
  RemovalAtDeath    removal(temporary);
  CheckCreation(path, temporary);
  m_Files.push_back({ path, target, temporary, std::move(removal) });
  return temporary;
}

std::string
OutputFiles::InFinalNames(std::string message) const
{
  for (const File & file : m_Files)
  {
    for (auto at = message.find(file.temporary); at != std::string::npos;
         at = message.find(file.temporary, at + file.path.size()))
    {
      message.replace(at, file.temporary.size(), file.path);
    }
  }
  return message;
}

void
OutputFiles::MakeFolder(const std::string & path)
{
  if (path.empty())
  {
    throw ParameterError("the name of a folder for outputs is empty");
  }
  std::error_code error;
  const fs::path  target = fs::absolute(path);
  for (const fs::path & folder : MissingFolders(target))
  {
    RemovalAtDeath removal(folder.string());
    const bool     isNew = fs::create_directory(folder, error);
    if (error)
    {
      ThrowCannotWrite(path, error.message(), "choose a writable folder");
    }
    if (isNew) // not created by another run meanwhile
    {
      m_Folders.push_back({ folder, std::move(removal) });
    }
  }
  if (!fs::is_directory(target, error))
  {
    ThrowCannotWrite(path, "it exists and is not a folder", "use another name");
  }
}

void
OutputFiles::MakeParentFolder(const std::string & path)
{
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty())
  {
    this->MakeFolder(folder.string());
  }
}

// Checks that the file was written, and syncs it to disk.
void
OutputFiles::Finish(const File & file)
{
  if (!fs::exists(file.temporary))
  {
    ThrowCannotWrite(file.path, "the program wrote nothing", "report this as a bug");
  }
  if (const int error = Sync(file.temporary))
  {
    ThrowCannotWrite(file.path, error);
  }
  KeepPermissions(file.target, file.temporary);
}

void
OutputFiles::Rename(const File & file)
{
  if (std::rename(file.temporary.c_str(), file.target.c_str()) != 0)
  {
    ThrowCannotWrite(file.path, std::generic_category().message(errno), "choose another name");
  }
  if (file.target.extension() == ".html")
  {
    m_Pages.insert(file.path);
  }
}

void
OutputFiles::Publish(const std::string & path)
{
  const fs::path target = ResolveTarget(path);
  const auto     file =
    std::find_if(m_Files.begin(), m_Files.end(), [&](const File & candidate) { return candidate.target == target; });
  if (file == m_Files.end())
  {
    throw std::logic_error("\"" + path + "\" is not an unpublished output of this run");
  }
  Finish(*file);
  const DeathDelay delay;
  Rename(*file);
  m_Files.erase(file);
}

void
OutputFiles::Commit()
{
  for (const File & file : m_Files)
  {
    Finish(file);
  }
  {
    const DeathDelay delay;
    for (const File & file : m_Files)
    {
      Rename(file);
    }
    m_Files.clear();
    m_Folders.clear();
  }
  for (const fs::path & folder : m_TidyFolders)
  {
    Sync(folder); // syncs the new names, which are already in place
  }
}
} // namespace shapeton
