#include "shapetonVolumeWriter.h"

#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonStoredVoxels.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonOperatingSystem.h"
#include "shapetonPrintable.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkMetaDataObject.h"
#include "itkMetaImageIO.h"
#include "itkNiftiImageIO.h"
#include "itkNrrdImageIO.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <set>

namespace shapeton
{
namespace
{
// NIfTI stores its geometry as float.
constexpr double GeometryTolerance = 1e-4;

bool
HasExtension(const std::string & path, const std::string & extension)
{
  return path.size() > extension.size() &&
         path.compare(path.size() - extension.size(), extension.size(), extension) == 0;
}

itk::ImageIOBase::Pointer
MakeImageIO(const std::string & path)
{
  if (HasExtension(path, ".nrrd"))
  {
    return itk::NrrdImageIO::New().GetPointer();
  }
  if (HasExtension(path, ".nii") || HasExtension(path, ".nii.gz"))
  {
    return itk::NiftiImageIO::New().GetPointer();
  }
  if (HasExtension(path, ".mha"))
  {
    return itk::MetaImageIO::New().GetPointer();
  }
  throw ParameterError(path + ": the extension must be .nrrd, .nii, .nii.gz or .mha");
}

/** The header is text with one entry per line. */
std::string
OnOneLine(std::string text)
{
  for (char & c : text)
  {
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

/** Both formats end a key at a colon or an equals sign, MetaImage also at a space. */
std::string
AsKey(std::string text)
{
  for (char & c : text)
  {
    c = static_cast<unsigned char>(c) <= ' ' || c == ':' || c == '=' ? '_' : c;
  }
  return text;
}

/** Fields of the header that metadata would replace. */
const std::set<std::string> fieldsOfMetaImage = {
  "AnatomicalOrientation",
  "BinaryData",
  "BinaryDataByteOrderMSB",
  "CenterOfRotation",
  "Comment",
  "CompressedData",
  "CompressedDataSize",
  "CompressionLevel",
  "DimSize",
  "ElementByteOrderMSB",
  "ElementDataFile",
  "ElementNumberOfChannels",
  "ElementSize",
  "ElementSpacing",
  "ElementType",
  "HeaderSize",
  "HeaderSizePerSlice",
  "ID",
  "Modality",
  "NDims",
  "Name",
  "ObjectSubType",
  "ObjectType",
  "Offset",
  "Orientation",
  "Origin",
  "ParentID",
  "Position",
  "Rotation",
  "TransformMatrix",
};

itk::MetaDataDictionary
MakeDictionary(const VolumeMetadata & metadata)
{
  itk::MetaDataDictionary dictionary;
  for (const auto & entry : metadata)
  {
    RequireParameter(fieldsOfMetaImage.count(entry.first) == 0,
                     "the metadata " + Quoted(entry.first) + " have the name of a field of MetaImage; rename them");
    const std::string value = OnOneLine(entry.second);
    if (!value.empty())
    {
      itk::EncapsulateMetaData<std::string>(dictionary, AsKey(entry.first), value);
    }
  }
  return dictionary;
}

/** Flushes the file to disk to detect late failures. */
void
Flush(const std::string & path)
{
  const FileStatus status = StatusOf(path);
  const int        reason = status.error != 0 ? status.error : status.isFile ? ErrorOfSync(path) : EINVAL;
  if (reason != 0 && !(status.isFile && (reason == EINVAL || reason == EROFS)))
  {
    ThrowCannotWrite(path, reason);
  }
}

template <typename TVector>
bool
AreClose(const TVector & a, const TVector & b)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (!(std::abs(a[i] - b[i]) <= GeometryTolerance * (1 + std::abs(a[i]))))
    {
      return false;
    }
  }
  return true;
}

/** The position of the first voxel, whose index may not be 0. */
template <typename TImage>
itk::Point<double, 3>
FirstPositionOf(const TImage * image)
{
  return image->template TransformIndexToPhysicalPoint<double>(image->GetLargestPossibleRegion().GetIndex());
}

template <typename TImage>
bool
HasSameGeometry(const TImage * a, const TImage * b)
{
  if (a->GetLargestPossibleRegion().GetSize() != b->GetLargestPossibleRegion().GetSize() ||
      !AreClose(a->GetSpacing(), b->GetSpacing()) || !AreClose(FirstPositionOf(a), FirstPositionOf(b)))
  {
    return false;
  }
  for (unsigned int row = 0; row < 3; ++row)
  {
    if (!AreClose(a->GetDirection()[row], b->GetDirection()[row]))
    {
      return false;
    }
  }
  return true;
}

/** Whether a file contains these voxels; read with the reader of its format. */
template <typename TImage>
bool
HoldsVoxels(const TImage * image, const std::string & path, itk::ImageFileReader<TImage> * reader)
{
  const StoredVoxels stored = LocateVoxels(path, ImageFormatOf(path));
  const char * const voxels = reinterpret_cast<const char *>(image->GetBufferPointer());
  const std::size_t  bytes = image->GetLargestPossibleRegion().GetNumberOfPixels() * sizeof(typename TImage::PixelType);
  if (stored.canBeTaken) // same layout as in memory: written on this machine
  {
    bool isEqual = true;
    TakeVoxels(stored, bytes, [&](std::uint64_t place, const char * piece, std::size_t size) {
      isEqual = isEqual && std::memcmp(voxels + place, piece, size) == 0;
    });
    return isEqual;
  }
  // ITK reads a truncated compressed file as trailing zeros, which labels may contain.
  VerifyVoxels(stored, bytes, bytes / sizeof(typename TImage::PixelType));
  reader->Update();
  return std::memcmp(voxels, reader->GetOutput()->GetBufferPointer(), bytes) == 0;
}

template <typename TImage>
void
Verify(const TImage * image, const std::string & path)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetFileName(path);
  reader->SetImageIO(MakeImageIO(path));
  reader->UpdateOutputInformation();
  if (!HasSameGeometry<TImage>(image, reader->GetOutput()))
  {
    throw OutputError(path + ": the geometry cannot be stored in this format; write .nrrd instead");
  }
  if (!HoldsVoxels<TImage>(image, path, reader))
  {
    throw OutputError(path + ": the file differs from the written data; check the free disk space");
  }
}
} // namespace

const std::string &
RequireVolumeName(const std::string & path)
{
  if (!path.empty())
  {
    MakeImageIO(path);
  }
  return path;
}

template <typename TPixel>
void
WriteVolume(const itk::Image<TPixel, 3> * image, const std::string & path, const VolumeMetadata & metadata)
{
  using ImageType = itk::Image<TPixel, 3>;
  RequirePixels(image, "the image");
  const itk::ImageIOBase::Pointer io = MakeImageIO(path);
  // A copy of the header that shares the pixels; the caller's image keeps its dictionary.
  const auto output = ImageType::New();
  output->Graft(image);
  output->SetMetaDataDictionary(MakeDictionary(metadata));
  const auto writer = itk::ImageFileWriter<ImageType>::New();
  writer->SetInput(output);
  writer->SetFileName(path);
  writer->SetImageIO(io);
  writer->SetUseCompression(std::is_integral<TPixel>::value);
  try
  {
    const QuietStandardError quiet;
    errno = 0;
    writer->Update();
    Flush(path);
    Verify(image, path);
  }
  catch (const OutputError &)
  {
    throw;
  }
  catch (const std::bad_alloc &)
  {
    throw;
  }
  catch (const std::exception &)
  {
    ThrowCannotWrite(path, errno, "ITK failed to write it");
  }
}

template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<float, 3> *, const std::string &, const VolumeMetadata &);
template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<short, 3> *, const std::string &, const VolumeMetadata &);
template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned char, 3> *, const std::string &, const VolumeMetadata &);
template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned short, 3> *, const std::string &, const VolumeMetadata &);
template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned int, 3> *, const std::string &, const VolumeMetadata &);

itk::Image<short, 3>::Pointer
ToShort(const itk::Image<float, 3> * image)
{
  const float * const first = image->GetBufferPointer();
  const float * const last = first + image->GetLargestPossibleRegion().GetNumberOfPixels();
  const bool          isShort = std::all_of(first, last, [](float value) {
    return value >= std::numeric_limits<short>::min() && value <= std::numeric_limits<short>::max() &&
           value == std::floor(value);
  });
  if (!isShort)
  {
    return nullptr;
  }
  return MapVoxels<short>(image, [](float value) { return static_cast<short>(value); });
}
} // namespace shapeton
