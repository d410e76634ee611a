#include "shapetonDicomExamination.h"

#include "shapetonExceptions.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonReadImage.h"
#include "shapetonRunRecords.h"
#include "shapetonStageRecord.h"

#include "itkNrrdImageIO.h"

namespace shapeton
{
namespace
{
constexpr const char * toolOfDicom = "ColonResultsToDicom";

void
RequireCurrent(const DicomExamination & exam, const ExaminationFile & file)
{
  RunRecords(exam.folder.GetFolder()).RequireCurrent(file.stage, file.name);
}

DicomLabelImage::Pointer
ReadLabels(const std::string & path)
{
  return ReadImage<DicomLabelImage>(path, itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
}

/** Checks the series that the run read: its UID, and the digest of its files. */
void
TakeSource(DicomExamination & exam)
{
  const std::string folder = exam.folder.GetFolder();
  const auto        record = ReadStageRecord(RecordPathOf(exam.folder.PathOf(examination::lumen)));
  exam.digest = record ? record->IdentityOfInput() : "";
  exam.seriesUID = SeriesOfQuality(exam.quality);
  if (exam.seriesUID.empty() || exam.digest.empty())
  {
    throw InputError("the examination \"" + folder +
                     "\" was not computed from a DICOM series, but DICOM results must reference one; run "
                     "VirtualColonoscopy on the series");
  }
}

void
TakeFolds(DicomExamination & exam)
{
  if (exam.Has(examination::foldLabels, "no folds") && exam.Has(examination::flat, "no folds"))
  {
    exam.flat = exam.folder.ReadSurfaceOf(examination::flat);
    exam.folds = FoldsOfFaces(exam.flat, *exam.folder.ReadFolds());
  }
}

void
TakeWarnings(DicomExamination & exam)
{
  const RunRecords records(exam.folder.GetFolder());
  for (const char * const stage : { colonoscopystage::segmentation,
                                    colonoscopystage::flattening,
                                    colonoscopystage::landmarks,
                                    colonoscopystage::folds,
                                    colonoscopystage::polyps })
  {
    for (const std::string & warning : records.WarningsOf(stage))
    {
      exam.warnings.push_back(std::string(stage) + ": " + warning);
    }
  }
}

void
TakeCandidates(DicomExamination & exam)
{
  if (exam.Has(examination::candidates, "no candidates"))
  {
    exam.isSearched = true;
    exam.candidates = exam.folder.ReadCandidates();
    if (exam.Has(examination::heads, "candidates have no segment; run VirtualColonoscopy again"))
    {
      exam.heads = ReadLabels(exam.folder.PathOf(examination::heads));
    }
  }
}
} // namespace

DicomExamination::DicomExamination(ExaminationFolder itsFolder) : folder(std::move(itsFolder)) {}

bool
DicomExamination::Has(const ExaminationFile & file, const std::string & what)
{
  if (!folder.Has(file))
  {
    missing.push_back("the examination lacks " + file.Path() + ": " + what);
    return false;
  }
  RequireCurrent(*this, file);
  return true;
}

std::string
DicomExamination::Required(const ExaminationFile & file) const
{
  const std::string path = folder.Required(file);
  RequireCurrent(*this, file);
  return path;
}

DicomExamination
ReadDicomExamination(const std::string & folder)
{
  DicomExamination exam(ExaminationFolder(folder, toolOfDicom));
  exam.Required(examination::quality);
  exam.quality = exam.folder.ReadQuality();
  TakeSource(exam);
  exam.lumen = ReadLabels(exam.Required(examination::lumen));
  exam.Required(examination::centerline);
  exam.centerline = exam.folder.ReadCenterline();
  if (exam.Has(examination::landmarks, "no segments of the colon"))
  {
    exam.segments = exam.folder.ReadSegments();
  }
  TakeFolds(exam);
  TakeCandidates(exam);
  TakeWarnings(exam);
  return exam;
}
} // namespace shapeton
