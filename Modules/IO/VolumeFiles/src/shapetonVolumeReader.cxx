#include "shapetonVolumeReader.h"

#include "shapetonDicomSeriesDefects.h"
#include "shapetonDicomSeriesScan.h"
#include "shapetonDicomVolume.h"
#include "shapetonFileErrors.h"
#include "shapetonImageFile.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;
using SeriesList = std::vector<const DicomSeries *>;

// Messages are one line long; DicomSeriesInspector prints long lists.
constexpr std::size_t LongestList = 6;

bool
IsRepaired(const DicomDefect & defect, const VolumeReadOptions & options, bool isChosenPart)
{
  switch (defect.kind)
  {
    case DicomDefectKind::duplicateIdentical:
    case DicomDefectKind::duplicateConflicting:
      return options.dropDuplicates;
    case DicomDefectKind::gap:
    case DicomDefectKind::variableSpacing:
      return options.resampleGaps && defect.isRepairable;
    case DicomDefectKind::shear:
      return options.deshear && defect.isRepairable;
    case DicomDefectKind::mixedSeries:
      return isChosenPart;
    default:
      return false;
  }
}

/** False for advice on a repair that the caller does not support. */
bool
MayAdvise(const DicomDefect & defect, const VolumeReadOptions & options)
{
  VolumeReadOptions repairs;
  repairs.dropDuplicates = repairs.resampleGaps = options.advice != DicomRepairAdvice::AllRepairs;
  repairs.deshear = options.advice == DicomRepairAdvice::None;
  return !IsRepaired(defect, repairs, false);
}

/** Reason why a series cannot be read with these options; otherwise empty. */
std::string
RefusalOf(const DicomSeries & series, const VolumeReadOptions & options)
{
  const bool isChosenPart = series.parts > 1 && options.seriesUID == series.GetSelector();
  // Nonmatching slices leave gaps, so they are reported first.
  std::vector<DicomDefect> defects = series.defects;
  std::stable_partition(defects.begin(), defects.end(), [](const DicomDefect & defect) {
    return defect.kind == DicomDefectKind::mixedSeries;
  });
  for (const DicomDefect & defect : defects)
  {
    if (!IsRepaired(defect, options, isChosenPart))
    {
      return defect.message + "; " +
             (MayAdvise(defect, options) ? GetDicomDefectAdvice(defect) : "a series without this defect is required");
    }
  }
  if (series.isSingleSlice && !options.allowSingleSlice)
  {
    return "a single slice; a volume requires two or more; use the folder of the series";
  }
  return series.isSingleSlice ? std::string() : series.refusal;
}

std::string
Describe(const DicomSeries & series)
{
  return series.GetSelector() + " (" + (series.description.empty() ? "no description" : series.description) + ", " +
         (series.distinction.empty() ? "" : series.distinction + ", ") +
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
    joined += number > 1 ? ", and " + Count(number - 1, "other slice") + " of the same kind" : "";
    i += number;
  }
  return i < list.size() ? joined + "; and " + std::to_string(list.size() - i) + " more" : joined;
}

/** True for a series of slices, complete or not. */
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

/** "2 RTStructureSetStorage, 1 EncapsulatedPDFStorage". */
std::string
ListObjects(const DicomScan & scan)
{
  std::string text;
  for (const auto & kind : scan.otherObjects)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(kind.second) + " " + kind.first;
  }
  return text;
}

/** Advice on DICOM objects that are not images. */
std::string
AdviceOnObjects(const DicomScan & scan)
{
  const bool areContours = scan.otherObjects.count("RTStructureSetStorage") > 0;
  const bool areReports = std::any_of(scan.otherObjects.begin(), scan.otherObjects.end(), [](const auto & kind) {
    return kind.first.find("SRStorage") != std::string::npos;
  });
  return std::string(areContours  ? "a structure set contains only contours; "
                     : areReports ? "the points of a report are read by DicomResultsToColon; "
                                  : "") +
         "use the folder with the image series that they reference";
}

/** A damaged file from an unknown series may be the first or last slice of any series. */
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
    // The localizers and other images of a series cannot be selected.
    const auto volumes =
      Select(scan, [&](const DicomSeries & series) { return series.uid == uid && IsVolumeLike(series); });
    list = volumes.empty() ? list : volumes;
  }
  if (list.empty())
  {
    SeriesList all = Select(scan, [](const DicomSeries &) { return true; });
    ThrowUnsuitable(scan.path, "series UID " + uid + " not found; available: " + List(all, Describe));
  }
  const std::string refusal = RefusalOf(*list.front(), options);
  if (!refusal.empty())
  {
    ThrowUnsuitable(scan.path, "series " + Describe(*list.front()) + ": " + refusal);
  }
  return *list.front();
}

/** Files that have the extension of the slices but are not DICOM, such as empty ones; they may explain a gap. */
std::string
DamagedSlicesOf(const DicomSeries & series, const DicomScan & scan)
{
  const auto  extension = series.slices.empty() ? fs::path() : fs::path(series.slices.front().file).extension();
  std::string first;
  std::size_t more = 0;
  for (const DicomDefect & file : scan.otherFiles)
  {
    if (!extension.empty() && fs::path(file.files.front()).extension() == extension)
    {
      more += first.empty() ? 0 : 1;
      first = first.empty() ? "; copy this file from its source again: " + file.message : first;
    }
  }
  return first + (more > 0 ? " (and " + std::to_string(more) + " more)" : "");
}

/** Images of the same series that are not slices; they may explain a gap. */
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
      text += "; not usable from this series: " + other.slices.front().file +
              (other.slices.size() > 1 ? " and " + std::to_string(other.slices.size() - 1) + " more" : "") + ": " +
              other.refusal;
    }
  }
  return text;
}

/** Several slices that a program or a de-identification gave a Series Instance UID each. */
[[noreturn]] void
RefuseSingleSlices(const DicomScan & scan, const SeriesList & slices)
{
  const auto haveOne = [&](std::string DicomSeries::*member) {
    return std::all_of(slices.begin(), slices.end(), [&](const DicomSeries * slice) {
      return slice->*member == slices.front()->*member;
    });
  };
  const bool isOneScan =
    haveOne(&DicomSeries::studyUID) && haveOne(&DicomSeries::frameOfReferenceUID) && haveOne(&DicomSeries::description);
  ThrowUnsuitable(scan.path,
                  std::to_string(slices.size()) + " series of one slice each, which do not form a volume" +
                    (isOneScan
                       ? ", although they share study, frame of reference and description; give them one Series "
                         "Instance UID, for example with dcmodify"
                       : "; use the folder of one series") +
                    ": " + List(slices, Describe));
}

const DicomSeries &
SelectOnlyOne(const DicomScan & scan, const VolumeReadOptions & options)
{
  RefuseUnknownDamage(scan);
  // A single slice is read only if it is the only series; it does not replace an irregular volume.
  const auto volumes = Select(scan, IsVolumeLike);
  const auto slices = Select(scan, [](const DicomSeries & series) { return series.isSingleSlice; });
  const auto usable = Select(scan, [&](const DicomSeries & series) {
    return RefusalOf(series, options).empty() && (volumes.empty() || !series.isSingleSlice);
  });
  if (volumes.empty() && slices.size() > 1 && slices.front()->uid != slices.back()->uid)
  {
    RefuseSingleSlices(scan, slices);
  }
  if (usable.size() > 1)
  {
    ThrowUnsuitable(scan.path,
                    std::to_string(usable.size()) +
                      " usable volumes; choose one by the parameter \"seriesUID\": " + List(usable, Describe));
  }
  if (usable.size() == 1)
  {
    return *usable.front();
  }
  const auto all = Select(scan, [](const DicomSeries &) { return true; });
  const auto explain = [&](const DicomSeries & series) {
    return Describe(series) + ": " + RefusalOf(series, options) + UnusableSlicesOf(series, scan) +
           DamagedSlicesOf(series, scan);
  };
  ThrowUnsuitable(scan.path, List(volumes.empty() ? all : volumes, explain));
}

/** Summarizes the other contents of a folder, after the user's selection. */
void
CountOthers(const DicomScan & scan, Volume & volume)
{
  const std::size_t others = scan.series.size() - 1;
  if (others > 0)
  {
    volume.notes.push_back("skipped: " + std::to_string(others) +
                           " other series or parts of the folder; DicomSeriesInspector lists them");
  }
}

/** Notes on images that were skipped automatically. */
void
ListOthers(const DicomScan & scan, const DicomSeries & taken, Volume & volume)
{
  std::size_t localizers = 0;
  for (const DicomSeries & series : scan.series)
  {
    localizers += series.Has(DicomDefectKind::localizer) && &series != &taken ? series.slices.size() : 0;
  }
  if (localizers > 0)
  {
    volume.notes.push_back(std::to_string(localizers) +
                           (localizers == 1 ? " localizer image was" : " localizer images were") + " skipped");
  }
  for (const DicomSeries & series : scan.series)
  {
    if (&series != &taken && !series.Has(DicomDefectKind::localizer))
    {
      const std::string reason = series.defects.empty() ? series.refusal : series.defects[0].message;
      volume.notes.push_back("skipped: series " + Describe(series) + (reason.empty() ? "" : ": " + reason));
    }
  }
}

/** Notes on irregularities of the series and other contents of the folder. */
void
NoteOthers(const DicomScan & scan, const DicomSeries & taken, bool isChosen, Volume & volume)
{
  for (const DicomDefect & remark : taken.remarks)
  {
    volume.notes.push_back(remark.message + "; " + GetDicomDefectAdvice(remark));
  }
  if (isChosen)
  {
    CountOthers(scan, volume);
  }
  else
  {
    ListOthers(scan, taken, volume);
  }
  const auto damaged = std::count_if(scan.otherFiles.begin(), scan.otherFiles.end(), [](const DicomDefect & file) {
    return file.kind == DicomDefectKind::truncated;
  });
  if (damaged > 0)
  {
    volume.notes.push_back(std::to_string(damaged) + (damaged == 1 ? " truncated file was" : " truncated files were") +
                           " skipped");
  }
}

Volume
ReadDicom(const std::string & path, const VolumeReadOptions & options, const Progress & progress)
{
  const DicomScan     scan = ScanDicom(path, progress.Part("Reading headers", 0.0, 0.3));
  const DicomSeries & series = SelectDicomSeries(scan, options);
  Volume              volume;
  try
  {
    volume = ReadDicomVolume(series, options, progress);
  }
  catch (const InputError & error)
  {
    const std::string message = error.what();
    throw InputError(message.compare(0, path.size(), path) == 0 ? message : path + ": " + message);
  }
  NoteOthers(scan, series, !options.seriesUID.empty(), volume);
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
      ThrowUnsuitable(path, "a single slice; a volume requires two or more along each axis");
    }
  }
}
} // namespace

void
RequireDicomImages(const DicomScan & scan, const std::string & wanted)
{
  if (!scan.series.empty())
  {
    return;
  }
  const auto truncated = std::find_if(scan.otherFiles.begin(), scan.otherFiles.end(), [](const DicomDefect & defect) {
    return defect.kind == DicomDefectKind::truncated;
  });
  const bool isDamaged = truncated != scan.otherFiles.end();
  const std::string first = isDamaged ? truncated->message : scan.otherFiles.front().message;
  if (isDamaged && scan.files == 1)
  {
    ThrowUnsuitable(scan.path, "truncated: " + first + "; copy the file from its source again");
  }
  const std::string which = scan.files == 1 ? "the file is not a DICOM image"
                                            : "none of its " + std::to_string(scan.files) + " files is a DICOM image";
  const std::string found = scan.otherObjects.empty() ? first : "DICOM objects without one: " + ListObjects(scan);
  ThrowUnsuitable(scan.path,
                  which + " (" + found + (isDamaged && found != first ? "; " + first : "") + "); " +
                    (scan.otherObjects.empty() ? wanted : AdviceOnObjects(scan)));
}

const DicomSeries &
SelectDicomSeries(const DicomScan & scan, const VolumeReadOptions & options)
{
  const bool isFile = scan.files == 1 && !fs::is_directory(scan.path);
  RequireDicomImages(scan,
                     isFile ? "use a folder with a DICOM series, or a DICOM, NRRD, NIfTI or MetaImage file"
                            : "use the folder that contains the series");
  return options.seriesUID.empty() ? SelectOnlyOne(scan, options) : SelectByUID(scan, options);
}

Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options, const Progress & progress)
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
    throw ParameterError(path + ": the parameter \"seriesUID\" selects a DICOM series, but this file is not one");
  }
  Volume volume = isImageFile ? ReadImageFile(path) : ReadDicom(path, options, progress);
  CheckExtent(path, volume, options);
  return volume;
}
} // namespace shapeton
