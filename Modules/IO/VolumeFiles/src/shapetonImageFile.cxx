#include "shapetonImageFile.h"
#include "shapetonFileErrors.h"
#include "shapetonDicomFields.h"
#include "shapetonDicomVolume.h"
#include "shapetonOperatingSystem.h"

#include "shapetonByteStream.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"
#include "shapetonPrintable.h"
#include "shapetonSha256.h"
#include "shapetonParallelFor.h"
#include "shapetonParsingServices.h"
#include "shapetonStoredVoxels.h"
#include "shapetonExceptions.h"
#include "shapetonNiftiHeader.h"
#include "shapetonNrrdFrame.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

namespace shapeton
{
namespace
{
using ComponentEnum = itk::ImageIOBase::IOComponentEnum;

itk::ImageIOBase::Pointer
MakeImageIO(ImageFormat format)
{
  return format == ImageFormat::nrrd ? itk::ImageIOBase::Pointer(itk::NrrdImageIO::New())
                                     : itk::ImageIOBase::Pointer(itk::MetaImageIO::New());
}

// ---- the header ----

struct ImageHeader : VoxelFormat
{
  std::vector<double> spacing;
  std::vector<double> origin;
  std::vector<double> direction; // row by row
  bool                isScalar{ false };
  std::string         modality, patientPosition, sliceThickness; // from DICOM; empty if unknown
};

template <typename TStream, typename THeader>
void
TransmitHeader(TStream & stream, THeader & header)
{
  auto     dimension = static_cast<std::uint32_t>(header.size.size());
  stream & dimension;
  if constexpr (!std::is_const<THeader>::value)
  {
    if (dimension > 16)
    {
      throw std::runtime_error("incomplete message");
    }
    header.size.resize(dimension);
    header.spacing.resize(dimension);
    header.origin.resize(dimension);
    header.direction.resize(dimension * dimension);
  }
  for (std::uint32_t i = 0; i < dimension; ++i)
  {
    stream & header.size[i] & header.spacing[i] & header.origin[i];
  }
  for (auto & cosine : header.direction)
  {
    stream & cosine;
  }
  stream & header.componentType & header.componentBytes & header.components & header.isScalar & header.statesSpacing;
  stream & header.modality & header.patientPosition & header.sliceThickness;
}

/** The cause in an ITK exception, without class and function names. NrrdIO lists functions from the outermost one to
 * the source of the error. */
std::string
Summary(const itk::ExceptionObject & error)
{
  std::string       text = Trimmed(error.GetDescription());
  const std::string nrrdLine = "[nrrd] ";
  const auto        nrrd = text.rfind(nrrdLine);
  const auto        colon = text.find("): ");
  if (nrrd != std::string::npos)
  {
    text = text.substr(nrrd + nrrdLine.size());
    text = text.substr(text.find(": ") == std::string::npos ? 0 : text.find(": ") + 2);
  }
  else if (colon != std::string::npos)
  {
    text = text.substr(colon + 3);
  }
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  constexpr std::size_t longest = 200;
  return text.substr(0, longest);
}

ImageHeader
ReadHeader(const std::string & path, ImageFormat format)
{
  const itk::ImageIOBase::Pointer io = MakeImageIO(format);
  io->SetFileName(path);
  io->ReadImageInformation();
  ImageHeader       header;
  const std::size_t dimension = io->GetNumberOfDimensions();
  for (std::size_t i = 0; i < dimension; ++i)
  {
    const auto axis = static_cast<unsigned int>(i);
    header.size.push_back(io->GetDimensions(axis));
    header.spacing.push_back(io->GetSpacing(axis));
    header.origin.push_back(io->GetOrigin(axis));
  }
  for (std::size_t row = 0; row < dimension; ++row)
  {
    for (std::size_t column = 0; column < dimension; ++column)
    {
      const auto axis = io->GetDirection(static_cast<unsigned int>(column)); // a column of the matrix
      header.direction.push_back(row < axis.size() ? axis[row] : 0.0);
    }
  }
  header.componentType = io->GetComponentType();
  if (header.componentType != ComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    header.componentBytes = io->GetComponentSize();
  }
  header.components = io->GetNumberOfComponents();
  header.isScalar = header.components == 1 && io->GetPixelType() != itk::IOPixelEnum::COMPLEX; // or a list of one
  header.statesSpacing = StatesSpacing(path, format);
  header.modality = DicomField(io, DicomModality);
  header.patientPosition = DicomField(io, DicomPatientPosition);
  header.sliceThickness = DicomField(io, DicomSliceThickness);
  return header;
}

void
ReadVoxels(const std::string & path, ImageFormat format, char * voxels)
{
  const itk::ImageIOBase::Pointer io = MakeImageIO(format);
  io->SetFileName(path);
  io->ReadImageInformation();
  itk::ImageIORegion region(io->GetNumberOfDimensions());
  for (unsigned int i = 0; i < io->GetNumberOfDimensions(); ++i)
  {
    region.SetIndex(i, 0);
    region.SetSize(i, io->GetDimensions(i));
  }
  io->SetIORegion(region);
  io->Read(voxels);
}

/** Time limit for work on `bytes` bytes of voxels; a slow machine processes one megabyte per second. */
ContainedProcess::Limits
LimitsFor(double bytes)
{
  constexpr double waiting = 600; // s; generous, for slow network drives
  const double     seconds = 10 + bytes / 1e6;
  return { static_cast<std::size_t>((256u << 20) + 3 * bytes),
           static_cast<unsigned int>(seconds),
           static_cast<unsigned int>(waiting + seconds) };
}

/** A request for the header, or for the voxels in shared memory. */
struct ImageRequest
{
  std::string   path;
  ImageFormat   format{ ImageFormat::none };
  StoredVoxels  stored;
  std::uint64_t voxelBytes{ 0 }; // 0: for the header
  std::uint64_t values{ 0 };
};

template <typename TStream, typename TRequest>
void
TransmitRequest(TStream & stream, TRequest & request)
{
  auto &   stored = request.stored;
  stream & request.path & request.format;
  stream.SizeOf(stored.files);
  for (auto & file : stored.files)
  {
    stream & file;
  }
  stream & stored.offset & stored.coding & stored.canBeTaken & stored.isBigEndian & stored.inflatedOffset & stored
    .areLast & request.voxelBytes & request.values;
}

std::string
CallImageService(ContainedProcess & process, const ImageRequest & request)
{
  ByteWriter writer;
  TransmitRequest(writer, request);
  return process.Call(writer.GetBytes());
}

/** Runs in the contained process. */
std::string
AnswerImageRequest(const ImageRequest & request, char * shared)
{
  ByteWriter writer;
  if (request.voxelBytes == 0)
  {
    const ImageHeader header = ReadHeader(request.path, request.format);
    TransmitHeader(writer, header);
  }
  else if (request.stored.canBeTaken)
  {
    bool hasMore = TakeVoxels(
      request.stored, request.voxelBytes, [shared](std::uint64_t place, const char * piece, std::size_t size) {
        std::copy_n(piece, size, shared + place);
      });
    writer & hasMore;
  }
  else
  {
    bool hasMore = VerifyVoxels(request.stored, request.voxelBytes, request.values);
    ReadVoxels(request.path, request.format, shared);
    writer & hasMore;
  }
  return writer.GetBytes();
}

ImageHeader
ReadHeaderContained(ContainedProcess & process, const ImageRequest & request)
{
  ImageHeader header;
  try
  {
    const std::string response = CallImageService(process, request);
    ByteReader        reader(response);
    TransmitHeader(reader, header);
  }
  catch (const ContainedProcess::Failure & failure)
  {
    ThrowUnsuitable(request.path, "the " + NameOf(request.format) + " header cannot be read: " + failure.what());
  }
  return header;
}

ImageHeader
HeaderOfNifti(const std::string & path)
{
  const NiftiHeader nifti = ReadNiftiHeader(path);
  const std::size_t dimension = nifti.size.size();
  ImageHeader       header{ nifti, {}, {}, {}, nifti.components == 1, {}, {}, {} };
  header.spacing.assign(dimension, 1.0);
  header.origin.assign(dimension, 0.0);
  header.direction.assign(dimension * dimension, 0.0);
  for (unsigned int i = 0; i < std::min<std::size_t>(3, dimension); ++i)
  {
    header.spacing[i] = nifti.spacing[i];
    header.origin[i] = nifti.origin[i];
    for (unsigned int j = 0; j < std::min<std::size_t>(3, dimension); ++j)
    {
      header.direction[i * dimension + j] = nifti.direction(i, j);
    }
  }
  return header;
}

/** Completes the frame that ITK read. */
void
Correct(const NrrdFrame & frame, ImageHeader & header)
{
  const std::size_t n = header.size.size();
  for (std::size_t row = 0; row < std::min<std::size_t>(3, n); ++row)
  {
    double shift = 0.0;
    for (std::size_t axis = 0; axis < std::min<std::size_t>(3, n); ++axis)
    {
      shift += header.direction[row * n + axis] * header.spacing[axis] * frame.first[axis];
    }
    header.origin[row] = frame.signs[row] * frame.millimeters * (header.origin[row] + shift);
    for (std::size_t axis = 0; axis < n; ++axis)
    {
      header.direction[row * n + axis] *= frame.signs[row];
    }
  }
  for (std::size_t axis = 0; axis < std::min<std::size_t>(3, n); ++axis)
  {
    header.spacing[axis] *= frame.millimeters;
  }
  AppendRemarks(header.notes, frame.notes);
}

// ---- checks ----

bool
AreFinite(const std::vector<double> & values)
{
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void
CheckKind(const std::string & path, const ImageHeader & header)
{
  if (!header.isScalar)
  {
    ThrowUnsuitable(path,
                    "its voxels have " + std::to_string(header.components) +
                      " components (color, vector or complex); one intensity per voxel is required");
  }
  if (header.componentBytes == 0)
  {
    ThrowUnsuitable(path, "its voxel type is not supported");
  }
  if (header.size.size() < 3)
  {
    ThrowUnsuitable(path, "a " + std::to_string(header.size.size()) + "-D image; a volume is required");
  }
  for (std::size_t i = 3; i < header.size.size(); ++i)
  {
    if (header.size[i] != 1)
    {
      ThrowUnsuitable(path,
                      "a series of " + std::to_string(header.size[i]) + " volumes (dimension " + std::to_string(i + 1) +
                        "); extract one of them");
    }
  }
}

void
CheckGeometry(const std::string & path, const ImageHeader & header)
{
  if (!AreFinite(header.spacing) || !AreFinite(header.origin) || !AreFinite(header.direction))
  {
    ThrowUnsuitable(path, "spacing, origin or direction is not a finite number; repair the header");
  }
  for (int i = 0; i < 3; ++i)
  {
    if (header.spacing[i] <= 0)
    {
      ThrowUnsuitable(path, "the spacing of axis " + std::to_string(i + 1) + " is not positive; repair the header");
    }
  }
  const std::size_t n = header.size.size();
  bool              isOrthonormal = true;
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      double dot = 0;
      for (int row = 0; row < 3; ++row)
      {
        dot += header.direction[row * n + a] * header.direction[row * n + b];
      }
      isOrthonormal = isOrthonormal && std::abs(dot - (a == b ? 1 : 0)) <= OrthonormalTolerance;
    }
  }
  if (!isOrthonormal)
  {
    ThrowUnsuitable(path, "its axes are not orthogonal (sheared direction matrix); resample it onto orthogonal axes");
  }
}

/** The size of the voxels in bytes; rejects headers that exceed the capacity of the file or the memory. */
double
CheckSize(const std::string & path, const ImageHeader & header, const StoredVoxels & stored)
{
  double voxels = 1;
  for (const std::uint64_t size : header.size)
  {
    voxels *= static_cast<double>(size);
  }
  if (voxels < 1)
  {
    ThrowUnsuitable(path, "it has no voxels");
  }
  const double bytes = voxels * header.componentBytes;
  if (!CanHold(stored, bytes, voxels))
  {
    std::ostringstream text;
    text << "truncated: the header states " << header.size[0] << "x" << header.size[1] << "x" << header.size[2]
         << " voxels, more than the file can contain";
    ThrowUnsuitable(path, text.str());
  }
  if (bytes + voxels * sizeof(float) > PhysicalMemory())
  {
    ThrowUnsuitable(path, "the volume exceeds the memory of this machine; crop it");
  }
  return bytes;
}

// ---- voxels ----

template <typename TStored>
TStored
Swapped(TStored value)
{
  char bytes[sizeof(TStored)];
  std::memcpy(bytes, &value, sizeof(TStored));
  std::reverse(bytes, bytes + sizeof(TStored));
  std::memcpy(&value, bytes, sizeof(TStored));
  return value;
}

template <typename TStored>
void
CopyVoxels(const ImageHeader & header, const char * stored, std::size_t count, float * voxels)
{
  const auto * const values = reinterpret_cast<const TStored *>(stored);
  const bool         isScaled = header.slope != 1.0 || header.intercept != 0.0;
  ParallelForBlocks(count, [&](std::size_t i) {
    const TStored value = header.isSwapped ? Swapped(values[i]) : values[i];
    voxels[i] = isScaled ? static_cast<float>(header.slope * static_cast<double>(value) + header.intercept)
                         : static_cast<float>(value);
  });
}

void
ConvertVoxels(const std::string & path,
              const ImageHeader & header,
              const char *        stored,
              std::size_t         count,
              float *             voxels)
{
  switch (header.componentType)
  {
    case ComponentEnum::UCHAR:
      return CopyVoxels<unsigned char>(header, stored, count, voxels);
    case ComponentEnum::CHAR:
      return CopyVoxels<signed char>(header, stored, count, voxels);
    case ComponentEnum::USHORT:
      return CopyVoxels<unsigned short>(header, stored, count, voxels);
    case ComponentEnum::SHORT:
      return CopyVoxels<short>(header, stored, count, voxels);
    case ComponentEnum::UINT:
      return CopyVoxels<unsigned int>(header, stored, count, voxels);
    case ComponentEnum::INT:
      return CopyVoxels<int>(header, stored, count, voxels);
    case ComponentEnum::ULONG:
      return CopyVoxels<unsigned long>(header, stored, count, voxels);
    case ComponentEnum::LONG:
      return CopyVoxels<long>(header, stored, count, voxels);
    case ComponentEnum::ULONGLONG:
      return CopyVoxels<unsigned long long>(header, stored, count, voxels);
    case ComponentEnum::LONGLONG:
      return CopyVoxels<long long>(header, stored, count, voxels);
    case ComponentEnum::FLOAT:
      return CopyVoxels<float>(header, stored, count, voxels);
    case ComponentEnum::DOUBLE:
      return CopyVoxels<double>(header, stored, count, voxels);
    default:
      ThrowUnsuitable(path, "its voxel type is not supported");
  }
}

void
CheckFinite(const std::string & path, const ImageHeader & header, const Volume::ImageType * image)
{
  const auto type = header.componentType;
  const bool isReal = type == ComponentEnum::FLOAT || type == ComponentEnum::DOUBLE || header.slope != 1.0;
  if (!isReal && header.intercept == 0.0)
  {
    return;
  }
  const float * const voxels = image->GetBufferPointer();
  const std::size_t   count = image->GetLargestPossibleRegion().GetNumberOfPixels();
  const auto          isBad = [](float value) { return !std::isfinite(value); };
  const auto          bad = static_cast<std::size_t>(std::count_if(voxels, voxels + count, isBad));
  if (bad == 0)
  {
    return;
  }
  const auto         offset = std::find_if(voxels, voxels + count, isBad) - voxels;
  const auto         index = image->ComputeIndex(offset);
  std::ostringstream text;
  text << bad << " of " << count << " voxels are not finite numbers, the first at index (" << index[0] << ", "
       << index[1] << ", " << index[2] << "); replace NaN and infinity by numbers";
  ThrowUnsuitable(path, text.str());
}

/** Integers are exact up to 2^24 in single precision. */
void
NoteRounding(const ImageHeader & header, Volume & volume)
{
  const auto type = header.componentType;
  const bool isWide = type == ComponentEnum::INT || type == ComponentEnum::UINT || type == ComponentEnum::LONG ||
                      type == ComponentEnum::ULONG || type == ComponentEnum::LONGLONG ||
                      type == ComponentEnum::ULONGLONG;
  const float * const voxels = volume.image->GetBufferPointer();
  const std::size_t   count = volume.image->GetLargestPossibleRegion().GetNumberOfPixels();
  constexpr float     firstRounded = 16777216.0F; // 2^24
  if (isWide && std::any_of(voxels, voxels + count, [](float value) { return std::abs(value) >= firstRounded; }))
  {
    volume.notes.push_back("intensities of 2^24 and more are rounded to single precision: small differences are lost");
  }
}

void
NoteMissingSpacing(const ImageHeader & header, Volume & volume)
{
  if (!header.statesSpacing)
  {
    volume.notes.push_back("the header states no spacing for at least one axis: 1 mm is assumed, and all values in mm "
                           "are uncertain; write the spacing into the header");
  }
}

Volume::ImageType::Pointer
MakeImage(const ImageHeader & header)
{
  auto                             image = Volume::ImageType::New();
  Volume::ImageType::SizeType      size;
  Volume::ImageType::SpacingType   spacing;
  Volume::ImageType::PointType     origin;
  Volume::ImageType::DirectionType direction;
  for (unsigned int i = 0; i < 3; ++i)
  {
    size[i] = header.size[i];
    spacing[i] = header.spacing[i];
    origin[i] = header.origin[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      direction(i, j) = header.direction[i * header.size.size() + j];
    }
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate(true);
  return image;
}

std::string
IdentityOf(const std::string & path, const StoredVoxels & stored)
{
  std::string digests = Sha256OfFile(path);
  if (stored.files.front() == path)
  {
    return "sha256:" + digests;
  }
  for (const std::string & file : stored.files)
  {
    digests += Sha256OfFile(file);
  }
  return "sha256:" + Sha256OfBytes(digests);
}

/** Sets image and identity, and adds notes. */
void
ReadImage(ContainedProcess & process, const ImageRequest & request, const ImageHeader & header, Volume & volume)
{
  process.Share(request.voxelBytes, LimitsFor(static_cast<double>(request.voxelBytes)));
  WorkBeside beside = StartBeside([&] {
    volume.image = MakeImage(header); // after the memory check
    volume.identity = IdentityOf(request.path, request.stored);
  });
  try
  {
    const std::string response = CallImageService(process, request);
    ByteReader        reader(response);
    bool              hasMore = false;
    reader &          hasMore;
    if (hasMore)
    {
      volume.notes.push_back("its file contains more voxels than its header describes; the rest was ignored: check the "
                             "sizes in the header");
    }
  }
  catch (const ContainedProcess::Failure & failure)
  {
    ThrowUnsuitable(request.path, failure.what());
  }
  process.Stop();
  beside.Get();
  ConvertVoxels(request.path,
                header,
                process.GetShared(),
                volume.image->GetLargestPossibleRegion().GetNumberOfPixels(),
                volume.image->GetBufferPointer());
}
} // namespace

ContainedService
MakeImageFileService()
{
  return [](const std::string & bytes, char * shared) {
    ImageRequest request;
    ByteReader   reader(bytes);
    TransmitRequest(reader, request);
    try
    {
      return AnswerImageRequest(request, shared);
    }
    catch (const itk::ExceptionObject & error)
    {
      throw std::runtime_error(Summary(error));
    }
  };
}

bool
IsImageFile(const std::string & path)
{
  return ImageFormatOf(path) != ImageFormat::none;
}

Volume
ReadImageFile(const std::string & path)
{
  ImageRequest request;
  request.format = ImageFormatOf(path);
  const bool isNifti = request.format == ImageFormat::nifti;
  request.path = isNifti ? NiftiHeaderFile(path) : path; // the file that contains the header
  errno = 0;
  if (!std::ifstream(request.path))
  {
    ThrowCannotRead(request.path, errno);
  }
  request.stored = LocateVoxels(request.path, request.format);
  ContainedProcess         process(ImageFileService, 0, LimitsFor(0));
  std::optional<NrrdFrame> frame;
  if (request.format == ImageFormat::nrrd)
  {
    frame.emplace(request.path);
  }
  ImageHeader header = isNifti ? HeaderOfNifti(request.path) : ReadHeaderContained(process, request);
  if (frame)
  {
    Correct(*frame, header);
    header.isSwapped = request.stored.canBeTaken && request.stored.isBigEndian && header.componentBytes > 1;
  }
  CheckKind(path, header);
  CheckGeometry(path, header);
  request.voxelBytes = static_cast<std::uint64_t>(CheckSize(path, header, request.stored));
  request.values = request.voxelBytes / header.componentBytes;
  Volume volume;
  ReadImage(process, request, header, volume);
  volume.modality = header.modality;
  volume.patientPosition = header.patientPosition;
  volume.sliceThickness = std::max(0.0, std::strtod(header.sliceThickness.c_str(), nullptr));
  SetDicomFields(volume);
  CheckFinite(path, header, volume.image);
  AppendRemarks(volume.notes, header.notes);
  NoteMissingSpacing(header, volume);
  NoteRounding(header, volume);
  return volume;
}
} // namespace shapeton
