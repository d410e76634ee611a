#ifndef ValidationVolumes_h
#define ValidationVolumes_h

#include "shapetonDiffusionTestVolumes.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonImageGrid.h"
#include "shapetonVolumeReader.h"

#include <stdexcept>

/** Cube of value 1 in the middle of a volume of 0. */
inline shapeton::test::Volume
Cube(std::size_t volumeSide, std::size_t side)
{
  shapeton::test::Volume volume({ volumeSide, volumeSide, volumeSide });
  const std::size_t      first = (volumeSide - side) / 2;
  volume.Fill([=](std::size_t x, std::size_t y, std::size_t z) {
    return std::min({ x, y, z }) >= first && std::max({ x, y, z }) < first + side ? 1.0 : 0.0;
  });
  return volume;
}

/** Heat after each of `steps`, with the tolerance 1e-5. */
inline std::vector<std::vector<float>>
HeatAt(const shapeton::VolumeGradientOperator & volumeGradient,
       const std::vector<std::uint64_t> &       steps,
       shapeton::HeatDiffusionSolver::Method    method = shapeton::HeatDiffusionSolver::Method::Chebyshev)
{
  const auto &                    grid = volumeGradient.GetGrid();
  const std::size_t               nx = grid.GetSize()[0];
  std::vector<std::vector<float>> fields(steps.size(), std::vector<float>(grid.GetNumberOfVoxels()));
  shapeton::PaddedField           heat(grid);
  volumeGradient.ComputeInitialHeat(heat);
  shapeton::HeatDiffusionSolver solver(
    volumeGradient, method, shapeton::HeatDiffusionSolver::MaximumTimeStepLength, 1e-5);
  solver.Run(heat, steps.back(), steps, [&](std::size_t i, std::size_t row, const float * values, unsigned int) {
    std::copy(values, values + nx, fields[i].data() + row * nx);
  });
  return fields;
}

/** TotalSegmentator's example, and the labels of its organs. */
struct Abdomen
{
  shapeton::Volume ct, organs;
};
inline Abdomen
ReadAbdomen(const std::string & dataFolder)
{
  const std::string folder = dataFolder + "/ct/totalsegmentator";
  Abdomen           abdomen{ shapeton::ReadVolume(folder + "/example_ct.nii.gz"),
                   shapeton::ReadVolume(folder + "/example_seg_fast_force_split.nii.gz") };
  if (!shapeton::HaveSameGrid(abdomen.ct.image, abdomen.organs.image))
  {
    throw std::runtime_error("the organ labels have another grid than the CT");
  }
  return abdomen;
}

template <typename TA, typename TB>
double
Correlation(const std::vector<TA> & a, const std::vector<TB> & b)
{
  const double n = static_cast<double>(a.size());
  double       sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sa += a[i];
    sb += b[i];
    saa += static_cast<double>(a[i]) * a[i];
    sbb += static_cast<double>(b[i]) * b[i];
    sab += static_cast<double>(a[i]) * b[i];
  }
  return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

#endif
