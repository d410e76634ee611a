#include "shapetonColonSegments.h"

#include "shapetonCenterlineShape.h"
#include "shapetonIleocecalValve.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Average length of a cecum (mm; Gray's Anatomy, see the header). It is measured straight from the end of the
 * centerline, because the course of the line is uncertain in wide lumen. */
constexpr double cecumLength = 60.0;
constexpr int    borderOfCecum = 5;
/** Confidence of the border, 0 to 1. Low, since the position is based on average anatomy, not on a visible
 * structure. */
constexpr double confidenceOfCecum = 0.3;

/** Labels the parts into which the loops divide the faces, from 0. */
std::vector<int>
PartsBetweenLoops(const ColonWallTube & tube, const std::vector<SegmentBorder> & borders)
{
  const SurfaceConnectivity & connectivity = tube.Connectivity();
  std::vector<char>           isBlocked(connectivity.NumberOfEdges(), 0);
  for (const SegmentBorder & border : borders)
  {
    const std::vector<int> & loop = border.loop.vertices;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      isBlocked[connectivity.FindEdge(loop[i], loop[(i + 1) % loop.size()])] = 1;
    }
  }
  std::vector<int> part(tube.Faces().rows(), -1);
  std::vector<int> stack;
  int              parts = 0;
  for (int seed = 0; seed < tube.Faces().rows(); ++seed)
  {
    if (part[seed] >= 0)
    {
      continue;
    }
    part[seed] = parts++;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int face = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const int edge = connectivity.EdgeOfFace(face, k);
        if (edge < 0 || isBlocked[edge])
        {
          continue;
        }
        for (const int next : connectivity.FacesOfEdge(edge))
        {
          if (part[next] < 0)
          {
            part[next] = part[face];
            stack.push_back(next);
          }
        }
      }
    }
  }
  return part;
}

/** The segment at a distance along the centerline; 0 if unknown. */
int
SegmentAt(const std::vector<SegmentBorder> & borders, double arcLength)
{
  int before = 0;                     // number of the previous border
  int behind = NumberOfColonSegments; // number of the next border
  for (const SegmentBorder & border : borders)
  {
    if (border.arcLength <= arcLength)
    {
      before = border.number;
    }
    else
    {
      behind = std::min(behind, border.number);
    }
  }
  return behind == before + 1 ? behind : 0;
}

/** Assigns to each part the segment at its center. */
std::vector<int>
SegmentsOfFaces(const ColonWallTube & tube, const std::vector<SegmentBorder> & borders)
{
  const std::vector<int> part = PartsBetweenLoops(tube, borders);
  const int              parts = 1 + *std::max_element(part.begin(), part.end());
  std::vector<double>    sum(parts, 0.0);
  std::vector<int>       count(parts, 0);
  for (int face = 0; face < tube.Faces().rows(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum[part[face]] += tube.ArcLength(tube.Faces()(face, k));
      ++count[part[face]];
    }
  }
  std::vector<int> segments;
  for (const int p : part)
  {
    segments.push_back(SegmentAt(borders, sum[p] / count[p]));
  }
  return segments;
}

/** Index of the line point at which a cecum of average length begins. */
int
EstimatedBeginOfCecum(const CenterlineShape & shape)
{
  const int end = shape.Size() - 1;
  int       i = end;
  while (i > 0 && (shape.Points().row(i) - shape.Points().row(end)).norm() < cecumLength)
  {
    --i;
  }
  return i;
}

void
AddCecum(const CurveSet &                      centerline,
         const std::optional<IleocecalValve> & valve,
         const ColonFlexures &                 flexures,
         std::vector<SegmentBorder> &          borders)
{
  const CenterlineShape shape(centerline);
  const int             i = valve ? shape.IndexAt(valve->arcLength) : EstimatedBeginOfCecum(shape);
  const ColonFlexure &  hepatic = flexures.flexures[3];
  if (!hepatic.isFound || hepatic.arcLength + 0.5 * cecumLength > shape.ArcLengthAt(i))
  {
    return;
  }
  SegmentBorder border;
  border.number = borderOfCecum;
  border.arcLength = shape.ArcLengthAt(i);
  border.confidence = valve ? valve->confidence : confidenceOfCecum;
  border.point = shape.Points().row(i).transpose();
  borders.push_back(border);
}
} // namespace

std::string
NameOfSegment(int segment)
{
  static const char * const names[] = {
    "unknown", "rectum", "sigmoid", "descending", "transverse", "ascending", "cecum"
  };
  return segment >= 0 && segment <= NumberOfColonSegments ? names[segment] : "";
}

ColonSegments
FindColonSegments(const ColonWallTube & tube,
                  const CurveSet &      centerline,
                  const ColonFlexures & flexures,
                  const Progress &      progress)
{
  std::vector<SegmentBorder> candidates;
  for (const ColonFlexure & flexure : flexures.flexures)
  {
    if (flexure.isFound)
    {
      candidates.push_back({ flexure.number, flexure.point, flexure.arcLength, flexure.confidence, {} });
    }
  }
  const std::optional<IleocecalValve> valve = IleocecalValveOf(centerline);
  AddCecum(centerline, valve, flexures, candidates);
  const CenterlineShape shape(centerline);
  const VertexMatrix    tangents = shape.Tangents(10.0);
  ColonSegments         result;
  result.isCecumAtValve = valve.has_value();
  for (std::size_t done = 0; done < candidates.size(); ++done)
  {
    SegmentBorder & border = candidates[done];
    const auto      number = static_cast<double>(candidates.size());
    const Progress  part = progress.Part("", done / number, (done + 1) / number);
    const int       i = shape.IndexAt(border.arcLength);
    border.loop = FindLoop(tube, border.point, tangents.row(i).transpose(), border.arcLength, part);
    if (border.loop.vertices.empty())
    {
      result.warnings.push_back("no loop around the wall was found at the end of the " + NameOfSegment(border.number));
    }
    else
    {
      result.borders.push_back(border);
    }
  }
  result.segmentOfFace = SegmentsOfFaces(tube, result.borders);
  const auto unknown = std::count(result.segmentOfFace.begin(), result.segmentOfFace.end(), 0);
  if (unknown > 0)
  {
    result.warnings.push_back(
      "the segment of " + std::to_string(static_cast<int>(std::lround(100.0 * unknown / result.segmentOfFace.size()))) +
      " % of the faces is unknown because a border is missing");
  }
  return result;
}
} // namespace shapeton
