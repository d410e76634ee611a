#ifndef shapetonHeatObjects_h
#define shapetonHeatObjects_h

#include "shapetonHeatObjectOptions.h"
#include "shapetonPartitionTree.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "ShapetonHeatObjectsExport.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** What the score and the probability of an object depend on, as numbers that a linear model needs: see
 * HeatObject::terms. \ingroup ShapetonHeatObjects */
constexpr std::size_t HeatObjectTerms = 8;

/** A region of heat with a border: a part that a person sees.
 * \ingroup ShapetonHeatObjects */
struct HeatObject
{
  int                   parent{ 0 }; ///< number of the smallest object, from 1, that contains this one; 0 for none
  itk::Point<double, 3> center{};    ///< mean position of its voxels, LPS, mm
  std::uint64_t         voxels{ 0 };
  double                volume{ 0.0 };   ///< mm^3
  double                meanHeat{ 0.0 }; ///< of its voxels
  /** Absolute log ratio of the heat on the two sides of its border, mean over the border. */
  double contrast{ 0.0 };
  /** Range of border strengths, as the natural logarithm of their ratio, over which its volume changes by less than a
   * factor of 2; at most 6. */
  double range{ 0.0 };
  /** 36 pi volume^2 / surface^3: 1 for a ball; the surface is two thirds of the area of the voxel faces. */
  double compactness{ 0.0 };
  /** Fraction of its border that lies on the border of the volume. */
  double cut{ 0.0 };
  /** If one object contains another, a person more probably means the one with the greater score; e to the power of the
   * difference is the ratio of the probabilities. */
  double score{ 0.0 };
  /** Calibrated probability that this is one whole object, neither part of an object nor several objects. */
  double probability{ 0.0 };
  /** ln range; ln voxels, at most ln 5,000; ln of the share of the volume, at least ln 0.1; ln of the factor by which
   * it grows when its weakest border is merged, at most ln 51; ln of the ratio of its contrast to the strength of that
   * border, 0 to 4, which is 0 for an object whose whole border is equally strong; ln contrast, -4 to 1; ln
   * compactness, at least ln 0.0001, at most ln 0.1; cut. The score depends on the first six. */
  std::array<double, HeatObjectTerms> terms{};
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

  /** By descending volume, so each follows those that contain it; then offers, if they were asked for, also by
   * descending volume. An offer is the best region for voxels in no object, with a probability of at least 0.01 that is
   * too small for an object; the parents of offers are offers. */
  std::vector<HeatObject> objects;
  std::size_t             numberOfOffers{ 0 };
  /** The number (starting at 1) of the smallest object, or else of the smallest offer, at each voxel; 0 for none. */
  LabelImage::Pointer labels;
  /** The voxels of each object, including those of the objects inside it; ascending. */
  std::vector<std::vector<VoxelRange>> ranges;
  Remarks                              warnings; ///< what to do if no object was found

  bool
  IsOffer(int object) const
  {
    return static_cast<std::size_t>(object) > objects.size() - numberOfOffers;
  }
};

/** A region of a tree that may be an object; position and mean heat are not set.
 * \ingroup ShapetonHeatObjects */
struct HeatObjectCandidate
{
  PartitionTree::Index region{ 0 };
  HeatObject           object;
};

/** \class HeatObjectTree
 * \brief The regions of a heat volume, and those that may be objects.
 *
 * The regions are those of a PartitionTree of the logarithm of heat; values below a millionth of the greatest one count
 * as a millionth. Candidates are the regions that grow by at least 15 % when their weakest border is merged. Of nested
 * ones, a person means the one with the greatest score; it is an object if it is probable enough. Parts of it, with at
 * most half of its voxels, are found in the same way.
 *
 * \ingroup ShapetonHeatObjects */
class ShapetonHeatObjects_EXPORT HeatObjectTree
{
public:
  using MaskImage = itk::Image<unsigned char, 3>;

  /** Works for shapeton visits, too. Throws InputError if a value is not a finite number, none is above 0, or the grids
   * differ, and ParameterError if an option is out of range. \param domain objects consist of its voxels that
   * are not 0, and its border is a border of the volume; null: all voxels */
  explicit HeatObjectTree(const itk::Image<float, 3> * heat,
                          const HeatObjectOptions &    options = {},
                          const MaskImage *            domain = nullptr,
                          const Progress &             progress = {});

  const PartitionTree &
  GetTree() const
  {
    return m_Tree;
  }

  /** Each follows those that contain it. */
  const std::vector<HeatObjectCandidate> &
  GetCandidates() const
  {
    return m_Candidates;
  }

  HeatObjectList
  List(bool withOffers = false) const;

private:
  itk::Image<float, 3>::ConstPointer m_Heat;
  HeatObjectOptions                  m_Options;
  PartitionTree                      m_Tree;
  std::vector<HeatObjectCandidate>   m_Candidates;
};

/** HeatObjectTree::List() of a heat volume. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatObjectList
FindHeatObjects(const itk::Image<float, 3> * heat,
                const HeatObjectOptions &    options = {},
                const Progress &             progress = {});

/** The object that a click on a voxel selects, from 1: of the smallest one at the voxel (its label) and its parents,
 * the one with the greatest score. Throws ParameterError. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT int
ObjectOfClick(const HeatObjectList & list, int smallest);

/** Mask of one object of the list (numbered from 1), including the objects inside it: 1 inside, 0 outside. Needs no
 * search. Throws ParameterError. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT itk::Image<unsigned char, 3>::Pointer
                           MaskOfObject(const HeatObjectList & list, int object);
} // namespace shapeton

#endif
