#include "shapetonHeatSnapshot.h"

#include "itkMetaDataObject.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <cmath>
#include <charconv>
#include <filesystem>
#include <map>
#include <vector>

namespace shapeton
{
namespace
{
constexpr char        prefix[] = "heat-";
constexpr char        suffix[] = ".nrrd";
constexpr std::size_t digits = 9; // of the step in a name, so that names are in order

std::optional<std::uint64_t>
WholeNumber(const std::string & text)
{
  std::uint64_t value = 0;
  const auto    result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool    isWhole = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return isWhole ? std::optional<std::uint64_t>(value) : std::nullopt;
}

std::optional<std::uint64_t>
TimeStepOfName(const std::string & name)
{
  const std::size_t fixed = sizeof(prefix) - 1 + sizeof(suffix) - 1;
  if (name.size() < fixed + digits || name.rfind(prefix, 0) != 0 ||
      name.compare(name.size() - (sizeof(suffix) - 1), std::string::npos, suffix) != 0)
  {
    return std::nullopt;
  }
  return WholeNumber(name.substr(sizeof(prefix) - 1, name.size() - fixed));
}

std::map<std::uint64_t, std::string>
SnapshotsIn(const std::string & folder)
{
  std::map<std::uint64_t, std::string> snapshots;
  std::error_code                      error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    const auto timeStep = TimeStepOfName(entry->path().filename().string());
    if (timeStep)
    {
      snapshots[*timeStep] = entry->path().string();
    }
  }
  if (error)
  {
    throw InputError("cannot read the folder " + folder + ": " + error.message());
  }
  return snapshots;
}

/** Lists the first few time steps, and the last one. */
std::string
ListOf(const std::map<std::uint64_t, std::string> & snapshots)
{
  constexpr std::size_t greatestNumber = 12;
  std::string           list;
  std::size_t           number = 0;
  for (const auto & snapshot : snapshots)
  {
    if (number < greatestNumber)
    {
      list += (list.empty() ? "" : ", ") + std::to_string(snapshot.first);
    }
    ++number;
  }
  return number > greatestNumber ? list + ", ... " + std::to_string(snapshots.rbegin()->first) : list;
}

HeatSnapshot
FindInFolder(const std::string & folder, std::optional<std::uint64_t> timeStep)
{
  const std::map<std::uint64_t, std::string> snapshots = SnapshotsIn(folder);
  if (snapshots.empty())
  {
    throw InputError("the folder " + folder + " contains no heat-<time step>.nrrd: use the snapshot folder of " +
                     "CumulativeHeatDiffusion, or a heat volume");
  }
  const auto found = timeStep ? snapshots.find(*timeStep) : std::prev(snapshots.end());
  if (found == snapshots.end())
  {
    throw ParameterError("the folder " + folder + " contains no snapshot of time step " + std::to_string(*timeStep) +
                         "; available: " + ListOf(snapshots));
  }
  return { found->second, found->first };
}

/** A value of the header; empty if there is none. */
std::string
ValueInHeader(const std::string & path, const std::string & key)
{
  const std::vector<itk::ImageIOBase::Pointer> formats = { itk::NrrdImageIO::New().GetPointer(),
                                                           itk::MetaImageIO::New().GetPointer() };
  const auto format = std::find_if(formats.begin(), formats.end(), [&path](const itk::ImageIOBase::Pointer & io) {
    return io->CanReadFile(path.c_str());
  });
  if (format == formats.end())
  {
    return ""; // NIfTI cannot store it
  }
  const itk::ImageIOBase::Pointer & reader = *format;
  try
  {
    reader->SetFileName(path);
    reader->ReadImageInformation();
  }
  catch (const itk::ExceptionObject &)
  {
    throw InputError("cannot read the header of " + path + ": write the heat volume again");
  }
  std::string text;
  itk::ExposeMetaData(reader->GetMetaDataDictionary(), key, text);
  return text;
}

std::optional<std::uint64_t>
TimeStepInHeader(const std::string & path)
{
  return WholeNumber(ValueInHeader(path, "timeStep"));
}

} // namespace

HeatSnapshot
FindHeatSnapshot(const std::string & path, std::optional<std::uint64_t> timeStep)
{
  if (!std::filesystem::exists(path))
  {
    throw InputError("no heat volume found at " + path + ": check the path of the heat volume or folder of snapshots");
  }
  if (std::filesystem::is_directory(path))
  {
    return FindInFolder(path, timeStep);
  }
  const std::optional<std::uint64_t> stated = TimeStepInHeader(path);
  if (timeStep && stated && *timeStep != *stated)
  {
    throw ParameterError("the heat volume " + path + " is from time step " + std::to_string(*stated) + ", not " +
                         std::to_string(*timeStep) + ": omit the time step, or use a folder of snapshots");
  }
  return { path, stated ? stated : timeStep };
}

std::string
HeatSnapshotName(std::uint64_t timeStep)
{
  const std::string number = std::to_string(timeStep);
  return prefix + std::string(digits - std::min(number.size(), digits), '0') + number + suffix;
}

itk::Image<std::uint32_t, 3>::Pointer
VisitsOf(const itk::Image<float, 3> * values, const HeatSnapshot & file)
{
  constexpr float     mostVisits = 4e9F; // below 2^32
  const float * const begin = values->GetBufferPointer();
  const float * const end = begin + values->GetBufferedRegion().GetNumberOfPixels();
  const bool          areVisits = file.timeStep && std::any_of(begin, end, [](float value) { return value > 1.0F; }) &&
                         std::all_of(begin, end, [](float value) {
                           return value >= 0.0F && value < mostVisits && value == std::floor(value);
                         });
  if (!areVisits)
  {
    return nullptr;
  }
  return MapVoxels<std::uint32_t>(values, [](float value) { return static_cast<std::uint32_t>(value); });
}
} // namespace shapeton
