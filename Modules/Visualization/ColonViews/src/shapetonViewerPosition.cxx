#include "shapetonViewerPosition.h"

#include "shapetonColonFlexures.h"
#include "shapetonCurveSet.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonFlatColon.h"
#include "shapetonFlatColonStrip.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonImageFile.h"
#include "shapetonPicture.h"
#include "shapetonPolypSearch.h"
#include "shapetonReadImage.h"
#include "shapetonSegmentQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonViewerCandidates.h"
#include "shapetonViewerDetails.h"
#include "shapetonViewerVolume.h"

#include "itkNrrdImageIO.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace shapeton
{
namespace
{
using LabelImage = itk::Image<unsigned short, 2>;

SurfaceArray::ValueMatrix
ValuesOf(const std::vector<SurfaceArray> & arrays, const std::string & name, const std::string & path)
{
  const SurfaceArray * array = FindSurfaceArray(arrays, name);
  if (array == nullptr)
  {
    throw InputError("the file \"" + path + "\" lacks the array " + name + "; run VirtualColonoscopy again");
  }
  return array->values;
}

/** Files of one position. Files missing after a failed stage are recorded as missing. */
class PositionFolder
{
public:
  explicit PositionFolder(std::string folder) : m_Folder(std::move(folder)) { RequireCurrentFileNames(m_Folder); }

  std::string
  Required(const std::string & name) const
  {
    const std::string path = m_Folder + "/" + name;
    if (!std::filesystem::exists(path))
    {
      throw InputError("the examination lacks \"" + path + "\"; let VirtualColonoscopy finish it");
    }
    return path;
  }
  bool
  Has(const std::string & name, const std::string & what)
  {
    const bool isThere = std::filesystem::exists(m_Folder + "/" + name);
    if (!isThere)
    {
      m_Missing.push_back(what);
    }
    return isThere;
  }
  const Json &
  Missing() const
  {
    return m_Missing;
  }

private:
  std::string m_Folder;
  Json        m_Missing = Json::array();
};

Json
PlaceOf(const VertexMatrix & points, int vertex)
{
  return { Hundredths(points(vertex, 0)), Hundredths(points(vertex, 1)), Hundredths(points(vertex, 2)) };
}

Json
PlacesOf(const CurveSet & curves, std::size_t curve)
{
  Json places = Json::array();
  for (const int vertex : curves.curves[curve])
  {
    places.push_back(PlaceOf(curves.V, vertex));
  }
  return places;
}

Json
Taeniae(const std::string & path)
{
  const CurveSet                  curves = ReadCurves(path);
  const SurfaceArray::ValueMatrix uv = ValuesOf(curves.pointArrays, "uv", path);
  Json                            taeniae = Json::array();
  for (std::size_t curve = 0; curve < curves.curves.size(); ++curve)
  {
    Json places = Json::array();
    for (const int vertex : curves.curves[curve])
    {
      places.push_back({ Hundredths(uv(vertex, 0)), Hundredths(uv(vertex, 1)) });
    }
    taeniae.push_back({ { "xyz", PlacesOf(curves, curve) }, { "uv", places } });
  }
  return taeniae;
}

Json
Flexures(const std::string & path)
{
  const CurveSet                  curves = ReadCurves(path);
  const SurfaceArray::ValueMatrix numbers = ValuesOf(curves.cellArrays, "flexure", path);
  const SurfaceArray::ValueMatrix confidence = ValuesOf(curves.cellArrays, "confidence", path);
  Json                            flexures = Json::array();
  for (std::size_t curve = 0; curve < curves.curves.size(); ++curve)
  {
    flexures.push_back({ { "name", NameOfFlexure(static_cast<int>(numbers(curve, 0))) },
                         { "confidence", Hundredths(confidence(curve, 0)) },
                         { "xyz", PlacesOf(curves, curve) } });
  }
  return flexures;
}

/** Names of the segments, and the visible part of their lengths. */
Json
EvaluableSegments(const Json & landmarks)
{
  Json segments = Json::array();
  for (const Json & segment : landmarks.at("segments"))
  {
    if (segment.contains("assessableShare"))
    {
      segments.push_back({ { "name", segment.at("name") }, { "share", segment.at("assessableShare") } });
    }
  }
  return segments;
}

void
PutCenterline(PageBlocks & blocks, const std::string & prefix, const std::string & path)
{
  constexpr const char *    arrays[] = { "arcLength", "radius", "notAssessable" };
  const CurveSet            line = ReadCurves(path);
  SurfaceArray::ValueMatrix rows(line.V.rows(), 6);
  rows.leftCols(3) = line.V;
  for (int i = 0; i < 3; ++i)
  {
    rows.col(3 + i) = PointValues(line, arrays[i], path);
  }
  blocks.PutReals(prefix + "centerline", rows);
}

/** The relief as rows of red, green and blue, drawn by the page as the flat wall. */
Json
PutRelief(PageBlocks & blocks, const std::string & prefix, const FlatColon & flat)
{
  const FlatColonGrid &     grid = flat.Grid();
  const Picture::Pointer    picture = PaintFlatRelief(grid, flat.Axis());
  const RGBColor *          pixels = picture->GetBufferPointer();
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < grid.Columns() * grid.Rows(); ++i)
  {
    bytes.insert(bytes.end(), pixels[i].Begin(), pixels[i].End());
  }
  blocks.Put(prefix + "relief", bytes, 3);
  const Eigen::Vector2d first = grid.UvOfPixel(0, 0);
  return { { "columns", grid.Columns() },
           { "rows", grid.Rows() },
           { "step", grid.PixelSize() },
           { "u", first.x() },
           { "v", first.y() },
           { "vSign", grid.IsMirrored() ? -1 : 1 } };
}

/** Face data for blocks, in the order along the colon. */
class FlatFaces
{
public:
  FlatFaces(const SurfaceMesh & mesh, const std::string & path) : m_Mesh(mesh), m_Order(mesh.NumberOfFaces())
  {
    const SurfaceArray::ValueMatrix arc = ValuesOf(mesh.pointArrays, "arcLength", path);
    const auto &                    F = mesh.F;
    Eigen::VectorXd                 place(F.rows());
    for (Eigen::Index face = 0; face < F.rows(); ++face)
    {
      place[face] = arc(F(face, 0), 0) + arc(F(face, 1), 0) + arc(F(face, 2), 0);
    }
    std::iota(m_Order.begin(), m_Order.end(), 0);
    std::stable_sort(m_Order.begin(), m_Order.end(), [&](int a, int b) { return place[a] < place[b]; });
  }

  void
  PutCorners(PageBlocks & blocks, const std::string & name) const
  {
    std::vector<std::uint32_t> corners;
    for (const int face : m_Order)
    {
      for (int k = 0; k < 3; ++k)
      {
        corners.push_back(m_Mesh.F(face, k));
      }
    }
    blocks.Put(name, corners, 3);
  }

  /** Bits 0 to 2: segment; 3 to 5: hindrance (why the wall is not visible), or 5 for visible wall coated by tagged
   * residue; 6: interpolated over a gap; 7: cap of a pouch. \param coated by face; empty if unknown. */
  void
  PutKinds(PageBlocks &              blocks,
           const std::string &       name,
           const Eigen::MatrixXd &   segments,
           const std::vector<bool> & coated) const
  {
    constexpr int             isCoated = 5;
    const Eigen::MatrixXd     hindrance = this->MarksOf("notAssessable");
    const Eigen::MatrixXd     bridged = this->MarksOf("bridged");
    const Eigen::MatrixXd     cap = this->MarksOf("cap");
    std::vector<std::uint8_t> kinds;
    for (const int face : m_Order)
    {
      const int segment = segments.size() > 0 ? static_cast<int>(segments(face, 0)) & 7 : 0;
      const int reason = static_cast<int>(hindrance(face, 0)) & 7;
      const int state = reason == 0 && !coated.empty() && coated[static_cast<std::size_t>(face)] ? isCoated : reason;
      kinds.push_back(static_cast<std::uint8_t>(segment | state << 3 | (bridged(face, 0) != 0 ? 64 : 0) |
                                                (cap(face, 0) != 0 ? 128 : 0)));
    }
    blocks.Put(name, kinds);
  }

  void
  PutFolds(PageBlocks & blocks, const std::string & name, const LabelImage * labels) const
  {
    std::vector<std::uint16_t> folds(m_Order.size(), 0);
    if (labels != nullptr)
    {
      const std::vector<unsigned short> ofFaces = FoldsOfFaces(m_Mesh, *labels);
      std::transform(m_Order.begin(), m_Order.end(), folds.begin(), [&](int face) { return ofFaces[face]; });
    }
    blocks.Put(name, folds, 1);
  }

private:
  /** Arrays that are written only if any value is set. */
  Eigen::MatrixXd
  MarksOf(const std::string & name) const
  {
    const SurfaceArray * array = FindSurfaceArray(m_Mesh.cellArrays, name);
    return array != nullptr ? Eigen::MatrixXd(array->values) : Eigen::MatrixXd::Zero(m_Mesh.F.rows(), 1);
  }

  const SurfaceMesh & m_Mesh;
  std::vector<int>    m_Order;
};

void
RequireSameFaces(const SurfaceMesh & mesh, const SurfaceMesh & flat, const std::string & path)
{
  if (mesh.F.rows() != flat.F.rows() || mesh.F != flat.F)
  {
    throw InputError("the file \"" + path +
                     "\" does not match the surface flattening/flat.vtp of its position; run VirtualColonoscopy again");
  }
}

Eigen::MatrixXd
SegmentsOf(const std::string & path, const SurfaceMesh & flat)
{
  const SurfaceFile file = ReadSurfaceFile(path);
  RequireSameFaces(file.mesh, flat, path);
  return ValuesOf(file.mesh.cellArrays, "segment", path);
}

void
PutPoints(PageBlocks & blocks, const std::string & prefix, const SurfaceMesh & mesh, const std::string & path)
{
  blocks.PutReals(prefix + "points", mesh.V);
  // On the map, faces on folds may measure only thousandths of a millimeter.
  blocks.PutReals<std::uint32_t>(prefix + "uv", ValuesOf(mesh.pointArrays, "uv", path));
  blocks.PutReals(prefix + "arc", ValuesOf(mesh.pointArrays, "arcLength", path));
  // Equal on both sides of the cut; renumbered because the page uses them as array indices.
  const SurfaceArray::ValueMatrix sources = ValuesOf(mesh.pointArrays, "sourcePointId", path);
  std::vector<std::uint32_t>      first(static_cast<std::size_t>(sources.maxCoeff()) + 1, mesh.NumberOfVertices());
  std::vector<std::uint32_t>      source(mesh.NumberOfVertices());
  for (int vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    auto & of = first[static_cast<std::size_t>(sources(vertex, 0))];
    of = std::min<std::uint32_t>(of, vertex);
    source[vertex] = of;
  }
  blocks.Put(prefix + "source", source, 1);
}

/** The original and the cleansed CT. Runs without cleansing.nrrd have only the latter; runs on a lumen mask have none,
 * so that the page shows the mask. */
ViewerVolume
VolumeOf(const std::string & segmentation, PositionFolder & files, const Volume & lumen)
{
  ViewerVolume volume;
  volume.isCt = files.Has("segmentation/cleansed.nrrd", "CT");
  volume.shown = volume.isCt ? ReadImageFile(segmentation + "cleansed.nrrd").image : lumen.image;
  volume.isCleansed = volume.isCt;
  if (volume.isCt && files.Has("segmentation/cleansing.nrrd", "CT before cleansing"))
  {
    volume.cleansed = volume.shown;
    volume.shown = UncleansedCt(volume.cleansed, segmentation + "cleansing.nrrd");
    volume.isCleansed = false;
  }
  return volume;
}

/** Whether tagged residue coats the faces of the wall; empty without the CT before cleansing. */
std::vector<bool>
CoatedFaces(const SurfaceMesh & wall, const std::string & lumen, const ViewerVolume & volume)
{
  if (!volume.cleansed)
  {
    return {};
  }
  const auto labels = ReadImage<LumenMask>(lumen, itk::NrrdImageIO::New(), "run VirtualColonoscopy again");
  return FindCoatedFaces(wall, labels, AttenuationOf(volume.shown));
}

SurfaceMesh
PutWall(PageBlocks &         blocks,
        const std::string &  prefix,
        const std::string &  folder,
        const ViewerVolume & volume,
        PositionFolder &     files,
        Json &               info)
{
  const std::string path = files.Required("flattening/flat.vtp");
  const FlatColon   flat(ReadSurfaceFile(path).mesh, {}, '"' + path + '"');
  const auto &      mesh = flat.Surface();
  info["circumference"] = flat.Grid().Circumference();
  info["faces"] = mesh.NumberOfFaces();
  info["relief"] = PutRelief(blocks, prefix, flat);
  PutPoints(blocks, prefix, mesh, path);
  const FlatFaces faces(mesh, path);
  faces.PutCorners(blocks, prefix + "faces");
  const bool            hasSegments = files.Has("landmarks/segments.vtp", "segments");
  const Eigen::MatrixXd segments =
    hasSegments ? SegmentsOf(folder + "/landmarks/segments.vtp", mesh) : Eigen::MatrixXd();
  faces.PutKinds(blocks, prefix + "kinds", segments, CoatedFaces(mesh, folder + "/segmentation/lumen.nrrd", volume));
  const bool hasFolds = files.Has("folds/labels.nrrd", "folds");
  faces.PutFolds(
    blocks, prefix + "folds", hasFolds ? ReadFoldLabels(folder + "/folds/labels.nrrd").GetPointer() : nullptr);
  return mesh;
}
} // namespace

Json
Hundredths(double value)
{
  return std::isfinite(value) ? Json(std::round(100.0 * value) / 100.0) : Json(nullptr);
}

Json
PutViewerPosition(PageBlocks &               blocks,
                  const std::string &        prefix,
                  const std::string &        exam,
                  const ColonViewerOptions & options)
{
  PositionFolder files(exam);
  Json           info;
  const Json     quality = ReadJson(files.Required("segmentation/quality.json"));
  info["name"] = quality.value("/lumen/position"_json_pointer, std::string());
  info["seriesUID"] = quality.value("/provenance/input.inputVolume"_json_pointer, std::string());
  PutCenterline(blocks, prefix, files.Required("segmentation/centerline.vtp"));
  const std::string  lumenPath = files.Required("segmentation/lumen.nrrd");
  const Volume       lumen = ReadImageFile(lumenPath);
  const ViewerVolume volume = VolumeOf(exam + "/segmentation/", files, lumen);
  const SurfaceMesh  flat = PutWall(blocks, prefix, exam, volume, files, info);
  PutViewerVolume(blocks, prefix + "volume", volume, *MaskForImage(lumen, lumenPath, volume.shown), flat.V, options);
  info["taeniae"] =
    files.Has("landmarks/taeniae.vtp", "taeniae") ? Taeniae(exam + "/landmarks/taeniae.vtp") : Json::array();
  info["flexures"] =
    files.Has("landmarks/flexures.vtp", "flexures") ? Flexures(exam + "/landmarks/flexures.vtp") : Json::array();
  const std::string landmarks = exam + "/landmarks/landmarks.json";
  info["segments"] = std::filesystem::exists(landmarks) ? EvaluableSegments(ReadJson(landmarks)) : Json::array();
  info["candidates"] = files.Has("polyps/candidates.csv", "candidates")
                         ? CandidatesForViewer(exam + "/polyps/candidates.csv")
                         : Json::array();
  const std::string wall = files.Required("segmentation/wall-repaired.vtp");
  PutViewerDetails(blocks, prefix, flat, ReadSurfaceFile(wall).mesh, info["candidates"]);
  info["missing"] = files.Missing();
  return info;
}

void
PutViewerMap(PageBlocks & blocks, const std::string & prefix, const std::string & exam, const std::string & path)
{
  const SurfaceMesh mesh = ReadSurfaceFile(path).mesh;
  RequireSameFaces(mesh, ReadSurfaceFile(exam + "/flattening/flat.vtp").mesh, path);
  const SurfaceArray::ValueMatrix confidence = ValuesOf(mesh.pointArrays, "confidence", path);
  const SurfaceArray::ValueMatrix excluded = ValuesOf(mesh.pointArrays, "excluded", path);
  constexpr double                fullTrust = 200.0; // code of confidence 1; 255 is an excluded vertex
  std::vector<std::uint8_t>       trust;
  for (int vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    const double share = std::isfinite(confidence(vertex, 0)) ? std::clamp(confidence(vertex, 0), 0.0, 1.0) : 0.0;
    trust.push_back(static_cast<std::uint8_t>(excluded(vertex, 0) != 0 ? 255 : std::lround(fullTrust * share)));
  }
  blocks.PutReals<std::uint32_t>(prefix + "mapped", ValuesOf(mesh.pointArrays, "mappedUv", path));
  blocks.Put(prefix + "trust", trust);
}
} // namespace shapeton
