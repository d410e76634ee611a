#include "shapetonColonExamination.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonPolypSearch.h"
#include "shapetonReadImage.h"
#include "shapetonRunRecords.h"
#include "shapetonSurfaceReader.h"
#include "shapetonVolume.h"

#include "itkNrrdImageIO.h"

#include <filesystem>

namespace shapeton
{
namespace
{
void
RequireCurrent(const ColonExamination & exam, const std::string & name)
{
  const auto slash = name.find('/');
  RunRecords(exam.folder).RequireCurrent(name.substr(0, slash), name.substr(slash + 1));
}

DicomLabelImage::Pointer
ReadLabels(const std::string & path)
{
  return ReadImage<DicomLabelImage>(path, itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
}

/** Checks the series that the run read: its UID, and the digest of its files. */
void
TakeSource(ColonExamination & exam)
{
  const std::string identity = exam.quality.value("/provenance/input.inputVolume"_json_pointer, std::string());
  const Json        record = ReadJson(exam.PathOf("stages/segmentation.json"));
  exam.digest = record.value("/signature/arguments/0/1"_json_pointer, std::string());
  exam.seriesUID = SeriesOfIdentity(identity);
  if (exam.seriesUID.empty() || exam.digest.empty())
  {
    throw InputError("the examination \"" + exam.folder +
                     "\" was not computed from a DICOM series, but DICOM results must reference one; run "
                     "VirtualColonoscopy on the series");
  }
}

double
LengthOf(const CurveSet & centerline, const std::string & path)
{
  return PointValues(centerline, "arcLength", path).maxCoeff();
}

void
TakeFolds(ColonExamination & exam)
{
  if (exam.Has("folds/labels.nrrd", "no folds") && exam.Has("flattening/flat.vtp", "no folds"))
  {
    exam.flat = ReadSurfaceFile(exam.PathOf("flattening/flat.vtp")).mesh;
    exam.folds = FoldsOfFaces(exam.flat, *ReadFoldLabels(exam.PathOf("folds/labels.nrrd")));
  }
}

void
TakeWarnings(ColonExamination & exam)
{
  const RunRecords records(exam.folder);
  for (const std::string stage : { "segmentation", "flattening", "landmarks", "folds", "polyps" })
  {
    for (const std::string & warning : records.WarningsOf(stage))
    {
      exam.warnings.push_back(stage + ": " + warning);
    }
  }
}

void
TakeCandidates(ColonExamination & exam)
{
  if (exam.Has("polyps/candidates.csv", "no candidates"))
  {
    exam.isSearched = true;
    exam.candidates = ReadPolypCandidates(exam.PathOf("polyps/candidates.csv"));
    if (exam.Has("polyps/heads.nrrd", "candidates have no segment; run VirtualColonoscopy again"))
    {
      exam.heads = ReadLabels(exam.PathOf("polyps/heads.nrrd"));
    }
  }
}
} // namespace

bool
ColonExamination::Has(const std::string & name, const std::string & what)
{
  if (!std::filesystem::exists(this->PathOf(name)))
  {
    missing.push_back("the examination lacks " + name + ": " + what);
    return false;
  }
  RequireCurrent(*this, name);
  return true;
}

std::string
ColonExamination::Required(const std::string & name) const
{
  if (!std::filesystem::exists(this->PathOf(name)))
  {
    throw InputError("the examination lacks \"" + this->PathOf(name) + "\"; let VirtualColonoscopy finish it");
  }
  RequireCurrent(*this, name);
  return this->PathOf(name);
}

ColonExamination
ReadColonExamination(const std::string & folder)
{
  RequireCurrentFileNames(folder);
  ColonExamination exam;
  exam.folder = folder;
  exam.quality = ReadJson(exam.Required("segmentation/quality.json"));
  TakeSource(exam);
  exam.lumen = ReadLabels(exam.Required("segmentation/lumen.nrrd"));
  const std::string centerline = exam.Required("segmentation/centerline.vtp");
  exam.centerline = ReadCurves(centerline);
  if (exam.Has("landmarks/landmarks.json", "no segments of the colon"))
  {
    exam.segments =
      SegmentsOf(ReadJson(exam.PathOf("landmarks/landmarks.json")), LengthOf(exam.centerline, centerline));
  }
  TakeFolds(exam);
  TakeCandidates(exam);
  TakeWarnings(exam);
  return exam;
}
} // namespace shapeton
