#include "shapetonFlatCoordinateMap.h"

#include "shapetonCsvTable.h"
#include "shapetonParallelFor.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"

#include "itkImageFileWriter.h"
#include "itkMetaDataObject.h"
#include "itkNrrdImageIO.h"

#include <cerrno>
#include <filesystem>

namespace shapeton
{
namespace
{
itk::MetaDataDictionary
HeaderOf(const FlatColonGrid & grid, const VolumeMetadata & metadata)
{
  VolumeMetadata entries{ { "Shapeton.vectors", "LPS mm of the wall under the middle of each pixel" },
                          { "Shapeton.pixelSize", CsvTable::Number(grid.PixelSize()) },
                          { "Shapeton.circumference", CsvTable::Number(grid.Circumference()) },
                          { "Shapeton.length", CsvTable::Number(grid.Length()) } };
  entries.insert(entries.end(), metadata.begin(), metadata.end());
  itk::MetaDataDictionary dictionary;
  for (const auto & entry : entries)
  {
    itk::EncapsulateMetaData<std::string>(dictionary, entry.first, entry.second);
  }
  return dictionary;
}
} // namespace

void
SetFlatSpace(const FlatColonGrid & grid, itk::ImageBase<2> * picture)
{
  itk::ImageBase<2>::SizeType size;
  size[0] = grid.Columns();
  size[1] = grid.Rows();
  picture->SetRegions(itk::ImageBase<2>::RegionType(size));
  itk::ImageBase<2>::SpacingType spacing;
  spacing.Fill(grid.PixelSize());
  picture->SetSpacing(spacing);
  const Eigen::Vector2d        first = grid.UvOfPixel(0, 0);
  itk::ImageBase<2>::PointType origin;
  origin[0] = first.x();
  origin[1] = first.y();
  picture->SetOrigin(origin);
  itk::ImageBase<2>::DirectionType direction;
  direction.SetIdentity();
  direction[1][1] = grid.IsMirrored() ? -1.0 : 1.0;
  picture->SetDirection(direction);
}

FlatCoordinateMap::Pointer
MakeFlatCoordinateMap(const FlatColonGrid & grid)
{
  const auto map = FlatCoordinateMap::New();
  SetFlatSpace(grid, map);
  map->Allocate();
  ParallelFor(grid.Rows(), [&](std::size_t row) {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const Eigen::Vector3d point = grid.PointOfPixel(column, static_cast<int>(row));
      auto * const          pixel = map->GetBufferPointer() + row * grid.Columns() + column;
      for (int k = 0; k < 3; ++k)
      {
        (*pixel)[k] = static_cast<float>(point[k]);
      }
    }
  });
  return map;
}

const std::string &
RequireCoordinateMapName(const std::string & path)
{
  const std::string extension = ".nrrd";
  const bool        fits =
    path.size() > extension.size() && path.compare(path.size() - extension.size(), std::string::npos, extension) == 0;
  RequireParameter(path.empty() || fits, path + ": a coordinate map must be written as .nrrd");
  return path;
}

void
WriteFlatCoordinateMap(const FlatColonGrid & grid, const std::string & path, const VolumeMetadata & metadata)
{
  RequireCoordinateMapName(path);
  const auto map = MakeFlatCoordinateMap(grid);
  map->SetMetaDataDictionary(HeaderOf(grid, metadata));
  const auto writer = itk::ImageFileWriter<FlatCoordinateMap>::New();
  writer->SetInput(map);
  writer->SetFileName(path);
  writer->SetImageIO(itk::NrrdImageIO::New());
  writer->SetUseCompression(false);
  try
  {
    errno = 0;
    writer->Update();
  }
  catch (const itk::ExceptionObject & failure)
  {
    ThrowCannotWrite(path, errno, failure.GetDescription());
  }
  const double bytes = 3.0 * sizeof(float) * grid.Columns() * grid.Rows();
  if (!(std::filesystem::file_size(path) > bytes))
  {
    throw OutputError(path + ": the file is too short; is the disk full?");
  }
}
} // namespace shapeton
