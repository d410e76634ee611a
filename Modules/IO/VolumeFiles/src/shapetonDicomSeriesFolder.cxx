#include "shapetonDicomSeriesFolder.h"

#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
[[noreturn]] void
ThrowCannotWriteSeries(const fs::path & folder, const std::string & reason, const std::string & advice)
{
  throw OutputError("cannot write a series to \"" + folder.string() + "\": " + reason + "; " + advice);
}

bool
IsNumber(const std::string & text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool
IsSliceName(const std::string & name)
{
  const fs::path    path(name);
  const std::string stem = path.stem().string();
  return path.extension() == ".dcm" && stem.size() >= 6 && stem.compare(0, 2, "IM") == 0 && IsNumber(stem.substr(2));
}

bool
IsOurSlice(const fs::directory_entry & entry)
{
  if (entry.is_symlink() || !entry.is_regular_file() || !IsSliceName(entry.path().filename().string()))
  {
    return false;
  }
  DcmFileFormat file;
  OFString      manufacturer;
  OFString      model;
  return file.loadFile(entry.path().c_str()).good() &&
         file.getDataset()->findAndGetOFString(DCM_Manufacturer, manufacturer).good() &&
         file.getDataset()->findAndGetOFString(DCM_ManufacturerModelName, model).good() &&
         manufacturer == DicomSeriesManufacturer && model == DicomSeriesModel;
}

// The real path of a folder: links resolved, no trailing separator.
fs::path
TargetOf(const std::string & folder)
{
  if (folder.empty())
  {
    throw OutputError("the name of the output folder is empty; specify a folder name");
  }
  std::error_code error;
  fs::path        target = fs::weakly_canonical(fs::absolute(folder), error).lexically_normal();
  if (error)
  {
    ThrowCannotWriteSeries(folder, error.message(), "use another name");
  }
  return target.has_filename() ? target : target.parent_path();
}

void
CheckContents(const fs::path & target)
{
  if (!fs::exists(target))
  {
    return;
  }
  if (!fs::is_directory(target))
  {
    ThrowCannotWriteSeries(target, "it is not a folder", "use another name");
  }
  std::error_code error;
  if (fs::equivalent(target, fs::current_path(), error))
  {
    ThrowCannotWriteSeries(target, "it is the current folder", "use a folder inside it");
  }
  for (const auto & entry : fs::directory_iterator(target))
  {
    if (!IsOurSlice(entry))
    {
      throw ParameterError("the folder \"" + target.string() + "\" contains \"" + entry.path().filename().string() +
                           "\", which is not a slice of a series written by this program; use a new or empty folder");
    }
  }
}

void
CheckTarget(const fs::path & target)
{
  try
  {
    CheckContents(target);
  }
  catch (const fs::filesystem_error & failure)
  {
    ThrowCannotWriteSeries(target, failure.code().message(), "use a readable and writable folder");
  }
  if (const int error = ErrorOfAccess(target.parent_path().string(), FileAccess::create))
  {
    ThrowCannotWriteSeries(target, std::strerror(error), "use an existing, writable folder");
  }
}

// Removes the slices of a folder, and the folder unless it contains other files.
void
RemoveSeries(const fs::path & folder)
{
  std::error_code       error;
  std::vector<fs::path> slices;
  for (const auto & entry : fs::directory_iterator(folder, error))
  {
    if (IsSliceName(entry.path().filename().string()))
    {
      slices.push_back(entry.path());
    }
  }
  for (const auto & slice : slices)
  {
    fs::remove(slice, error);
  }
  fs::remove(folder, error);
}

fs::path
HiddenName(const fs::path & target, const std::string & process, const std::string & kind)
{
  return target.parent_path() / ('.' + target.filename().string() + '.' + process + kind);
}

// The hidden folders `.name.<process>.<kind>` of terminated processes.
std::vector<fs::path>
FindLeftovers(const fs::path & target, const std::string & kind)
{
  std::vector<fs::path> leftovers;
  const std::string     start = '.' + target.filename().string() + '.';
  std::error_code       error;
  for (const auto & entry : fs::directory_iterator(target.parent_path(), error))
  {
    const std::string name = entry.path().filename().string();
    if (name.size() <= start.size() + kind.size() || name.compare(0, start.size(), start) != 0 ||
        name.compare(name.size() - kind.size(), kind.size(), kind) != 0 || !entry.is_directory(error))
    {
      continue;
    }
    const std::string process = name.substr(start.size(), name.size() - start.size() - kind.size());
    if (IsNumber(process) && process.size() < 10 && !IsProcessAlive(std::stoi(process)))
    {
      leftovers.push_back(entry.path());
    }
  }
  return leftovers;
}

// Cleans up after killed runs: restores a series that was moved aside and removes unfinished ones.
void
Recover(const fs::path & target)
{
  std::error_code error;
  for (const auto & old : FindLeftovers(target, ".old"))
  {
    if (fs::exists(target, error))
    {
      RemoveSeries(old);
    }
    else
    {
      fs::rename(old, target, error);
    }
  }
  for (const auto & part : FindLeftovers(target, ".part"))
  {
    RemoveSeries(part);
  }
}

void
ThrowWhenInterrupted()
{
  if (DeferredSignals::IsPending())
  {
    throw OutputError("interrupted by a signal while a series was written; nothing was changed");
  }
}

// A temporary folder that replaces the target or is removed.
class TemporaryFolder
{
public:
  explicit TemporaryFolder(const fs::path & target)
    : m_Target(target), m_Path(HiddenName(target, std::to_string(ProcessNumber()), ".part"))
  {
    std::error_code error;
    if (!fs::create_directory(m_Path, error))
    {
      ThrowCannotWriteSeries(target, error ? error.message() : "another run is writing to it", "use another folder");
    }
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &
  operator=(const TemporaryFolder &) = delete;
  ~TemporaryFolder() { RemoveSeries(m_Path); }

  std::string
  GetPath() const
  {
    return m_Path.string();
  }

  void
  Commit()
  {
    this->Sync();
    if (!fs::exists(m_Target) || fs::is_empty(m_Target))
    {
      this->Rename(m_Path, m_Target);
    }
    else if (!ExchangeNames(m_Path.string(), m_Target.string()))
    {
      this->ReplaceInTwoSteps(); // not every file system supports the exchange
    }
  }

private:
  void
  Sync() const
  {
    if (const int reason = ErrorOfFileSystemSync(m_Path.string()))
    {
      ThrowCannotWriteSeries(m_Target, std::strerror(reason), "free some space or use another folder");
    }
  }

  void
  Rename(const fs::path & from, const fs::path & to) const
  {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
    {
      ThrowCannotWriteSeries(m_Target, error.message(), "use another folder");
    }
  }

  // If the process is killed between the two steps, Recover() restores the old series.
  void
  ReplaceInTwoSteps()
  {
    const fs::path old = HiddenName(m_Target, std::to_string(ProcessNumber()), ".old");
    this->Rename(m_Target, old);
    std::error_code error;
    fs::rename(m_Path, m_Target, error);
    if (error)
    {
      this->Rename(old, m_Target);
      ThrowCannotWriteSeries(m_Target, error.message(), "use another folder");
    }
    RemoveSeries(old);
  }

  fs::path m_Target;
  fs::path m_Path;
};
} // namespace

void
CheckDicomSeriesFolder(const std::string & folder)
{
  CheckTarget(TargetOf(folder));
}

void
WriteDicomSeriesFolder(const itk::Image<short, 3> *   image,
                       const std::string &            folder,
                       const DicomSeriesDescription & description)
{
  const fs::path target = TargetOf(folder);
  Recover(target);
  CheckTarget(target);
  const DeferredSignals signals; // until the unfinished folder has been removed or renamed
  TemporaryFolder       temporary(target);
  WriteDicomSlices(image, temporary.GetPath(), description, ThrowWhenInterrupted);
  temporary.Commit();
}
} // namespace shapeton
