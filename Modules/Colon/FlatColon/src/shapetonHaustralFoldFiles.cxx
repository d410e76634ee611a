#include "shapetonHaustralFoldFiles.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonReadImage.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkMetaDataObject.h"
#include "itkNrrdImageIO.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>

namespace shapeton
{
namespace
{
using LabelImage = itk::Image<unsigned short, 2>;

/** Number of feature points per fold: the center and two ends. */
constexpr int pointsOfFold = 3;

/** Colors (red, green, blue; 0 to 1) of centers and ends. */
constexpr std::array<double, 3> blue{ 0.2, 0.5, 1.0 };
constexpr std::array<double, 3> green{ 0.2, 0.9, 0.3 };

/** A feature point of a fold: center (0) or end (1, 2). */
struct Feature
{
  Feature(const HaustralFold & fold, int kind)
    : point(kind == 0 ? fold.center : fold.ends[kind - 1])
    , uv(kind == 0 ? fold.centerUv : fold.endUv[kind - 1])
    , reliability(kind == 0 ? fold.reliability : fold.endReliability[kind - 1])
  {}

  Eigen::Vector3d point;
  Eigen::Vector2d uv;
  double          reliability;
};

SurfaceArray
CellArray(const std::string & name, std::size_t rows, int columns, bool areIntegers)
{
  SurfaceArray array;
  array.name = name;
  array.values.setZero(static_cast<Eigen::Index>(rows), columns);
  array.areIntegers = areIntegers;
  return array;
}

bool
AreArcLengthsKnown(const HaustralFolds & folds)
{
  return std::all_of(
    folds.folds.begin(), folds.folds.end(), [](const HaustralFold & fold) { return std::isfinite(fold.arcLength); });
}

/** The fold at a position of the map; v is taken modulo the circumference. */
unsigned short
LabelAt(const LabelImage & labels, const Eigen::Vector2d & uv)
{
  const auto size = labels.GetLargestPossibleRegion().GetSize();
  const auto place = labels.TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 2>(uv.data()));
  const auto rows = static_cast<long>(size[1]);
  const long column = std::clamp(std::lround(place[0]), 0L, static_cast<long>(size[0]) - 1);
  const long row = std::lround(place[1]) % rows;
  return labels.GetPixel({ { column, row < 0 ? row + rows : row } });
}
} // namespace

CurveSet
FeaturesOfFolds(const HaustralFolds & folds)
{
  const std::size_t rows = pointsOfFold * folds.folds.size();
  CurveSet          features;
  features.V.resize(static_cast<Eigen::Index>(rows), 3);
  features.cellArrays = { CellArray("fold", rows, 1, true),
                          CellArray("kind", rows, 1, true),
                          CellArray("reliability", rows, 1, false),
                          CellArray("uv", rows, 2, false) };
  const bool hasArcLength = AreArcLengthsKnown(folds);
  if (hasArcLength)
  {
    features.cellArrays.push_back(CellArray("arcLength", rows, 1, false));
  }
  int row = 0;
  for (const HaustralFold & fold : folds.folds)
  {
    for (int kind = 0; kind < pointsOfFold; ++kind, ++row)
    {
      const Feature feature(fold, kind);
      features.V.row(row) = feature.point;
      features.curves.push_back({ row });
      features.cellArrays[0].values(row, 0) = fold.label;
      features.cellArrays[1].values(row, 0) = kind;
      features.cellArrays[2].values(row, 0) = feature.reliability;
      features.cellArrays[3].values.row(row) = feature.uv;
      if (hasArcLength)
      {
        features.cellArrays[4].values(row, 0) = fold.arcLength;
      }
    }
  }
  return features;
}

void
WriteFoldFeatures(const HaustralFolds &                                    folds,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path)
{
  CurveSet features = FeaturesOfFolds(folds);
  features.facts = facts;
  WriteCurves(features, path);
}

std::vector<Markup>
MarkupsOfFolds(const HaustralFolds & folds)
{
  Markup centers;
  centers.name = "Fold centers";
  centers.color = blue;
  Markup ends;
  ends.name = "Fold ends";
  ends.color = green;
  for (const HaustralFold & fold : folds.folds)
  {
    for (int kind = 0; kind < pointsOfFold; ++kind)
    {
      const Feature feature(fold, kind);
      Markup &      markup = kind == 0 ? centers : ends;
      markup.points.push_back(feature.point);
      markup.labels.push_back(std::to_string(fold.label) + (kind == 0 ? "" : kind == 1 ? "a" : "b"));
      markup.descriptions.push_back("reliability " + CsvTable::Rounded(feature.reliability, 2));
    }
  }
  return folds.folds.empty() ? std::vector<Markup>{} : std::vector<Markup>{ centers, ends };
}

std::vector<LabelColor>
ColorsOfFolds(const HaustralFolds & folds)
{
  std::vector<LabelColor> colors;
  for (const HaustralFold & fold : folds.folds)
  {
    colors.push_back({ fold.label, "fold " + std::to_string(fold.label), ColorOfLabel(fold.label) });
  }
  return colors;
}

const std::string &
RequireFoldLabelsName(const std::string & path)
{
  const std::string extension = ".nrrd";
  const bool        fits =
    path.size() > extension.size() && path.compare(path.size() - extension.size(), std::string::npos, extension) == 0;
  RequireParameter(path.empty() || fits, path + ": fold labels must be written as .nrrd");
  return path;
}

void
WriteFoldLabels(const HaustralFolds &  folds,
                const FlatColonGrid &  grid,
                const std::string &    path,
                const VolumeMetadata & metadata)
{
  RequireFoldLabelsName(path);
  VolumeMetadata entries{ { "Shapeton.labels", "haustral folds on the flat colon; 0 is wall" },
                          { "Shapeton.pixelSize", CsvTable::Number(grid.PixelSize()) },
                          { "Shapeton.circumference", CsvTable::Number(grid.Circumference()) },
                          { "Shapeton.length", CsvTable::Number(grid.Length()) } };
  entries.insert(entries.end(), metadata.begin(), metadata.end());
  itk::MetaDataDictionary dictionary;
  for (const auto & entry : entries)
  {
    itk::EncapsulateMetaData<std::string>(dictionary, entry.first, entry.second);
  }
  folds.labels->SetMetaDataDictionary(dictionary);
  const auto writer = itk::ImageFileWriter<LabelImage>::New();
  writer->SetInput(folds.labels);
  writer->SetFileName(path);
  writer->SetImageIO(itk::NrrdImageIO::New());
  writer->SetUseCompression(true);
  const auto reader = itk::ImageFileReader<LabelImage>::New();
  reader->SetFileName(path);
  reader->SetImageIO(itk::NrrdImageIO::New());
  try
  {
    errno = 0;
    writer->Update();
    reader->Update(); // detects a full disk
  }
  catch (const itk::ExceptionObject & failure)
  {
    ThrowCannotWrite(path, errno, failure.GetDescription());
  }
}

itk::Image<unsigned short, 2>::Pointer
ReadFoldLabels(const std::string & path)
{
  return ReadImage<LabelImage>(path, itk::NrrdImageIO::New(), "remove it and run VirtualColonoscopy again");
}

std::vector<unsigned short>
FoldsOfFaces(const SurfaceMesh & flat, const LabelImage & labels)
{
  const SurfaceArray * const uv = FindSurfaceArray(flat.pointArrays, "uv");
  if (uv == nullptr)
  {
    throw InputError("the flat surface lacks the array uv; run ColonFlattening again");
  }
  std::vector<unsigned short> folds;
  for (Eigen::Index face = 0; face < flat.F.rows(); ++face)
  {
    const auto            corners = flat.F.row(face);
    const Eigen::Vector2d middle =
      (uv->values.row(corners[0]) + uv->values.row(corners[1]) + uv->values.row(corners[2])).transpose() / 3.0;
    folds.push_back(LabelAt(labels, middle));
  }
  return folds;
}
} // namespace shapeton
