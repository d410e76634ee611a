#include "shapetonNiftiHeader.h"

#include "shapetonFileErrors.h"
#include "shapetonPi.h"
#include "shapetonPrintable.h"

#include "itk_zlib.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;
using Vector = NiftiHeader::Vector;
using ComponentEnum = itk::ImageIOBase::IOComponentEnum;

// nifti1.h and nifti2.h
constexpr int Nifti1Bytes = 348;
constexpr int Nifti2Bytes = 540;

// Tolerance: half a voxel in 500; smaller deviations are rounding errors.
constexpr double RelativeSpacingTolerance = 1e-3;

/** Offsets of the fields that are read. */
struct Layout
{
  int magic, dim, datatype, pixdim, voxelOffset, slope, units, qformCode, sformCode, quaternion, srow;
};
// By nifti1.h and nifti2.h.
constexpr Layout Nifti1Layout{ 344, 40, 70, 76, 108, 112, 123, 252, 254, 256, 280 };
constexpr Layout Nifti2Layout{ 4, 16, 12, 104, 168, 176, 500, 344, 348, 352, 400 };

std::string
Text(const Vector & vector, const char * separator)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(6);
  text << vector[0] << separator << vector[1] << separator << vector[2];
  return text.str();
}

/** The first bytes of a file, inflated if compressed. */
std::string
FirstBytes(const std::string & path, std::size_t size)
{
  std::string                                           bytes(size, '\0');
  const std::unique_ptr<gzFile_s, decltype(&gzclose_r)> file(gzopen(path.c_str(), "rb"), &gzclose_r);
  const int read = file ? gzread(file.get(), &bytes[0], static_cast<unsigned int>(size)) : 0;
  bytes.resize(static_cast<std::size_t>(std::max(0, read)));
  return bytes;
}

/** Access to header fields for any version and byte order. */
class Fields
{
public:
  explicit Fields(const std::string & path) : m_Path(path), m_Bytes(FirstBytes(path, Nifti2Bytes))
  {
    for (const bool isSwapped : { false, true })
    {
      m_IsSwapped = isSwapped;
      const std::int32_t size = m_Bytes.size() < 4 ? 0 : this->Number<std::int32_t>(0);
      if (size == Nifti1Bytes || size == Nifti2Bytes)
      {
        m_IsNifti2 = size == Nifti2Bytes;
        this->Require(m_Bytes.size() >= static_cast<std::size_t>(size), "truncated: it ends within its header");
        return;
      }
    }
    this->Refuse("this is not a NIfTI file: its first four bytes are not the size of a header, 348 or 540");
  }

  [[noreturn]] void
  Refuse(const std::string & reason) const
  {
    ThrowUnsuitable(m_Path, reason);
  }
  void
  Require(bool condition, const std::string & reason) const
  {
    if (!condition)
    {
      this->Refuse(reason);
    }
  }

  bool
  IsSwapped() const
  {
    return m_IsSwapped;
  }
  int
  Size() const
  {
    return m_IsNifti2 ? Nifti2Bytes : Nifti1Bytes;
  }
  const char *
  Name() const
  {
    return m_IsNifti2 ? "NIfTI-2" : "NIfTI-1";
  }

  /** Whether the voxels are in the same file. */
  bool
  IsSingleFile() const
  {
    const std::string magic = m_Bytes.substr(this->Of().magic, m_IsNifti2 ? 8 : 4);
    const std::string end = m_IsNifti2 ? std::string("2\0\r\n\032\n", 6) : std::string("1\0", 2);
    const bool        isSingle = magic == "n+" + end;
    this->Require(isSingle || magic == "ni" + end,
                  std::string("its header has the magic number ") + Quoted(Printable(magic.substr(0, 3))) + " where " +
                    this->Name() + (m_IsNifti2 ? " has \"n+2\" or \"ni2\"" : " has \"n+1\" or \"ni1\"") +
                    ": it is damaged, or ANALYZE 7.5, which does not state orientation and origin; convert it to NIfTI "
                    "with a program that sets them");
    return isSingle;
  }
  std::int64_t
  Dimension(int i) const
  {
    return m_IsNifti2 ? this->Number<std::int64_t>(this->Of().dim + 8 * i)
                      : this->Number<std::int16_t>(this->Of().dim + 2 * i);
  }
  int
  DataType() const
  {
    return this->Number<std::int16_t>(this->Of().datatype);
  }
  double
  VoxelOffset() const
  {
    return m_IsNifti2 ? static_cast<double>(this->Number<std::int64_t>(this->Of().voxelOffset))
                      : this->Real(this->Of().voxelOffset);
  }
  int
  Units() const
  {
    return m_IsNifti2 ? this->Number<std::int32_t>(this->Of().units) : m_Bytes[this->Of().units];
  }
  int
  QformCode() const
  {
    return this->Code(this->Of().qformCode);
  }
  int
  SformCode() const
  {
    return this->Code(this->Of().sformCode);
  }
  double
  Slope() const
  {
    return this->Real(this->Of().slope);
  }
  double
  Intercept() const
  {
    return this->Real(this->Of().slope, 1);
  }
  double
  Pixdim(int i) const
  {
    return this->Real(this->Of().pixdim, i);
  }
  /** b, c, d and the offset of the qform. */
  Vector
  Quaternion() const
  {
    return this->Reals(this->Of().quaternion, 0);
  }
  Vector
  QformOffset() const
  {
    return this->Reals(this->Of().quaternion, 3);
  }
  /** A column of the sform; the last one, 3, is its offset. */
  Vector
  SformColumn(int column) const
  {
    Vector values;
    for (int row = 0; row < 3; ++row)
    {
      values[row] = this->Real(this->Of().srow, 4 * row + column);
    }
    return values;
  }

private:
  const Layout &
  Of() const
  {
    return m_IsNifti2 ? Nifti2Layout : Nifti1Layout;
  }
  template <typename TNumber>
  TNumber
  Number(int offset) const
  {
    char bytes[sizeof(TNumber)];
    std::memcpy(bytes, m_Bytes.data() + offset, sizeof(TNumber));
    if (m_IsSwapped)
    {
      std::reverse(bytes, bytes + sizeof(TNumber));
    }
    TNumber number;
    std::memcpy(&number, bytes, sizeof(TNumber));
    return number;
  }
  /** The i-th of several floating-point numbers, in single precision in NIfTI-1. */
  double
  Real(int offset, int i = 0) const
  {
    return m_IsNifti2 ? this->Number<double>(offset + 8 * i) : this->Number<float>(offset + 4 * i);
  }
  Vector
  Reals(int offset, int first) const
  {
    Vector values;
    for (int i = 0; i < 3; ++i)
    {
      values[i] = this->Real(offset, first + i);
    }
    return values;
  }
  int
  Code(int offset) const
  {
    return m_IsNifti2 ? this->Number<std::int32_t>(offset) : this->Number<std::int16_t>(offset);
  }

  std::string m_Path;
  std::string m_Bytes;
  bool        m_IsSwapped{ false };
  bool        m_IsNifti2{ false };
};

bool
AreFinite(const Vector & v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// ---- voxels ----

struct DataType
{
  int           code;
  ComponentEnum type;
  std::uint32_t bytes;
  std::uint32_t components;
};

/** Other types, such as bits and 128-bit floating point, are not supported by ITK. */
constexpr DataType DataTypes[] = { { 2, ComponentEnum::UCHAR, 1, 1 },       { 4, ComponentEnum::SHORT, 2, 1 },
                                   { 8, ComponentEnum::INT, 4, 1 },         { 16, ComponentEnum::FLOAT, 4, 1 },
                                   { 32, ComponentEnum::FLOAT, 4, 2 },      { 64, ComponentEnum::DOUBLE, 8, 1 },
                                   { 128, ComponentEnum::UCHAR, 1, 3 },     { 256, ComponentEnum::CHAR, 1, 1 },
                                   { 512, ComponentEnum::USHORT, 2, 1 },    { 768, ComponentEnum::UINT, 4, 1 },
                                   { 1024, ComponentEnum::LONGLONG, 8, 1 }, { 1280, ComponentEnum::ULONGLONG, 8, 1 },
                                   { 1792, ComponentEnum::DOUBLE, 8, 2 },   { 2304, ComponentEnum::UCHAR, 1, 4 } };

void
SetVoxels(const Fields & fields, NiftiHeader & header)
{
  const std::int64_t     dimensions = fields.Dimension(0);
  constexpr std::int64_t most = 7;
  fields.Require(dimensions >= 1 && dimensions <= most,
                 "dim[0], the number of dimensions, is " + std::to_string(dimensions) + "; it must be 1 to 7");
  for (int i = 1; i <= dimensions; ++i)
  {
    const std::int64_t size = fields.Dimension(i);
    fields.Require(size > 0 || i > 3,
                   "dim[" + std::to_string(i) + "], a number of voxels, is " + std::to_string(size) +
                     "; it must be positive");
    header.size.push_back(static_cast<std::uint64_t>(std::max<std::int64_t>(size, 1))); // 0 in some files if unused
  }
  const auto * const type = std::find_if(
    std::begin(DataTypes), std::end(DataTypes), [&](const DataType & t) { return t.code == fields.DataType(); });
  fields.Require(type != std::end(DataTypes),
                 "its voxel type, datatype = " + std::to_string(fields.DataType()) + ", is not supported");
  header.componentType = type->type;
  header.componentBytes = type->bytes;
  header.components = type->components;
  header.isSwapped = fields.IsSwapped();
  const double slope = fields.Slope();
  if (std::isfinite(slope) && slope != 0.0) // otherwise the stored values are the intensities
  {
    header.slope = slope;
    header.intercept = fields.Intercept();
    fields.Require(std::isfinite(header.intercept), "scl_inter is not a finite number; repair the header");
  }
}

/** The name without .gz. */
fs::path
Uncompressed(const fs::path & path)
{
  return LowerCase(path.extension().string()) == ".gz" ? fs::path(path).replace_extension() : path;
}

/** The other file of a pair, with a lower- or upper-case extension, compressed or not; empty if not found. */
std::string
FileBeside(const fs::path & path, const std::string & extension, const std::string & capitals)
{
  for (const std::string & ending : { extension, extension + ".gz", capitals, capitals + ".GZ" })
  {
    std::error_code   error;
    const std::string file = Uncompressed(path).replace_extension(ending).string();
    if (fs::is_regular_file(file, error))
    {
      return file;
    }
  }
  return {};
}

void
SetPlace(const std::string & path, const Fields & fields, NiftiHeader & header)
{
  const bool isSingle = fields.IsSingleFile();
  header.voxelFile = isSingle ? path : FileBeside(path, ".img", ".IMG");
  fields.Require(!header.voxelFile.empty(), "the .img file with its voxels is missing (magic \"ni1\" or \"ni2\")");
  const double       offset = fields.VoxelOffset();
  const int          least = isSingle ? fields.Size() : 0;
  constexpr double   farthest = 1e15; // exact in double precision
  std::ostringstream text;
  text << "vox_offset, the start of the voxels, is " << offset << "; it must be an integer of at least " << least;
  fields.Require(offset >= least && offset == std::floor(offset) && offset < farthest, text.str());
  header.voxelOffset = static_cast<std::uint64_t>(offset);
}

// ---- geometry ----

/** Axes of voxels in NIfTI space, RAS, in the unit of the file. */
struct Frame
{
  std::array<Vector, 3> axes; ///< from a voxel to the next
  Vector                origin;
};

std::string
NumberOf(int axis)
{
  return std::to_string(axis + 1);
}

/** A spacing from pixdim, or 1 if it is missing. */
double
SpacingOf(const Fields & fields, int axis, NiftiHeader & header)
{
  const double stated = fields.Pixdim(axis + 1);
  if (!std::isfinite(stated) || stated == 0.0)
  {
    header.statesSpacing = false;
    return 1.0;
  }
  if (stated < 0.0)
  {
    std::ostringstream text;
    text << "pixdim[" << axis + 1 << "] = " << stated << ", a distance, is negative: its absolute value is used";
    header.notes.push_back(text.str());
  }
  return std::abs(stated);
}

/** Rows of the rotation matrix from quaternions: nifti1.h, "method 2". */
Frame
QformOf(const Fields & fields, NiftiHeader & header)
{
  const Vector q = fields.Quaternion();
  Frame        frame{ {}, fields.QformOffset() };
  fields.Require(AreFinite(q) && AreFinite(frame.origin),
                 "a number of its qform (quatern_b to qoffset_z) is not finite; repair the header");
  const double square = q.GetSquaredNorm();
  fields.Require(square <= 1.0 + OrthonormalTolerance,
                 "its qform is not a rotation: quatern_b, c, d = " + Text(q, ", ") +
                   " is longer than 1; repair the header");
  const double scale = square > 1.0 ? 1.0 / std::sqrt(square) : 1.0;
  const double a = std::sqrt(std::max(0.0, 1.0 - square));
  const double b = scale * q[0];
  const double c = scale * q[1];
  const double d = scale * q[2];
  const double handedness = fields.Pixdim(0) < 0.0 ? -1.0 : 1.0; // qfac; 0 counts as 1
  const double rotation[3][3] = {
    { a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c) },
    { 2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b) },
    { 2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c },
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = SpacingOf(fields, axis, header) * (axis == 2 ? handedness : 1.0);
    for (int row = 0; row < 3; ++row)
    {
      frame.axes[axis][row] = length * rotation[row][axis];
    }
  }
  return frame;
}

/** nifti1.h, "method 3". */
Frame
SformOf(const Fields & fields, NiftiHeader & header)
{
  Frame  frame{ {}, fields.SformColumn(3) };
  bool   agrees = true;
  Vector stated;
  Vector taken;
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.axes[axis] = fields.SformColumn(axis);
    fields.Require(AreFinite(frame.axes[axis]) && AreFinite(frame.origin),
                   "a number of its sform (srow_x, srow_y, srow_z) is not finite; repair the header");
    taken[axis] = frame.axes[axis].GetNorm();
    fields.Require(taken[axis] > 0.0, "axis " + NumberOf(axis) + " of its sform has zero length; repair the header");
    stated[axis] = std::abs(fields.Pixdim(axis + 1));
    agrees = agrees && std::abs(stated[axis] - taken[axis]) <= RelativeSpacingTolerance * taken[axis];
  }
  if (!agrees)
  {
    header.notes.push_back("the voxel spacing of pixdim, " + Text(stated, " x ") +
                           ", differs from that of the sform, " + Text(taken, " x ") + ", which is used");
  }
  return frame;
}

void
RequireOrthogonal(const Fields & fields, const Frame & frame)
{
  for (int a = 0; a < 3; ++a)
  {
    const int    b = (a + 1) % 3;
    const double cosine = frame.axes[a] * frame.axes[b] / (frame.axes[a].GetNorm() * frame.axes[b].GetNorm());
    if (std::abs(cosine) > OrthonormalTolerance)
    {
      std::ostringstream text;
      text.precision(4);
      text << "the axes of its sform are not orthogonal: the angle between axis " << std::min(a, b) + 1 << " and axis "
           << std::max(a, b) + 1 << " is " << DegreesPerRadian * std::acos(cosine)
           << " degrees; resample the volume onto orthogonal axes";
      fields.Refuse(text.str() + (fields.QformCode() > 0 ? ", or set sform_code to 0 to use its qform" : ""));
    }
  }
}

/** Adds a note if qform and sform place a corner of the volume more than half a voxel apart, because programs differ in
 * which one they use. */
void
NoteOtherQform(const Fields & fields, const Frame & sform, double scale, NiftiHeader & header)
{
  if (fields.QformCode() <= 0 || !(fields.Quaternion().GetSquaredNorm() <= 1.0 + OrthonormalTolerance) ||
      !AreFinite(fields.QformOffset()))
  {
    return;
  }
  NiftiHeader ignored; // removes its notes on pixdim, which is unused here
  const Frame qform = QformOf(fields, ignored);
  double      distance = 0.0;
  double      voxel = sform.axes[0].GetNorm();
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    Vector difference = qform.origin - sform.origin;
    for (std::size_t axis = 0; axis < std::min<std::size_t>(3, header.size.size()); ++axis)
    {
      const double steps = (corner >> axis) & 1U ? static_cast<double>(header.size[axis] - 1) : 0.0;
      difference += (qform.axes[axis] - sform.axes[axis]) * steps;
      voxel = std::min(voxel, sform.axes[axis].GetNorm());
    }
    distance = std::max(distance, difference.GetNorm());
  }
  if (distance > 0.5 * voxel)
  {
    std::ostringstream text;
    text.precision(4);
    text << "sform (code " << fields.SformCode() << ") and qform (code " << fields.QformCode()
         << ") place the volume up to " << scale * distance << " mm apart: the sform is used";
    header.notes.push_back(text.str());
  }
}

double
MillimetersPerUnit(const Fields & fields, NiftiHeader & header)
{
  const int unit = fields.Units() & 7; // the other bits are the time unit
  switch (unit)
  {
    case 0: // unknown
    case 2:
      return 1.0;
    case 1:
      header.notes.emplace_back("its unit of length is the meter: spacing and origin were converted to mm");
      return 1000.0;
    case 3:
      header.notes.emplace_back("its unit of length is the micrometer: spacing and origin were converted to mm");
      return 0.001;
    default:
      header.notes.push_back("xyzt_units states the unknown unit of length " + std::to_string(unit) +
                             ": mm is assumed, and all lengths are uncertain");
      return 1.0;
  }
}

void
SetGeometry(const Fields & fields, NiftiHeader & header)
{
  const double scale = MillimetersPerUnit(fields, header);
  // If neither is defined, the axes are those of ITK's space.
  Frame frame{ { Vector(0.0), Vector(0.0), Vector(0.0) }, Vector(0.0) };
  if (fields.SformCode() > 0)
  {
    frame = SformOf(fields, header);
    RequireOrthogonal(fields, frame);
    NoteOtherQform(fields, frame, scale, header);
  }
  else if (fields.QformCode() > 0)
  {
    frame = QformOf(fields, header);
  }
  else
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      frame.axes[axis][axis] = (axis < 2 ? -1.0 : 1.0) * SpacingOf(fields, axis, header);
    }
    header.notes.emplace_back("sform_code and qform_code are 0: orientation and origin are unknown, as are left and "
                              "right; the axes are assumed to be left, posterior and superior");
  }
  const double toLps[3] = { -1.0, -1.0, 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = frame.axes[axis].GetNorm();
    header.spacing[axis] = scale * length;
    header.origin[axis] = scale * toLps[axis] * frame.origin[axis] + 0.0; // avoids -0
    for (int row = 0; row < 3; ++row)
    {
      const double cosine = toLps[row] * frame.axes[axis][row] / length;
      // Smaller values are rounding errors, and VNL's singular values of a matrix with subnormal numbers do not
      // converge.
      const bool isNothing = std::abs(cosine) < std::numeric_limits<double>::epsilon();
      header.direction(row, axis) = isNothing ? 0.0 : cosine;
    }
  }
}
} // namespace

std::string
NiftiHeaderFile(const std::string & path)
{
  return LowerCase(Uncompressed(path).extension().string()) == ".img" ? FileBeside(path, ".hdr", ".HDR") : path;
}

NiftiHeader
ReadNiftiHeader(const std::string & path)
{
  const Fields fields(path);
  NiftiHeader  header;
  SetPlace(path, fields, header);
  SetVoxels(fields, header);
  SetGeometry(fields, header);
  return header;
}
} // namespace shapeton
