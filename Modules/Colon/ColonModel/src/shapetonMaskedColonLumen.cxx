#include "shapetonMaskedColonLumen.h"

#include "shapetonColonGravity.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonQuantiles.h"

#include "itkImageRegionConstIterator.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkImageRegionIterator.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr unsigned char Gas = 1;              // label of a LumenMask
constexpr unsigned char Fluid = 2;            // label of a LumenMask
constexpr double        TypicalTissue = 40.0; // HU; soft tissue, as in ModeOfTissue()
/** Bounds on the values (HU) of the voxels from which gas and tagged fluid are measured, and the minimum number of
 * fluid voxels. */
constexpr float       GreatestOfGas = -600.0F;
constexpr float       LeastOfFluid = 150.0F;
constexpr std::size_t LeastFluidVoxels = 20;
/** Seed thresholds of gas and fluid as in the segmentation of the CT: a fifth of the way from gas to tissue, and 0.7 of
 * the way from tissue to fluid. The latter is relative because a fixed threshold of 200 HU includes bone and small
 * bowel. */
constexpr double GasSeedOfTissue = 0.2;
constexpr double GasSeedOfGas = 0.8;
constexpr double FluidSeedShare = 0.7;

double
VoxelMl(const itk::ImageBase<3> * image)
{
  const auto & spacing = image->GetSpacing();
  return 1e-3 * spacing[0] * spacing[1] * spacing[2];
}

/** Accumulated sums of a piece. */
struct PieceSums
{
  double                 gas{ 0.0 };
  double                 fluid{ 0.0 };
  double                 gasHU{ 0.0 };
  double                 radius{ 0.0 };
  itk::Vector<double, 3> gasPlace{ 0.0 };
  itk::Vector<double, 3> fluidPlace{ 0.0 };
};

/** Computes sums over the components of the labels; `ct` may be null. */
std::vector<PieceSums>
SumPieces(const itk::Image<float, 3> * ct, const LumenMask * labels, const LumenDistanceImage * distance)
{
  const auto                                        region = distance->GetBufferedRegion();
  const auto                                        components = FindLumenComponents(labels, region);
  std::vector<PieceSums>                            sums(components.components.size());
  itk::ImageRegionConstIterator<LumenLabelImage>    piece(components.labels, components.labels->GetBufferedRegion());
  itk::ImageRegionConstIterator<LumenDistanceImage> depth(distance, distance->GetBufferedRegion());
  itk::ImageRegionConstIteratorWithIndex<LumenMask> label(labels, region);
  for (; !label.IsAtEnd(); ++label, ++piece, ++depth)
  {
    if (label.Get() == 0)
    {
      continue;
    }
    PieceSums &            sum = sums[static_cast<std::size_t>(piece.Get()) - 1];
    const auto             point = labels->TransformIndexToPhysicalPoint<double>(label.GetIndex());
    const bool             isGas = label.Get() == Gas;
    itk::Vector<double, 3> place = point.GetVectorFromOrigin();
    (isGas ? sum.gas : sum.fluid) += 1.0;
    (isGas ? sum.gasPlace : sum.fluidPlace) += place;
    sum.gasHU += isGas && ct ? ct->GetPixel(label.GetIndex()) : 0.0;
    sum.radius = std::max(sum.radius, static_cast<double>(depth.Get()));
  }
  return sums;
}

void
DescribePieces(const std::vector<PieceSums> & sums, double voxelMl, ColonLumen & lumen)
{
  for (const PieceSums & sum : sums)
  {
    LumenPiece piece;
    piece.gasMl = voxelMl * sum.gas;
    piece.fluidMl = voxelMl * sum.fluid;
    piece.inscribedRadius = sum.radius;
    piece.meanGasHU = sum.gas > 0.0 ? sum.gasHU / sum.gas : 0.0;
    const auto center = (sum.gasPlace + sum.fluidPlace) / (sum.gas + sum.fluid);
    piece.center = itk::Point<double, 3>(center.GetDataPointer());
    lumen.pieces.push_back(piece);
  }
}

/** Estimates gravity by comparing the positions of gas and fluid in each piece. */
void
ChooseGravity(const std::vector<PieceSums> & sums, const std::string & position, ColonLumen & lumen)
{
  if (const auto given = GivenGravity(position))
  {
    lumen.gravity = *given;
    lumen.gravitySource = ColonGravitySource::PatientPosition;
    return;
  }
  itk::Vector<double, 3> down(0.0);
  for (const PieceSums & sum : sums)
  {
    if (sum.gas > 0.0 && sum.fluid > 0.0)
    {
      down += (sum.fluidPlace / sum.fluid - sum.gasPlace / sum.gas) * std::min(sum.gas, sum.fluid);
    }
  }
  if (down.GetNorm() > 0.0)
  {
    lumen.gravity = *GravityOfPatientPosition(NameOfGravity(down));
    lumen.gravitySource = ColonGravitySource::Levels;
    return;
  }
  lumen.gravity = *GravityOfPatientPosition("supine");
  lumen.warnings.push_back("no patient position is given and the lumen contains no fluid; supine is assumed");
}

/** Intensities of pure gas and fluid, from voxels at least 2 mm and 1.5 voxels deep. */
void
MeasureThresholds(const itk::Image<float, 3> * ct, const LumenDistanceImage * distance, ColonLumen & lumen)
{
  const auto         region = distance->GetBufferedRegion();
  const auto &       spacing = distance->GetSpacing();
  const double       deep = std::max(2.0, 1.5 * *std::max_element(spacing.Begin(), spacing.End()));
  std::vector<float> gas;
  std::vector<float> fluid;
  itk::ImageRegionConstIterator<itk::Image<float, 3>> value(ct, region);
  itk::ImageRegionConstIterator<LumenDistanceImage>   depth(distance, distance->GetBufferedRegion());
  for (; !value.IsAtEnd(); ++value, ++depth)
  {
    if (depth.Get() >= deep)
    {
      (value.Get() < GreatestOfGas ? gas : fluid).push_back(value.Get());
    }
  }
  if (gas.empty())
  {
    throw InputError(
      "the given lumen contains no gas: all its voxels away from the wall are above -600 HU; give its CT, "
      "in HU");
  }
  ColonThresholds & thresholds = lumen.thresholds;
  thresholds.tissue = TypicalTissue;
  thresholds.gas = UpperMedian(std::move(gas));
  thresholds.gasBoundary = 0.5 * (thresholds.gas + thresholds.tissue);
  thresholds.gasSeed = GasSeedOfTissue * thresholds.tissue + GasSeedOfGas * thresholds.gas;
  fluid.erase(std::remove_if(fluid.begin(), fluid.end(), [](float v) { return v < LeastOfFluid; }), fluid.end());
  lumen.isTagged = fluid.size() >= LeastFluidVoxels;
  if (lumen.isTagged)
  {
    thresholds.fluid = UpperMedian(std::move(fluid));
    thresholds.fluidBoundary = 0.5 * (thresholds.fluid + thresholds.tissue);
    thresholds.fluidSeed = thresholds.tissue + FluidSeedShare * (thresholds.fluid - thresholds.tissue);
  }
}
} // namespace

ColonLumen
ColonLumenOfMask(const itk::Image<float, 3> * ct, const LumenMask * mask, const ColonLumenOptions & options)
{
  ColonLumen lumen;
  const auto distance = LumenDistance(mask, LumenRegion(mask));
  MeasureThresholds(ct, distance, lumen);
  lumen.labels = NewImageOn<LumenMask>(mask);
  const auto                                          region = mask->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<LumenMask>            inside(mask, region);
  itk::ImageRegionConstIterator<itk::Image<float, 3>> value(ct, region);
  itk::ImageRegionIterator<LumenMask>                 label(lumen.labels, region);
  for (; !label.IsAtEnd(); ++label, ++inside, ++value)
  {
    const bool isGas = !lumen.isTagged || value.Get() < lumen.thresholds.gasBoundary;
    label.Set(inside.Get() == 0 ? 0 : isGas ? Gas : Fluid);
  }
  const auto sums = SumPieces(ct, lumen.labels, distance);
  DescribePieces(sums, VoxelMl(mask), lumen);
  ChooseGravity(sums, PatientPositionOf(ct, options.position), lumen);
  lumen.failure = FailureOfMask(ct, mask);
  return lumen;
}

ColonLumen
ColonLumenOfMask(const LumenMask * mask)
{
  ColonLumen lumen;
  lumen.labels = NewImageOn<LumenMask>(mask);
  const auto                               region = mask->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<LumenMask> inside(mask, region);
  itk::ImageRegionIterator<LumenMask>      label(lumen.labels, region);
  for (; !label.IsAtEnd(); ++label, ++inside)
  {
    label.Set(inside.Get() == 0 ? 0 : Gas);
  }
  DescribePieces(SumPieces(nullptr, lumen.labels, LumenDistance(mask, LumenRegion(mask))), VoxelMl(mask), lumen);
  return lumen;
}
} // namespace shapeton
