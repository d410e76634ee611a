#include "shapetonOrthonormalDirection.h"

#include "itkVector.h"

#include <cmath>

namespace shapeton
{
namespace
{
using VectorType = itk::Vector<double, 3>;

VectorType
GetColumn(const itk::Matrix<double, 3, 3> & matrix, unsigned int column)
{
  return VectorType(matrix.GetVnlMatrix().get_column(column).data_block());
}

} // namespace

bool
MakeOrthonormal(itk::Matrix<double, 3, 3> & direction, double tolerance)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = i; j < 3; ++j)
    {
      const double product = GetColumn(direction, i) * GetColumn(direction, j);
      if (!(std::abs(product - (i == j ? 1.0 : 0.0)) <= tolerance))
      {
        return false;
      }
    }
  }
  const bool leftHanded = IsLeftHanded(direction);
  VectorType first = GetColumn(direction, 0);
  first /= first.GetNorm();
  VectorType second = GetColumn(direction, 1);
  second -= first * (first * second);
  second /= second.GetNorm();
  const VectorType third = itk::CrossProduct(first, second);
  direction.GetVnlMatrix().set_column(0, first.GetDataPointer());
  direction.GetVnlMatrix().set_column(1, second.GetDataPointer());
  direction.GetVnlMatrix().set_column(2, (leftHanded ? -third : third).GetDataPointer());
  return true;
}

bool
IsLeftHanded(const itk::Matrix<double, 3, 3> & direction)
{
  return itk::CrossProduct(GetColumn(direction, 0), GetColumn(direction, 1)) * GetColumn(direction, 2) < 0.0;
}
} // namespace shapeton
