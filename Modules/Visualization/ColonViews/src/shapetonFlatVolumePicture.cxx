#include "shapetonFlatColonStrip.h"

#include "shapetonCsvTable.h"
#include "shapetonStripPainter.h"
#include "shapetonExceptions.h"
#include "shapetonTrilinearVolume.h"

#include <array>

namespace shapeton
{
namespace
{
/** The colour of tissue by its Hounsfield units: fat, soft tissue, contrast medium and bone. */
class TissueColors
{
public:
  TissueColors()
  {
    struct Stop
    {
      double   hu;
      RGBColor color;
    };
    static const Stop stops[] = { { -700.0, MakeColor(238, 176, 160) }, { -250.0, MakeColor(234, 160, 144) },
                                  { -100.0, MakeColor(236, 170, 150) }, { 20.0, MakeColor(234, 164, 148) },
                                  { 120.0, MakeColor(222, 128, 116) },  { 250.0, MakeColor(240, 236, 214) },
                                  { 600.0, MakeColor(255, 255, 246) } };
    constexpr int     last = sizeof(stops) / sizeof(stops[0]) - 1;
    for (int i = 0; i < size; ++i)
    {
      const double hu = lowest + i * step;
      int          k = 0;
      while (k < last - 1 && stops[k + 1].hu < hu)
      {
        ++k;
      }
      const double share = std::clamp((hu - stops[k].hu) / (stops[k + 1].hu - stops[k].hu), 0.0, 1.0);
      m_Colors[i] = ToLinear(MixColors(stops[k].color, stops[k + 1].color, share));
    }
  }
  const LinearColor &
  Of(float hu) const
  {
    return m_Colors[std::clamp(static_cast<int>((hu - lowest) / step), 0, size - 1)];
  }

private:
  static constexpr int          size = 512;
  static constexpr float        lowest = -900.0F;
  static constexpr float        step = 4.0F;
  std::array<LinearColor, size> m_Colors;
};

/** Rays through the wall. */
class WallRays
{
public:
  WallRays(const itk::Image<float, 3> * ct, const FlatVolumeOptions & options)
    : m_Volume(ct), m_Options(options), m_Step(0.4 * m_Volume.SmallestSpacing()), m_StepsBehind(1.5 / 0.4)
  {}

  RGBColor
  Cast(const FlatSample & sample, const FlatColonFrame & frame) const
  {
    const Eigen::Vector3d surface = m_Volume.IndexOf(sample.point);
    const double reach = std::max(m_Options.depthOfLumen, m_Options.depthOfWall) + 3.0 * m_Volume.SmallestSpacing();
    return m_Volume.HoldsBall(surface, reach) ? this->Cast<true>(surface, sample, frame)
                                              : this->Cast<false>(surface, sample, frame);
  }

private:
  template <bool IsInside>
  RGBColor
  Cast(const Eigen::Vector3d & surface, const FlatSample & sample, const FlatColonFrame & frame) const
  {
    constexpr float       faint = 0.12F; // adds so little that the light of the sample before will do
    const Eigen::Vector3d outwards = m_Volume.IndexOfVector(-m_Step * sample.inwardNormal);
    const int             first = this->FirstStep<IsInside>(surface, outwards);
    const int             last = static_cast<int>(std::ceil(m_Options.depthOfWall / m_Step));
    FlatLight             light(frame, sample.inwardNormal);
    LinearColor           color = LinearColor::Zero();
    float                 transparency = 1.0F;
    for (int step = first; step <= last && transparency > 0.01F; ++step)
    {
      const Eigen::Vector3d place = surface + step * outwards;
      const float           hu = m_Volume.At<IsInside>(place);
      const float           weight = transparency * this->Opacity(hu);
      if (weight > faint)
      {
        light = FlatLight(frame, this->Normal<IsInside>(place, sample.inwardNormal));
      }
      if (weight > 0.0F)
      {
        const bool  isBoundary = hu < m_Options.tissue;
        const float behind = isBoundary ? m_Volume.At<IsInside>(place + m_StepsBehind * outwards) : hu;
        color += weight * ((light.brightness * m_Colors.Of(std::max(hu, behind))).array() + light.highlight).matrix();
        transparency -= weight;
      }
    }
    return FromLinear(color + transparency * m_Nothing);
  }
  /** The furthest step into the lumen without tissue between it and the surface. */
  template <bool IsInside>
  int
  FirstStep(const Eigen::Vector3d & surface, const Eigen::Vector3d & outwards) const
  {
    const auto boundary = static_cast<float>(0.5 * (m_Options.gas + m_Options.tissue));
    const int  furthest = static_cast<int>(std::ceil(m_Options.depthOfLumen / m_Step));
    bool       wasGas = false;
    int        step = 0;
    for (; step < furthest; ++step)
    {
      const bool isGas = m_Volume.At<IsInside>(surface - (step + 1) * outwards) < boundary;
      if (wasGas && !isGas)
      {
        break; // the other side of a fold or of the lumen
      }
      wasGas = isGas;
    }
    return -step;
  }
  float
  Opacity(float hu) const
  {
    if (hu <= m_Options.gas)
    {
      return 0.0F;
    }
    const double share = std::clamp((hu - m_Options.gas) / (m_Options.tissue - m_Options.gas), 0.0, 1.0);
    const double smooth = share * share * (3.0 - 2.0 * share);
    return static_cast<float>(1.0 - std::exp(-smooth * m_Options.extinction * m_Step));
  }
  /** Against the gradient, towards the gas; that of the surface where the CT is even. */
  template <bool IsInside>
  Eigen::Vector3d
  Normal(const Eigen::Vector3d & place, const Eigen::Vector3d & ofSurface) const
  {
    constexpr double      weak = 60.0; // HU per mm, above the noise of a smooth region
    const Eigen::Vector3d gradient = m_Volume.GradientAt<IsInside>(place);
    const Eigen::Vector3d sum = weak * ofSurface - gradient;
    return sum.norm() > 0.0 ? Eigen::Vector3d(sum.normalized()) : ofSurface;
  }

  TrilinearVolume   m_Volume;
  FlatVolumeOptions m_Options;
  TissueColors      m_Colors;
  double            m_Step;
  /** The colour is that of a voxel and a half further out: on the boundary the mean of gas and contrast medium would
   * look like tissue. */
  double m_StepsBehind;
  /** Seen where a ray meets no wall. */
  LinearColor m_Nothing = ToLinear(MakeColor(64, 64, 70));
};

void
RequireCover(const FlatColonGrid & grid, const itk::Image<float, 3> * ct)
{
  constexpr double      greatestShare = 0.05;
  const TrilinearVolume volume(ct);
  const auto &          points = grid.Points();
  int                   outside = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    outside += !volume.Holds(volume.IndexOf(points.row(i)));
  }
  const double share = static_cast<double>(outside) / points.rows();
  if (share > greatestShare)
  {
    throw InputError("the volume does not hold the surface: " + CsvTable::Rounded(100.0 * share, 3) +
                     " % of it lie outside; give the CT that the surface was made from");
  }
}
} // namespace

Picture::Pointer
PaintFlatVolume(const FlatColonGrid &        grid,
                const FlatColonAxis &        axis,
                const itk::Image<float, 3> * ct,
                const FlatVolumeOptions &    options)
{
  RequireParameter(options.gas < options.tissue, "the intensity of gas must be below that of tissue");
  RequireParameter(options.depthOfLumen >= 0.0 && options.depthOfWall > 0.0 && options.extinction > 0.0,
                   "depths and extinction of a volume picture must be positive");
  RequireCover(grid, ct);
  const WallRays rays(ct, options);
  return PaintStrip(grid, [&](const FlatSample & sample, int column) {
    return rays.Cast(sample, FrameAt(axis, column, sample.point));
  });
}
} // namespace shapeton
