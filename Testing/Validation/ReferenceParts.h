#ifndef ReferenceParts_h
#define ReferenceParts_h

#include "shapetonHeatObjects.h"
#include "shapetonVoxelGrid.h"

#include <string>
#include <vector>

/** Dice of an object that counts as a whole one. */
constexpr double wholeObject = 0.85;

/** \class ReferenceParts
 * \brief The parts of a volume that a segmentation should find, from a label image.
 *
 * A part is a label with at least 300 voxels and at most a quarter of the volume; larger ones are surroundings. A part
 * that encloses others counts with or without them: a body with its organs, a shell with its content. Label A encloses
 * label B if each path over touching labels from the background to B passes A. */
class ReferenceParts
{
public:
  using Labels = itk::Image<unsigned char, 3>;
  /** Number of voxels of each label. */
  using Counts = std::vector<double>;

  explicit ReferenceParts(const Labels * labels);

  /** The labels that are parts, ascending. */
  const std::vector<int> &
  GetLabels() const
  {
    return m_Parts;
  }

  /** Number of voxels of each label of the volume, the background first. */
  const Counts &
  GetTotals() const
  {
    return m_Totals;
  }

  int
  LabelOf(std::size_t voxel) const
  {
    return m_Labels->GetBufferPointer()[voxel];
  }

  const shapeton::VoxelGrid &
  GetGrid() const
  {
    return m_Grid;
  }

  /** Dice coefficient of a part and a region of `size` voxels with these counts, without or with the enclosed labels,
   * whichever is greater. */
  double
  Dice(int part, const double * counts, double size) const;

  /** The greatest one over all parts. */
  double
  BestDice(const double * counts, double size) const;

  /** Squared distance in voxels of each voxel of a part to the nearest voxel outside of it, and the voxels. */
  struct Depths
  {
    std::vector<std::size_t> voxels;
    std::vector<float>       squares;
  };
  Depths
  DepthsOf(int part) const;

private:
  /** The labels that are enclosed by one. */
  std::vector<int>
  EnclosedBy(int label, const std::vector<std::vector<char>> & touches) const;

  Labels::ConstPointer          m_Labels;
  shapeton::VoxelGrid           m_Grid;
  Counts                        m_Totals;
  std::vector<int>              m_Parts;
  std::vector<std::vector<int>> m_Enclosed; ///< by each label
};

/** Number of voxels of each label in the voxels of an object. */
ReferenceParts::Counts
CountsIn(const std::vector<shapeton::VoxelRange> & ranges, const ReferenceParts & parts);

#endif
