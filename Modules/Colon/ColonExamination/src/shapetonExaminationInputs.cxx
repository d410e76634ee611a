#include "shapetonExaminationInputs.h"

#include "shapetonExceptions.h"
#include "shapetonFlatColon.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonParallelFor.h"
#include "shapetonRunRecords.h"
#include "shapetonSha256.h"

namespace shapeton
{
namespace
{
/** Reads an optional surface. If the file is missing, warns about the consequences and returns an empty surface. */
SurfaceMesh
ReadPart(const ExaminationFolder & exam,
         const ExaminationFile &   file,
         const std::string &       name,
         const std::string &       cost,
         PolypColon &              colon)
{
  const std::string path = exam.PathOf(file);
  if (!exam.Has(file))
  {
    colon.warnings.push_back("\"" + path + "\" was not found: " + cost);
    return {};
  }
  colon.facts.emplace_back(name, "sha256:" + Sha256OfFile(path));
  return exam.ReadSurfaceOf(file);
}

Eigen::VectorXd
ReadCurvature(const ExaminationFolder & exam, const SurfaceMesh & flat)
{
  const std::string          path = exam.Required(examination::foldsSurface);
  const SurfaceMesh          surface = exam.ReadSurfaceOf(examination::foldsSurface);
  const SurfaceArray * const curvature = FindSurfaceArray(surface.pointArrays, "meanCurvature");
  if (!curvature || curvature->values.cols() != 1)
  {
    throw InputError('"' + path + "\" has no point array meanCurvature; give the file written by ColonLandmarks");
  }
  if (surface.V.rows() != flat.V.rows() || surface.F.rows() != flat.F.rows())
  {
    throw InputError('"' + path + "\" does not match the flat surface; run VirtualColonoscopy again");
  }
  return curvature->values.col(0);
}

void
ReadLandmarksOf(const ExaminationFolder & exam, ColonPositionFiles & files)
{
  const Json document = exam.ReadLandmarks();
  const auto flexures = FlexuresOf(document);
  for (std::size_t i = 0; i < flexures.size(); ++i)
  {
    files.position.flexures[i] = flexures[i].arcLength;
    files.position.flexureConfidence[i] = flexures[i].confidence;
  }
  const std::string     path = '"' + exam.PathOf(examination::centerline) + '"';
  const Eigen::VectorXd arcLength = PointValues(files.position.centerline, "arcLength", path);
  files.segments = SegmentsOf(document, arcLength.maxCoeff());
  if (exam.Has(examination::taeniae))
  {
    files.position.taeniae = exam.ReadCurvesOf(examination::taeniae);
  }
  else
  {
    files.warnings.push_back(files.position.name +
                             ": no taeniae were found there, so all rotations are tried; mark some points on them "
                             "(parameter \"markers\" of VirtualColonoscopy) for a more reliable result");
  }
}

/** Warns if the patient position stored with the lumen suggests that the examinations are swapped. */
void
WarnOfPosition(const ExaminationFolder & exam, ColonPositionFiles & files)
{
  if (!exam.Has(examination::quality))
  {
    return;
  }
  const Json        quality = exam.ReadQuality();
  const std::string position = PositionOfQuality(quality);
  const std::string name = files.position.name;
  const bool        isOpposite = (name == "supine" && position == "prone") || (name == "prone" && position == "supine");
  if (isOpposite && IsPositionKnown(quality))
  {
    files.warnings.push_back(name + ": the patient position of this examination is " + position +
                             "; the two may be swapped");
  }
}

/** Identity of the files that a registration depends on, regardless of their location. */
std::string
IdentityOfPosition(const ExaminationFolder & exam)
{
  using namespace examination;
  std::string identities;
  for (const ExaminationFile & file : { centerline, flat, landmarks, taeniae, foldsSurface, foldTable })
  {
    if (exam.Has(file))
    {
      identities += std::string(file.name) + ' ' + Sha256OfFile(exam.PathOf(file)) + '\n';
    }
  }
  return "sha256:" + Sha256OfBytes(identities);
}
/** Rejects the folder of an interrupted or failed run, which may mix results of two. */
void
RequireCurrent(const ExaminationFolder & exam)
{
  for (const char * const stage : { colonoscopystage::landmarks, colonoscopystage::folds })
  {
    RunRecords(exam.GetFolder()).RequireCurrent(stage);
  }
}
} // namespace

PolypColon
ReadPolypColon(const ExaminationFolder & exam)
{
  using namespace examination;
  RequireCurrent(exam);
  PolypColon colon;
  exam.Required(repairedWall);
  exam.Required(lumen);
  WorkBeside readsWall = StartBeside([&] { colon.wall = ReadPart(exam, repairedWall, "wall", "", colon); });
  colon.lumen = exam.ReadLumen();
  colon.ct = exam.ReadCleansedCt();
  colon.original = exam.ReadOriginalCt(colon.ct);
  readsWall.Get();
  colon.centerline = exam.Has(centerline) ? exam.ReadCenterline() : CurveSet();
  colon.catheter = exam.Has(catheter) ? exam.ReadCurvesOf(catheter) : CurveSet();
  SurfaceMesh flatWall = ReadPart(exam, flat, "flat", "candidates have neither a map position nor a picture", colon);
  if (flatWall.NumberOfFaces() > 0)
  {
    colon.flat = std::make_shared<FlatColon>(std::move(flatWall));
  }
  colon.folds = exam.ReadFolds();
  colon.segments = ReadPart(exam, segments, "segments", "segments are not named", colon);
  return colon;
}

ColonPositionFiles
ReadColonPosition(const ExaminationFolder & exam, const std::string & name)
{
  RequireCurrent(exam);
  ColonPositionFiles files;
  ColonPosition &    position = files.position;
  position.name = name;
  position.centerline = exam.ReadCenterline();
  position.flat = exam.ReadFlatColon();
  position.flat->Grid(); // rejects a surface that is not flat before reading other files
  ReadLandmarksOf(exam, files);
  position.curvature = ReadCurvature(exam, position.flat->Surface());
  position.folds = ReadFoldTable(exam.Required(examination::foldTable));
  position.isExcluded = FindExcludedColumns(*position.flat, position.centerline);
  WarnOfPosition(exam, files);
  files.identity = IdentityOfPosition(exam);
  return files;
}
} // namespace shapeton
