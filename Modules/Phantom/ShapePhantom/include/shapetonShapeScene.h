#ifndef shapetonShapeScene_h
#define shapetonShapeScene_h

#include "ShapePhantomExport.h"

#include "itkPoint.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** \class ShapeScene
 * \brief Objects with known shape, place, intensity and label: the truth of a phantom.
 *
 * Objects are solids given by signed distance functions: spheres, ellipsoids, cubes, boxes, cylinders, capsules, tori
 * and tubes along polylines, turned, placed, and deformed by bending, twisting or bumps. Coordinates are physical LPS
 * with the scene's centre at (0, 0, 0).
 *
 * A scene is a JSON document; the README of the module describes its schema. Presets follow the synthetic data of the
 * dissertation: figure2.4 (one cube), figure2.7a (a cube and two spheres of different size), figure2.7b (two cubes and
 * two cuboids of different size and orientation), figure3.4 (a cube, two cuboids, a sphere), figure3.5 (a cuboid, the
 * same cuboid bent and twisted, a sphere, the same sphere with bumps), hydrogen (a nucleus, two lobes and an orbit,
 * like Figure 3.11a), and vessels (thin tubes, a large vessel and an aneurysm, like the data of Figures 2.10 and 3.7).
 * The dissertation gives no measures; they are ours.
 *
 * A scene has its own unit of length: millimetres, or for a relative scene (all presets) a length that
 * ShapePhantomImageSource sets to the shortest extent of the volume. Presets fit into a ball with the diameter of 0.96
 * units, so that no direction of the image axes cuts them.
 *
 * \ingroup ShapePhantom
 */
class ShapePhantom_EXPORT ShapeScene
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

  /** An empty scene with background 0. */
  ShapeScene();

  static const std::vector<std::string> &
  GetPresetNames();

  /** A preset, or else a JSON file. Throws ParameterError when it is neither, and what FromFile throws. */
  static ShapeScene
  Load(const std::string & presetOrFile);

  /** Throws InputError that names the file and the key. */
  static ShapeScene
  FromFile(const std::string & path);

  /** `source` is the name used in messages. */
  static ShapeScene
  FromJson(const nlohmann::ordered_json & document, const std::string & source);

  /** True when lengths are fractions of the unit length. */
  bool
  IsRelative() const;

  /** Length in mm of the scene's unit, > 0; default 1. */
  void
  SetUnitLength(double millimetres);
  double
  GetUnitLength() const
  {
    return m_UnitLength;
  }

  /** Intensity where there is no object, HU. */
  double
  GetBackground() const;

  std::size_t
  GetNumberOfObjects() const;
  Object
  GetObject(std::size_t object) const;

  /** Signed distance in mm from a point to the surface of an object, negative inside, rounded to 2^-30 mm. Exact for
   * undeformed objects but ellipsoids (inside a sharp bend of a tube, a lower bound), to first order near the surface
   * for the others; the sign is exact for all. */
  double
  SignedDistance(std::size_t object, const PointType & point) const;

  /** The label at a point: that of the last object whose signed distance is <= 0, or 0. */
  unsigned char
  GetLabel(const PointType & point) const;

  struct Data;

private:
  std::shared_ptr<const Data> m_Data;
  double                      m_UnitLength{ 1.0 };
};
} // namespace shapeton

#endif
