#include "shapetonVolumeReader.h"

#include "shapetonDicomSeriesDefects.h"
#include "shapetonDicomSeriesScan.h"
#include "shapetonDicomVolume.h"
#include "shapetonFileErrors.h"
#include "shapetonImageFile.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;
using SeriesList = std::vector<const DicomSeries *>;

// A message is one line; a long list is for DicomSeriesInspector.
constexpr std::size_t LongestList = 6;

bool
IsRepaired(DicomDefectKind kind, const VolumeReadOptions & options, bool isChosenPart)
{
  switch (kind)
  {
    case DicomDefectKind::duplicateIdentical:
    case DicomDefectKind::duplicateConflicting:
      return options.dropDuplicates;
    case DicomDefectKind::gap:
    case DicomDefectKind::variableSpacing:
      return options.resampleGaps;
    case DicomDefectKind::shear:
      return options.deshear;
    case DicomDefectKind::mixedSeries:
      return isChosenPart;
    default:
      return false;
  }
}

/** Why a series cannot be read with these options; empty when it can. */
std::string
RefusalOf(const DicomSeries & series, const VolumeReadOptions & options)
{
  const bool isChosenPart = series.parts > 1 && options.seriesUID == series.GetSelector();
  // Slices that do not fit the others leave gaps: that they do not fit is to be told first.
  std::vector<DicomDefect> defects = series.defects;
  std::stable_partition(defects.begin(), defects.end(), [](const DicomDefect & defect) {
    return defect.kind == DicomDefectKind::mixedSeries;
  });
  for (const DicomDefect & defect : defects)
  {
    if (!IsRepaired(defect.kind, options, isChosenPart))
    {
      VolumeReadOptions all;
      all.dropDuplicates = all.resampleGaps = all.deshear = true;
      const bool isOption = IsRepaired(defect.kind, all, false);
      return std::string(GetDicomDefectName(defect.kind)) + ": " + defect.message + "; " +
             (isOption && !options.adviseRepair ? "a series without this defect is needed"
                                                : GetDicomDefectAdvice(defect.kind));
    }
  }
  if (series.isSingleSlice && !options.allowSingleSlice)
  {
    return "a single slice; a volume needs two or more, name the folder of the series";
  }
  return series.isSingleSlice ? std::string() : series.refusal;
}

std::string
Describe(const DicomSeries & series)
{
  return series.GetSelector() + " (" + (series.description.empty() ? "no description" : series.description) + ", " +
         (series.modality.empty() ? "" : series.modality + ", ") + std::to_string(series.slices.size()) +
         (series.slices.size() == 1 ? " slice)" : " slices)");
}

std::string
List(const SeriesList & list, const std::function<std::string(const DicomSeries &)> & text)
{
  std::string joined;
  std::size_t i = 0;
  for (std::size_t entries = 0; i < list.size() && entries < LongestList; ++entries)
  {
    const std::size_t number = LengthOfSingles(list, i);
    joined += (i > 0 ? "; " : "") + text(*list[i]);
    joined += number > 1 ? ", and " + Count(number - 1, "other slice") + " apart like it" : "";
    i += number;
  }
  return i < list.size() ? joined + "; and " + std::to_string(list.size() - i) + " more" : joined;
}

/** True for what a person calls a series of slices, whole or not. */
bool
IsVolumeLike(const DicomSeries & series)
{
  return series.slices.size() > 1 && series.refusal.empty() && !series.Has(DicomDefectKind::localizer);
}

SeriesList
Select(const DicomScan & scan, const std::function<bool(const DicomSeries &)> & isWanted)
{
  SeriesList list;
  for (const DicomSeries & series : scan.series)
  {
    if (isWanted(series))
    {
      list.push_back(&series);
    }
  }
  return list;
}

[[noreturn]] void
RefuseFolderWithoutImage(const DicomScan & scan)
{
  if (scan.files == 1)
  {
    const DicomDefect & defect = scan.otherFiles.front();
    ThrowUnsuitable(scan.path,
                    std::string(GetDicomDefectName(defect.kind)) + ": " + defect.message +
                      (defect.kind == DicomDefectKind::truncated
                         ? "; copy the file from its source again"
                         : "; wanted is a folder with a DICOM series, a DICOM image, NRRD, NIfTI or MetaImage"));
  }
  const auto truncated = std::find_if(scan.otherFiles.begin(), scan.otherFiles.end(), [](const DicomDefect & defect) {
    return defect.kind == DicomDefectKind::truncated;
  });
  const std::string first = truncated != scan.otherFiles.end() ? truncated->message : scan.otherFiles.front().message;
  ThrowUnsuitable(scan.path,
                  "notAnImage: none of its " + std::to_string(scan.files) + " files is a DICOM image (" + first +
                    "); name the folder that holds the series");
}

/** A damaged file whose series is not known may be the first or last slice of any. */
void
RefuseUnknownDamage(const DicomScan & scan)
{
  for (const DicomDefect & file : scan.otherFiles)
  {
    if (file.kind == DicomDefectKind::truncated)
    {
      ThrowUnsuitable(
        file.files.front(),
        "truncated: " + file.message +
          "; it may belong to the series: copy it from its source again, remove it, or choose a series by the "
          "parameter \"seriesUID\"");
    }
  }
}

const DicomSeries &
SelectByUID(const DicomScan & scan, const VolumeReadOptions & options)
{
  const std::string & uid = options.seriesUID;
  auto                list = Select(scan, [&uid](const DicomSeries & series) { return series.GetSelector() == uid; });
  if (list.empty())
  {
    list = Select(scan, [&uid](const DicomSeries & series) { return series.uid == uid; });
    // The localizers and other images of a series are no parts to choose from.
    const auto volumes =
      Select(scan, [&](const DicomSeries & series) { return series.uid == uid && IsVolumeLike(series); });
    list = volumes.empty() ? list : volumes;
  }
  if (list.empty())
  {
    SeriesList all = Select(scan, [](const DicomSeries &) { return true; });
    ThrowUnsuitable(scan.path, "no series has the UID " + uid + "; there are: " + List(all, Describe));
  }
  const std::string refusal = RefusalOf(*list.front(), options);
  if (!refusal.empty())
  {
    ThrowUnsuitable(scan.path, "series " + Describe(*list.front()) + ": " + refusal);
  }
  return *list.front();
}

/** The images of the same series that are no slices: a gap may be theirs. */
std::string
UnusableSlicesOf(const DicomSeries & series, const DicomScan & scan)
{
  std::string text;
  for (const DicomSeries & other : scan.series)
  {
    const bool isUnusable = other.uid == series.uid && &other != &series && !other.refusal.empty() &&
                            !(other.isSingleSlice && series.isSingleSlice);
    if (isUnusable && !other.slices.empty() && !other.Has(DicomDefectKind::localizer))
    {
      text += "; not usable of this series: " + other.slices.front().file +
              (other.slices.size() > 1 ? " and " + std::to_string(other.slices.size() - 1) + " more" : "") + ": " +
              other.refusal;
    }
  }
  return text;
}

const DicomSeries &
SelectOnlyOne(const DicomScan & scan, const VolumeReadOptions & options)
{
  RefuseUnknownDamage(scan);
  const auto usable = Select(scan, [&](const DicomSeries & series) { return RefusalOf(series, options).empty(); });
  if (usable.size() > 1)
  {
    ThrowUnsuitable(scan.path,
                    std::to_string(usable.size()) +
                      " usable volumes; choose one by the parameter \"seriesUID\": " + List(usable, Describe));
  }
  const auto volumes = Select(scan, IsVolumeLike);
  // A single slice is taken where nothing else is meant, and not in place of a volume that is irregular.
  if (usable.size() == 1 && (volumes.empty() || !usable.front()->isSingleSlice))
  {
    return *usable.front();
  }
  const auto all = Select(scan, [](const DicomSeries &) { return true; });
  const auto explain = [&](const DicomSeries & series) {
    return Describe(series) + ": " + RefusalOf(series, options) + UnusableSlicesOf(series, scan);
  };
  ThrowUnsuitable(scan.path, List(volumes.empty() ? all : volumes, explain));
}

/** What else is in the folder, for the user to know that it was not taken. */
void
NoteOthers(const DicomScan & scan, const DicomSeries & taken, Volume & volume)
{
  for (const DicomDefect & remark : taken.remarks)
  {
    volume.notes.push_back(std::string(GetDicomDefectName(remark.kind)) + ": " + remark.message + "; " +
                           GetDicomDefectAdvice(remark.kind));
  }
  std::size_t              localizers = 0;
  std::vector<std::string> others;
  const std::string        uid = taken.GetSelector();
  for (const DicomSeries & series : scan.series)
  {
    if (&series == &taken)
    {
      continue;
    }
    if (series.Has(DicomDefectKind::localizer))
    {
      localizers += series.slices.size();
      continue;
    }
    const std::string reason = series.defects.empty() ? series.refusal : GetDicomDefectName(series.defects[0].kind);
    others.push_back(Describe(series) + (reason.empty() ? "" : ": " + reason));
  }
  if (localizers > 0)
  {
    volume.notes.push_back(std::to_string(localizers) +
                           (localizers == 1 ? " localizer image was" : " localizer images were") + " left out");
  }
  for (const std::string & other : others)
  {
    volume.notes.push_back("left out: series " + other);
  }
  const auto damaged = std::count_if(scan.otherFiles.begin(), scan.otherFiles.end(), [](const DicomDefect & file) {
    return file.kind == DicomDefectKind::truncated;
  });
  if (damaged > 0)
  {
    volume.notes.push_back(std::to_string(damaged) + (damaged == 1 ? " truncated file was" : " truncated files were") +
                           " left out");
  }
}

Volume
ReadDicom(const std::string & path, const VolumeReadOptions & options)
{
  const DicomScan     scan = ScanDicom(path, options.progress.Part("Reading headers", 0.0, 0.3));
  const DicomSeries & series = SelectDicomSeries(scan, options);
  Volume              volume;
  try
  {
    volume = ReadDicomVolume(series, options);
  }
  catch (const InputError & error)
  {
    const std::string message = error.what();
    throw InputError(message.compare(0, path.size(), path) == 0 ? message : path + ": " + message);
  }
  NoteOthers(scan, series, volume);
  return volume;
}

void
CheckExtent(const std::string & path, const Volume & volume, const VolumeReadOptions & options)
{
  const auto size = volume.image->GetLargestPossibleRegion().GetSize();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] < 2 && !options.allowSingleSlice)
    {
      ThrowUnsuitable(path, "a single slice; a volume needs two or more along each axis");
    }
  }
}
} // namespace

const DicomSeries &
SelectDicomSeries(const DicomScan & scan, const VolumeReadOptions & options)
{
  if (scan.series.empty())
  {
    RefuseFolderWithoutImage(scan);
  }
  return options.seriesUID.empty() ? SelectOnlyOne(scan, options) : SelectByUID(scan, options);
}

Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    ThrowUnsuitable(path, error ? "cannot be read: " + error.message() : "does not exist");
  }
  if (!fs::is_directory(path, error) && !fs::is_regular_file(path, error))
  {
    ThrowUnsuitable(path, "is neither a file nor a folder; name the volume or its folder");
  }
  const bool isImageFile = IsImageFile(path) && !fs::is_directory(path, error);
  if (isImageFile && !options.seriesUID.empty())
  {
    throw ParameterError(path + ": the parameter \"seriesUID\" chooses a DICOM series, and this file is none");
  }
  Volume volume = isImageFile ? ReadImageFile(path) : ReadDicom(path, options);
  CheckExtent(path, volume, options);
  return volume;
}
} // namespace shapeton
