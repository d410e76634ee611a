#include "shapetonColonWall.h"

#include "shapetonArcLengthField.h"
#include "shapetonColonBridges.h"
#include "shapetonConformalTube.h"
#include "shapetonCutDisc.h"
#include "shapetonDiffusionTime.h"
#include "shapetonHandleLoops.h"
#include "shapetonImageGrid.h"
#include "shapetonParallelFor.h"
#include "shapetonRemoveBridges.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonSurfaceSmoothing.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace shapeton
{
namespace
{
/** Face count for the first estimate of FacesForDiffusion(). */
constexpr int leastChosenFaces = 55000;

enum class Step
{
  Bridged,
  Repaired,
  Extracted,
  Opened,
  Simplified,
  Done
};

/** Approximate fraction of the run time completed after each step. */
double
ShareAfter(Step step)
{
  constexpr double shares[] = { 0.02, 0.2, 0.3, 0.5, 0.95, 1.0 };
  return shares[static_cast<int>(step)];
}

class Builder
{
public:
  Builder(OccupancyImage::ConstPointer && occupancy,
          const CurveSet &                centerline,
          const ColonWallSettings &       options,
          OccupancyImage::ConstPointer && repairedOccupancy)
    : m_Occupancy(std::move(occupancy))
    , m_RepairedOccupancy(repairedOccupancy ? std::move(repairedOccupancy) : m_Occupancy)
    , m_Centerline(centerline)
    , m_Options(options)
  {}

  ColonWall
  Build()
  {
    this->Bridge();
    Remarks                       remarksOnRaw;
    std::optional<ArcLengthField> arcLengths;
    SurfaceMesh                   repaired;
    // All other steps depend on the repaired surface, but not on the raw surface.
    ParallelInvoke([this] { this->Repair(); },
                   [&, this] {
                     remarksOnRaw = this->MakeRaw();
                     this->Inspect(m_Wall.raw, m_Wall.report.rawFaces, m_Wall.report.rawQuality);
                   });
    this->MakeRepaired();
    this->MakeUnrepaired();
    this->ReleaseOccupancy();
    ParallelInvoke([this] { this->Simplify(); }, // single-threaded
                   [&, this] {
                     arcLengths.emplace(m_Mask, m_Centerline);
                     m_Mask = nullptr;
                     repaired = m_Wall.repaired; // which is an input of the simplification
                     m_Wall.report.bridgedFaces =
                       this->Inspect(repaired, m_Wall.report.repairedFaces, m_Wall.report.repairedQuality);
                     this->AddPlaces(m_Wall.raw, *arcLengths);
                     this->AddPlaces(repaired, *arcLengths);
                     if (m_Options.besideSimplification)
                     {
                       m_Options.besideSimplification(m_Wall.raw, repaired);
                     }
                   });
    m_Wall.repaired = std::move(repaired);
    this->Denoise(*arcLengths);
    this->Inspect(m_Wall.simplified, m_Wall.report.simplifiedFaces, m_Wall.report.simplifiedQuality);
    this->AddPlaces(m_Wall.simplified, *arcLengths);
    AppendRemarks(m_Wall.report.warnings, remarksOnRaw);
    AppendRemarks(m_Wall.report.warnings, m_RemarksOnRepaired);
    this->Advance(Step::Done);
    return std::move(m_Wall);
  }

private:
  void
  Advance(Step step) const
  {
    m_Options.progress(ShareAfter(step));
  }

  void
  Bridge()
  {
    m_Bridges = AddBridges(m_Occupancy, m_Centerline, m_Options.bridgeRadius);
    m_Wall.report.warnings = m_Bridges.warnings;
    m_RepairedField =
      m_RepairedOccupancy == m_Occupancy ? m_Bridges.occupancy : DrawBridges(m_RepairedOccupancy, m_Bridges);
    this->Advance(Step::Bridged);
  }

  void
  Repair()
  {
    LumenTopology topology = RepairLumenTopology(m_Bridges.occupancy, m_Centerline);
    m_Wall.report.topology = topology.report;
    m_Mask = topology.mask;
    if (topology.report.droppedPieces > 0)
    {
      std::ostringstream text;
      text.precision(4);
      text << topology.report.droppedPieces << " pieces of the lumen with " << topology.report.droppedVolume
           << " ml in total have no connection to the rest and were removed from the wall";
      m_Wall.report.warnings.push_back(text.str());
    }
    this->Advance(Step::Repaired);
  }

  SurfaceSmoothingOptions
  Smoothing(double normalLimit) const
  {
    const auto              spacing = m_Occupancy->GetSpacing();
    const double            finest = std::min({ spacing[0], spacing[1], spacing[2] });
    SurfaceSmoothingOptions smoothing;
    smoothing.tangentialLimit = m_Options.tangentialLimit * finest;
    smoothing.normalLimit = normalLimit * finest;
    return smoothing;
  }

  Remarks
  MakeRaw()
  {
    m_Wall.raw = SmoothSurface(ExtractWall(m_Bridges.occupancy), this->Smoothing(0.0));
    return this->OpenRaw();
  }

  void
  MakeRepaired()
  {
    m_Wall.repaired = SmoothSurface(ExtractWall(m_RepairedField, m_Mask), this->Smoothing(m_Options.normalLimit));
    this->Advance(Step::Extracted);
    OpenWall opened = OpenColonEnds(m_Wall.repaired, m_Centerline, m_Options.ends);
    m_Wall.repaired = std::move(opened.mesh);
    ColonWallReport & report = m_Wall.report;
    report.repairedGenus = opened.genus;
    report.rectumRadius = opened.rectumRadius;
    report.cecumRadius = opened.cecumRadius;
    this->WarnOfSmallEnd("rectum", opened.rectumRadius);
    this->WarnOfSmallEnd("cecum", opened.cecumRadius);
    this->Advance(Step::Opened);
  }

  /** Makes the surface to simplify for topologies other than Repaired. */
  void
  MakeUnrepaired()
  {
    m_Wall.report.simplifiedGenusBefore = m_Wall.report.repairedGenus;
    if (m_Options.topology != WallTopology::Repaired)
    {
      OpenWall opened =
        OpenColonEnds(SmoothSurface(ExtractWall(m_RepairedField), this->Smoothing(m_Options.normalLimit)),
                      m_Centerline,
                      m_Options.ends);
      m_Unrepaired = std::move(opened.mesh);
      m_Wall.report.simplifiedGenusBefore = opened.genus;
    }
  }

  /** Opens the raw surface, unless handles near an end prevent a disc there. */
  Remarks
  OpenRaw()
  {
    Remarks         remarks;
    OpenEndsOptions ends = m_Options.ends;
    ends.smoothRims = false;
    try
    {
      OpenWall opened = OpenColonEnds(m_Wall.raw, m_Centerline, ends);
      m_Wall.raw = std::move(opened.mesh);
      m_Wall.report.rawGenus = opened.genus;
    }
    catch (const InputError & error)
    {
      m_Wall.report.rawGenus = SurfaceConnectivity(m_Wall.raw).Components().front().genus.value_or(-1);
      remarks.push_back(std::string("the raw surface remains closed: ") + error.what());
    }
    return remarks;
  }

  /** Releases the input volumes to reduce peak memory. */
  void
  ReleaseOccupancy()
  {
    m_RepairedField = nullptr;
    m_RepairedOccupancy = nullptr;
    m_Bridges.occupancy = nullptr;
    if (m_Bridges.axes.empty()) // otherwise required to identify faces of the tubes
    {
      m_Occupancy = nullptr;
    }
  }

  void
  WarnOfSmallEnd(const char * end, double radius)
  {
    if (radius < m_Options.ends.radius)
    {
      std::ostringstream text;
      text << "the opening at the " << end << " has a radius of " << radius << " mm instead of "
           << m_Options.ends.radius << " mm: a larger region is not a disc";
      m_RemarksOnRepaired.push_back(text.str());
    }
  }

  void
  Simplify()
  {
    const bool   isGiven = m_Options.faces > 0;
    const double begin = ShareAfter(Step::Opened);
    const double end = ShareAfter(Step::Simplified);
    const double middle = isGiven ? end : 0.5 * (begin + end);
    int          faces = isGiven ? m_Options.faces : leastChosenFaces;
    this->SimplifyTo(faces, begin, middle);
    const int chosen = isGiven ? faces : this->FacesForFlatMap();
    if (chosen > faces)
    {
      faces = chosen;
      this->SimplifyTo(faces, middle, end);
    }
    if (!m_Simplification.reachedTarget)
    {
      m_RemarksOnRepaired.push_back("the simplified wall has " + std::to_string(m_Simplification.faces) +
                                    " faces instead of " + std::to_string(faces) + ": " + m_Simplification.reason);
    }
    const SurfaceConnectivity connectivity(m_Wall.simplified);
    const int                 genus =
      SetLoops(m_Wall.simplified, connectivity, this->EndOfCenterline(true), this->EndOfCenterline(false));
    if (genus != m_Wall.report.simplifiedGenusBefore)
    {
      throw InputError("the simplified wall has genus " + std::to_string(genus) + ", the wall " +
                       std::to_string(m_Wall.report.simplifiedGenusBefore));
    }
    m_Wall.report.simplifiedGenus = genus;
    this->Advance(Step::Simplified);
  }

  void
  Denoise(const ArcLengthField & field)
  {
    if (m_Options.topology == WallTopology::Denoised)
    {
      this->AddArcLength(m_Wall.simplified, field); // tells loops around handles from loops around the colon
      HandleCuts cuts = CutHandles(std::move(m_Wall.simplified));
      m_Wall.simplified = std::move(cuts.mesh);
      m_Wall.simplified.pointArrays.pop_back();
      m_Wall.report.simplifiedGenus = cuts.genus;
      if (cuts.genus > 0)
      {
        m_RemarksOnRepaired.push_back(std::to_string(cuts.genus) +
                                      " handles at the ends of the simplified wall could not be cut");
      }
    }
  }

  /** Simplifies the wall; the progress is scaled to a part of the total. */
  void
  SimplifyTo(int faces, double begin, double end)
  {
    SurfaceSimplificationSettings options;
    options.faces = faces;
    options.progress = m_Options.progress.Part("", begin, end);
    const bool isRepaired = m_Options.topology == WallTopology::Repaired;
    m_Wall.simplified = SimplifySurface(isRepaired ? m_Wall.repaired : m_Unrepaired, options, &m_Simplification);
  }

  /** Computes the face count from the area and the smallest radius of the simplified wall. */
  int
  FacesForFlatMap() const
  {
    SurfaceMesh wall = m_Wall.simplified;
    wall.cellArrays.push_back(BridgedFaces(wall, m_Bridges, m_Occupancy)); // excluded from the radius
    const SurfaceConnectivity connectivity(wall);
    const TubeEnds            ends = FindTubeEnds(wall, connectivity, "the wall");
    const Eigen::VectorXd     u = HarmonicAlongTube(MakeSurfaceLaplacian(connectivity, wall.V), ends);
    return FacesForDiffusion(SurfaceArea(wall.V, wall.F), NarrowestLevelRadius(wall, u));
  }

  Eigen::Vector3d
  EndOfCenterline(bool isRectum) const
  {
    const auto & curve = m_Centerline.curves.front();
    return m_Centerline.V.row(isRectum ? curve.front() : curve.back());
  }

  void
  AddArcLength(SurfaceMesh & mesh, const ArcLengthField & field) const
  {
    SurfaceArray array{ "arcLength", SurfaceArray::ValueMatrix(mesh.NumberOfVertices(), 1), false };
    ParallelForBlocks(static_cast<std::size_t>(mesh.NumberOfVertices()), [&](std::size_t i) {
      const auto v = static_cast<Eigen::Index>(i);
      array.values(v, 0) = field.ArcLengthAt(mesh.V.row(v));
    });
    mesh.pointArrays.push_back(std::move(array));
  }

  /** Adds `arcLength`, and `notAssessable` if the centerline has that array. */
  void
  AddPlaces(SurfaceMesh & mesh, const ArcLengthField & field) const
  {
    this->AddArcLength(mesh, field);
    if (FindSurfaceArray(m_Centerline.pointArrays, "notAssessable") != nullptr)
    {
      mesh.cellArrays.push_back(this->HindrancesOfFaces(mesh));
    }
  }

  /** For each face, `notAssessable` of the centerline point with the nearest arcLength. */
  SurfaceArray
  HindrancesOfFaces(const SurfaceMesh & mesh) const
  {
    const Eigen::VectorXd hindrance = PointValues(m_Centerline, "notAssessable", "the centerline");
    const Eigen::VectorXd line = PointValues(m_Centerline, "arcLength", "the centerline");
    const auto &          arcLength = mesh.pointArrays.back().values;
    SurfaceArray          array{ "notAssessable", SurfaceArray::ValueMatrix(mesh.NumberOfFaces(), 1), true };
    for (Eigen::Index face = 0; face < mesh.F.rows(); ++face)
    {
      const double at =
        (arcLength(mesh.F(face, 0), 0) + arcLength(mesh.F(face, 1), 0) + arcLength(mesh.F(face, 2), 0)) / 3.0;
      Eigen::Index point = std::lower_bound(line.begin(), line.end() - 1, at) - line.begin();
      point -= point > 0 && at - line[point - 1] < line[point] - at ? 1 : 0;
      array.values(face, 0) = hindrance[point];
    }
    return array;
  }

  /** Adds `bridged` and returns the number of tube faces. */
  int
  Inspect(SurfaceMesh & mesh, int & faces, SurfaceQuality & quality) const
  {
    mesh.facts = m_Options.facts;
    mesh.cellArrays.push_back(BridgedFaces(mesh, m_Bridges, m_Occupancy));
    faces = mesh.NumberOfFaces();
    const double bridged = mesh.cellArrays.back().values.sum();
    if (m_Options.keepPieces)
    {
      mesh = RemoveBridges(mesh);
    }
    quality = InspectSurface(mesh);
    return static_cast<int>(bridged);
  }

  OccupancyImage::ConstPointer m_Occupancy;
  OccupancyImage::ConstPointer m_RepairedOccupancy;
  const CurveSet &             m_Centerline;
  const ColonWallSettings &    m_Options;
  BridgedOccupancy             m_Bridges;
  OccupancyImage::ConstPointer m_RepairedField;
  LumenMaskImage::Pointer      m_Mask;
  SurfaceSimplificationReport  m_Simplification; ///< of the last simplification
  ColonWall                    m_Wall;
  SurfaceMesh                  m_Unrepaired; ///< see MakeUnrepaired()
  Remarks                      m_RemarksOnRepaired;
};

/** A line of another frame would be bridged over any distance. */
void
RequireLineIn(const OccupancyImage * volume, const CurveSet & centerline)
{
  constexpr double leastInside = 0.5; // fraction of the points; chosen, a colon may extend beyond a scan
  int              inside = 0;
  for (Eigen::Index i = 0; i < centerline.V.rows(); ++i)
  {
    itk::Point<double, 3> point;
    std::copy_n(centerline.V.row(i).eval().data(), 3, point.Begin());
    itk::ContinuousIndex<double, 3> index;
    inside += volume->TransformPhysicalPointToContinuousIndex(point, index) ? 1 : 0;
  }
  if (inside < leastInside * static_cast<double>(centerline.V.rows()))
  {
    throw InputError("most of the centerline is outside the volume; use a centerline and a volume of the same frame");
  }
}
} // namespace

void
RequireFacesOfWall(int faces)
{
  RequireParameter(faces == 0 || faces >= 1000, "the parameter \"faces\" must be 0 or at least 1000");
}

ColonWall
BuildColonWall(OccupancyImage::ConstPointer occupancy,
               const CurveSet &             centerline,
               const ColonWallSettings &    options,
               OccupancyImage::ConstPointer repairedOccupancy)
{
  CheckOptions(options);
  RequireFacesOfWall(options.faces);
  RequireSound(centerline, "the centerline");
  if (centerline.curves.size() != 1 || centerline.curves.front().size() < 2)
  {
    throw InputError("the centerline must be one curve of at least two points; it has " +
                     std::to_string(centerline.curves.size()) + " curves");
  }
  RequireLineIn(occupancy, centerline);
  return Builder(std::move(occupancy), centerline, options, std::move(repairedOccupancy)).Build();
}

ColonWall
BuildColonWallFromMask(const LumenMaskImage * mask, const CurveSet & centerline, const ColonWallSettings & options)
{
  RequirePixels(mask, "the lumen mask");
  const auto * const voxels = mask->GetBufferPointer();
  if (std::all_of(voxels, voxels + mask->GetBufferedRegion().GetNumberOfPixels(), [](auto v) { return v == 0; }))
  {
    throw InputError("the lumen mask is empty: all voxels are 0; give a mask whose lumen is nonzero");
  }
  const auto   spacing = mask->GetSpacing();
  const double meanSpacing = std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  auto         sharp = OccupancyFromMask(mask);
  auto         smooth = OccupancyFromMask(mask, options.maskSmoothing * meanSpacing);
  return BuildColonWall(std::move(sharp), centerline, options, std::move(smooth));
}
} // namespace shapeton
