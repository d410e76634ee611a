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
/** Largest deviation of scalar products of axes from 0 and 1: directions are stored as float or as short decimals. */
constexpr double OrthonormalTolerance = 1e-3;

/** The stored voxels of an image file, and what its header leaves open. */
struct VoxelFormat
{
  /** Along each axis. */
  std::vector<std::uint64_t>        size;
  itk::ImageIOBase::IOComponentEnum componentType{ itk::ImageIOBase::IOComponentEnum::UNKNOWNCOMPONENTTYPE };
  std::uint32_t                     componentBytes{ 0 };
  /** Components per voxel: 2 for complex numbers, 3 or 4 for colors. */
  std::uint32_t components{ 1 };
  /** Whether the byte order of the voxels differs from that of this machine. */
  bool isSwapped{ false };
  /** An intensity is slope * stored value + intercept. */
  double slope{ 1.0 };
  double intercept{ 0.0 };
  /** False if a spacing of 1 mm was assumed because the header lacks it. */
  bool statesSpacing{ true };
  /** Remarks on the geometry for the user. */
  Remarks notes;
};

/** Header of a NIfTI-1 or NIfTI-2 file, as specified at https://nifti.nimh.nih.gov.
 *
 * ITK's reader is not used because it scales the spacing to mm but not the origin, rejects an sform that disagrees
 * with pixdim, treats a file without a valid magic number as ANALYZE 7.5, adds scl_inter when scl_slope is 0, and does
 * not support NIfTI-2. */
struct NiftiHeader : VoxelFormat
{
  using Vector = itk::Vector<double, 3>;

  /** The file that contains the voxels, and their offset in bytes. */
  std::string   voxelFile;
  std::uint64_t voxelOffset{ 0 };

  /** The geometry in LPS, mm. The columns of `direction` are the axes, orthogonal and of unit length. */
  Vector                    spacing;
  Vector                    origin;
  itk::Matrix<double, 3, 3> direction;
};

/** The file that contains the header: the .hdr or .hdr.gz next to an .img or .img.gz, empty if not found; otherwise
 * `path`. */
std::string
NiftiHeaderFile(const std::string & path);

/** Reads a header, optionally gzip-compressed, in either byte order. Uses the sform if its code is positive, else
 * the qform; otherwise orientation and origin are unknown, and a note is added. Throws InputError with the field and
 * its value. */
NiftiHeader
ReadNiftiHeader(const std::string & path);
} // namespace shapeton

#endif
