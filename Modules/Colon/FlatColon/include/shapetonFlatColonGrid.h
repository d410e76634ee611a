#ifndef shapetonFlatColonGrid_h
#define shapetonFlatColonGrid_h

#include "ShapetonFlatColonExport.h"

#include "shapetonFlatColonGridOptions.h"
#include "shapetonSurfaceMesh.h"

#include <limits>

namespace shapeton
{
/** A pixel of the grid. Columns run along the tube, rows around it. \ingroup ShapetonFlatColon */
struct FlatPixel
{
  int column{ 0 };
  int row{ 0 };
};

/** Surface sample at a position on the flat map. \ingroup ShapetonFlatColon */
struct FlatSample
{
  /** -1 in a hole of the surface, where the other members are undefined. */
  int face{ -1 };
  /** Barycentric coordinates in the face, each at least 0; their sum is 1. */
  Eigen::Vector3d barycentric{ Eigen::Vector3d::Zero() };
  /** Point in space, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Unit normal into the lumen. */
  Eigen::Vector3d inwardNormal{ Eigen::Vector3d::Zero() };
  /** Mean curvature (half the sum of the principal curvatures), 1/mm: positive where the wall bulges into the lumen, as
   * at folds and polyps (1/r on a ball of radius r), negative where it bulges outward (-1/(2R) on a tube of radius
   * R). */
  double curvature{ 0.0 };
  /** mm on the surface per mm of the map. */
  double scale{ 1.0 };
  /** Whether this part of the wall bridges a gap. */
  bool isBridged{ false };
  /** Distance along the centerline, mm; NaN if the surface lacks arcLength. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
};

/** \class FlatColonGrid
 * \brief Regular grid of square pixels on the flat map of a tube.
 *
 * The surface is a flat tube from FlattenTube(): V in space (LPS, mm), duplicate vertices along the cut, the point
 * arrays uv (mm at the mean circumference: u along the tube, v around it) and sourcePointId, the field arrays
 * circumference and length (mm). The cell array bridged and the point array arcLength are optional. v may be outside
 * [0, circumference], for example along an uneven cut; it is taken modulo the circumference.
 *
 * The grid image, columns to the right and rows downward, is the view from inside the lumen for any orientation of the
 * faces and of the map: the rows are reversed relative to v if the map is mirrored. Inside is the side of the tube
 * axis.
 *
 * A pixel is assigned to the face that contains its center. Coordinates are rounded to multiples of 2^-14 pixels, and
 * pixel centers on shared edges are assigned by the top-left rule, so there are neither holes nor ties, even along the
 * cut. Where the map overlaps, faces that are not flipped have priority, then lower indices. Samples are computed in
 * double precision.
 *
 * Memory: 4 bytes per pixel and about 130 per face. The result does not depend on the number of threads.
 *
 * \ingroup ShapetonFlatColon
 */
class ShapetonFlatColon_EXPORT FlatColonGrid
{
public:
  /** Throws InputError, prefixed with `what`, if an array is missing or malformed, a value is not finite, or the map is
   * not a flat tube. Throws ParameterError if the pixel size is not positive or requires more than 65,536 pixels along
   * an axis or 2^27 in total. */
  explicit FlatColonGrid(const SurfaceMesh &          flat,
                         const FlatColonGridOptions & options = {},
                         const std::string &          what = "the flat surface");
  ~FlatColonGrid();

  /** Number of pixels along the tube. */
  int
  Columns() const
  {
    return m_Columns;
  }
  /** Number of pixels per turn around the tube. */
  int
  Rows() const
  {
    return m_Rows;
  }
  /** Pixel size in mm of the map: the circumference divided by the number of rows. */
  double
  PixelSize() const
  {
    return m_PixelSize;
  }
  /** Mean circumference of the tube, mm. */
  double
  Circumference() const
  {
    return m_Circumference;
  }
  /** Length in mm of the map. */
  double
  Length() const
  {
    return m_Length;
  }
  bool
  HasArcLength() const
  {
    return m_ArcLength.size() > 0;
  }
  /** Whether v decreases from row to row. */
  bool
  IsMirrored() const
  {
    return m_IsMirrored;
  }
  /** Number of pixels outside all faces. */
  int
  UncoveredPixels() const
  {
    return m_UncoveredPixels;
  }

  /** The face under the center of a pixel, or -1. Rows are taken modulo Rows(). */
  int
  FaceOfPixel(int column, int row) const
  {
    return m_FaceOfPixel[static_cast<std::size_t>(Wrap(row)) * m_Columns + column];
  }
  /** Whether the wall at the pixel bridges a gap. */
  bool
  IsBridged(int column, int row) const
  {
    const int face = this->FaceOfPixel(column, row);
    return face >= 0 && !m_IsBridged.empty() && m_IsBridged[face] != 0;
  }
  /** (u, v) of the center of a pixel. */
  Eigen::Vector2d
  UvOfPixel(int column, int row) const;
  /** The pixel that contains a position of the map; v is taken modulo the circumference, u is clamped to the grid. */
  FlatPixel
  PixelOfUv(const Eigen::Vector2d & uv) const;
  /** Surface sample at the center of a pixel. */
  FlatSample
  SampleOfPixel(int column, int row) const;
  /** Point at the center of a pixel, LPS, mm; NaN outside all faces. */
  Eigen::Vector3d
  PointOfPixel(int column, int row) const;

  /** (u, v) of a point of a face, v in [0, circumference). */
  Eigen::Vector2d
  UvOfFacePoint(int face, const Eigen::Vector3d & barycentric) const;
  /** The surface from the constructor. */
  const VertexMatrix &
  Points() const
  {
    return m_V;
  }
  const FaceMatrix &
  Faces() const
  {
    return m_F;
  }
  /** Tube vertex index of each point, from 0; duplicates along the cut share an index. */
  const std::vector<int> &
  SourceOfPoints() const
  {
    return m_SourceOfVertex;
  }
  /** Unit vectors into the lumen, by tube vertex. */
  const VertexMatrix &
  InwardNormals() const
  {
    return m_InwardNormals;
  }

private:
  void
  ReadArrays(const SurfaceMesh & flat, const std::string & what);
  void
  ChooseSize(const FlatColonGridOptions & options);
  void
  FindOrientation();
  int
  Wrap(int row) const
  {
    const int rest = row % m_Rows;
    return rest < 0 ? rest + m_Rows : rest;
  }
  Eigen::Vector3d
  BarycentricOf(int face, Eigen::Vector2d uv) const;

  VertexMatrix      m_V;
  FaceMatrix        m_F;
  VertexMatrix      m_InwardNormals;
  Eigen::MatrixX2d  m_Uv;
  std::vector<int>  m_SourceOfVertex; ///< from 0
  Eigen::VectorXd   m_Curvature;
  Eigen::VectorXd   m_Scale;
  Eigen::VectorXd   m_ArcLength;
  std::vector<char> m_IsBridged; ///< per face; empty without bridges
  std::vector<int>  m_FaceOfPixel;
  double            m_PixelSize{ 1.0 };
  double            m_Circumference{ 1.0 };
  double            m_Length{ 1.0 };
  int               m_Columns{ 0 };
  int               m_Rows{ 0 };
  int               m_UncoveredPixels{ 0 };
  bool              m_IsMirrored{ false };
};
} // namespace shapeton

#endif
