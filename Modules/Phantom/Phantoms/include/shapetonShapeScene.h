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
 * \brief Objects with known shape, position, intensity and label: the ground truth of a phantom.
 *
 * Objects are solids given by signed distance functions: spheres, ellipsoids, cubes, boxes, cylinders, capsules, tori
 * and tubes along polylines, rotated, translated, and deformed by bending, twisting or bumps. Coordinates are physical
 * LPS with the center of the scene at (0, 0, 0).
 *
 * A scene is a JSON document; the README of the module describes its schema. Presets follow the synthetic data of the
 * dissertation: figure2.4 (one cube), figure2.7a (a cube and two spheres of different size), figure2.7b (two cubes and
 * two cuboids of different size and orientation), figure3.4 (a cube, two cuboids, a sphere), figure3.5 (a cuboid, the
 * same cuboid bent and twisted, a sphere, the same sphere with bumps), hydrogen (a nucleus, two lobes and an orbit,
 * like Figure 3.11a), and vessels (thin tubes, a large vessel and an aneurysm, like the data of Figures 2.10 and 3.7).
 * The dissertation does not specify dimensions; these are our choice.
 *
 * A scene has its own unit of length: millimeters, or for a relative scene (all presets) a length that
 * ShapePhantomImageSource sets to the shortest extent of the volume. Presets fit into a ball with a diameter of 0.96
 * units, so that they are complete for any direction of the image axes.
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

  /** Loads a preset, or else a JSON file. Throws ParameterError if it is neither, and the exceptions of FromFile. */
  static ShapeScene
  Load(const std::string & presetOrFile);

  /** Throws InputError with the file and the key. */
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
  SetUnitLength(double millimeters);
  double
  GetUnitLength() const
  {
    return m_UnitLength;
  }

  /** Intensity outside all objects, HU. */
  double
  GetBackground() const;

  std::size_t
  GetNumberOfObjects() const;
  Object
  GetObject(std::size_t object) const;

  /** Signed distance in mm from a point to the surface of an object, negative inside, rounded to 2^-30 mm. Exact for
   * undeformed objects except ellipsoids (inside a sharp bend of a tube, a lower bound); first-order accurate near
   * the surface for the others. The sign is exact for all. */
  double
  SignedDistance(std::size_t object, const PointType & point) const;

  /** The label at a point: that of the last object with signed distance <= 0, or 0. */
  unsigned char
  GetLabel(const PointType & point) const;

  struct Data;

private:
  std::shared_ptr<const Data> m_Data;
  double                      m_UnitLength{ 1.0 };
};
} // namespace shapeton

#endif
