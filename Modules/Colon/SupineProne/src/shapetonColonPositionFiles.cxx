#include "shapetonColonPositionFiles.h"

#include "shapetonHaustralFoldFiles.h"
#include "shapetonJson.h"
#include "shapetonSha256.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Reads the files of an examination folder. */
class Examination
{
public:
  Examination(const std::string & folder, const std::string & name) : m_Folder(folder), m_Name(name)
  {
    if (!fs::is_directory(folder))
    {
      throw InputError(name + ": the folder \"" + folder + "\" was not found; give one written by VirtualColonoscopy");
    }
    RequireCurrentFileNames(folder);
  }

  bool
  Has(const std::string & stage, const std::string & file) const
  {
    return fs::is_regular_file(this->PathOf(stage, file));
  }

  /** The path of a required file. */
  std::string
  Take(const std::string & stage, const std::string & file, const std::string & tool)
  {
    if (!this->Has(stage, file))
    {
      throw InputError(m_Name + ": \"" + this->PathOf(stage, file) + "\" is missing; run VirtualColonoscopy into \"" +
                       m_Folder + "\", whose stage " + stage + " (" + tool + ") writes it");
    }
    m_Identities += file + ' ' + Sha256OfFile(this->PathOf(stage, file)) + '\n';
    return this->PathOf(stage, file);
  }

  std::string
  Identity() const
  {
    return "sha256:" + Sha256OfBytes(m_Identities);
  }

  std::string
  PathOf(const std::string & stage, const std::string & file) const
  {
    return (fs::path(m_Folder) / stage / file).string();
  }

private:
  std::string m_Folder;
  std::string m_Name;
  std::string m_Identities;
};

Eigen::VectorXd
CurvatureOf(const SurfaceMesh & surface, const SurfaceMesh & flat, const std::string & path)
{
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
ReadLandmarks(Examination & examination, ColonPositionFiles & files)
{
  const Json document = ReadJson(examination.Take("landmarks", "landmarks.json", "ColonLandmarks"));
  const auto flexures = FlexuresOf(document);
  for (std::size_t i = 0; i < flexures.size(); ++i)
  {
    files.position.flexures[i] = flexures[i].arcLength;
    files.position.flexureConfidence[i] = flexures[i].confidence;
  }
  const Eigen::VectorXd arcLength = PointValues(files.position.centerline, "arcLength", files.position.name);
  files.segments = SegmentsOf(document, arcLength.maxCoeff());
  if (examination.Has("landmarks", "taeniae.vtp"))
  {
    files.position.taeniae = ReadCurves(examination.Take("landmarks", "taeniae.vtp", "ColonLandmarks"));
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
WarnOfPosition(const Examination & examination, ColonPositionFiles & files)
{
  if (!examination.Has("segmentation", "quality.json"))
  {
    return;
  }
  const Json document = ReadJson(examination.PathOf("segmentation", "quality.json"));
  const auto said = [&](const char * place) {
    const Json::json_pointer pointer(place);
    return document.contains(pointer) && document.at(pointer).is_string() ? document.at(pointer).get<std::string>()
                                                                          : "";
  };
  const std::string position = said("/lumen/position");
  const std::string name = files.position.name;
  const bool        isOpposite = (name == "supine" && position == "prone") || (name == "prone" && position == "supine");
  if (isOpposite && said("/lumen/gravitySource") != "assumed")
  {
    files.warnings.push_back(name + ": the patient position of this examination is " + position +
                             "; the two may be swapped");
  }
}
} // namespace

ColonPositionFiles
ReadColonPosition(const std::string & folder, const std::string & name)
{
  Examination        examination(folder, name);
  ColonPositionFiles files;
  ColonPosition &    position = files.position;
  position.name = name;
  position.centerline = ReadCurves(examination.Take("segmentation", "centerline.vtp", "ColonSegmentation"));
  RequireSound(position.centerline, name + ": the centerline");
  const std::string flatPath = examination.Take("flattening", "flat.vtp", "ColonFlattening");
  position.flat = std::make_shared<FlatColon>(ReadSurface(flatPath).mesh, FlatColonGridOptions{}, '"' + flatPath + '"');
  position.flat->Grid(); // rejects a surface that is not flat before reading other files
  ReadLandmarks(examination, files);
  const std::string foldsPath = examination.Take("landmarks", "folds-surface.vtp", "ColonLandmarks");
  position.curvature = CurvatureOf(ReadSurface(foldsPath).mesh, position.flat->Surface(), foldsPath);
  position.folds = ReadFoldTable(examination.Take("folds", "folds.csv", "ColonFolds"));
  position.isExcluded = FindExcludedColumns(*position.flat, position.centerline);
  WarnOfPosition(examination, files);
  files.identity = examination.Identity();
  return files;
}
} // namespace shapeton
