#include "shapetonDicomReportReader.h"

#include "shapetonByteStream.h"
#include "shapetonDicomReading.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr int DeepestTree = 64; // levels; chosen, bounds the recursion for malformed reports

/** A content item with coordinates, as stored in the file, and the statements of its measurement group. */
struct Graphic
{
  std::string            name;
  double                 length{ std::numeric_limits<double>::quiet_NaN() };
  std::vector<DicomCode> sites;
  std::string            comment;
  std::string            type;
  /** Frame of reference of points in space. */
  std::string frameOfReferenceUID;
  bool        isInPixels{ false };
  /** Image of points in pixels; empty unless exactly one image is referenced. */
  std::string        sopInstanceUID;
  std::uint32_t      frame{ 1 };
  std::vector<float> values;
};

template <typename TStream, typename TGraphic>
void
TransmitGraphic(TStream & stream, TGraphic & graphic)
{
  stream & graphic.length & graphic.comment & graphic.name & graphic.type & graphic.frameOfReferenceUID & graphic
    .isInPixels & graphic.sopInstanceUID & graphic.frame;
  stream.SizeOf(graphic.sites).SizeOf(graphic.values);
  for (auto & site : graphic.sites)
  {
    stream & site.value & site.scheme & site.meaning;
  }
  for (auto & value : graphic.values)
  {
    stream & value;
  }
}

// ---- in the contained process ----

/** Traverses the tree of a report and collects items with coordinates. */
class GraphicFinder
{
public:
  explicit GraphicFinder(DcmItem & root) : m_Root(root) { this->Visit(root, {}, 0); }

  const std::vector<Graphic> &
  Found() const
  {
    return m_Found;
  }

private:
  /** `context` contains the statements of the enclosing items. */
  void
  Visit(DcmItem & item, Graphic context, int depth)
  {
    if (depth > DeepestTree)
    {
      throw std::runtime_error("has a content tree that is too deep");
    }
    const auto children = ItemsOf(item, DCM_ContentSequence);
    TakeStatements(item, children, context);
    const std::string type = TextOf(item, DCM_ValueType);
    if ((type == "SCOORD" || type == "SCOORD3D") && !IsPlaceOfText(item))
    {
      this->Take(item, type == "SCOORD", context);
    }
    for (DcmItem * const child : children)
    {
      if (!RepeatsSpacePoint(*child, children))
      {
        this->Visit(*child, context, depth + 1);
      }
    }
  }

  static void
  TakeStatements(DcmItem & item, const std::vector<DcmItem *> & children, Graphic & context)
  {
    if (CodeOf(item, DCM_ConceptNameCodeSequence) == DicomCode{ "125007", "DCM", {} }) // a measurement group
    {
      context = {};
    }
    if (TextOf(item, DCM_ValueType) == "NUM")
    {
      context.length = LengthOf(item);
    }
    for (DcmItem * const child : children)
    {
      const DicomCode concept = CodeOf(*child, DCM_ConceptNameCodeSequence);
      if (concept == DicomCode{ "112039", "DCM", {} })
      {
        context.name = TextOf(*child, DCM_TextValue);
      }
      else if (concept == DicomCode{ "363698007", "SCT", {} })
      {
        context.sites.push_back(CodeOf(*child, DCM_ConceptCodeSequence));
      }
      else if (concept == DicomCode{ "121106", "DCM", {} } && context.comment.empty())
      {
        context.comment = TextOf(*child, DCM_TextValue);
      }
    }
  }

  /** The value of a number in mm; otherwise NaN. */
  static double
  LengthOf(DcmItem & number)
  {
    DcmItem * const value = ItemOf(number, DCM_MeasuredValueSequence);
    const bool isLength = value && CodeOf(*value, DCM_MeasurementUnitsCodeSequence) == DicomCode{ "mm", "UCUM", {} };
    return isLength && value->tagExistsWithValue(DCM_NumericValue) ? NumbersOf(*value, DCM_NumericValue, 1).front()
                                                                   : std::numeric_limits<double>::quiet_NaN();
  }

  static bool
  IsPlaceOfText(DcmItem & item)
  {
    return CodeOf(item, DCM_ConceptNameCodeSequence) == DicomCode{ "TextPosition", "99CS3D", {} };
  }

  /** Whether an item has pixel coordinates and a sibling with space coordinates has the same concept. */
  static bool
  RepeatsSpacePoint(DcmItem & item, const std::vector<DcmItem *> & siblings)
  {
    const DicomCode concept = CodeOf(item, DCM_ConceptNameCodeSequence);
    return TextOf(item, DCM_ValueType) == "SCOORD" && !concept.value.empty() &&
           std::any_of(siblings.begin(), siblings.end(), [&](DcmItem * const other) {
             return TextOf(*other, DCM_ValueType) == "SCOORD3D" &&
                    CodeOf(*other, DCM_ConceptNameCodeSequence) == concept;
           });
  }

  void
  Take(DcmItem & item, bool isInPixels, const Graphic & context)
  {
    Graphic graphic = context;
    if (graphic.name.empty())
    {
      graphic.name = CodeOf(item, DCM_ConceptNameCodeSequence).meaning;
    }
    graphic.type = TextOf(item, DCM_GraphicType);
    graphic.isInPixels = isInPixels;
    const Float32 * values = nullptr;
    unsigned long   count = 0;
    item.findAndGetFloat32Array(DCM_GraphicData, values, &count);
    graphic.values.assign(values, values + (values ? count : 0));
    if (isInPixels)
    {
      this->TakeImage(item, graphic);
    }
    else
    {
      graphic.frameOfReferenceUID = TextOf(item, DCM_ReferencedFrameOfReferenceUID);
    }
    m_Found.push_back(graphic);
  }

  /** The image is a child, or is referenced by a child through its position in the tree. */
  void
  TakeImage(DcmItem & item, Graphic & graphic) const
  {
    int images = 0;
    for (DcmItem * child : ItemsOf(item, DCM_ContentSequence))
    {
      child = this->Resolve(child);
      DcmItem * const reference = child ? ItemOf(*child, DCM_ReferencedSOPSequence) : nullptr;
      if (reference)
      {
        Sint32 frame = 1;
        reference->findAndGetSint32(DCM_ReferencedFrameNumber, frame);
        graphic.sopInstanceUID = TextOf(*reference, DCM_ReferencedSOPInstanceUID);
        graphic.frame = static_cast<std::uint32_t>(std::max<Sint32>(frame, 1));
        ++images;
      }
    }
    graphic.sopInstanceUID = images == 1 ? graphic.sopInstanceUID : std::string();
  }

  DcmItem *
  Resolve(DcmItem * item) const
  {
    const Uint32 * path = nullptr;
    unsigned long  length = 0;
    if (item->findAndGetUint32Array(DCM_ReferencedContentItemIdentifier, path, &length).bad() || !path)
    {
      return item;
    }
    DcmItem * place = &m_Root; // the first number, 1, is the root
    for (unsigned long i = 1; i < length && place; ++i)
    {
      place = path[i] > 0 ? ItemOf(*place, DCM_ContentSequence, static_cast<signed long>(path[i]) - 1) : nullptr;
    }
    return place;
  }

  DcmItem &            m_Root;
  std::vector<Graphic> m_Found;
};

std::string
ParseReport(const std::string & path, std::size_t, char *)
{
  DcmFileFormat format;
  LoadDicomObject(format,
                  path,
                  { UID_Comprehensive3DSRStorage,
                    UID_ComprehensiveSRStorage,
                    UID_EnhancedSRStorage,
                    UID_ExtensibleSRStorage,
                    UID_ColonCADSRStorage });
  const GraphicFinder finder(*format.getDataset());
  ByteWriter          writer;
  writer & static_cast<std::uint64_t>(finder.Found().size());
  for (const Graphic & graphic : finder.Found())
  {
    TransmitGraphic(writer, graphic);
  }
  return writer.GetBytes();
}

// ---- in this process ----

std::vector<Graphic>
ReadGraphics(const std::string & path)
{
  std::vector<Graphic> graphics;
  ReadContained(path, DicomReportService, 0, [&](const std::string & response, const char *) {
    ByteReader    reader(response);
    std::uint64_t count = 0;
    reader &      count;
    for (std::uint64_t i = 0; i < count; ++i)
    {
      graphics.emplace_back();
      TransmitGraphic(reader, graphics.back());
    }
  });
  return graphics;
}

/** Converts the coordinates of a report to the space of a source. */
class PlaceFinder
{
public:
  PlaceFinder(const std::string & path, const DicomSource & source) : m_Path(path), m_Source(source) {}

  DicomReportPoints
  PlacesOf(const Graphic & graphic) const
  {
    const bool        isInSpace = !graphic.isInPixels;
    const std::size_t dimension = isInSpace ? 3 : 2;
    const bool        isFinite =
      std::all_of(graphic.values.begin(), graphic.values.end(), [](float value) { return std::isfinite(value); });
    if (graphic.values.size() % dimension != 0 || !isFinite ||
        !MayHave(graphic.type, graphic.values.size() / dimension))
    {
      throw InputError('"' + m_Path + "\" has invalid coordinates of a " +
                       (graphic.type.empty() ? "graphic" : graphic.type) + " of " + graphic.name + "; write it again");
    }
    DicomReportPoints points;
    points.name = graphic.name;
    points.type = graphic.type;
    points.length = graphic.length;
    points.sites = graphic.sites;
    points.comment = graphic.comment;
    for (std::size_t i = 0; i < graphic.values.size(); i += dimension)
    {
      points.places.push_back(isInSpace ? this->InSpace(graphic, &graphic.values[i])
                                        : this->InPixels(graphic, &graphic.values[i]));
    }
    KeepMiddle(graphic.type, points.places);
    return points;
  }

private:
  using Place = itk::Point<double, 3>;

  /** Whether the number of points is valid for this graphic type: DICOM PS3.3, C.18.6 and C.18.9. */
  static bool
  MayHave(const std::string & type, std::size_t points)
  {
    const std::map<std::string, std::size_t> exact{
      { "POINT", 1 }, { "CIRCLE", 2 }, { "ELLIPSE", 4 }, { "ELLIPSOID", 6 }
    };
    const auto found = exact.find(type);
    return found != exact.end() ? points == found->second
                                : points > 0 && (type == "MULTIPOINT" || type == "POLYLINE" || type == "POLYGON");
  }

  Place
  InSpace(const Graphic & graphic, const float * values) const
  {
    if (m_Source.series.frameOfReferenceUID.empty())
    {
      throw InputError('"' + m_Path + "\" has points in space, but the series " + m_Source.series.uid +
                       " has no frame of reference; use its source series");
    }
    if (graphic.frameOfReferenceUID != m_Source.series.frameOfReferenceUID)
    {
      throw InputError('"' + m_Path + "\" has points " +
                       (graphic.frameOfReferenceUID.empty() ? "without a frame of reference, unlike the series "
                                                            : "in another frame of reference than the series ") +
                       m_Source.series.uid + "; use its source series");
    }
    Place place;
    std::copy(values, values + 3, place.Begin());
    return place;
  }

  Place
  InPixels(const Graphic & graphic, const float * values) const
  {
    const auto & slices = m_Source.series.slices;
    const auto   slice = std::find_if(slices.begin(), slices.end(), [&](const DicomSlice & one) {
      return one.sopInstanceUID == graphic.sopInstanceUID && graphic.frame == (one.isMultiFrame ? one.frame + 1 : 1);
    });
    if (graphic.sopInstanceUID.empty())
    {
      throw InputError('"' + m_Path + "\" has points of " + graphic.name +
                       " that reference no image or more than one; write it again");
    }
    if (slice == slices.end())
    {
      throw InputError('"' + m_Path + "\" has points in an image that is not a slice of the series " +
                       m_Source.series.uid + "; use its source series");
    }
    if (!(values[0] >= 0.0F && values[0] <= static_cast<float>(m_Source.series.size[0]) && values[1] >= 0.0F &&
          values[1] <= static_cast<float>(m_Source.series.size[1])))
    {
      throw InputError('"' + m_Path + "\" has points of " + graphic.name + " outside their image; write it again");
    }
    const DicomSeries & series = m_Source.series;
    Place               place = slice->imagePosition;
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      const double pixels = values[axis] - 0.5; // 0 is the outer corner of the first pixel
      for (unsigned int k = 0; k < 3; ++k)
      {
        place[k] += pixels * series.spacing[axis] * series.direction(k, axis);
      }
    }
    return place;
  }

  /** A circle is defined by its center and a point on it, an ellipse by the ends of its axes. */
  static void
  KeepMiddle(const std::string & type, std::vector<Place> & places)
  {
    if (type == "CIRCLE")
    {
      places.resize(1);
    }
    else if ((type == "ELLIPSE" || type == "ELLIPSOID") && places.size() > 1)
    {
      places = { Place(0.5 * (places[0].GetVectorFromOrigin() + places[1].GetVectorFromOrigin())) };
    }
  }

  std::string         m_Path;
  const DicomSource & m_Source;
};
} // namespace

ContainedService
MakeDicomReportService()
{
  return MakeDicomService(ParseReport);
}

std::vector<DicomReportPoints>
ReadDicomReportPoints(const std::string & path, const DicomSource & source)
{
  const PlaceFinder              finder(path, source);
  std::vector<DicomReportPoints> points;
  for (const Graphic & graphic : ReadGraphics(path))
  {
    points.push_back(finder.PlacesOf(graphic));
  }
  if (points.empty())
  {
    throw InputError('"' + path + "\" contains no points; use a report with points or regions");
  }
  return points;
}
} // namespace shapeton
