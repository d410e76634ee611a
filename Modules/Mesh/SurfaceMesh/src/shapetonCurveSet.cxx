#include "shapetonCurveSet.h"
#include "shapetonFileBytes.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
void
RequireVertices(const CurveSet & curves, const std::string & what)
{
  for (std::size_t c = 0; c < curves.curves.size(); ++c)
  {
    const std::vector<int> & curve = curves.curves[c];
    if (curve.empty())
    {
      throw InputError(what + ": curve " + std::to_string(c) + " has no vertices; correct it");
    }
    for (const int v : curve)
    {
      if (v < 0 || v >= curves.V.rows())
      {
        throw InputError(what + ": curve " + std::to_string(c) + " refers to vertex " + std::to_string(v) +
                         ", but there are " + std::to_string(curves.V.rows()) + "; correct it");
      }
    }
  }
}

/** The curves in VTK cell order: points, then lines. Cell array rows of faces stay last. */
CurveSet
PointsFirst(CurveSet curves, int faces)
{
  std::vector<int> order(curves.curves.size() + faces);
  std::iota(order.begin(), order.end(), 0);
  const auto endOfCurves = order.end() - faces;
  std::stable_partition(order.begin(), endOfCurves, [&](int c) { return curves.curves[c].size() == 1; });
  std::vector<std::vector<int>> sorted(curves.curves.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    sorted[i] = std::move(curves.curves[order[i]]);
  }
  curves.curves = std::move(sorted);
  curves.cellArrays = RowsOfArrays(curves.cellArrays, order);
  return curves;
}

void
RequireVtp(const std::string & path)
{
  RequireParameter(SurfaceExtension(path) == "vtp",
                   "\"" + path + "\" does not have the extension of a curve format; use .vtp");
}

/** Checks cell arrays with rows for `faces` additional faces; an empty curve set is valid. */
void
RequireConsistent(const CurveSet & curves, Eigen::Index faces, const std::string & what)
{
  for (Eigen::Index vertex = 0; vertex < curves.V.rows(); ++vertex)
  {
    RequireFinite(curves.V, vertex, what);
  }
  RequireVertices(curves, what);
  RequireRows(curves.pointArrays, curves.V.rows(), what);
  RequireRows(curves.cellArrays, static_cast<Eigen::Index>(curves.curves.size()) + faces, what);
}
} // namespace

void
RequireSound(const CurveSet & curves, const std::string & what)
{
  if (curves.V.rows() == 0)
  {
    throw InputError(what + ": there are no points; use a file with lines or points");
  }
  RequireConsistent(curves, 0, what);
}

Eigen::VectorXd
PointValues(const CurveSet & curves, const std::string & array, const std::string & what)
{
  const SurfaceArray * const found = FindSurfaceArray(curves.pointArrays, array);
  if (!found || found->values.cols() != 1)
  {
    throw InputError(what + ": the point array \"" + array +
                     "\" with one component is missing; use a file with this array");
  }
  return found->values.col(0);
}

void
WriteCurves(CurveSet curves, const std::string & path)
{
  RequireVtp(path);
  RequireConsistent(curves, 0, "the curves");
  WriteVtp(PointsFirst(std::move(curves), 0), {}, path);
}

void
WriteCurvesOnSurface(CurveSet curves, const FaceMatrix & faces, const std::string & path)
{
  RequireVtp(path);
  RequireConsistent(curves, faces.rows(), "the curves");
  const SurfaceMesh surface{ curves.V, faces, {}, {}, {}, {} };
  RequireSound(surface, "the surface of the curves");
  WriteVtp(PointsFirst(std::move(curves), static_cast<int>(faces.rows())), faces, path);
}

CurveSet
ReadCurves(const std::string & path)
{
  if (SurfaceExtension(path) != "vtp")
  {
    RefuseSurface(path, "not a curve format", "use a .vtp file");
  }
  PolygonSurface read = ReadVtpCurves(ReadFileBytes(path), path);
  CurveSet       curves;
  curves.V = Eigen::Map<const VertexMatrix>(read.points.data(), static_cast<Eigen::Index>(read.points.size() / 3), 3);
  std::size_t begin = 0;
  for (const std::size_t end : read.ends)
  {
    curves.curves.emplace_back(read.corners.begin() + begin, read.corners.begin() + end);
    begin = end;
  }
  curves.pointArrays = std::move(read.pointArrays);
  curves.cellArrays = std::move(read.cellArrays);
  curves.fieldArrays = std::move(read.fieldArrays);
  curves.facts = std::move(read.facts);
  RequireConsistent(curves, 0, "\"" + path + "\"");
  if (read.isRas)
  {
    curves.V.leftCols<2>() *= -1.0;
  }
  return curves;
}
} // namespace shapeton
