#include "shapetonExaminationFolder.h"

#include "shapetonExceptions.h"
#include "shapetonFlatColon.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonImageFile.h"
#include "shapetonParallelFor.h"
#include "shapetonPolypSearch.h"
#include "shapetonReadImage.h"
#include "shapetonImageGrid.h"
#include "shapetonSurfaceReader.h"
#include "shapetonVolume.h"

#include "itkNrrdImageIO.h"

#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
constexpr const char * formatName = "Shapeton examination"; // value of "format" in the file

/** A folder without this file was assembled from the results of individual tools. */
void
RequireVersion(const std::string & path)
{
  if (!fs::exists(path))
  {
    return;
  }
  const Json document = ReadJson(path);
  const Json version = document.is_object() ? document.value("version", Json()) : Json();
  if (version != ExaminationVersion)
  {
    throw InputError("\"" + path + "\" states the version " + version.dump() +
                     " of the format, but this program reads " + std::to_string(ExaminationVersion) +
                     "; run VirtualColonoscopy again");
  }
}

/** Text at a JSON pointer; "" if the document has no text there. */
std::string
TextAt(const Json & document, const char * place)
{
  const Json::json_pointer pointer(place);
  return document.contains(pointer) && document.at(pointer).is_string() ? document.at(pointer).get<std::string>() : "";
}
} // namespace

ExaminationFolder::ExaminationFolder(std::string folder, std::string reader)
  : m_Folder(std::move(folder)), m_Reader(std::move(reader))
{
  if (!fs::is_directory(m_Folder))
  {
    throw InputError("the examination \"" + m_Folder + "\" was not found; give a folder written by VirtualColonoscopy");
  }
  RequireVersion(m_Folder + '/' + examination::format.Path());
}

std::string
ExaminationFolder::PathOf(const ExaminationFile & file) const
{
  if (!m_Reader.empty() && !file.IsReadBy(m_Reader))
  {
    throw std::logic_error("format/files.json does not declare that " + m_Reader + " reads " + file.Path());
  }
  return m_Folder + '/' + file.Path();
}

bool
ExaminationFolder::Has(const ExaminationFile & file) const
{
  return fs::is_regular_file(this->PathOf(file));
}

std::string
ExaminationFolder::Required(const ExaminationFile & file) const
{
  if (!this->Has(file))
  {
    throw InputError("the examination lacks \"" + this->PathOf(file) + "\", written by the stage " + file.stage + " (" +
                     file.tool + "); let VirtualColonoscopy finish it");
  }
  return this->PathOf(file);
}

Json
ExaminationFolder::ReadQuality() const
{
  return ReadJson(this->Required(examination::quality));
}

Json
ExaminationFolder::ReadLandmarks() const
{
  return ReadJson(this->Required(examination::landmarks));
}

std::vector<ColonSegmentExtent>
ExaminationFolder::ReadSegments() const
{
  if (!this->Has(examination::landmarks))
  {
    return {};
  }
  const Eigen::VectorXd arcLength =
    PointValues(this->ReadCenterline(), "arcLength", this->PathOf(examination::centerline));
  return SegmentsOf(this->ReadLandmarks(), arcLength.maxCoeff());
}

CurveSet
ExaminationFolder::ReadCenterline() const
{
  CurveSet centerline = this->ReadCurvesOf(examination::centerline);
  RequireSound(centerline, '"' + this->PathOf(examination::centerline) + '"');
  return centerline;
}

CurveSet
ExaminationFolder::ReadCurvesOf(const ExaminationFile & file) const
{
  return ReadCurves(this->Required(file));
}

SurfaceMesh
ExaminationFolder::ReadSurfaceOf(const ExaminationFile & file) const
{
  return ReadSurfaceFile(this->Required(file)).mesh;
}

std::shared_ptr<const FlatColon>
ExaminationFolder::ReadFlatColon() const
{
  return std::make_shared<const FlatColon>(
    this->ReadSurfaceOf(examination::flat), FlatColonGridOptions{}, '"' + this->PathOf(examination::flat) + '"');
}

itk::Image<unsigned char, 3>::Pointer
ExaminationFolder::ReadLumen() const
{
  return ReadImage<itk::Image<unsigned char, 3>>(
    this->Required(examination::lumen), itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
}

itk::Image<float, 3>::Pointer
ExaminationFolder::ReadCleansedCt() const
{
  return this->Has(examination::cleansedCt) ? ReadImageFile(this->PathOf(examination::cleansedCt)).image : nullptr;
}

itk::Image<float, 3>::Pointer
ExaminationFolder::ReadOriginalCt(const itk::Image<float, 3> * cleansed) const
{
  if (cleansed == nullptr || !this->Has(examination::cleansing))
  {
    return nullptr;
  }
  const std::string path = this->PathOf(examination::cleansing);
  const auto        image = ReadImageFile(path).image;
  if (!HaveSameGrid(image, cleansed))
  {
    throw InputError("\"" + path + "\" does not belong to the cleansed CT beside it; run ColonSegmentation again");
  }
  const std::size_t   voxels = image->GetLargestPossibleRegion().GetNumberOfPixels();
  float * const       values = image->GetBufferPointer();
  const float * const rest = cleansed->GetBufferPointer();
  ParallelForBlocks(voxels, [=](std::size_t i) { values[i] += rest[i]; });
  return image;
}

itk::Image<unsigned short, 2>::Pointer
ExaminationFolder::ReadFolds() const
{
  return this->Has(examination::foldLabels) ? ReadFoldLabels(this->PathOf(examination::foldLabels)) : nullptr;
}

std::vector<PolypCandidate>
ExaminationFolder::ReadCandidates() const
{
  return this->Has(examination::candidates) ? ReadPolypCandidates(this->PathOf(examination::candidates))
                                            : std::vector<PolypCandidate>();
}

std::string
PositionOfQuality(const Json & quality)
{
  return TextAt(quality, "/lumen/position");
}

bool
IsPositionKnown(const Json & quality)
{
  return TextAt(quality, "/lumen/gravitySource") != "assumed";
}

std::string
SeriesOfQuality(const Json & quality)
{
  return SeriesOfIdentity(TextAt(quality, "/provenance/input.inputVolume"));
}

Json
SeriesRead(const Json & inspection, const Json & quality)
{
  const std::string selector = SeriesOfQuality(quality); // empty if segmentation has failed
  for (const Json & series : inspection.is_null() ? Json::array() : inspection.value("series", Json::array()))
  {
    if (selector.empty() ? series.value("usable", false) : series.value("selector", "") == selector)
    {
      return series;
    }
  }
  return Json::object();
}

void
WriteExaminationVersion(const std::string & path)
{
  WriteJson({ { "format", formatName }, { "version", ExaminationVersion } }, path);
}
} // namespace shapeton
