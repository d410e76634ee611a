#ifndef shapetonHeatObjects_h
#define shapetonHeatObjects_h

#include "shapetonHeatObjectOptions.h"
#include "shapetonProgress.h"
#include "ShapetonHeatObjectsExport.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** A connected region that changes little over a range of heat.
 * \ingroup ShapetonHeatObjects */
struct HeatObject
{
  int                   parent{ 0 };    ///< number of the smallest object, from 1, that contains this one; 0 for none
  bool                  isWarm{ true }; ///< voxels of at least `heat`; otherwise of at most `heat`
  int                   time{ 0 };      ///< the heat volume in which it was found, from 0
  float                 heat{ 0.0F };   ///< the threshold; in [0, 1] for heat, in visits for shapetons
  std::uint32_t         seed{ 0 };      ///< index of a voxel of the object: its warmest, or coldest, one
  itk::Point<double, 3> center{};       ///< mean position of its voxels, LPS, mm
  std::uint64_t         voxels{ 0 };
  double                volume{ 0.0 }; ///< mm^3
  /** Mean value of its voxels in each heat volume. */
  std::vector<double> heatCurve;
  /** Logarithmic change of the volume when the threshold changes by 5 %; 0: none. */
  double growth{ 0.0 };
  /** Range of thresholds (natural logarithm of their ratio) over which the volume stays within 20 %. */
  double range{ 0.0 };
  /** Absolute log ratio of the heat on the two sides of a border face, median over all faces. */
  double contrast{ 0.0 };
  /** 36 pi volume^2 / surface^3: 1 for a ball; the surface is two thirds of the area of the voxel faces. */
  double compactness{ 0.0 };
  /** Fraction of its border that lies on the border of the volume. */
  double cut{ 0.0 };
  /** Calibrated probability that this is one whole object, neither part of an object nor several objects. */
  double probability{ 0.0 };
};

/** Voxels whose index in the volume is in [begin, end).
 * \ingroup ShapetonHeatObjects */
struct VoxelRange
{
  std::uint32_t begin, end;
};

/** Objects with their voxels.
 * \ingroup ShapetonHeatObjects */
struct HeatObjectList
{
  using LabelImage = itk::Image<unsigned short, 3>;

  std::vector<HeatObject> objects; ///< by descending volume, so each follows those that contain it
  /** The number (starting at 1) of the smallest object at each voxel; 0 for none. */
  LabelImage::Pointer labels;
  /** The voxels of each object, including those of the objects inside it; ascending. */
  std::vector<std::vector<VoxelRange>> ranges;
};

/** Finds the stable nodes of the component trees (max-tree and min-tree) of one or several heat volumes on one grid,
 * for example at several times or with several windows.
 *
 * Along each path of a tree, from an extremum to the whole volume, a node is stable where the volume hardly changes
 * with the threshold (maximally stable regions; Matas et al. 2002). Nodes found in both trees or at several times count
 * once: the most probable one is kept. Throws InputError if the grids differ or a value is not a finite number, and
 * ParameterError if an option is out of range or `heats` is empty.
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatObjectList
FindHeatObjects(const std::vector<const itk::Image<float, 3> *> & heats,
                const HeatObjectOptions &                         options = {},
                const Progress &                                  progress = {});

/** Terms of the logistic model of the probability: ln range (at most 6), ln (growth + 0.002), ln compactness (at most
 * 0.02), ln voxels (at most 2,000). Above these limits, larger values no longer distinguish objects from noise, which
 * has regions of 64 voxels or with a sponge-like surface. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT std::array<double, 4>
                           ProbabilityTerms(const HeatObject & object);

/** Mask of one object of the list (numbered from 1), including the objects inside it: 1 inside, 0 outside. Needs no
 * search. Throws ParameterError. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT itk::Image<unsigned char, 3>::Pointer
                           MaskOfObject(const HeatObjectList & list, int object);
} // namespace shapeton

#endif
