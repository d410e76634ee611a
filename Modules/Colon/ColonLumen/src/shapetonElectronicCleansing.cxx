#include "shapetonElectronicCleansing.h"

#include "shapetonAirFluidInterface.h"

#include "shapetonColonVolume.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr double Margin = 6.0;          // mm around the lumen; chosen greater than Shell
constexpr double Shell = 4.0;           // mm; the lumen has no influence beyond this distance
constexpr double FullyInside = 10.0;    // in units of the blur; the error function is exactly 1 there
constexpr double ScannerBlur = 0.75;    // mm, standard deviation; between estimates on real scans (0.56 to 0.9)
constexpr double GreatestRate = 0.15;   // of one inverse diffusion step; higher rates amplify noise
constexpr double ContinuedOver = 1.2;   // mm, scale of the weights along gravity
constexpr double VarianceOfBlur = 0.64; // mm^2, the square of UsualBlur
/** Fractions of fluid that contradict a nearer gas or fluid voxel. */
constexpr double SurelyFluid = 0.95;
constexpr double SurelyGas = 0.05;
constexpr double Negligible = 0.005; // fraction of gas or fluid
constexpr double Overshoot = 0.2;    // of the lumen fraction beyond 0 and 1
constexpr double LeastSeen = 0.01;   // lumen fraction
constexpr float  OnlyFluid = 0.99F;  // fraction of fluid in the lumen

/** Lumen fraction of a voxel, and the fluid fraction of the lumen. */
struct Share
{
  float lumen{ 0.0F };
  float fluid{ 0.0F }; ///< fraction of the lumen part
};

class Cleansing
{
public:
  Cleansing(const ColonImage * ct, const ColonLumen & lumen, const ColonGrid & grid)
    : m_Image(ct)
    , m_Lumen(lumen)
    , m_Grid(grid)
    , m_Fall(grid, { lumen.gravity[0], lumen.gravity[1], lumen.gravity[2] })
    , m_Hu(LoadVoxels(ct, grid))
    , m_Labels(this->LoadLabels())
    , m_Fluid(this->MakeFluid())
    , m_Levels(m_Grid, m_Hu, m_Labels, m_Fall, m_Fluid, lumen.thresholds.gas)
    , m_Blur(std::sqrt(VarianceOfBlur + lumen.smoothing * lumen.smoothing + UniformVariance(grid.spacing.maxCoeff())))
  {}

  /** Releases each volume after use, since the volumes dominate peak memory. */
  CleansedColon
  Run(const Progress & progress)
  {
    progress(0.4);
    this->FindShares();
    progress(0.6);
    this->FindOccupancy();
    Release(m_LumenShares);
    Release(m_ToLumen);
    progress(0.8);
    CleansedColon result;
    result.ct = this->MakeCleansed();
    Release(m_FluidParts);
    result.occupancy = this->MakeOccupancy();
    progress(1.0);
    return result;
  }

private:
  static void
  Release(VoxelValues & values)
  {
    VoxelValues().swap(values);
  }

  void
  FindShares()
  {
    m_ToGas = this->DistanceTo(1, Shell);
    m_ToFluid = this->DistanceTo(2, Shell);
    this->ForAll([this](std::size_t p) { // in place; depends only on values of the same voxel
      const Share share = this->DirectShare(p);
      m_Hu[p] = share.lumen;
      m_ToGas[p] = std::min(m_ToGas[p], m_ToFluid[p]);
      m_ToFluid[p] = share.fluid;
    });
    m_LumenShares = std::move(m_Hu);
    m_ToLumen = std::move(m_ToGas);
    m_FluidParts = std::move(m_ToFluid);
  }

  void
  FindOccupancy()
  {
    const double allLumen = 0.5 * m_Grid.spacing.maxCoeff() + FullyInside * m_Blur;
    m_Occupancy = this->DistanceWithin(m_Labels, allLumen); // distance to the wall; later replaced by the occupancy
    this->ForAll([&](std::size_t p) {
      m_Occupancy[p] = this->Bounded(this->Continued(p), m_Labels[p] != 0, m_Occupancy[p], m_ToLumen[p]);
    });
  }

  template <typename TBody>
  void
  ForAll(const TBody & body) const
  {
    ParallelFor(m_Grid.size[2], [&](std::size_t k) {
      for (std::size_t p = k * m_Grid.stride[2]; p < (k + 1) * m_Grid.stride[2]; ++p)
      {
        body(p);
      }
    });
  }

  std::vector<unsigned char>
  LoadLabels()
  {
    std::vector<unsigned char> labels(m_Grid.NumberOfVoxels());
    const auto *               from = m_Lumen.labels->GetBufferPointer();
    ForEachVoxel(m_Lumen.labels, m_Grid, [&](std::size_t q, std::size_t p) { labels[p] = from[q]; });
    if (m_Lumen.smoothing > 0.0)
    {
      SmoothVoxels(m_Grid, m_Hu, m_Lumen.smoothing);
    }
    return labels;
  }

  LocalFluid
  MakeFluid() const
  {
    std::vector<unsigned char> mask(m_Labels.size());
    std::transform(m_Labels.begin(), m_Labels.end(), mask.begin(), [](unsigned char c) { return c == 2; });
    return LocalFluid(m_Grid, m_Hu, mask, m_Lumen.thresholds.fluid);
  }

  /** Distance (mm) to the nearest voxel of a class, clamped to `farthest`. */
  VoxelValues
  DistanceTo(unsigned char c, double farthest) const
  {
    std::vector<unsigned char> mask(m_Labels.size());
    std::transform(m_Labels.begin(), m_Labels.end(), mask.begin(), [c](unsigned char l) { return l != c; });
    return this->DistanceWithin(mask, farthest);
  }

  /** Distance (mm) from each voxel of a mask to the nearest voxel outside it. */
  VoxelValues
  DistanceWithin(const std::vector<unsigned char> & mask, double farthest) const
  {
    auto d = SquaredDistanceToBackground(m_Grid, mask, farthest);
    this->ForAll([&](std::size_t p) { d[p] = std::sqrt(d[p]); });
    return d;
  }

  double
  FluidAt(std::size_t p) const
  {
    const auto v = m_Grid.Voxel(p);
    return std::max(m_Fluid.At(v[0], v[1], v[2]), m_Lumen.thresholds.tissue + 100.0);
  }

  /** Contrast between the lumen content and tissue. */
  double
  Contrast(double fluidShare, std::size_t p) const
  {
    const auto & t = m_Lumen.thresholds;
    return fluidShare > 0.0 ? (1.0 - fluidShare) * (t.gas - t.tissue) + fluidShare * (this->FluidAt(p) - t.tissue)
                            : t.gas - t.tissue;
  }

  /** Whether a fluid fraction is inconsistent with the nearest label, or with the label and value of the voxel. With
   * fluid f and gas g, f + g <= 1, a value above the half height of fluid limits g to a fifth of f + g, and a value
   * below the half height of gas limits f to half of f + g. Inconsistencies occur at the rim of a level, where fluid
   * wets the wall. */
  bool
  IsRefuted(double share, std::size_t p) const
  {
    const auto & t = m_Lumen.thresholds;
    const bool   isFluid = m_Labels[p] == 2 && m_Hu[p] > 0.5 * (t.tissue + this->FluidAt(p));
    const bool   isGas = m_Labels[p] == 1 && m_Hu[p] < 0.5 * (t.tissue + t.gas);
    return (share > SurelyFluid && m_ToGas[p] < m_ToFluid[p]) || (share < SurelyGas && m_ToFluid[p] < m_ToGas[p]) ||
           (share < 0.5 && isFluid) || (share > 0.5 && isGas);
  }

  /** Fluid fraction of the lumen. */
  double
  FluidShare(std::size_t p) const
  {
    const bool isNearGas = m_ToGas[p] <= Shell;
    const bool isNearFluid = m_ToFluid[p] <= Shell;
    if (!isNearFluid || !isNearGas)
    {
      return isNearFluid ? 1.0 : 0.0;
    }
    const auto height = m_Levels.HeightAbove(p);
    if (height)
    {
      const double share = NormalDistribution(-*height / m_Levels.Blur());
      if (!this->IsRefuted(share, p))
      {
        return share < Negligible ? 0.0 : share > 1.0 - Negligible ? 1.0 : share;
      }
    }
    return m_Hu[p] > m_Lumen.thresholds.tissue ? 1.0 : 0.0;
  }

  Share
  DirectShare(std::size_t p) const
  {
    Share share;
    if (std::min(m_ToGas[p], m_ToFluid[p]) > Shell)
    {
      return share;
    }
    share.fluid = static_cast<float>(this->FluidShare(p));
    const double contrast = this->Contrast(share.fluid, p);
    const double safe = contrast < 0.0 ? std::min(contrast, -1.0) : std::max(contrast, 1.0);
    share.lumen =
      static_cast<float>(std::clamp((m_Hu[p] - m_Lumen.thresholds.tissue) / safe, -Overshoot, 1.0 + Overshoot));
    return share;
  }

  /** Reliability of a voxel value, computed on demand, since few voxels contain both gas and fluid. */
  float
  Weight(std::size_t p) const
  {
    const float fluid = m_FluidParts[p];
    if (!(fluid > 0.0F && fluid < 1.0F))
    {
      return 1.0F;
    }
    const double contrast = this->Contrast(fluid, p);
    const double full = m_Lumen.thresholds.tissue - m_Lumen.thresholds.gas;
    return static_cast<float>(std::min(1.0, contrast * contrast / (full * full)));
  }

  /** Lumen fraction; where a mixture of gas and fluid resembles tissue, interpolated linearly between the fractions
   * above and below. */
  double
  Continued(std::size_t p) const
  {
    const float  own = m_LumenShares[p];
    const double trust = std::clamp((this->Weight(p) - 0.1) / 0.3, 0.0, 1.0);
    if (trust >= 1.0)
    {
      return own;
    }
    double     s0 = 0.0, s1 = 0.0, s2 = 0.0, y0 = 0.0, y1 = 0.0;
    const auto v = m_Grid.Voxel(p);
    const int  steps = static_cast<int>(std::ceil(3.0 / m_Fall.step));
    for (int t = -steps; t <= steps; ++t)
    {
      const auto o = m_Fall.Offset(t);
      if (m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        const auto   q = m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2]);
        const float  other = m_LumenShares[q];
        const double x = t * m_Fall.step;
        const double w = this->Weight(q) * std::exp(-0.5 * x * x / (ContinuedOver * ContinuedOver));
        s0 += w;
        s1 += w * x;
        s2 += w * x * x;
        y0 += w * other;
        y1 += w * x * other;
      }
    }
    const double determinant = s0 * s2 - s1 * s1;
    const double line = determinant > 1e-9 ? (s2 * y0 - s1 * y1) / determinant : own;
    return trust * own + (1.0 - trust) * line;
  }

  /** Limits the occupancy according to the distance from the label border, since an edge has no influence beyond the
   * blur. */
  float
  Bounded(double share, bool isLumen, double toWall, double toLumen) const
  {
    const double half = 0.5 * m_Grid.spacing.maxCoeff();
    if (isLumen)
    {
      const double least = NormalDistribution((toWall - half) / m_Blur - 1.0);
      return static_cast<float>(std::clamp(share, least, 1.0));
    }
    if (toLumen > Shell)
    {
      return 0.0F;
    }
    const double most = NormalDistribution(1.0 - (toLumen - half) / m_Blur);
    const double seen = std::clamp(share, 0.0, most);
    return seen < LeastSeen ? 0.0F : static_cast<float>(seen);
  }

  /** Restores curved walls in fluid by one step of inverse diffusion, whose rate is limited by the voxel size. Blur
   * shrinks the half height surface at crests of folds and heads of polyps. */
  float
  Sharpened(std::size_t p) const
  {
    const auto   v = m_Grid.Voxel(p);
    const double own = m_Occupancy[p];
    double       change = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      if (m_FluidParts[p] < OnlyFluid || v[a] == 0 || v[a] + 1 == m_Grid.size[a])
      {
        return m_Occupancy[p];
      }
      const auto q = p - m_Grid.stride[a];
      const auto r = p + m_Grid.stride[a];
      const bool isFluid =
        (m_FluidParts[q] > 0.99F || m_Occupancy[q] < 0.01F) && (m_FluidParts[r] > 0.99F || m_Occupancy[r] < 0.01F);
      if (!isFluid)
      {
        return m_Occupancy[p];
      }
      const double rate =
        std::min(0.5 * ScannerBlur * ScannerBlur / (m_Grid.spacing[a] * m_Grid.spacing[a]), GreatestRate);
      change += rate * (m_Occupancy[q] + m_Occupancy[r] - 2.0 * own);
    }
    return static_cast<float>(std::clamp(own - change, 0.0, 1.0));
  }

  ColonImage::Pointer
  MakeOccupancy() const
  {
    auto                   image = ColonImage::New();
    ColonImage::IndexType  first = m_Image->GetBufferedRegion().GetIndex();
    ColonImage::RegionType region;
    ColonGrid              grid = m_Grid;
    for (int a = 0; a < 3; ++a)
    {
      region.SetSize(m_Grid.imageAxis[a], m_Grid.size[a]);
      first[m_Grid.imageAxis[a]] += m_Grid.corner[a];
      grid.corner[a] = 0;
    }
    ColonImage::PointType origin;
    m_Image->TransformIndexToPhysicalPoint(first, origin);
    image->CopyInformation(m_Image);
    image->SetOrigin(origin);
    image->SetRegions(region);
    image->Allocate();
    float * out = image->GetBufferPointer();
    ForEachVoxel(image, grid, [&](std::size_t to, std::size_t from) { out[to] = m_Occupancy[from]; });
    return image;
  }

  /** Creates the cleansed CT: replaces the fluid fraction of each voxel by gas; pure lumen voxels become gas. */
  ColonImage::Pointer
  MakeCleansed() const
  {
    const auto & t = m_Lumen.thresholds;
    const auto   image = NewImageOn<ColonImage>(m_Image);
    float *      out = image->GetBufferPointer();
    std::copy_n(m_Image->GetBufferPointer(), m_Image->GetBufferedRegion().GetNumberOfPixels(), out);
    ForEachVoxel(m_Image, m_Grid, [&](std::size_t to, std::size_t p) {
      const double fluid = m_FluidParts[p] * m_Occupancy[p];
      if (fluid <= 0.001)
      {
        return;
      }
      const float  sharp = this->Sharpened(p);
      const double value = out[to] - fluid * (this->FluidAt(p) - t.gas) - (sharp - m_Occupancy[p]) * (t.tissue - t.gas);
      const double most = t.gas + (1.0 - sharp) * (std::max<double>(out[to], t.tissue) - t.gas) + 2.0 * m_Lumen.noise;
      out[to] = static_cast<float>(std::max(t.gas, std::min(value, most)));
    });
    return image;
  }

  const ColonImage *         m_Image;
  const ColonLumen &         m_Lumen;
  ColonGrid                  m_Grid;
  GravitySteps               m_Fall;
  VoxelValues                m_Hu;
  std::vector<unsigned char> m_Labels;
  LocalFluid                 m_Fluid;
  LevelSurface               m_Levels;
  double                     m_Blur;
  VoxelValues                m_ToGas;
  VoxelValues                m_ToFluid;
  VoxelValues                m_ToLumen;
  VoxelValues                m_LumenShares;
  VoxelValues                m_FluidParts; ///< fractions of the lumen
  VoxelValues                m_Occupancy;
};

VoxelBox
BoxOfLabels(const ColonLumen & lumen, const ColonGrid & grid)
{
  std::vector<VoxelBox> ofSlice(grid.size[2]);
  const auto *          labels = lumen.labels->GetBufferPointer();
  ForEachVoxel(lumen.labels, grid, [&](std::size_t q, std::size_t p) {
    if (labels[q] != 0)
    {
      const auto v = grid.Voxel(p);
      auto &     box = ofSlice[v[2]];
      const bool isNew = box.IsEmpty();
      for (int a = 0; a < 3; ++a)
      {
        box.low[a] = isNew ? v[a] : std::min(box.low[a], v[a]);
        box.high[a] = isNew ? v[a] + 1 : std::max(box.high[a], v[a] + 1);
      }
    }
  });
  VoxelBox whole;
  for (const auto & box : ofSlice)
  {
    const bool isNew = whole.IsEmpty();
    for (int a = 0; a < 3 && !box.IsEmpty(); ++a)
    {
      whole.low[a] = isNew ? box.low[a] : std::min(whole.low[a], box.low[a]);
      whole.high[a] = isNew ? box.high[a] : std::max(whole.high[a], box.high[a]);
    }
  }
  return whole;
}
} // namespace

CleansedColon
CleanseColon(const itk::Image<float, 3> * ct, const ColonLumen & lumen, const Progress & progress)
{
  if (!lumen.labels || lumen.labels->GetBufferedRegion() != ct->GetBufferedRegion())
  {
    throw std::invalid_argument("CleanseColon: the labels are not on the grid of the image");
  }
  const ColonGrid whole = GridOfImage(ct);
  VoxelBox        box = BoxOfLabels(lumen, whole);
  if (box.IsEmpty())
  {
    box.high = { { 1, 1, 1 } };
  }
  progress(0.0);
  return Cleansing(ct, lumen, whole.Part(whole.Widened(box, Margin))).Run(progress);
}
} // namespace shapeton
