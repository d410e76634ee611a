#ifndef shapetonFlatColonGrid_h
#define shapetonFlatColonGrid_h

#include "FlatColonExport.h"

#include "shapetonSurfaceMesh.h"

#include <array>
#include <limits>

namespace shapeton
{
/** Resolution and smoothing of a FlatColonGrid. \ingroup FlatColon */
struct FlatColonGridOptions
{
  /** mm at the mean circumference, greater than 0. The grid takes the nearest size that divides the circumference into
   * whole pixels. */
  double pixelSize{ 1.0 };
  /** Standard deviation, mm on the surface, of the mean that is taken of the curvature; 0 for none. */
  double curvatureLength{ 0.0 };
  /** The same for the normals: for relief without the steps of voxels. */
  double normalLength{ 0.0 };
};

/** A place in the grid. Columns run along the tube, rows around it. \ingroup FlatColon */
struct FlatPixel
{
  int column{ 0 };
  int row{ 0 };
};

/** What lies at a place of the flat map. \ingroup FlatColon */
struct FlatSample
{
  /** -1 where no face lies (a hole of the surface); the other members then mean nothing. */
  int face{ -1 };
  /** Of the corners of the face; each at least 0, sum 1. */
  Eigen::Vector3d barycentric{ Eigen::Vector3d::Zero() };
  /** LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Unit length, into the lumen. */
  Eigen::Vector3d inwardNormal{ Eigen::Vector3d::Zero() };
  /** Mean curvature (half the sum of the principal ones), 1/mm: positive where the wall bulges into the lumen, as at
   * folds and polyps (1/r on a ball of radius r), negative where it bulges outwards (-1/(2R) on a tube of radius R). */
  double curvature{ 0.0 };
  /** mm on the surface for each mm of the map. */
  double scale{ 1.0 };
  /** The wall was made up here over a gap. */
  bool isBridged{ false };
  /** Distance along the centreline, mm; not a number where the surface does not tell. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
};

/** \class FlatColonGrid
 * \brief The regular grid of square pixels on the flat map of a tube.
 *
 * The surface is a flat tube as FlattenTube() gives it: V in space (LPS, mm), vertices along the cut duplicated, the
 * point arrays uv (mm at the mean circumference: u along the tube, v around it) and sourcePointId, the field arrays
 * circumference and length (mm). Cell array bridged and point array arcLength are used where they are
 * there. v may leave [0, circumference], as it does along a cut that is not straight: it is taken modulo the
 * circumference, on which both sides of the cut agree.
 *
 * The picture of the grid, columns to the right and rows downwards, is what an eye inside of the lumen sees: u x v
 * points out of the lumen, whatever the orientation of the faces and of the map (rows run against v where the map is
 * the mirror image). Inside is where the axis of the tube lies.
 *
 * A pixel belongs to the face that its middle lies in. Places are whole multiples of 2^-14 pixels for that decision,
 * and the middle of a pixel on a shared edge belongs to one of the two faces (top-left rule), so that there are neither
 * holes nor doubts, not along the cut either. Where the map is folded over, the face that is not turned over wins, then
 * the one with the lower index. What lies at a pixel is computed from the places in double precision.
 *
 * 4 bytes are kept for each pixel, about 130 for each face. Equal input gives equal results for any number of threads.
 *
 * \ingroup FlatColon
 */
class FlatColon_EXPORT FlatColonGrid
{
public:
  /** Throws InputError, with `what` in front, when an array is missing or has another form, a value is not finite or
   * the map is no tube's; ParameterError for a pixel size that is not positive, or so small that there would be more
   * than 65,536 pixels in a direction or 2^27 in all. */
  explicit FlatColonGrid(const SurfaceMesh &          flat,
                         const FlatColonGridOptions & options = {},
                         const std::string &          what = "the flat surface");
  ~FlatColonGrid();

  /** Pixels along the tube: their middles lie within its length. */
  int
  Columns() const
  {
    return m_Columns;
  }
  /** Pixels around the tube, exactly one turn. */
  int
  Rows() const
  {
    return m_Rows;
  }
  /** mm of the map: circumference over rows. */
  double
  PixelSize() const
  {
    return m_PixelSize;
  }
  /** mm, the mean of the tube. */
  double
  Circumference() const
  {
    return m_Circumference;
  }
  /** mm of the map. */
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
  /** Whether v falls from row to row. */
  bool
  IsMirrored() const
  {
    return m_IsMirrored;
  }
  /** How many pixels lie on no face. */
  int
  UncoveredPixels() const
  {
    return m_UncoveredPixels;
  }

  /** The face under the middle of a pixel, or -1. Rows are taken modulo Rows(). */
  int
  FaceOfPixel(int column, int row) const
  {
    return m_FaceOfPixel[static_cast<std::size_t>(Wrap(row)) * m_Columns + column];
  }
  /** Whether the wall was made up there over a gap. */
  bool
  IsBridged(int column, int row) const
  {
    const int face = this->FaceOfPixel(column, row);
    return face >= 0 && !m_IsBridged.empty() && m_IsBridged[face] != 0;
  }
  /** (u, v) of the middle of a pixel. */
  Eigen::Vector2d
  UvOfPixel(int column, int row) const;
  /** The pixel that a place of the map lies in; v is taken modulo the circumference, u beyond the ends goes to the
   * first or last column. */
  FlatPixel
  PixelOfUv(const Eigen::Vector2d & uv) const;
  /** What lies at the middle of a pixel. */
  FlatSample
  SampleOfPixel(int column, int row) const;
  /** The point of a pixel alone, LPS, mm; not a number where no face lies. */
  Eigen::Vector3d
  PointOfPixel(int column, int row) const;

  /** (u, v) of a point of a face, v in [0, circumference). */
  Eigen::Vector2d
  UvOfFacePoint(int face, const Eigen::Vector3d & barycentric) const;
  /** Positions and faces as they were given. */
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
  /** For each point its number, from 0 on, in which the copies of a vertex along the cut are one: the tube's. */
  const std::vector<int> &
  SourceOfPoints() const
  {
    return m_SourceOfVertex;
  }
  /** Unit vectors into the lumen, by these numbers. */
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
  std::vector<int>  m_SourceOfVertex; ///< numbered from 0 on
  Eigen::VectorXd   m_Curvature;
  Eigen::VectorXd   m_Scale;
  Eigen::VectorXd   m_ArcLength;
  std::vector<char> m_IsBridged; ///< of faces; empty where nothing is
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
