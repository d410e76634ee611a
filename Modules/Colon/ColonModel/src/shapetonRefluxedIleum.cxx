#include "shapetonArcLengthField.h"
#include "shapetonIlealCaliber.h"
#include "shapetonMappedImage.h"
#include "shapetonPaddedVoxels.h"
#include "shapetonQuantiles.h"
#include "shapetonTerminalIleum.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace shapeton
{
namespace
{
/** Maximum radius (mm) of half of an ileum, which is 10 to 25 mm wide, and of half of its first stretch (length in mm);
 * fraction of its length that is not wider than DistendedIleum. */
constexpr double WidestIleum = 12.5;
constexpr double MostOfIleum = 0.75;
constexpr double FirstStretch = 100.0;
/** Maximum ratio of the median radius of the ileum to that of the colon; it is 0.53 in one real patient. A spastic
 * sigmoid is narrow, too, but the colon is widest at the cecum. */
constexpr double NarrowerThanColon = 0.75;
/** Length (mm) of the stretch before the valve whose caliber is compared with that of the ileum. */
constexpr double ComparedColon = 150.0;
/** Minimum length (mm) of an ileum. The pole of a cecum is within one radius of the end. */
constexpr double LeastIleum = 40.0;
/** Minimum distances (mm) beyond the inscribed ball of the line for all voxels and for the deepest voxel of a pouch.
 * Haustra of a phantom are up to 20 mm deep; cecal poles were 22 mm (phantom) and 40 mm (patient). */
constexpr double PouchBegin = 10.0;
constexpr double LeastPouchDepth = 21.0;
/** Minimum distance (mm) beyond the inscribed ball for the voxels of a cecum that touches the ileum. Folds of the ileum
 * are shallower. */
constexpr double CecumBegin = 3.0;
/** Minimum volume (ml) of the part of a cecum beyond the line. The short cecum of a phantom has a volume of 1.4 ml. */
constexpr double LeastPouchMl = 1.0;
/** Lengths (mm) of the line: from the pouch through the cecum to the valve, at most if it turns in the cecum (120 in a
 * real patient), and through the valve. */
constexpr double ValveReach = 60.0;
constexpr double TurningReach = 180.0;
constexpr double ValveLength = 30.0;
constexpr double WiderThanIleum = 1.3; // radius of the cecum relative to the median of the ileum
constexpr double PlaceStep = 5.0;      // mm between tried places
/** For an ileum behind a valve that is found: minimum length (mm), longer than a cecum, and minimum length (mm) of the
 * colon before it; maximum distance (mm) of the narrow place from the valve; minimum confidence. */
constexpr double LeastIleumAtValve = 120.0;
constexpr double LeastColon = 600.0;
constexpr double NearValve = 15.0;
constexpr double LeastValveConfidence = 0.9;

/** Inscribed radii along a line. */
class Caliber
{
public:
  explicit Caliber(const CurveSet & centerline)
    : m_ArcLengths(PointValues(centerline, "arcLength", "the centerline"))
    , m_Radii(PointValues(centerline, "radius", "the centerline"))
    , m_Gap(PointValues(centerline, "gap", "the centerline"))
    , m_Points(centerline.V)
  {}

  double
  End() const
  {
    return m_ArcLengths[m_ArcLengths.size() - 1];
  }

  Eigen::Index
  PointAt(double arcLength) const
  {
    const auto * const at = std::lower_bound(m_ArcLengths.data(), m_ArcLengths.data() + m_ArcLengths.size(), arcLength);
    return std::min<Eigen::Index>(at - m_ArcLengths.data(), m_ArcLengths.size() - 1);
  }

  /** Whether the rest of the line is as narrow as an ileum, and the colon before it is wider. */
  bool
  IsNarrowFrom(double arcLength) const
  {
    const auto before = this->Radii(arcLength - ComparedColon, arcLength);
    const auto first = this->Radii(arcLength, arcLength + FirstStretch);
    const auto after = this->Radii(arcLength, this->End());
    if (first.empty() || before.empty() || arcLength > this->End() - LeastIleum)
    {
      return false;
    }
    const double ileum = std::max(LowerQuantile(first, 0.5), LowerQuantile(after, 0.5));
    return LowerQuantile(after, MostOfIleum) <= DistendedIleum && ileum <= WidestIleum &&
           ileum <= NarrowerThanColon * LowerQuantile(before, 0.5);
  }

  bool
  HasNarrowEnd() const
  {
    bool isNarrow = false;
    for (double s = this->End() - LeastIleum; s > 0.0 && !isNarrow; s -= PlaceStep)
    {
      isNarrow = this->IsNarrowFrom(s);
    }
    return isNarrow;
  }

  /** Points of the line that may be in an open valve: the narrowest ones at the beginning of a narrow rest. */
  std::set<Eigen::Index>
  NarrowPlaces() const
  {
    std::set<Eigen::Index> places;
    for (double s = this->End() - LeastIleumAtValve; s >= LeastColon; s -= PlaceStep)
    {
      const Eigen::Index place = this->IsNarrowFrom(s) ? this->NarrowestIn(this->PointAt(s), ValveLength) : 0;
      if (place > 0 && m_Radii[place] <= OpenValve)
      {
        places.insert(place);
      }
    }
    return places;
  }

  /** The valve: the narrowest place after the last place near the pouch that is wider than an ileum, or after those
   * that follow it without a narrow stretch. A gap in the line is a closed valve. */
  double
  ValveAfter(double arcLength) const
  {
    const double end = this->End() - LeastIleum;
    const double last = std::min(arcLength + ValveReach, end);
    const double farthest = std::min(arcLength + TurningReach, end);
    const double wide = WiderThanIleum * LowerQuantile(this->Radii(last, this->End()), 0.5);
    Eigen::Index cecum = this->PointAt(arcLength);
    for (Eigen::Index i = cecum;
         m_ArcLengths[i] < std::max(last, std::min(m_ArcLengths[cecum] + ValveLength, farthest));
         ++i)
    {
      cecum = m_Radii[i] >= wide ? i : cecum;
    }
    return m_ArcLengths[this->NarrowestIn(cecum, ValveLength)];
  }

  double
  ArcLengthAt(Eigen::Index point) const
  {
    return m_ArcLengths[point];
  }

  Eigen::Vector3d
  PointOf(Eigen::Index point) const
  {
    return m_Points.row(point).transpose();
  }

  /** Distance (mm) of a point beyond the inscribed ball at a position on the line. */
  double
  Beyond(double arcLength, const Eigen::Vector3d & point) const
  {
    const Eigen::Index i = this->PointAt(arcLength);
    return (point - m_Points.row(i).transpose()).norm() - m_Radii[i];
  }

private:
  /** The point with the least radius on a length (mm) of the line. */
  Eigen::Index
  NarrowestIn(Eigen::Index first, double length) const
  {
    Eigen::Index narrowest = first;
    for (Eigen::Index i = first; i < m_Radii.size() && m_ArcLengths[i] < m_ArcLengths[first] + length; ++i)
    {
      narrowest = m_Radii[i] < m_Radii[narrowest] ? i : narrowest;
    }
    return narrowest;
  }

  std::vector<double>
  Radii(double begin, double end) const
  {
    std::vector<double> radii;
    for (Eigen::Index i = this->PointAt(begin); i < m_Radii.size() && m_ArcLengths[i] <= end; ++i)
    {
      if (m_Gap[i] == 0.0)
      {
        radii.push_back(m_Radii[i]);
      }
    }
    return radii;
  }

  Eigen::VectorXd m_ArcLengths;
  Eigen::VectorXd m_Radii;
  Eigen::VectorXd m_Gap;
  VertexMatrix    m_Points;
};

double
VolumeInMl(const LumenMask * mask)
{
  const auto                  spacing = mask->GetSpacing();
  const unsigned char * const begin = mask->GetBufferPointer();
  const auto                  size = static_cast<std::ptrdiff_t>(mask->GetBufferedRegion().GetNumberOfPixels());
  return 1e-3 * spacing[0] * spacing[1] * spacing[2] *
         static_cast<double>(std::count(begin, begin + size, static_cast<unsigned char>(1)));
}

/** The first points of a line. */
CurveSet
FirstPoints(const CurveSet & line, Eigen::Index points)
{
  CurveSet part;
  part.V = line.V.topRows(points);
  part.curves.emplace_back(static_cast<std::size_t>(points));
  std::iota(part.curves[0].begin(), part.curves[0].end(), 0);
  for (const SurfaceArray & array : line.pointArrays)
  {
    part.pointArrays.push_back({ array.name, array.values.topRows(points), array.areIntegers });
  }
  return part;
}

/** The part of a cecum beside the line. */
struct CecalPouch
{
  double              depth{ 0.0 }; ///< mm beyond the inscribed ball
  std::vector<double> arcLengths;   ///< of its voxels
};

/** Searches for the pouch of lumen beside the line where the caliber drops. */
class PouchSearch
{
public:
  PouchSearch(const LumenMask * labels, const CurveSet & centerline, const Caliber & caliber)
    : m_Labels(labels), m_Field(labels, centerline), m_Caliber(caliber), m_Voxels(labels->GetBufferedRegion())
  {
    m_Voxels.ForEachVoxel([&](std::int64_t padded, std::int64_t inner) {
      m_Voxels.flags[padded] = m_Labels->GetBufferPointer()[inner] != 0 && this->Beyond(inner) > PouchBegin ? 1 : 0;
    });
    m_Pieces = FindComponents(m_Voxels, 1, true, VoxelContact::Face);
  }

  /** The largest deep pouch after which the line is as narrow as an ileum. */
  std::optional<CecalPouch>
  Find() const
  {
    std::vector<CecalPouch> pouches(m_Pieces.sizes.size());
    this->ForEachVoxelOf(m_Pieces, [&](int label, std::size_t voxel) {
      const std::int64_t inner = this->Inner(voxel);
      pouches[label].depth = std::max(pouches[label].depth, this->Beyond(inner));
      pouches[label].arcLengths.push_back(m_Field.ArcLengthOfVoxel(inner));
    });
    const auto                spacing = m_Labels->GetSpacing();
    const double              voxelMl = 1e-3 * spacing[0] * spacing[1] * spacing[2];
    std::optional<CecalPouch> largest;
    for (CecalPouch & pouch : pouches)
    {
      if (pouch.depth >= LeastPouchDepth && voxelMl * static_cast<double>(pouch.arcLengths.size()) >= LeastPouchMl &&
          m_Caliber.IsNarrowFrom(m_Caliber.ValveAfter(LowerQuantile(pouch.arcLengths, 0.5))) &&
          (!largest || pouch.arcLengths.size() > largest->arcLengths.size()))
      {
        largest = std::move(pouch);
      }
    }
    return largest;
  }

  /** The lumen around the line behind the valve, excluding the cecum, which may touch the ileum. */
  TerminalIleum
  IleumBehind(Eigen::Index valve) const
  {
    const double  begin = m_Caliber.ArcLengthAt(valve);
    TerminalIleum ileum;
    ileum.mask = NewImageOn<LumenMask>(m_Labels, true);
    unsigned char * const isIleum = ileum.mask->GetBufferPointer();
    PaddedVoxels          colon(m_Labels->GetBufferedRegion());
    m_Voxels.ForEachVoxel([&](std::int64_t padded, std::int64_t inner) {
      const bool isLumen = m_Labels->GetBufferPointer()[inner] != 0;
      isIleum[inner] = isLumen && m_Field.ArcLengthOfVoxel(inner) > begin ? 1 : 0;
      colon.flags[padded] = isLumen && (isIleum[inner] == 0 || this->Beyond(inner) > CecumBegin) ? 1 : 0;
    });
    const VoxelComponents pieces = FindComponents(colon, 1, true, VoxelContact::Face);
    const auto            largest = std::max_element(pieces.sizes.begin(), pieces.sizes.end()) - pieces.sizes.begin();
    this->ForEachVoxelOf(pieces, [&](int piece, std::size_t voxel) {
      isIleum[this->Inner(voxel)] = piece == largest ? 0 : isIleum[this->Inner(voxel)];
    });
    ileum.mouth = m_Caliber.PointOf(valve);
    ileum.length = m_Caliber.End() - begin;
    ileum.volume = VolumeInMl(ileum.mask);
    return ileum;
  }

private:
  double
  Beyond(std::int64_t inner) const
  {
    return m_Caliber.Beyond(m_Field.ArcLengthOfVoxel(inner), m_Field.PointOfVoxel(inner));
  }

  /** Buffer index of a voxel of the padded grid. */
  std::int64_t
  Inner(std::size_t padded) const
  {
    const auto & size = m_Voxels.grid.size;
    const auto   v = m_Voxels.grid.Voxel(padded);
    return (static_cast<std::int64_t>(v[2] - 1) * (size[1] - 2) + v[1] - 1) * (size[0] - 2) + v[0] - 1;
  }

  /** Calls `body(label, index in the padded grid)` in order. */
  template <typename TBody>
  void
  ForEachVoxelOf(const VoxelComponents & pieces, const TBody & body) const
  {
    ForEachRun(pieces.runs, [&](std::size_t r, int j, int k) {
      for (int i = pieces.runs.runs[r].begin; i < pieces.runs.runs[r].end; ++i)
      {
        body(pieces.labels.ofRun[r], m_Voxels.grid.Index(i, j, k));
      }
    });
  }

  const LumenMask * m_Labels;
  ArcLengthField    m_Field;
  const Caliber &   m_Caliber;
  PaddedVoxels      m_Voxels; ///< of all pouches
  VoxelComponents   m_Pieces;
};
} // namespace

std::optional<TerminalIleum>
FindRefluxedIleum(const LumenMask * labels, const CurveSet & centerline)
{
  const Caliber caliber(centerline);
  if (!caliber.HasNarrowEnd())
  {
    return std::nullopt;
  }
  const PouchSearch search(labels, centerline, caliber);
  const auto        pouch = search.Find();
  if (!pouch)
  {
    return std::nullopt;
  }
  return search.IleumBehind(caliber.PointAt(caliber.ValveAfter(LowerQuantile(pouch->arcLengths, 0.5))));
}

std::optional<TerminalIleum>
FindIleumBehindValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centerline)
{
  const Caliber caliber(centerline);
  for (const Eigen::Index place : caliber.NarrowPlaces())
  {
    const Eigen::Vector3d               mouth = centerline.V.row(place);
    const std::optional<IleocecalValve> valve =
      FindIleocecalValve(labels, ct, FirstPoints(centerline, place + 1)).valve;
    if (valve && valve->confidence >= LeastValveConfidence && (valve->position - mouth).norm() <= NearValve)
    {
      return PouchSearch(labels, centerline, caliber).IleumBehind(place);
    }
  }
  return std::nullopt;
}
} // namespace shapeton
