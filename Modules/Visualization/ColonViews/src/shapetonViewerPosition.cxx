#include "shapetonViewerPosition.h"

#include "shapetonColonFlexures.h"
#include "shapetonCurveSet.h"
#include "shapetonExceptions.h"
#include "shapetonFlatColon.h"
#include "shapetonFlatColonStrip.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonPicture.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonSegmentQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonViewerCandidates.h"
#include "shapetonViewerDetails.h"
#include "shapetonViewerVolume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
using LabelImage = itk::Image<unsigned short, 2>;
using MaskImage = itk::Image<unsigned char, 3>;

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

/** Whether a file exists; if not, adds what the page lacks. */
bool
Has(const ExaminationFolder & exam, const ExaminationFile & file, const char * what, Json & missing)
{
  const bool isThere = exam.Has(file);
  if (!isThere)
  {
    missing.push_back(what);
  }
  return isThere;
}

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
Taeniae(const ExaminationFolder & exam)
{
  const CurveSet                  curves = exam.ReadCurvesOf(examination::taeniae);
  const SurfaceArray::ValueMatrix uv = ValuesOf(curves.pointArrays, "uv", exam.PathOf(examination::taeniae));
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
Flexures(const ExaminationFolder & exam)
{
  const std::string               path = exam.PathOf(examination::flexures);
  const CurveSet                  curves = exam.ReadCurvesOf(examination::flexures);
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

/** "ID 123, 2026-02-17", as far as known. */
std::string
PatientOf(const ExaminationFolder & exam, const Json & quality)
{
  constexpr std::size_t year = 4, month = 2; // digits of the date
  const Json            series =
    SeriesRead(exam.Has(examination::series) ? ReadJson(exam.PathOf(examination::series)) : Json(), quality);
  const std::string id = series.value("patientID", ""), date = series.value("studyDate", "");
  const std::string when = date.size() < year + month
                             ? date
                             : date.substr(0, year) + '-' + date.substr(year, month) + '-' + date.substr(year + month);
  return (id.empty() ? "" : "ID " + id) + (id.empty() || when.empty() ? "" : ", ") + when;
}

void
PutCenterline(PageBlocks & blocks, const std::string & prefix, const ExaminationFolder & exam)
{
  constexpr const char *    arrays[] = { "arcLength", "radius", "notAssessable" };
  const std::string         path = exam.PathOf(examination::centerline);
  const CurveSet            line = exam.ReadCenterline();
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

  /** Bits 0 to 2: segment; 3 to 5: hindrance (why the wall is not visible), 4 + WallCover for visible wall; 6:
   * interpolated over a gap; 7: cap of a pouch. \param covers by face; empty if unknown. */
  void
  PutKinds(PageBlocks &                   blocks,
           const std::string &            name,
           const Eigen::MatrixXd &        segments,
           const std::vector<WallCover> & covers) const
  {
    constexpr int             visible = 4;
    const Eigen::MatrixXd     hindrance = this->MarksOf("notAssessable");
    const Eigen::MatrixXd     bridged = this->MarksOf("bridged");
    const Eigen::MatrixXd     cap = this->MarksOf("cap");
    std::vector<std::uint8_t> kinds;
    for (const int face : m_Order)
    {
      const int segment = segments.size() > 0 ? static_cast<int>(segments(face, 0)) & 7 : 0;
      const int reason = static_cast<int>(hindrance(face, 0)) & 7;
      const int cover = covers.empty() ? 0 : static_cast<int>(covers[static_cast<std::size_t>(face)]);
      const int state = reason == 0 && cover != 0 ? visible + cover : reason;
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
SegmentsOfFaces(const ExaminationFolder & exam, const SurfaceMesh & flat)
{
  const std::string path = exam.PathOf(examination::segments);
  const SurfaceMesh segments = exam.ReadSurfaceOf(examination::segments);
  RequireSameFaces(segments, flat, path);
  return ValuesOf(segments.cellArrays, "segment", path);
}

void
PutPoints(PageBlocks & blocks, const std::string & prefix, const FlatColon & flat, const std::string & path)
{
  const SurfaceMesh & mesh = flat.Surface();
  blocks.PutReals(prefix + "points", mesh.V);
  // On the map, faces on folds may measure only thousandths of a millimeter.
  blocks.PutReals<std::uint32_t>(prefix + "uv", ValuesOf(mesh.pointArrays, "uv", path));
  blocks.PutReals(prefix + "arc", ValuesOf(mesh.pointArrays, "arcLength", path));
  // The first vertex at this place, equal on both sides of the cut: the page uses it as an index into its arrays.
  const std::vector<int> &   places = flat.Grid().SourceOfPoints();
  std::vector<std::uint32_t> first(places.size(), mesh.NumberOfVertices());
  std::vector<std::uint32_t> source;
  for (int vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    std::uint32_t & of = first[places[vertex]];
    of = std::min<std::uint32_t>(of, vertex);
    source.push_back(of);
  }
  blocks.Put(prefix + "source", source, 1);
}

/** The labels of the lumen as a volume to be drawn, for a run without a CT. */
itk::Image<float, 3>::Pointer
VolumeOfLabels(const MaskImage & labels)
{
  return MapVoxels<float>(&labels, [](unsigned char label) { return static_cast<float>(label); });
}

/** The original and the cleansed CT. Runs without cleansing.nrrd have only the latter; runs on a lumen mask have none,
 * so that the page shows the mask. */
ViewerVolume
ReadViewerVolume(const ExaminationFolder & exam, const MaskImage & lumen, Json & missing)
{
  ViewerVolume volume;
  volume.isCt = Has(exam, examination::cleansedCt, "CT", missing);
  volume.isCleansed = volume.isCt;
  volume.shown = volume.isCt ? exam.ReadCleansedCt() : VolumeOfLabels(lumen);
  if (!HaveSameGrid(&lumen, volume.shown))
  {
    throw InputError(exam.PathOf(examination::lumen) +
                     ": the mask differs in size or position from the CT; run VirtualColonoscopy again");
  }
  if (volume.isCt && Has(exam, examination::cleansing, "CT before cleansing", missing))
  {
    volume.cleansed = volume.shown;
    volume.shown = exam.ReadOriginalCt(volume.cleansed);
    volume.isCleansed = false;
  }
  return volume;
}

void
PutWall(PageBlocks &                   blocks,
        const std::string &            prefix,
        const ExaminationFolder &      exam,
        const std::vector<WallCover> & covers,
        const FlatColon &              flat,
        Json &                         info,
        Json &                         missing)
{
  const std::string path = exam.PathOf(examination::flat);
  const auto &      mesh = flat.Surface();
  info["circumference"] = flat.Grid().Circumference();
  info["faces"] = mesh.NumberOfFaces();
  info["relief"] = PutRelief(blocks, prefix, flat);
  PutPoints(blocks, prefix, flat, path);
  const FlatFaces faces(mesh, path);
  faces.PutCorners(blocks, prefix + "faces");
  const bool hasSegments = Has(exam, examination::segments, "segments", missing);
  faces.PutKinds(blocks, prefix + "kinds", hasSegments ? SegmentsOfFaces(exam, mesh) : Eigen::MatrixXd(), covers);
  const bool hasFolds = Has(exam, examination::foldLabels, "folds", missing);
  faces.PutFolds(blocks, prefix + "folds", hasFolds ? exam.ReadFolds().GetPointer() : nullptr);
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
                  const ExaminationFolder &  exam,
                  const ColonViewerOptions & options)
{
  Json       info;
  Json       missing = Json::array();
  const Json quality = exam.ReadQuality();
  info["name"] = PositionOfQuality(quality);
  info["seriesUID"] = SeriesOfQuality(quality);
  info["patient"] = PatientOf(exam, quality);
  info["gravity"] = IsPositionKnown(quality) ? quality.value("/lumen/gravity"_json_pointer, Json()) : Json();
  info["valve"] = quality.value("/ileocecalValve/position"_json_pointer, Json());
  PutCenterline(blocks, prefix, exam);
  const auto         lumen = exam.ReadLumen();
  const ViewerVolume volume = ReadViewerVolume(exam, *lumen, missing);
  const auto         flat = exam.ReadFlatColon();
  // Empty without a CT from before cleansing.
  const auto covers =
    volume.cleansed ? FindWallCovers(flat->Surface(), lumen, AttenuationOf(volume.shown)) : std::vector<WallCover>();
  PutWall(blocks, prefix, exam, covers, *flat, info, missing);
  PutViewerVolume(blocks, prefix + "volume", volume, *lumen, flat->Surface().V, options);
  info["taeniae"] = Has(exam, examination::taeniae, "taeniae", missing) ? Taeniae(exam) : Json::array();
  info["flexures"] = Has(exam, examination::flexures, "flexures", missing) ? Flexures(exam) : Json::array();
  info["segments"] = exam.Has(examination::landmarks) ? EvaluableSegments(exam.ReadLandmarks()) : Json::array();
  info["candidates"] = Has(exam, examination::candidates, "candidates", missing)
                         ? CandidatesForViewer(exam.PathOf(examination::candidates))
                         : Json::array();
  PutViewerDetails(blocks, prefix, flat->Surface(), exam.ReadSurfaceOf(examination::repairedWall), info["candidates"]);
  info["missing"] = missing;
  return info;
}

void
PutViewerMap(PageBlocks & blocks, const std::string & prefix, const ExaminationFolder & exam, const std::string & path)
{
  const SurfaceMesh mesh = ReadSurfaceFile(path).mesh;
  RequireSameFaces(mesh, exam.ReadSurfaceOf(examination::flat), path);
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
