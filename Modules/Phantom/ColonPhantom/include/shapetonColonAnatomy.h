#ifndef shapetonColonAnatomy_h
#define shapetonColonAnatomy_h

#include "ColonPhantomExport.h"
#include "shapetonColonPhantomParameters.h"
#include "shapetonCurveSet.h"
#include "shapetonSurfaceMesh.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** A polyp of the phantom. \ingroup ColonPhantom */
struct ColonPolyp
{
  int             id;        ///< from 1
  std::string     kind;      ///< sessile, pedunculated or flat
  double          diameter;  ///< mm, the widest of the head
  double          height;    ///< mm, how far it stands out of the wall
  Eigen::Vector3d position;  ///< the middle of the head, LPS mm
  Eigen::Vector3d base;      ///< where it sits on the wall, LPS mm
  double          arcLength; ///< mm
  int             segment;
  bool            onFold;     ///< on the crest of a fold
  int             materialId; ///< the nearest wall point of Correspondence()
};

/** A diverticulum of the phantom: a sac outside of the wall, which a neck joins to the lumen. LPS, mm.
 * \ingroup ColonPhantom */
struct ColonDiverticulum
{
  int             id;         ///< from 1; the same in all positions of one seed
  Eigen::Vector3d mouth;      ///< where the neck leaves the wall
  Eigen::Vector3d position;   ///< the middle of the sac, a ball
  double          neck;       ///< inner diameter
  double          diameter;   ///< of the sac, less than in other positions where it has little room
  double          arcLength;  ///< of the mouth
  int             segment;    ///< of the mouth
  int             materialId; ///< of the mouth, the nearest wall point of Correspondence()
  /** stool, or of ColonAnatomy lumen: what the lumen holds there; of ColonStructures gas or fluid, by the middle. */
  std::string content;
  double      intensity; ///< of stool, HU; else 0
};

/** The ileocaecal valve of the phantom. LPS, mm. \ingroup ColonPhantom */
struct ColonValve
{
  std::string     kind;      ///< bump or lips
  Eigen::Vector3d position;  ///< in the middle between base and crest
  Eigen::Vector3d base;      ///< on the wall without folds
  Eigen::Vector3d mouth;     ///< where the ileum opens, at the bottom of the cleft between the lips; of a bump its top
  Eigen::Vector3d direction; ///< unit vector out of the wall into the lumen
  Eigen::Vector3d slit;      ///< unit vector around the colon, along the mouth
  Eigen::Vector3d upperLip;  ///< the middle of the crest of the lip towards the ascending colon; of a bump its top
  Eigen::Vector3d lowerLip;  ///< of that towards the caecum
  double          length;    ///< along the slit
  double          height;    ///< above the wall
  double          thickness; ///< of each lip; of a bump the whole
  double          arcLength;
};

/** A place of the wall. LPS, mm. \ingroup ColonPhantom */
struct ColonPlace
{
  Eigen::Vector3d point;   ///< where a ray from the centreline first meets tissue
  Eigen::Vector3d inwards; ///< unit vector to the centreline
  double          radius;  ///< from the centreline
  double          angle;   ///< material, about the centreline
  double          arcLength;
};

/** \class ColonAnatomy
 * \brief The colon of a synthetic patient in one position, known exactly.
 *
 * Physical LPS, mm, around (0, 0, 0): +x is left, +y posterior, +z superior. Segments: 1 rectum (with the anal canal),
 * 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 caecum. Arc length is that of the centreline of this position,
 * from the anal verge. The lumen keeps clear of the spine, a cylinder along z through x = 0, y = 80 with the radius 30
 * for z > -50, which below goes on as the sacrum behind the rectum (see SpineAxis()).
 *
 * All functions are constant and may be called by many threads at a time. The same parameters give the same bytes.
 * \ingroup ColonPhantom
 */
class ColonPhantom_EXPORT ColonAnatomy
{
public:
  /** Beyond this many mm from the wall, on either side, Sample::distance is cut to it. */
  static constexpr double Reach = 10.0;

  struct Sample
  {
    /** mm to the wall, positive in the lumen, in [-Reach, Reach]; of first order near the wall. */
    double distance;
    /** mm; of no meaning where distance == -Reach. */
    double arcLength;
    /** Material angle about the centreline, radians in (-pi, pi]. */
    double angle;
    /** 0 where distance == -Reach. */
    int segment;
  };

  /** Throws ParameterError as RequireValid(). */
  explicit ColonAnatomy(const ColonPhantomParameters & parameters);
  ~ColonAnatomy();
  ColonAnatomy(const ColonAnatomy &) = delete;
  ColonAnatomy &
  operator=(const ColonAnatomy &) = delete;

  const ColonPhantomParameters &
  GetParameters() const;

  Sample
  Evaluate(const Eigen::Vector3d & point) const;

  /** One curve from the anal verge to the caecum with the point arrays arcLength (mm), radius (mean radius of the wall
   * without folds, mm), inscribedRadius (distance to the nearest wall or fold, mm), segment and collapsed (0 or 1). */
  CurveSet
  Centreline() const;

  /** Three curves on the wall with the point arrays arcLength and materialId, and the cell array taenia. */
  CurveSet
  Taeniae() const;

  /** One curve along the crest of each fold with the cell arrays fold, height and thickness (mm), angularExtent
   * (degrees), arcLength, segment and flattened, and the point array crestHeight (mm above the wall). */
  CurveSet
  Folds() const;

  std::vector<ColonPolyp>
  Polyps() const;

  /** Those that are open in this position, in the order of their numbers. */
  std::vector<ColonDiverticulum>
  Diverticula() const;

  ColonValve
  Valve() const;

  /** The point of the wall that is farthest from the mouth of the caecum, the middle of the lumen at the valve. */
  Eigen::Vector3d
  CaecalPole() const;

  /** Points of the wall on a grid in material coordinates with the point arrays materialId, arcLength, angle, segment,
   * collapsed and onFold. The same materialId is the same piece of wall in all positions of one seed. */
  CurveSet
  Correspondence() const;

  /** The wall at a share of the colon's length at rest and an angle: the same piece of wall in all positions of one
   * seed.
   */
  ColonPlace
  PlaceAt(double share, double angle) const;

  /** The surface of the lumen, closed at both ends, normals out of the lumen, sampled with `edgeLength` mm. Edges
   * above 0.7 of the thinnest septum join stretches that touch, those above 0.5 of the narrowest neck may cut a
   * diverticulum off. */
  SurfaceMesh
  Wall(double edgeLength) const;

  /** mm, from the anal verge to the end in the caecum. */
  double
  Length() const;

  int
  SegmentAt(double arcLength) const;

  /** rectum, sigmoid, descending, transverse, ascending, caecum. Empty for other numbers. */
  static std::string
  SegmentName(int segment);

  /** Corners of a box that holds the lumen with `margin` mm to spare. */
  void
  BoundingBox(double margin, Eigen::Vector3d & low, Eigen::Vector3d & high) const;

  /** Where the middle of the spine is at a height z: the colon keeps 30 mm from it. For a scanner to put bone there. */
  static Eigen::Vector3d
  SpineAxis(double z);

  /** Where the catheter enters and which way the anal canal goes from there, a unit vector into the body. */
  void
  AnalVerge(Eigen::Vector3d & point, Eigen::Vector3d & inwards) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_Data;
};
} // namespace shapeton

#endif
