#include "shapetonFlatSurface.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Arrays of a flat surface. */
constexpr const char * uvName = "uv";
constexpr const char * sourceName = "sourcePointId";
constexpr const char * circumferenceName = "circumference";
constexpr const char * lengthName = "length";

void
SetArray(std::vector<SurfaceArray> & arrays, SurfaceArray array)
{
  arrays.erase(
    std::remove_if(arrays.begin(), arrays.end(), [&](const SurfaceArray & other) { return other.name == array.name; }),
    arrays.end());
  arrays.push_back(std::move(array));
}

void
RemoveArray(std::vector<SurfaceArray> & arrays, const std::string & name)
{
  arrays.erase(
    std::remove_if(arrays.begin(), arrays.end(), [&](const SurfaceArray & array) { return array.name == name; }),
    arrays.end());
}

const SurfaceArray &
RequirePointArray(const SurfaceMesh & flat, const std::string & name, int components, const std::string & what)
{
  const SurfaceArray * array = FindSurfaceArray(flat.pointArrays, name);
  if (!array || array->values.cols() != components || array->values.rows() != flat.V.rows())
  {
    throw InputError(what + " is not a flat surface: it has no point array \"" + name + "\" of " +
                     std::to_string(components) + (components == 1 ? " component" : " components") +
                     "; flatten it with ColonFlattening or ConformalMap");
  }
  return *array;
}

double
RequireExtent(const SurfaceMesh & flat, const std::string & name, const std::string & what)
{
  const SurfaceArray * array = FindSurfaceArray(flat.fieldArrays, name);
  if (!array || array->values.size() != 1)
  {
    throw InputError(what + " has no field array \"" + name + "\" with one value, as in flat tubes; flatten it " +
                     "with ColonFlattening");
  }
  const double value = array->values(0, 0);
  if (!std::isfinite(value) || value <= 0.0)
  {
    throw InputError(what + ": its " + name + " of " + std::to_string(value) + " mm is not positive");
  }
  return value;
}
} // namespace

SurfaceMesh
MakeFlatSurface(CutSurface cut, const Eigen::MatrixX2d & uv)
{
  if (uv.rows() != cut.mesh.V.rows() || !uv.allFinite())
  {
    throw InputError("the flat map has " + std::to_string(uv.rows()) + " places for " +
                     std::to_string(cut.mesh.V.rows()) + " vertices, or a position is not finite");
  }
  SurfaceMesh  flat = std::move(cut.mesh);
  SurfaceArray source{ sourceName, {}, true };
  source.values.resize(uv.rows(), 1);
  for (Eigen::Index i = 0; i < uv.rows(); ++i)
  {
    source.values(i, 0) = cut.sourcePointId[i];
  }
  SetArray(flat.pointArrays, { uvName, uv, false });
  SetArray(flat.pointArrays, std::move(source));
  RemoveArray(flat.fieldArrays, circumferenceName);
  RemoveArray(flat.fieldArrays, lengthName);
  return flat;
}

void
SetFlatExtent(SurfaceMesh & flat, double circumference, double length)
{
  SetArray(flat.fieldArrays, { circumferenceName, SurfaceArray::ValueMatrix::Constant(1, 1, circumference), false });
  SetArray(flat.fieldArrays, { lengthName, SurfaceArray::ValueMatrix::Constant(1, 1, length), false });
}

Eigen::MatrixX2d
FlatCoordinates(const SurfaceMesh & flat, const std::string & what)
{
  const SurfaceArray & array = RequirePointArray(flat, uvName, 2, what);
  if (!array.values.allFinite())
  {
    throw InputError(what + ": its flat map has a position that is not finite; flatten it again");
  }
  return array.values;
}

double
FlatCircumference(const SurfaceMesh & flat, const std::string & what)
{
  return RequireExtent(flat, circumferenceName, what);
}

double
FlatLength(const SurfaceMesh & flat, const std::string & what)
{
  return RequireExtent(flat, lengthName, what);
}

std::vector<int>
FlatSourcePoints(const SurfaceMesh & flat, const std::string & what)
{
  const SurfaceArray & array = RequirePointArray(flat, sourceName, 1, what);
  std::vector<int>     points(flat.NumberOfVertices());
  for (int i = 0; i < flat.NumberOfVertices(); ++i)
  {
    const double point = array.values(i, 0);
    if (!(point >= 0.0 && point <= std::numeric_limits<int>::max() && point == std::floor(point)))
    {
      throw InputError(what + ": its point array " + sourceName + " contains " + std::to_string(point) +
                       ", which is not the number of a point; flatten it again");
    }
    points[i] = static_cast<int>(point);
  }
  return points;
}
} // namespace shapeton
