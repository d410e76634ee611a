#ifndef shapetonNiftiTestFile_h
#define shapetonNiftiTestFile_h

#include "itk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace niftitest
{
/** A NIfTI file of 2 x 3 x 4 float voxels, 0 to 23, with an identity sform; tests modify single fields. */
class NiftiFile
{
public:
  explicit NiftiFile(int version = 1, bool isSwapped = false)
    : m_Version(version), m_IsSwapped(isSwapped), m_Header(version == 1 ? 348 : 540, '\0')
  {
    this->Put<std::int32_t>(0, static_cast<std::int32_t>(m_Header.size()));
    this->SetMagic(version == 1 ? std::string("n+1\0", 4) : std::string("n+2\0\r\n\032\n", 8));
    this->SetDimensions({ 3, 2, 3, 4, 1, 1, 1, 1 });
    this->SetPixdim({ 1, 1, 1, 1, 1, 1, 1, 1 });
    this->SetOffset(static_cast<double>(m_Header.size() + 4));
    this->SetSform({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 });
    this->SetCodes(0, 1);
    this->SetVoxels<float>(16);
  }

  void
  SetMagic(const std::string & magic)
  {
    m_Header.replace(m_Version == 1 ? 344 : 4, magic.size(), magic);
  }
  void
  SetDimensions(const std::vector<int> & dim)
  {
    for (std::size_t i = 0; i < dim.size(); ++i)
    {
      m_Version == 1 ? this->Put<std::int16_t>(40 + 2 * i, dim[i]) : this->Put<std::int64_t>(16 + 8 * i, dim[i]);
    }
  }
  void
  SetPixdim(const std::vector<double> & pixdim)
  {
    this->PutReals(76, 104, pixdim);
  }
  void
  SetOffset(double offset)
  {
    m_Version == 1 ? this->Put<float>(108, offset) : this->Put<std::int64_t>(168, offset);
  }
  void
  SetScale(double slope, double intercept)
  {
    this->PutReals(112, 176, { slope, intercept });
  }
  void
  SetUnits(int units)
  {
    m_Version == 1 ? this->Put<char>(123, units) : this->Put<std::int32_t>(500, units);
  }
  void
  SetCodes(int qform, int sform)
  {
    m_Version == 1 ? this->Put<std::int16_t>(252, qform) : this->Put<std::int32_t>(344, qform);
    m_Version == 1 ? this->Put<std::int16_t>(254, sform) : this->Put<std::int32_t>(348, sform);
  }
  /** quatern_b, c, d and qoffset_x, y, z. */
  void
  SetQform(const std::vector<double> & values)
  {
    this->PutReals(256, 352, values);
  }
  /** srow_x, srow_y, srow_z. */
  void
  SetSform(const std::vector<double> & values)
  {
    this->PutReals(280, 400, values);
  }
  /** The numbers 0 to 23 as values of a voxel type. */
  template <typename TVoxel>
  void
  SetVoxels(int datatype)
  {
    m_Version == 1 ? this->Put<std::int16_t>(70, datatype) : this->Put<std::int16_t>(12, datatype);
    m_Version == 1 ? this->Put<std::int16_t>(72, 8 * sizeof(TVoxel)) : this->Put<std::int16_t>(14, 8 * sizeof(TVoxel));
    voxels.clear();
    for (int i = 0; i < 24; ++i)
    {
      voxels += this->BytesOf(static_cast<TVoxel>(i));
    }
  }

  /** A single file with voxels at `offset` and zeros before them. */
  std::string
  Single(std::size_t offset = 0) const
  {
    const std::size_t begin = offset ? offset : m_Header.size() + 4;
    return m_Header + std::string(begin - m_Header.size(), '\0') + voxels;
  }
  /** The header of a pair; its voxels start at 0. */
  std::string
  HeaderOfPair() const
  {
    NiftiFile pair = *this;
    pair.SetMagic("ni");
    pair.SetOffset(0);
    return pair.m_Header;
  }
  const std::string &
  Header() const
  {
    return m_Header;
  }

  std::string voxels;

private:
  template <typename TNumber>
  std::string
  BytesOf(TNumber number) const
  {
    std::string bytes(sizeof(number), '\0');
    std::memcpy(&bytes[0], &number, sizeof(number));
    if (m_IsSwapped)
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
  }
  template <typename TNumber>
  void
  Put(std::size_t offset, double value)
  {
    m_Header.replace(offset, sizeof(TNumber), this->BytesOf(static_cast<TNumber>(value)));
  }
  void
  PutReals(std::size_t offset1, std::size_t offset2, const std::vector<double> & values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      m_Version == 1 ? this->Put<float>(offset1 + 4 * i, values[i]) : this->Put<double>(offset2 + 8 * i, values[i]);
    }
  }

  int         m_Version;
  bool        m_IsSwapped;
  std::string m_Header;
};

/** Writes a file, or compresses it if a mode of gzopen() is given. */
inline void
WriteBytes(const std::string & path, const std::string & bytes, const char * compresses = nullptr)
{
  if (!compresses)
  {
    std::ofstream(path, std::ios::binary) << bytes;
    return;
  }
  const gzFile file = gzopen(path.c_str(), compresses);
  gzwrite(file, bytes.data(), static_cast<unsigned int>(bytes.size()));
  gzclose(file);
}
} // namespace niftitest

#endif
