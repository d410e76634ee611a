#ifndef shapetonShapeScene_h
#define shapetonShapeScene_h

#include "ShapetonPhantomsExport.h"

#include "itkPoint.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** \class ShapeScene
 * \brief Objects with known shape, position, intensity and label, the ground truth of a phantom.
 *
 * Objects are solids defined by signed distance functions: spheres, ellipsoids, cubes, boxes, cylinders, capsules, tori
 * and tubes along polylines, optionally rotated, translated, bent, twisted or with bumps. Coordinates are physical LPS
 * with the center of the scene at (0, 0, 0).
 *
 * A scene is a JSON document; see the README of the module for the schema. Presets resemble the synthetic data of the
 * dissertation: figure2.4 (one cube), figure2.7a (a cube and two spheres of different size), figure2.7b (two cubes and
 * two cuboids of different size and orientation), figure3.4 (a cube, two cuboids, a sphere), figure3.5 (a cuboid, the
 * same cuboid bent and twisted, a sphere, the same sphere with bumps), hydrogen (a nucleus, two lobes and an orbit,
 * like Figure 3.11a), and vessels (thin tubes, a large vessel and an aneurysm, like the data of Figures 2.10 and 3.7).
 * The dimensions are our choice, since the dissertation does not specify them.
 *
 * The unit of length is the millimeter or, for a relative scene (all presets), the shortest extent of the volume, set
 * by ShapePhantomImageSource. Presets fit into a ball with a diameter of 0.96 units, so they are complete for any image
 * direction.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ShapeScene
{
public:
  using PointType = itk::Point<double, 3>;

  struct Object
  {
    std::string   name;
    double        intensity; ///< HU
    unsigned char label;     ///< 0 for a cavity
    PointType     boundingCenter;
    double        boundingRadius; ///< mm
  };

  /** Creates an empty scene with background 0. */
  ShapeScene();

  static const std::vector<std::string> &
  GetPresetNames();

  /** Loads a preset or a JSON file. Throws ParameterError if neither exists, and InputError with the file and the
   * invalid key. */
  static ShapeScene
  Load(const std::string & presetOrFile);

  /** `source` is the name used in messages. */
  static ShapeScene
  FromJson(const nlohmann::ordered_json & document, const std::string & source);

  /** Whether lengths are fractions of the unit length. */
  bool
  IsRelative() const;

  /** Unit length in mm, > 0; default 1. */
  void
  SetUnitLength(double millimeters);

  /** Intensity outside all objects, HU. */
  double
  GetBackground() const;

  std::size_t
  GetNumberOfObjects() const;
  Object
  GetObject(std::size_t object) const;

  /** Signed distance (mm) from a point to the surface of an object, negative inside, rounded to 2^-30 mm. Exact for
   * undeformed objects except ellipsoids (a lower bound inside sharp bends of tubes), otherwise first-order accurate
   * near the surface. The sign is always exact. */
  double
  SignedDistance(std::size_t object, const PointType & point) const;

  /** Label of the last object with signed distance <= 0 at a point, or 0. */
  unsigned char
  GetLabel(const PointType & point) const;

  struct Data;

private:
  std::shared_ptr<const Data> m_Data;
  double                      m_UnitLength{ 1.0 };
};
} // namespace shapeton

#endif
