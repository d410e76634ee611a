#include "shapetonColonPhantomImageSource.h"

#include "shapetonBodySampler.h"
#include "shapetonColonAbdomen.h"
#include "shapetonCorrelatedNoise.h"
#include "shapetonFilterProgress.h"
#include "shapetonLumenLabels.h"
#include "shapetonParallelFor.h"

#include "itkImageRegionIterator.h"
#include "itkImageRegionSplitterMultidimensional.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace shapeton
{
namespace
{
using RegionType = itk::ImageRegion<3>;
using ImageType = ColonPhantomImageSource::ImageType;

constexpr itk::SizeValueType tileSide = 32; // voxels; chosen for speed

/** Effect of a reconstruction kernel on blur and noise. */
struct Kernel
{
  double                blur;             ///< factor
  std::array<double, 3> noiseCorrelation; ///< along x, y and z
};

// Measured on CT colonographies for the standard and the sharp kernel; extrapolated for the soft one.
constexpr Kernel sharpKernel{ 0.75, { { 0.39, 0.32, 0.33 } } };
constexpr Kernel softKernel{ 1.2, { { 0.66, 0.5, 0.5 } } };
constexpr Kernel standardKernel{ 1.0, { { 0.63, 0.14, 0.42 } } };

/** Default voxels of a CT that covers the abdomen. */
constexpr itk::SizeValueType defaultColumns = 256;
constexpr itk::SizeValueType defaultSlices = 240;
constexpr double             defaultSpacing = 1.4; // mm

Kernel
KernelOf(const std::string & name)
{
  if (name == "sharp")
  {
    return sharpKernel;
  }
  return name == "soft" ? softKernel : standardKernel;
}

// The tiles do not depend on the number of threads.
std::vector<RegionType>
TilesOf(const RegionType & region)
{
  std::vector<RegionType> tiles;
  RegionType              tile;
  for (itk::SizeValueType z = 0; z < region.GetSize(2); z += tileSide)
  {
    for (itk::SizeValueType y = 0; y < region.GetSize(1); y += tileSide)
    {
      for (itk::SizeValueType x = 0; x < region.GetSize(0); x += tileSide)
      {
        const itk::SizeValueType start[3] = { x, y, z };
        for (unsigned int i = 0; i < 3; ++i)
        {
          tile.SetIndex(i, region.GetIndex(i) + static_cast<itk::IndexValueType>(start[i]));
          tile.SetSize(i, std::min(tileSide, region.GetSize(i) - start[i]));
        }
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

std::uint64_t
NoiseSeed(const ColonPhantomParameters & parameters)
{
  return (std::uint64_t{ parameters.seed } << 8) + static_cast<unsigned char>(parameters.position[0]);
}
} // namespace

ColonPhantomImageSource::ColonPhantomImageSource() : PhantomImageSource(4)
{
  SizeType size;
  size.Fill(defaultColumns);
  size[2] = defaultSlices;
  this->SetSize(size);
  SpacingType spacing;
  spacing.Fill(defaultSpacing);
  this->SetSpacing(spacing);
  this->CenterOutput();
}

void
ColonPhantomImageSource::SetParameters(const ColonPhantomParameters & parameters)
{
  RequireValid(parameters);
  m_Parameters = parameters;
  m_Structures.reset();
  m_Fluid.reset();
  m_Anatomy.reset();
  this->Modified();
}

const ColonAnatomy &
ColonPhantomImageSource::GetAnatomy()
{
  if (!m_Anatomy)
  {
    m_Anatomy = std::make_unique<const ColonAnatomy>(m_Parameters);
  }
  return *m_Anatomy;
}

const ColonFluid &
ColonPhantomImageSource::GetFluid()
{
  if (!m_Fluid)
  {
    m_Fluid = std::make_unique<const ColonFluid>(this->GetAnatomy());
  }
  return *m_Fluid;
}

const ColonStructures &
ColonPhantomImageSource::GetStructures()
{
  if (!m_Structures)
  {
    m_Structures = std::make_unique<const ColonStructures>(this->GetAnatomy(), this->GetFluid());
  }
  return *m_Structures;
}

void
ColonPhantomImageSource::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const SpacingType spacing = this->GetSpacing();
  if (!std::all_of(spacing.Begin(), spacing.End(), [](double s) { return s > 0.0 && std::isfinite(s); }))
  {
    itkExceptionMacro("the spacing " << spacing << " is not positive");
  }
}

void
ColonPhantomImageSource::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

void
ColonPhantomImageSource::GenerateData()
{
  LabelImageType * const lumen = this->GetLumenOutput();
  LabelImageType * const segments = this->GetSegmentOutput();
  LabelImageType * const structures = this->GetStructureOutput();
  for (LabelImageType * const output : { lumen, segments, structures })
  {
    output->SetBufferedRegion(output->GetRequestedRegion());
    output->Allocate(true);
  }
  const bool                    hasColon = Contains(m_Parameters, "colon");
  const ColonAnatomy &          anatomy = this->GetAnatomy();
  const ColonFluid &            fluid = this->GetFluid();
  const ColonStructures &       known = this->GetStructures();
  const std::vector<RegionType> tiles = TilesOf(lumen->GetLargestPossibleRegion());
  ParallelFor(
    tiles.size(),
    [&](std::size_t i) {
      if (hasColon)
      {
        FillLumenLabels(anatomy, fluid, tiles[i], lumen, segments);
      }
      known.Fill(structures, tiles[i]);
    },
    m_TruthOnly ? this->Reporter() : Progress());
  if (!m_TruthOnly)
  {
    this->PaintImage(tiles);
  }
}

Progress
ColonPhantomImageSource::Reporter()
{
  return [this](double share) { ReportProgress(*this, share); };
}

void
ColonPhantomImageSource::PaintImage(const std::vector<OutputImageRegionType> & tiles)
{
  ImageType * const image = this->GetOutput();
  image->SetBufferedRegion(image->GetRequestedRegion());
  image->Allocate();
  const ColonPhantomParameters & parameters = this->GetAnatomy().GetParameters(); // including drawn values
  const Kernel                   kernel = KernelOf(parameters.kernel);
  const double                   blur = kernel.blur * m_Blur;
  const double          along = std::sqrt(blur * blur + parameters.sliceThickness * parameters.sliceThickness / 12.0);
  const BodySampler     sampler(MakeColonAbdomen(this->GetAnatomy(), this->GetFluid(), this->GetStructures()),
                            image,
                            { { blur, blur, parameters.sliceThickness > 0.0 ? along : blur } },
                            airIntensity);
  const CorrelatedNoise noise(
    NoiseSeed(m_Parameters), image->GetLargestPossibleRegion(), parameters.noise, kernel.noiseCorrelation);
  ParallelFor(
    tiles.size(),
    [&](std::size_t i) {
      std::vector<float> values = sampler.Sample(tiles[i]);
      noise.AddTo(values, tiles[i]);
      itk::ImageRegionIterator<ImageType> it(image, tiles[i]);
      for (const float value : values)
      {
        it.Set(ToHounsfieldUnits(value));
        ++it;
      }
    },
    this->Reporter());
}

void
ColonPhantomImageSource::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << m_Parameters.seed << '\n';
  os << indent << "Position: " << m_Parameters.position << '\n';
  os << indent << "Preset: " << m_Parameters.preset << '\n';
  os << indent << "Lungs: " << m_Parameters.lungs << '\n';
  os << indent << "Blur: " << m_Blur << '\n';
  os << indent << "TruthOnly: " << m_TruthOnly << '\n';
}
} // namespace shapeton
