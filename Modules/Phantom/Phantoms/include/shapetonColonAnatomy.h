#ifndef shapetonColonAnatomy_h
#define shapetonColonAnatomy_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonPhantomParameters.h"
#include "shapetonCurveSet.h"
#include "shapetonSurfaceMesh.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** A polyp of the phantom. \ingroup ShapetonPhantoms */
struct ColonPolyp
{
  int             id;        ///< from 1
  std::string     kind;      ///< sessile, pedunculated or flat
  double          diameter;  ///< mm, largest width of the head
  double          height;    ///< mm, height above the wall
  Eigen::Vector3d position;  ///< center of the head, LPS mm
  Eigen::Vector3d base;      ///< attachment point on the wall, LPS mm
  double          arcLength; ///< mm
  int             segment;
  bool            onFold;     ///< on the crest of a fold
  int             materialId; ///< nearest wall point of Correspondence()
};

/** A diverticulum of the phantom: a sac outside the wall, connected to the lumen by a neck. LPS, mm.
 * \ingroup ShapetonPhantoms */
struct ColonDiverticulum
{
  int             id;         ///< from 1; equal in all positions of one seed
  Eigen::Vector3d mouth;      ///< start of the neck at the wall
  Eigen::Vector3d position;   ///< center of the spherical sac
  double          neck;       ///< inner diameter
  double          diameter;   ///< diameter of the sac; smaller in positions with limited space
  double          arcLength;  ///< arc length of the mouth
  int             segment;    ///< segment of the mouth
  int             materialId; ///< wall point of Correspondence() nearest to the mouth
  /** Content: "stool", or "lumen" if the sac is filled like the lumen at its mouth. ColonStructures replaces "lumen"
   * with the gas or fluid at the center of the sac. */
  std::string content;
  double      intensity; ///< HU of the stool, otherwise 0
};

/** The ileocecal valve of the phantom. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonValve
{
  std::string     kind;      ///< bump or lips
  Eigen::Vector3d position;  ///< midpoint of base and crest
  Eigen::Vector3d base;      ///< point on the wall without folds
  Eigen::Vector3d mouth;     ///< opening of the ileum, at the bottom of the cleft between the lips; top of a bump
  Eigen::Vector3d direction; ///< unit vector from the wall into the lumen
  Eigen::Vector3d slit;      ///< unit vector around the colon, along the mouth
  Eigen::Vector3d upperLip;  ///< midpoint of the crest of the lip toward the ascending colon; top of a bump
  Eigen::Vector3d lowerLip;  ///< midpoint of the crest of the lip toward the cecum; top of a bump
  double          length;    ///< along the slit
  double          height;    ///< above the wall
  double          thickness; ///< of each lip; total thickness of a bump
  double          arcLength;
};

/** A point of the wall. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonPlace
{
  Eigen::Vector3d point;   ///< first tissue hit by a ray from the centerline
  Eigen::Vector3d inwards; ///< unit vector toward the centerline
  double          radius;  ///< distance from the centerline
  double          angle;   ///< material angle about the centerline
  double          arcLength;
};

/** \class ColonAnatomy
 * \brief The colon of a synthetic patient in one position, with exactly known geometry.
 *
 * Physical LPS, mm, around (0, 0, 0): +x is left, +y posterior, +z superior. Segments: 1 rectum (with the anal canal),
 * 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 cecum. Arc length is measured along the centerline of this
 * position, from the anal verge. The lumen intersects neither the spine, a cylinder along z at x = 0, y = 80 with
 * radius 30 for z > -50, nor the sacrum below it, behind the rectum (see SpineAxis()).
 *
 * All functions are const and thread-safe. Results are reproducible bit for bit.
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ColonAnatomy
{
public:
  /** Sample::distance is clamped to this distance (mm) on both sides of the wall. */
  static constexpr double Reach = 10.0;

  struct Sample
  {
    /** Distance to the wall in mm, positive in the lumen, in [-Reach, Reach]; first-order accurate near the wall. */
    double distance;
    /** Arc length (mm) of the point; undefined if distance == -Reach. */
    double arcLength;
    /** Material angle about the centerline, radians in (-pi, pi]. */
    double angle;
    /** 0 if distance == -Reach. */
    int segment;
  };

  /** Throws ParameterError as RequireValid() does. */
  explicit ColonAnatomy(const ColonPhantomParameters & parameters);
  ~ColonAnatomy();
  ColonAnatomy(const ColonAnatomy &) = delete;
  ColonAnatomy &
  operator=(const ColonAnatomy &) = delete;

  const ColonPhantomParameters &
  GetParameters() const;

  Sample
  Evaluate(const Eigen::Vector3d & point) const;

  /** One curve from the anal verge to the cecum with the point arrays arcLength (mm), radius (mean radius of the wall
   * without folds, mm), inscribedRadius (distance to the nearest wall or fold, mm), segment and collapsed (0 or 1). */
  CurveSet
  Centerline() const;

  /** Three curves on the wall with the point arrays arcLength and materialId, and the cell arrays taenia and name: 1
   * libera, 2 mesocolica, 3 omentalis, or 0 without anatomicalTaeniae. */
  CurveSet
  Taeniae() const;

  /** One curve along the crest of each fold with the cell arrays fold, height and thickness (mm), angularExtent
   * (degrees), arcLength, segment and flattened, and the point array crestHeight (mm above the wall). */
  CurveSet
  Folds() const;

  std::vector<ColonPolyp>
  Polyps() const;

  /** The diverticula open in this position, ordered by id. */
  std::vector<ColonDiverticulum>
  Diverticula() const;

  ColonValve
  Valve() const;

  /** The wall point farthest from the mouth of the cecum, which is the center of the lumen at the valve. */
  Eigen::Vector3d
  CecalPole() const;

  /** Points of the wall on a grid in material coordinates with the point arrays materialId, arcLength, angle,
   * segment, collapsed and onFold. The same materialId identifies the same piece of wall in all positions of one
   * seed. */
  CurveSet
  Correspondence() const;

  /** The wall point at a fraction of the colon length at rest and an angle: the same piece of wall in all positions of
   * one seed. */
  ColonPlace
  PlaceAt(double share, double angle) const;

  /** The surface of the lumen, closed at both ends, with outward normals, sampled at an edge length of `edgeLength` mm.
   * An edge length above 0.7 times the thinnest septum merges touching stretches; above 0.5 times the narrowest neck,
   * it may cut off a diverticulum. */
  SurfaceMesh
  Wall(double edgeLength) const;

  /** Length (mm) from the anal verge to the end in the cecum. */
  double
  Length() const;

  int
  SegmentAt(double arcLength) const;

  /** "rectum", "sigmoid", "descending", "transverse", "ascending", "cecum"; empty for other numbers. */
  static std::string
  SegmentName(int segment);

  /** Corners of the bounding box of the lumen with a margin of `margin` mm. */
  void
  BoundingBox(double margin, Eigen::Vector3d & low, Eigen::Vector3d & high) const;

  /** Center of the spine at height z; the distance to the colon is at least 30 mm. Used to add bone to the image. */
  static Eigen::Vector3d
  SpineAxis(double z);

  /** Entry point of the catheter, and unit vector along the anal canal into the body. */
  void
  AnalVerge(Eigen::Vector3d & point, Eigen::Vector3d & inwards) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_Data;
};
} // namespace shapeton

#endif
