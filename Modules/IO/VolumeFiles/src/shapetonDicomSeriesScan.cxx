#include "shapetonDicomSeriesScan.h"

#include "shapetonDicomAttributes.h"
#include "shapetonDicomFile.h"
#include "shapetonDicomSeriesDefects.h"
#include "shapetonDicomText.h"
#include "shapetonExceptions.h"
#include "shapetonFileWalk.h"
#include "shapetonParsingServices.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace shapeton
{
namespace
{
constexpr double EqualCosineTolerance = 1e-4;  // chosen; rounding of written direction cosines
constexpr double PixelSpacingTolerance = 1e-4; // of the first spacing; chosen, rounding of written spacings

/** A slice to be assigned to a series; `frame` is null if the image has no valid frame. */
struct Item
{
  const DicomFile *  file;
  const DicomFrame * frame;
  unsigned int       number;
};
using Items = std::vector<Item>;

// ---- headers ----

DicomFile
ParseContained(ContainedProcess & process, const std::string & path)
{
  DicomFile file;
  try
  {
    const std::string response = process.Call(path);
    ByteReader        reader(response);
    Transmit(reader, file);
  }
  catch (const ContainedProcess::Failure & failure)
  {
    file = DicomFile();
    file.kind = DicomFile::Kind::damaged;
    file.what = std::string("its header cannot be read: ") + failure.what();
  }
  file.path = path;
  return file;
}

std::vector<DicomFile>
ParseFiles(const std::vector<std::string> & paths, const Progress & progress)
{
  constexpr ContainedProcess::Limits limits{ std::size_t{ 512 } << 20, 15, 600 };
  ContainedProcess                   process(DicomHeaderService, 0, limits);
  std::vector<DicomFile>             files;
  files.reserve(paths.size());
  for (const std::string & path : paths)
  {
    files.push_back(ParseContained(process, path));
    progress(static_cast<double>(files.size()) / static_cast<double>(paths.size()));
  }
  return files;
}

// ---- copies ----

bool
HaveEqualBytes(const std::string & a, const std::string & b)
{
  std::ifstream first(a, std::ios::binary);
  std::ifstream second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/** Takes out the images whose bytes are those of an earlier file, and returns them: copy, original. */
std::map<std::string, std::string>
TakeCopies(std::vector<DicomFile> & files)
{
  std::map<std::string, std::vector<std::string>> byInstance;
  std::map<std::string, std::string>              copies;
  for (const DicomFile & file : files)
  {
    if (file.kind != DicomFile::Kind::image || file.sopInstanceUID.empty())
    {
      continue;
    }
    auto &     others = byInstance[file.sopInstanceUID];
    const auto original = std::find_if(
      others.begin(), others.end(), [&](const std::string & other) { return HaveEqualBytes(file.path, other); });
    if (original == others.end())
    {
      others.push_back(file.path);
    }
    else
    {
      copies[file.path] = *original;
    }
  }
  files.erase(
    std::remove_if(files.begin(), files.end(), [&](const DicomFile & file) { return copies.count(file.path) > 0; }),
    files.end());
  return copies;
}

void
RemarkOnCopies(const std::map<std::string, std::string> & copies, DicomSeries & series)
{
  DicomDefect remark{ DicomDefectKind::copiedFile, {}, {}, {} };
  for (const auto & copy : copies)
  {
    const auto isOriginal = [&](const DicomSlice & slice) { return slice.file == copy.second; };
    if (std::any_of(series.slices.begin(), series.slices.end(), isOriginal))
    {
      remark.files.push_back(copy.first);
    }
  }
  if (!remark.files.empty())
  {
    const std::size_t count = remark.files.size();
    remark.message = Count(count, "file") +
                     (count == 1 ? " is an exact copy of another" : " are exact copies of others") +
                     " and not used, the first: " + std::filesystem::path(remark.files.front()).filename().string();
    series.remarks.push_back(remark);
  }
}

// ---- grouping ----

/** True for an image with a position in a volume, even if it is truncated. */
bool
IsPartOfVolume(const Item & item)
{
  return item.frame && item.frame->hasGeometry && !item.frame->isLocalizer && !item.file->isOtherObject;
}

bool
AreClose(const double * a, const double * b, int count, double tolerance)
{
  for (int i = 0; i < count; ++i)
  {
    if (!(std::abs(a[i] - b[i]) <= tolerance))
    {
      return false;
    }
  }
  return true;
}

/** False if both state a patient position and these differ. */
bool
AreOfOnePosition(const DicomFile & a, const DicomFile & b)
{
  return a.patientPosition == b.patientPosition || a.patientPosition.empty() || b.patientPosition.empty();
}

/** True for images of the same kind, regardless of patient and frame of reference. */
bool
AreOfOneKind(const Item & a, const Item & b)
{
  if (a.file->rows != b.file->rows || a.file->columns != b.file->columns || a.file->refusal != b.file->refusal ||
      !a.frame != !b.frame || !AreOfOnePosition(*a.file, *b.file))
  {
    return false;
  }
  if (!a.frame)
  {
    return true;
  }
  return a.frame->hasGeometry == b.frame->hasGeometry && a.frame->isLocalizer == b.frame->isLocalizer &&
         a.frame->pixels.hasRescale == b.frame->pixels.hasRescale && // otherwise units of slices would differ
         AreClose(a.frame->orientation, b.frame->orientation, 6, EqualCosineTolerance) &&
         AreClose(a.frame->spacing, b.frame->spacing, 2, PixelSpacingTolerance * a.frame->spacing[0]);
}

/** Groups of items in which each item matches the first one of its group. */
template <typename TBelong>
std::vector<Items>
GroupBy(const Items & items, const TBelong & belong)
{
  std::vector<Items> groups;
  for (const Item & item : items)
  {
    const auto group =
      std::find_if(groups.begin(), groups.end(), [&](const Items & other) { return belong(other.front(), item); });
    if (group == groups.end())
    {
      groups.push_back({ item });
    }
    else
    {
      group->push_back(item);
    }
  }
  return groups;
}

// ---- geometry of a group ----

/** An orthonormal frame from Image Orientation (Patient). */
itk::Matrix<double, 3, 3>
MakeDirection(const double (&orientation)[6])
{
  itk::Vector<double, 3> row(orientation);
  itk::Vector<double, 3> column(orientation + 3);
  row.Normalize();
  column -= row * (row * column);
  column.Normalize();
  const itk::Vector<double, 3> normal = itk::CrossProduct(row, column);
  itk::Matrix<double, 3, 3>    direction;
  for (unsigned int i = 0; i < 3; ++i)
  {
    direction(i, 0) = row[i];
    direction(i, 1) = column[i];
    direction(i, 2) = normal[i];
  }
  return direction;
}

double
Along(const itk::Matrix<double, 3, 3> & direction, unsigned int axis, const double (&position)[3])
{
  return direction(0, axis) * position[0] + direction(1, axis) * position[1] + direction(2, axis) * position[2];
}

void
SortAlongNormal(Items & items)
{
  const itk::Matrix<double, 3, 3> direction = MakeDirection(items.front().frame->orientation);
  std::sort(items.begin(), items.end(), [&direction](const Item & a, const Item & b) {
    const double positionA = Along(direction, 2, a.frame->position);
    const double positionB = Along(direction, 2, b.frame->position);
    if (positionA != positionB)
    {
      return positionA < positionB;
    }
    if (a.file->instanceNumber != b.file->instanceNumber)
    {
      return a.file->instanceNumber < b.file->instanceNumber;
    }
    return a.file != b.file ? a.file->path < b.file->path : a.number < b.number;
  });
}

std::vector<SlicePlace>
PlacesOf(const Items & sorted)
{
  const itk::Matrix<double, 3, 3> direction = MakeDirection(sorted.front().frame->orientation);
  const double(&origin)[3] = sorted.front().frame->position;
  std::vector<SlicePlace> places;
  for (const Item & item : sorted)
  {
    const double(&position)[3] = item.frame->position;
    const double step[3] = { position[0] - origin[0], position[1] - origin[1], position[2] - origin[2] };
    places.push_back({ Along(direction, 2, step), { Along(direction, 0, step), Along(direction, 1, step) } });
  }
  return places;
}

SlicesGeometry
ExamineItems(const Items & sorted)
{
  const double(&spacing)[2] = sorted.front().frame->spacing;
  const double pixelSpacing[2] = { spacing[1], spacing[0] };
  return ExamineSlices(PlacesOf(sorted), pixelSpacing);
}

/** True if two groups cover the same interval along the normal. */
bool
Overlap(const Items & a, const Items & b, double spacing)
{
  const itk::Matrix<double, 3, 3> direction = MakeDirection(a.front().frame->orientation);
  const double                    start =
    std::max(Along(direction, 2, a.front().frame->position), Along(direction, 2, b.front().frame->position));
  const double end =
    std::min(Along(direction, 2, a.back().frame->position), Along(direction, 2, b.back().frame->position));
  return end - start > 0.5 * spacing;
}

// ---- patients and frames of reference ----

/** True if two of the groups are complete volumes that cover the same interval. */
bool
HaveTwoVolumes(std::vector<Items> groups)
{
  for (auto group = groups.begin(); group != groups.end(); ++group)
  {
    SortAlongNormal(*group);
    const SlicesGeometry geometry = ExamineItems(*group);
    const bool           isVolume = group->size() > 2 && geometry.IsRegular();
    if (isVolume && std::any_of(groups.begin(), group, [&](const Items & other) {
          return other.size() > 2 && Overlap(other, *group, geometry.spacing);
        }))
    {
      return true;
    }
  }
  return false;
}

/** Groups items of one kind by patient and frame of reference; a single group if the differences are a flaw within one
 * volume. Two slices are not sufficient because any two are equidistant. */
std::vector<Items>
SplitByIdentity(Items items)
{
  std::vector<Items> groups = GroupBy(items, [](const Item & a, const Item & b) {
    return a.file->frameOfReferenceUID == b.file->frameOfReferenceUID && a.file->patientID == b.file->patientID;
  });
  const bool         isOneStudy = std::all_of(items.begin(), items.end(), [&items](const Item & item) {
    return item.file->studyUID == items.front().file->studyUID;
  });
  if (groups.size() > 1 && items.size() > 2 && isOneStudy && IsPartOfVolume(items.front()) && !HaveTwoVolumes(groups))
  {
    SortAlongNormal(items);
    if (ExamineItems(items).IsRegular())
    {
      return { items };
    }
  }
  return groups;
}

std::vector<Items>
SplitByGeometry(const Items & items)
{
  std::vector<Items> groups;
  for (const Items & kind : GroupBy(items, AreOfOneKind))
  {
    for (Items & group : SplitByIdentity(kind))
    {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

// ---- acquisitions ----

/** Items of one volume, and the attribute that distinguishes them from others of their kind. */
struct Part
{
  Items       items;
  std::string distinction;
};

/** Groups interleave if their slice distance is more than this many times that of all slices together. With two groups,
 * it is twice as large; positions jitter by a few percent. */
constexpr double CoarserGrid = 1.5;

/** The value of an attribute; an index past the last one returns all values together. */
std::string
ValueOf(const DicomFrame & frame, unsigned int key)
{
  return key < DicomFrame::NumberOfAcquisitionKeys
           ? frame.acquisition[key]
           : JoinDicomValues({ std::begin(frame.acquisition), std::end(frame.acquisition) });
}

bool
HaveOneValue(const Items & items, unsigned int key)
{
  return std::all_of(items.begin(), items.end(), [&](const Item & item) {
    return ValueOf(*item.frame, key) == ValueOf(*items.front().frame, key);
  });
}

/** "ConvolutionKernel B30f, FilterType 0": the attributes common to a group but not to all other groups. */
std::string
DistinctionOf(const Items & group, const Part & whole)
{
  std::string text = whole.distinction;
  for (unsigned int key = 0; key < DicomFrame::NumberOfAcquisitionKeys; ++key)
  {
    if (HaveOneValue(group, key) && !HaveOneValue(whole.items, key))
    {
      const std::string value = ValueOf(*group.front().frame, key);
      text +=
        (text.empty() ? "" : ", ") + DicomFrame::NameOfAcquisitionKey(key) + ' ' + (value.empty() ? "missing" : value);
    }
  }
  return text;
}

/** Groups by one attribute; empty if the attribute only numbers the steps of one scan. Separate volumes are regular
 * grids that cover the same positions or interleave. */
std::vector<Part>
SplitByKey(const Part & whole, const SlicesGeometry & geometry, unsigned int key)
{
  std::map<std::string, Items> byValue;
  for (const Item & item : whole.items)
  {
    byValue[ValueOf(*item.frame, key)].push_back(item);
  }
  std::vector<Part> parts;
  for (auto & entry : byValue)
  {
    Items & items = entry.second;
    SortAlongNormal(items);
    const SlicesGeometry own = ExamineItems(items);
    const auto           overlaps = [&](const Part & other) { return Overlap(other.items, items, own.spacing); };
    const bool           isApart = geometry.IsGrid() ? own.spacing > CoarserGrid * geometry.spacing
                                                     : parts.empty() || std::any_of(parts.begin(), parts.end(), overlaps);
    if (byValue.size() < 2 || items.size() < 2 || !own.IsGrid() || !isApart)
    {
      return {};
    }
    parts.push_back({ items, DistinctionOf(items, whole) });
  }
  return parts;
}

/** The volumes formed by items of one kind. */
std::vector<Part>
SplitByAcquisition(Part whole)
{
  SortAlongNormal(whole.items);
  const SlicesGeometry geometry = ExamineItems(whole.items);
  for (unsigned int key = 0; key <= DicomFrame::NumberOfAcquisitionKeys; ++key)
  {
    std::vector<Part> split;
    for (const Part & part : SplitByKey(whole, geometry, key))
    {
      for (Part & smaller : SplitByAcquisition(part))
      {
        split.push_back(std::move(smaller));
      }
    }
    if (!split.empty())
    {
      return split;
    }
  }
  return { whole };
}

// ---- defects ----

/** The indices of the items that satisfy a predicate. */
std::vector<unsigned int>
IndicesOf(const Items & items, const std::function<bool(const DicomFile &)> & isWanted)
{
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < items.size(); ++i)
  {
    if (isWanted(*items[i].file))
    {
      indices.push_back(i);
    }
  }
  return indices;
}

std::string
EncodingInWords(const std::string & transferSyntax)
{
  return transferSyntax.empty() ? "a header without an encoding (transfer syntax), "
                                : "the encoding " + transferSyntax + " is not supported, ";
}

/** Defects found in the headers of individual files. */
void
AddFileDefects(DicomSeries & series, const Items & items)
{
  const auto truncated = IndicesOf(items, [](const DicomFile & file) { return !file.truncation.empty(); });
  const auto malformed = IndicesOf(items, [](const DicomFile & file) { return !file.malformedValue.empty(); });
  const auto unsupported = IndicesOf(items, [](const DicomFile & file) { return file.isUnsupportedTransferSyntax; });
  if (!truncated.empty())
  {
    const std::string & reason = items[truncated.front()].file->truncation;
    AddDefect(series,
              DicomDefectKind::truncated,
              Count(truncated.size(), "slice") + (truncated.size() == 1 ? " is" : " are") +
                " truncated: " + NameOfSlice(series, truncated.front()) + ": " + reason,
              truncated);
  }
  if (!malformed.empty())
  {
    const DicomFile & file = *items[malformed.front()].file;
    AddDefect(series,
              DicomDefectKind::malformedValue,
              Count(malformed.size(), "file") + (malformed.size() == 1 ? " has" : " have") + " a malformed number: " +
                std::filesystem::path(file.path).filename().string() + ": " + file.malformedValue,
              malformed);
  }
  if (!unsupported.empty())
  {
    AddDefect(series,
              DicomDefectKind::unsupportedTransferSyntax,
              EncodingInWords(items[unsupported.front()].file->transferSyntax) +
                NameOfSlice(series, unsupported.front()),
              unsupported);
  }
}

/** Adds a remark if the slices of one volume differ in a member of their files; `names` is its name. */
void
RemarkOnIdentity(DicomSeries & series,
                 const Items & items,
                 std::string DicomFile::*member,
                 DicomDefectKind         kind,
                 const std::string &     names)
{
  std::set<std::string> values;
  for (const Item & item : items)
  {
    values.insert(item.file->*member);
  }
  if (values.size() > 1)
  {
    series.remarks.push_back(DefectOfSlices(series,
                                            kind,
                                            "the slices have " + std::to_string(values.size()) + " " + names +
                                              ", but are equidistant and treated as one volume",
                                            AllIndices(series)));
  }
}

void
ExamineGeometry(DicomSeries & series, const Items & items)
{
  const SlicesGeometry geometry = ExamineItems(items);
  series.spacing[2] = geometry.spacing;
  if (geometry.isSheared)
  {
    const auto places = PlacesOf(items);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      series.slices[i].offset[0] = places[i].offset[0];
      series.slices[i].offset[1] = places[i].offset[1];
    }
  }
  AddGeometryDefects(series, geometry);
}

// ---- series ----

std::string
JoinTransferSyntaxes(const Items & items)
{
  std::set<std::string> names;
  for (const Item & item : items)
  {
    names.insert(item.file->transferSyntax);
  }
  std::string joined;
  for (const std::string & name : names)
  {
    joined += (joined.empty() ? "" : ", ") + name;
  }
  return joined;
}

DicomSlice
MakeSlice(const Item & item)
{
  DicomSlice slice;
  slice.file = item.file->path;
  slice.frame = item.number;
  slice.isMultiFrame = item.file->isMultiFrame;
  slice.tilesPerRow = item.file->tilesPerRow;
  slice.sopClassUID = item.file->sopClassUID;
  slice.sopInstanceUID = item.file->sopInstanceUID;
  slice.instanceNumber = item.file->instanceNumber;
  if (item.frame)
  {
    slice.imagePosition = itk::Point<double, 3>(item.frame->position);
    slice.thickness = item.frame->thickness;
    slice.pixels = item.frame->pixels;
  }
  return slice;
}

void
DescribeSeries(DicomSeries & series, const Items & items)
{
  const DicomFile & file = *items.front().file;
  series.uid = file.seriesUID;
  series.studyUID = file.studyUID;
  series.frameOfReferenceUID = file.frameOfReferenceUID;
  series.number = file.seriesNumber;
  series.description = file.description;
  series.modality = file.modality;
  series.patientID = file.patientID;
  series.studyDate = file.studyDate;
  series.patientPosition = file.patientPosition;
  series.transferSyntax = JoinTransferSyntaxes(items);
  series.size[0] = file.columns;
  series.size[1] = file.rows;
  series.size[2] = static_cast<unsigned int>(items.size());
  series.refusal = file.refusal;
  series.direction.SetIdentity();
  for (const Item & item : items)
  {
    series.isLossy = series.isLossy || item.file->isLossy;
    series.isDerived = series.isDerived || item.file->isDerived;
    series.isInverted = series.isInverted || item.file->isInverted;
    series.size[2] += item.file->unplacedFrames;
    series.slices.push_back(MakeSlice(item));
  }
  if (file.isUndecodable)
  {
    series.remarks.push_back(
      DefectOfSlices(series,
                     DicomDefectKind::undecodableText,
                     "the Series Description contains bytes that are invalid in its character set, shown as '?'",
                     AllIndices(series)));
  }
}

DicomSeries
MakeSeries(const Part & part)
{
  Items      items = part.items;
  const bool hasGeometry = items.front().frame && items.front().frame->hasGeometry;
  if (hasGeometry)
  {
    SortAlongNormal(items);
  }
  DicomSeries series;
  series.distinction = part.distinction;
  DescribeSeries(series, items);
  AddFileDefects(series, items);
  if (!hasGeometry)
  {
    return series;
  }
  const DicomFrame & frame = *items.front().frame;
  series.direction = MakeDirection(frame.orientation);
  series.spacing[0] = frame.spacing[1];
  series.spacing[1] = frame.spacing[0];
  const auto places = PlacesOf(items);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    series.slices[i].position = places[i].position;
  }
  RemarkOnIdentity(
    series, items, &DicomFile::frameOfReferenceUID, DicomDefectKind::mixedFrameOfReference, "frames of reference");
  RemarkOnIdentity(series, items, &DicomFile::patientID, DicomDefectKind::mixedPatient, "patients");
  if (frame.isLocalizer)
  {
    AddDefect(series, DicomDefectKind::localizer, "planning images (localizer), not a volume", AllIndices(series));
  }
  else if (series.refusal.empty())
  {
    ExamineGeometry(series, items);
  }
  if (items.size() == 1 && series.refusal.empty())
  {
    series.isSingleSlice = true;
    series.refusal = "a single slice";
  }
  return series;
}

std::string
Extent(const DicomSeries & series)
{
  return std::to_string(series.size[0]) + "x" + std::to_string(series.size[1]) + "x" + std::to_string(series.size[2]);
}

/** True for an image that accompanies the volume of a series but is not part of it. */
bool
IsBesideTheVolume(const DicomSeries & part)
{
  return part.Has(DicomDefectKind::localizer) || (!part.refusal.empty() && !part.isSingleSlice);
}

std::string
ListParts(const std::vector<DicomSeries> & parts)
{
  constexpr std::size_t longestList = 4;
  std::string           list;
  for (std::size_t i = 0; i < parts.size() && i < longestList; ++i)
  {
    const std::string & distinction = parts[i].distinction;
    list += (i > 0 ? ", #" : "#") + std::to_string(i + 1) + " " + Extent(parts[i]) +
            (distinction.empty() ? "" : " (" + distinction + ")");
  }
  return parts.size() > longestList ? list + ", ..." : list;
}

/** Reason why the parts of a series do not form one volume. */
std::string
MixtureOf(const std::vector<DicomSeries> & parts)
{
  const std::string number = std::to_string(parts.size());
  const bool        areSlices =
    std::all_of(parts.begin(), parts.end(), [](const DicomSeries & part) { return part.isSingleSlice; });
  return areSlices
           ? "one Series Instance UID contains " + number +
               " slices that do not form a volume: they differ in patient, frame of reference, orientation or size, "
               "and are not equidistant"
           : "one Series Instance UID contains images of " + number +
               " kinds (columns x rows x slices): " + ListParts(parts);
}

/** Numbers the groups of one series; a series with several groups that may be volumes is mixed. */
void
NumberParts(std::vector<DicomSeries> & parts, unsigned int volumes)
{
  std::stable_sort(
    parts.begin(), parts.end(), [](const DicomSeries & a, const DicomSeries & b) { return a.size[2] > b.size[2]; });
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    parts[i].part = i + 1;
    parts[i].parts = static_cast<unsigned int>(parts.size());
    if (volumes > 1 && !IsBesideTheVolume(parts[i]))
    {
      AddDefect(parts[i], DicomDefectKind::mixedSeries, MixtureOf(parts), AllIndices(parts[i]));
    }
  }
}

/** A file without a known position may be a slice of any volume of its series, so all volumes may be incomplete. */
void
SpreadMalformedValues(std::vector<DicomSeries> & parts)
{
  std::vector<DicomDefect> found;
  for (const DicomSeries & part : parts)
  {
    std::copy_if(part.defects.begin(), part.defects.end(), std::back_inserter(found), [](const DicomDefect & defect) {
      return defect.kind == DicomDefectKind::malformedValue;
    });
  }
  for (DicomSeries & part : parts)
  {
    for (const DicomDefect & defect : found)
    {
      if (!part.Has(DicomDefectKind::malformedValue) && !IsBesideTheVolume(part))
      {
        part.defects.push_back({ defect.kind, defect.message, defect.files, {} });
      }
    }
  }
}

std::vector<DicomSeries>
MakeSeriesOfUID(const Items & items)
{
  std::vector<DicomSeries> parts;
  unsigned int             volumes = 0;
  for (const Items & group : SplitByGeometry(items))
  {
    const bool isPart = IsPartOfVolume(group.front());
    for (const Part & part : isPart ? SplitByAcquisition({ group, {} }) : std::vector<Part>{ { group, {} } })
    {
      parts.push_back(MakeSeries(part));
      volumes += isPart ? 1 : 0;
    }
  }
  SpreadMalformedValues(parts);
  NumberParts(parts, volumes);
  return parts;
}

void
AddOtherFile(const DicomFile & file, DicomScan & scan)
{
  const std::string name = std::filesystem::path(file.path).filename().string();
  switch (file.kind)
  {
    case DicomFile::Kind::damaged:
      scan.otherFiles.push_back({ DicomDefectKind::truncated, name + ": " + file.what, { file.path }, {} });
      break;
    case DicomFile::Kind::notImage:
      ++scan.otherObjects[file.what];
      scan.otherFiles.push_back(
        { DicomDefectKind::notAnImage, name + ": DICOM without a slice image (" + file.what + ")", { file.path }, {} });
      break;
    default:
      scan.otherFiles.push_back({ DicomDefectKind::notAnImage, name + ": not a DICOM file", { file.path }, {} });
  }
}

void
CollectSeries(std::vector<DicomFile> files, DicomScan & scan)
{
  const auto                   copies = TakeCopies(files);
  std::map<std::string, Items> byUID;
  for (const DicomFile & file : files)
  {
    if (file.kind != DicomFile::Kind::image)
    {
      AddOtherFile(file, scan);
      continue;
    }
    Items & items = byUID[file.seriesUID];
    for (unsigned int i = 0; i < file.frames.size(); ++i)
    {
      items.push_back({ &file, &file.frames[i], i });
    }
    if (file.frames.empty())
    {
      items.push_back({ &file, nullptr, 0 });
    }
  }
  for (const auto & entry : byUID)
  {
    for (DicomSeries & series : MakeSeriesOfUID(entry.second))
    {
      RemarkOnCopies(copies, series);
      scan.series.push_back(std::move(series));
    }
  }
  std::stable_sort(scan.series.begin(), scan.series.end(), [](const DicomSeries & a, const DicomSeries & b) {
    return a.number < b.number;
  });
}
} // namespace

ContainedService
MakeDicomHeaderService()
{
  PrepareDicomParsing();
  return [](const std::string & path, char *) {
    ByteWriter      writer;
    const DicomFile file = ParseDicomFile(path);
    Transmit(writer, file);
    return writer.GetBytes();
  };
}

std::string
DicomSeries::GetSelector() const
{
  return parts > 1 ? uid + "#" + std::to_string(part) : uid;
}

bool
DicomSeries::Has(DicomDefectKind kind) const
{
  return std::any_of(
    defects.begin(), defects.end(), [kind](const DicomDefect & defect) { return defect.kind == kind; });
}

DicomScan
ScanDicom(const std::string & path, const Progress & progress)
{
  DicomScan scan;
  scan.path = path;
  const auto paths = ListFiles(path);
  if (paths.empty())
  {
    throw InputError(path + ": the folder is empty; use the folder that contains the DICOM files");
  }
  scan.files = static_cast<unsigned int>(paths.size());
  CollectSeries(ParseFiles(paths, progress), scan);
  return scan;
}
} // namespace shapeton
