#include "ScalarPeer.h"

void
ScalarStep(const shapeton::VolumeGradientOperator & volumeGradient, const float * f, float * out, float dt)
{
  const auto &        grid = volumeGradient.GetGrid();
  const std::size_t   sy = grid.GetStride(1);
  const std::size_t   sz = grid.GetStride(2);
  const float * const cx = volumeGradient.GetConductances(0);
  const float * const cy = volumeGradient.GetConductances(1);
  const float * const cz = volumeGradient.GetConductances(2);
  for (std::size_t z = 0; z < grid.GetSize()[2]; ++z)
  {
    for (std::size_t y = 0; y < grid.GetSize()[1]; ++y)
    {
      const std::size_t row = grid.GetRow(y, z);
      for (std::size_t i = row; i < row + grid.GetSize()[0]; ++i)
      {
        const float heat = f[i];
        out[i] =
          heat + dt * (cx[i] * (f[i + 1] - heat) + cx[i - 1] * (f[i - 1] - heat) + cy[i] * (f[i + sy] - heat) +
                       cy[i - sy] * (f[i - sy] - heat) + cz[i] * (f[i + sz] - heat) + cz[i - sz] * (f[i - sz] - heat));
      }
    }
  }
}
