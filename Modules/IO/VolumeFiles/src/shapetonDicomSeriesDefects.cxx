#include "shapetonDicomSeriesDefects.h"

#include "shapetonDicomPixels.h"
#include "shapetonDicomVolume.h"
#include "shapetonNumberText.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <numeric>

namespace shapeton
{
namespace
{
std::string
Millimeters(double value)
{
  return NumberText(value) + " mm";
}

bool
HaveEqualPixels(const DicomSeries & series, const SlicesGeometry::Duplicate & duplicate)
{
  std::vector<const DicomSlice *> slices;
  for (unsigned int i = 0; i < duplicate.count; ++i)
  {
    slices.push_back(&series.slices[duplicate.first + i]);
  }
  const std::size_t  pixels = std::size_t(series.size[0]) * series.size[1];
  std::vector<float> first(pixels);
  std::vector<float> other(pixels);
  ReadDicomSlices({ slices[0] }, series.size[0], series.size[1], first.data());
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    ReadDicomSlices({ slices[i] }, series.size[0], series.size[1], other.data());
    if (std::memcmp(first.data(), other.data(), pixels * sizeof(float)) != 0)
    {
      return false;
    }
  }
  return true;
}

/** Unreadable pixels are not considered equal. */
bool
AreIdentical(const DicomSeries & series, const SlicesGeometry::Duplicate & duplicate)
{
  try
  {
    return HaveEqualPixels(series, duplicate);
  }
  catch (const InputError &)
  {
    return false;
  }
}

void
AddDuplicates(DicomSeries & series, const SlicesGeometry & geometry)
{
  const bool isReadable =
    !series.Has(DicomDefectKind::unsupportedTransferSyntax) && !series.Has(DicomDefectKind::truncated);
  std::vector<unsigned int> indices[2];
  unsigned int              positions[2] = { 0, 0 };
  for (const auto & duplicate : geometry.duplicates)
  {
    const int kind = isReadable && AreIdentical(series, duplicate) ? 0 : 1;
    ++positions[kind];
    for (unsigned int i = 0; i < duplicate.count; ++i)
    {
      indices[kind].push_back(duplicate.first + i);
    }
  }
  const char * endings[] = { " with equal pixels, the first: ", " with different pixels, the first: " };
  for (const int kind : { 0, 1 })
  {
    if (!indices[kind].empty())
    {
      AddDefect(series,
                kind == 0 ? DicomDefectKind::duplicateIdentical : DicomDefectKind::duplicateConflicting,
                Count(positions[kind], "position") + " with several slices" + endings[kind] +
                  NameOfSlice(series, indices[kind][0]) + " and " + NameOfSlice(series, indices[kind][1]),
                indices[kind]);
    }
  }
}

bool
MayBeResampled(const DicomSeries & series, const SlicesGeometry & geometry)
{
  std::size_t positions = series.slices.size();
  for (const auto & duplicate : geometry.duplicates)
  {
    positions -= duplicate.count - 1;
  }
  return CanBeResampled(positions, series.slices.back().position, geometry.spacing);
}

void
AddGaps(DicomSeries & series, const SlicesGeometry & geometry)
{
  if (geometry.gaps.empty())
  {
    return;
  }
  std::vector<unsigned int> indices;
  std::size_t               missing = 0;
  for (const auto & gap : geometry.gaps)
  {
    missing += gap.missing;
    indices.push_back(gap.before);
    indices.push_back(gap.after);
  }
  std::string message = Count(missing, "slice") + (missing == 1 ? " is" : " are") + " missing";
  message += geometry.gaps.size() > 1 ? " in " + Count(geometry.gaps.size(), "gap") + ", the first" : "";
  AddDefect(series,
            DicomDefectKind::gap,
            message + " between " + NameOfSlice(series, indices[0]) + " and " + NameOfSlice(series, indices[1]),
            indices);
  series.defects.back().isRepairable = MayBeResampled(series, geometry);
}

void
AddVariableSpacing(DicomSeries & series, const SlicesGeometry & geometry)
{
  if (!geometry.isVariable)
  {
    return;
  }
  double lowest = series.slices.back().position;
  double highest = 0;
  for (std::size_t i = 1; i < series.slices.size(); ++i)
  {
    const double distance = series.slices[i].position - series.slices[i - 1].position;
    if (distance > PositionTolerance(geometry.spacing))
    {
      lowest = std::min(lowest, distance);
      highest = std::max(highest, distance);
    }
  }
  AddDefect(series,
            DicomDefectKind::variableSpacing,
            "the distance between slices varies from " + Millimeters(lowest) + " to " + Millimeters(highest) +
              ", first at " + NameOfSlice(series, geometry.unusual.front()),
            geometry.unusual);
  series.defects.back().isRepairable = MayBeResampled(series, geometry);
}

void
AddShear(DicomSeries & series, const SlicesGeometry & geometry)
{
  if (!geometry.isSheared)
  {
    return;
  }
  AddDefect(series,
            DicomDefectKind::shear,
            geometry.isLinearShear ? "the line through the slices is tilted relative to their normal by " +
                                       NumberText(geometry.tiltDegrees, 3) + " degrees (gantry tilt)"
                                   : std::string("the slices are displaced relative to one another within "
                                                 "their planes"),
            AllIndices(series));
  series.defects.back().isRepairable = PlaneOfSlices(series, series.slices).growth <= LargestGrowth;
}
} // namespace

const char *
GetDicomDefectName(DicomDefectKind kind)
{
  switch (kind)
  {
    case DicomDefectKind::duplicateIdentical:
      return "duplicateIdentical";
    case DicomDefectKind::duplicateConflicting:
      return "duplicateConflicting";
    case DicomDefectKind::gap:
      return "gap";
    case DicomDefectKind::variableSpacing:
      return "variableSpacing";
    case DicomDefectKind::shear:
      return "shear";
    case DicomDefectKind::localizer:
      return "localizer";
    case DicomDefectKind::mixedSeries:
      return "mixedSeries";
    case DicomDefectKind::truncated:
      return "truncated";
    case DicomDefectKind::unsupportedTransferSyntax:
      return "unsupportedTransferSyntax";
    case DicomDefectKind::mixedFrameOfReference:
      return "mixedFrameOfReference";
    case DicomDefectKind::mixedPatient:
      return "mixedPatient";
    case DicomDefectKind::malformedValue:
      return "malformedValue";
    case DicomDefectKind::undecodableText:
      return "undecodableText";
    case DicomDefectKind::copiedFile:
      return "copiedFile";
    default:
      return "notAnImage";
  }
}

const char *
GetDicomDefectAdvice(const DicomDefect & defect)
{
  if (!defect.isRepairable)
  {
    return defect.kind == DicomDefectKind::shear
             ? "the slices are displaced too far to be resampled; choose another series"
             : "the gaps are too wide to be interpolated; copy the missing files from their source";
  }
  switch (defect.kind)
  {
    case DicomDefectKind::duplicateIdentical:
    case DicomDefectKind::duplicateConflicting:
      return "the parameter \"dropDuplicates\" keeps the first slice of each position";
    case DicomDefectKind::gap:
    case DicomDefectKind::variableSpacing:
      return "the parameter \"resampleGaps\" interpolates";
    case DicomDefectKind::shear:
      return "the parameter \"deshear\" resamples onto perpendicular axes";
    case DicomDefectKind::mixedSeries:
      return "choose one part by the parameter \"seriesUID\" = UID#PART";
    case DicomDefectKind::mixedFrameOfReference:
      return "if the series was combined from several, check that no part is displaced";
    case DicomDefectKind::mixedPatient:
      return "check that all slices belong to one person";
    case DicomDefectKind::malformedValue:
      return "write these numbers as DICOM Decimal Strings, with a decimal point, or export the series again";
    case DicomDefectKind::undecodableText:
    case DicomDefectKind::copiedFile:
      return "the images are not affected";
    case DicomDefectKind::localizer:
      return "choose a series with a volume";
    case DicomDefectKind::unsupportedTransferSyntax:
      return "convert the files to an uncompressed or JPEG encoding";
    default:
      return "copy the files from their source again";
  }
}

std::string
Count(std::size_t count, const std::string & noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string
NameOfSlice(const DicomSeries & series, unsigned int index)
{
  const DicomSlice & slice = series.slices[index];
  std::string        name =
    "slice " + std::to_string(index + 1) + " (" + std::filesystem::path(slice.file).filename().string();
  return name + (slice.frame > 0 ? ", frame " + std::to_string(slice.frame + 1) : "") + ")";
}

std::vector<unsigned int>
AllIndices(const DicomSeries & series)
{
  std::vector<unsigned int> indices(series.slices.size());
  std::iota(indices.begin(), indices.end(), 0U);
  return indices;
}

DicomDefect
DefectOfSlices(const DicomSeries &               series,
               DicomDefectKind                   kind,
               const std::string &               message,
               const std::vector<unsigned int> & indices)
{
  DicomDefect defect{ kind, message, {}, {} };
  for (const unsigned int index : indices)
  {
    const std::string & file = series.slices[index].file;
    if (defect.files.empty() || defect.files.back() != file)
    {
      defect.files.push_back(file);
    }
    defect.slices.push_back(index + 1);
  }
  return defect;
}

void
AddDefect(DicomSeries &                     series,
          DicomDefectKind                   kind,
          const std::string &               message,
          const std::vector<unsigned int> & indices)
{
  series.defects.push_back(DefectOfSlices(series, kind, message, indices));
}

std::size_t
LengthOfSingles(const std::vector<const DicomSeries *> & list, std::size_t first)
{
  std::size_t end = first + 1;
  while (end < list.size() && list[first]->isSingleSlice && list[end]->isSingleSlice &&
         list[end]->uid == list[first]->uid)
  {
    ++end;
  }
  return end - first;
}

void
AddGeometryDefects(DicomSeries & series, const SlicesGeometry & geometry)
{
  AddDuplicates(series, geometry);
  AddGaps(series, geometry);
  AddVariableSpacing(series, geometry);
  AddShear(series, geometry);
}
} // namespace shapeton
