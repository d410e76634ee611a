#ifndef shapetonNiftiHeader_h
#define shapetonNiftiHeader_h

#include "shapetonRemarks.h"

#include "itkImageIOBase.h"
#include "itkMatrix.h"
#include "itkVector.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** How far scalar products of axes may be from 0 and 1: directions are stored as float or as short decimals. */
constexpr double OrthonormalTolerance = 1e-3;

/** What the header of a NIfTI-1 or NIfTI-2 file says, by https://nifti.nimh.nih.gov.
 *
 * ITK's reader is not used for it: it scales the spacing to mm but not the origin, rejects an sform that disagrees with
 * pixdim, takes a file without a valid magic for ANALYZE 7.5, adds scl_inter when scl_slope is 0, and knows no NIfTI-2.
 */
struct NiftiHeader
{
  using Vector = itk::Vector<double, 3>;

  /** dim[1] to dim[dim[0]]. */
  std::vector<std::uint64_t>        size;
  itk::ImageIOBase::IOComponentEnum componentType{ itk::ImageIOBase::IOComponentEnum::UNKNOWNCOMPONENTTYPE };
  std::uint32_t                     componentBytes{ 0 };
  /** Values of a voxel: 2 of complex numbers, 3 or 4 of colors. */
  std::uint32_t components{ 1 };
  /** The voxels have the other byte order than this machine. */
  bool isSwapped{ false };
  /** An intensity is slope * stored value + intercept. */
  double slope{ 1.0 };
  double intercept{ 0.0 };
  /** Where the voxels are, and the bytes before them. */
  std::string   voxelFile;
  std::uint64_t voxelOffset{ 0 };

  /** The geometry in LPS, mm. The columns of `direction` are those of the axes, orthogonal and of unit length. */
  Vector                    spacing;
  Vector                    origin;
  itk::Matrix<double, 3, 3> direction;
  /** False where a spacing of 1 mm was taken because the header states none. */
  bool statesSpacing{ true };
  /** What the user should know about the geometry. */
  Remarks notes;
};

/** The file that holds the header: of .img or .img.gz the .hdr or .hdr.gz beside it, empty where there is none; else
 * `path`. */
std::string
NiftiHeaderFile(const std::string & path);

/** Reads such a file, compressed by gzip or not, of either byte order. The sform counts where its code is positive,
 * else the qform; else neither orientation nor origin is known, and a note says so. Throws InputError that names the
 * field and its value. */
NiftiHeader
ReadNiftiHeader(const std::string & path);
} // namespace shapeton

#endif
