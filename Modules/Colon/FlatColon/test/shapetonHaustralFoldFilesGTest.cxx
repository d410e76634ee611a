#include "shapetonHaustralFoldFiles.h"

#include "shapetonFoldTubes.h"
#include "shapetonTestErrors.h"

#include "itkImageFileReader.h"
#include "itkNrrdImageIO.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
using foldtubes::MakeTube;

const shapeton::FlatColon &
Flat()
{
  static const shapeton::FlatColon flat(MakeTube({ { 40.0, 2.0, 18.0, 6.0 }, { 100.0, 4.0, 20.0, 8.0 } }));
  return flat;
}

std::string
Temporary(const std::string & name)
{
  const std::string folder = std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/HaustralFoldFiles";
  std::filesystem::create_directories(folder);
  return folder + '/' + name;
}
} // namespace

TEST(HaustralFoldFiles, FeaturesAreThreePointsOfEachFold)
{
  const shapeton::HaustralFolds folds = shapeton::FindHaustralFolds(Flat());
  ASSERT_EQ(folds.folds.size(), 2u);
  const std::string path = Temporary("features.vtp");
  shapeton::WriteFoldFeatures(folds, {}, path);
  const shapeton::CurveSet features = shapeton::ReadCurves(path);
  ASSERT_EQ(features.curves.size(), 6u);
  for (int row = 0; row < 6; ++row)
  {
    const shapeton::HaustralFold & fold = folds.folds[row / 3];
    const int                      kind = row % 3;
    EXPECT_EQ(shapeton::FindSurfaceArray(features.cellArrays, "fold")->values(row, 0), fold.label);
    EXPECT_EQ(shapeton::FindSurfaceArray(features.cellArrays, "kind")->values(row, 0), kind);
    EXPECT_NEAR(shapeton::FindSurfaceArray(features.cellArrays, "arcLength")->values(row, 0), fold.arcLength, 1e-4);
    EXPECT_NEAR(shapeton::FindSurfaceArray(features.cellArrays, "reliability")->values(row, 0),
                kind == 0 ? fold.reliability : fold.endReliability[kind - 1],
                1e-6);
    const Eigen::Vector3d point = kind == 0 ? fold.center : fold.ends[kind - 1];
    EXPECT_LT((features.V.row(features.curves[row][0]).transpose() - point).norm(), 1e-4);
    const Eigen::Vector2d uv = kind == 0 ? fold.centerUv : fold.endUv[kind - 1];
    EXPECT_LT((shapeton::FindSurfaceArray(features.cellArrays, "uv")->values.row(row).transpose() - uv).norm(), 1e-4);
  }
}

TEST(HaustralFoldFiles, WithoutFoldsThereAreNoPoints)
{
  shapeton::HaustralFolds none;
  const std::string       path = Temporary("none.vtp");
  shapeton::WriteFoldFeatures(none, {}, path);
  EXPECT_GT(std::filesystem::file_size(path), 0u);
  EXPECT_TRUE(shapeton::TableOfFolds(none).GetRows().empty());
  EXPECT_TRUE(shapeton::MarkupsOfFolds(none).empty());
  EXPECT_TRUE(shapeton::ColorsOfFolds(none).empty());
}

TEST(HaustralFoldFiles, TheTableHasARowForEachFold)
{
  shapeton::HaustralFolds folds = shapeton::FindHaustralFolds(Flat());
  folds.folds[1].height = std::numeric_limits<double>::quiet_NaN();
  const shapeton::CsvTable table = shapeton::TableOfFolds(folds);
  ASSERT_EQ(table.GetRows().size(), 2u);
  const auto column = [&](const std::string & name) {
    const auto & columns = table.GetColumns();
    return std::find(columns.begin(), columns.end(), name) - columns.begin();
  };
  EXPECT_EQ(table.GetRows()[0][column("fold")], "1");
  EXPECT_NEAR(std::stod(table.GetRows()[1][column("length")]), folds.folds[1].length, 1e-3);
  EXPECT_NEAR(std::stod(table.GetRows()[1][column("end2Z")]), folds.folds[1].ends[1].z(), 1e-3);
  EXPECT_EQ(table.GetRows()[1][column("height")], ""); // unknown
}

TEST(HaustralFoldFiles, FoldsWhereTheWallIsNotSeenTellWhy)
{
  shapeton::SurfaceMesh  surface = Flat().Surface();
  shapeton::SurfaceArray hindrance{ "notAssessable",
                                    shapeton::SurfaceArray::ValueMatrix::Zero(surface.NumberOfFaces(), 1),
                                    true };
  const auto             plain = shapeton::FindHaustralFolds(Flat()).folds;
  const double           between = 0.5 * (plain[0].center.x() + plain[1].center.x());
  for (int face = 0; face < surface.NumberOfFaces(); ++face)
  {
    hindrance.values(face, 0) = surface.V(surface.F(face, 0), 0) < between ? 4.0 : 0.0;
  }
  surface.cellArrays.push_back(hindrance);
  const auto folds = shapeton::FindHaustralFolds(shapeton::FlatColon(surface)).folds;
  ASSERT_EQ(folds.size(), 2u);
  for (const shapeton::HaustralFold & fold : folds)
  {
    EXPECT_EQ(fold.hindrance,
              fold.center.x() < between ? shapeton::ColonHindrance::Narrow : shapeton::ColonHindrance::None);
  }
}

TEST(HaustralFoldFiles, ATableWithAnUnknownReasonIsRefusedByLine)
{
  const std::string  path = Temporary("unknown.csv");
  shapeton::CsvTable table = shapeton::TableOfFolds(shapeton::FindHaustralFolds(Flat()));
  const auto &       columns = table.GetColumns();
  const auto         column = std::find(columns.begin(), columns.end(), "notAssessable") - columns.begin();
  shapeton::CsvTable wrong(columns);
  auto               row = table.GetRows()[0];
  row[column] = "loud";
  wrong.AddRow(row);
  wrong.Write(path);
  EXPECT_TRUE(basetest::Refuses([&] { shapeton::ReadFoldTable(path); }, "unknown.csv\", line 2: \"loud\""));
}

TEST(HaustralFoldFiles, TheTableReadsBackExactly)
{
  shapeton::HaustralFolds folds = shapeton::FindHaustralFolds(Flat());
  folds.folds[0].arcLength = 0.1 + 0.2; // 17 digits
  folds.folds[1].height = std::numeric_limits<double>::quiet_NaN();
  folds.folds[1].crossesCut = true;
  folds.folds[1].hindrance = shapeton::ColonHindrance::UntaggedFluid;
  folds.folds[1].ends[1] = { -1.0 / 3.0, std::nextafter(1000.0, 2000.0), 1e-300 };
  const std::string path = Temporary("folds.csv");
  shapeton::TableOfFolds(folds).Write(path);
  const std::vector<shapeton::HaustralFold> read = shapeton::ReadFoldTable(path);
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i)
  {
    const shapeton::HaustralFold & a = read[i];
    const shapeton::HaustralFold & b = folds.folds[i];
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.crossesCut, b.crossesCut);
    EXPECT_EQ(a.hindrance, b.hindrance);
    EXPECT_EQ(a.centerUv, b.centerUv);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.endUv, b.endUv);
    EXPECT_EQ(a.ends, b.ends);
    EXPECT_EQ(a.endReliability, b.endReliability);
    for (const auto value : { &shapeton::HaustralFold::length,
                              &shapeton::HaustralFold::area,
                              &shapeton::HaustralFold::elongation,
                              &shapeton::HaustralFold::angle,
                              &shapeton::HaustralFold::meanCurvature,
                              &shapeton::HaustralFold::reliability,
                              &shapeton::HaustralFold::arcLength })
    {
      EXPECT_EQ(a.*value, b.*value);
    }
  }
  EXPECT_EQ(read[0].height, folds.folds[0].height);
  EXPECT_TRUE(std::isnan(read[1].height));
}

TEST(HaustralFoldFiles, MarkupsAndColorsNameTheLabels)
{
  const shapeton::HaustralFolds       folds = shapeton::FindHaustralFolds(Flat());
  const std::vector<shapeton::Markup> markups = shapeton::MarkupsOfFolds(folds);
  ASSERT_EQ(markups.size(), 2u);
  EXPECT_EQ(markups[0].points.size(), 2u);
  EXPECT_EQ(markups[1].points.size(), 4u);
  EXPECT_EQ(markups[1].labels[3], "2b");
  EXPECT_EQ(markups[1].points[3], folds.folds[1].ends[1]);
  const std::vector<shapeton::LabelColor> colors = shapeton::ColorsOfFolds(folds);
  ASSERT_EQ(colors.size(), 2u);
  EXPECT_EQ(colors[1].value, 2);
  EXPECT_EQ(colors[1].name, "fold 2");
}

TEST(HaustralFoldFiles, LabelsAreReadBackWithTheirSpace)
{
  const shapeton::HaustralFolds folds = shapeton::FindHaustralFolds(Flat());
  const std::string             path = Temporary("labels.nrrd");
  shapeton::WriteFoldLabels(folds, Flat().Grid(), path, { { "note", "a test" } });
  const auto reader = itk::ImageFileReader<itk::Image<unsigned short, 2>>::New();
  reader->SetFileName(path);
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetLargestPossibleRegion(), folds.labels->GetLargestPossibleRegion());
  EXPECT_LT((reader->GetOutput()->GetOrigin() - folds.labels->GetOrigin()).GetNorm(), 1e-9);
  EXPECT_TRUE(std::equal(folds.labels->GetBufferPointer(),
                         folds.labels->GetBufferPointer() + folds.labels->GetPixelContainer()->Size(),
                         reader->GetOutput()->GetBufferPointer()));
}

TEST(HaustralFoldFiles, OtherExtensionsAndFoldersAreRefused)
{
  const shapeton::HaustralFolds folds = shapeton::FindHaustralFolds(Flat());
  EXPECT_THROW(shapeton::WriteFoldLabels(folds, Flat().Grid(), "labels.png"), shapeton::ParameterError);
  EXPECT_THROW(shapeton::WriteFoldLabels(folds, Flat().Grid(), "/nowhere/labels.nrrd"), shapeton::OutputError);
}
