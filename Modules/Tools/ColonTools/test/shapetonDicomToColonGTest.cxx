#include "shapetonDicomToColon.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;

DicomSegmentInFile
Segment(int number, const std::string & name, const std::string & code)
{
  DicomSegmentInFile segment;
  segment.number = number;
  segment.name = name;
  segment.type = { code, "SCT", name };
  return segment;
}

DicomSegmentationFile
FileOf(std::vector<DicomSegmentInFile> segments)
{
  DicomSegmentationFile file;
  file.path = "seg.dcm";
  file.segments = std::move(segments);
  return file;
}
} // namespace

TEST(DicomToColon, LumenIsGasAndFluidByTheirCodes)
{
  const auto file =
    FileOf({ Segment(1, "polyp", "52988006"), Segment(2, "air", "74947009"), Segment(5, "tagged", "442170005") });
  EXPECT_EQ(LumenSegmentsOf(file), (std::vector<int>{ 2, 5 }));
  EXPECT_EQ(AllSegmentsOf(file), (std::vector<int>{ 1, 2, 5 }));
}

TEST(DicomToColon, TheOnlySegmentIsTheLumenWhateverItIsCalled)
{
  EXPECT_EQ(LumenSegmentsOf(FileOf({ Segment(3, "Segment_1", "85756007") })), (std::vector<int>{ 3 }));
}

TEST(DicomToColon, WhatMayBeTheLumenIsAsked)
{
  EXPECT_EQ(basetest::ErrorOf([] {
              LumenSegmentsOf(FileOf({ Segment(1, "a", "1"), Segment(2, "b", "2") }));
            }),
            "\"seg.dcm\" has no gas segment; select segments with the parameter \"segments\" of 1 (a), 2 (b)");
}

TEST(DicomToColon, TableCountsMilliliters)
{
  DicomSegmentVoxels voxels;
  voxels.labels = DicomLabelImage::New();
  const double spacing[3] = { 0.5, 1.0, 4.0 };
  voxels.labels->SetSpacing(spacing);
  voxels.voxels = { 500, 7 };
  const auto table = TableOfSegments(FileOf({ Segment(1, "air", "74947009"), Segment(2, "b", "2") }), { 1, 2 }, voxels);
  EXPECT_EQ(table.GetRows()[0], (std::vector<std::string>{ "1", "air", "74947009", "SCT", "air", "500", "1" }));
}

TEST(DicomToColon, PointsAreNamedByTheirMeasurements)
{
  DicomReportPoints points;
  points.name = "lesion 4";
  points.places.resize(2);
  points.places[1][2] = 7.5;
  Remarks    remarks;
  const auto markups = MarkupsOfReport({ points }, remarks);
  ASSERT_EQ(markups.size(), 1u);
  EXPECT_EQ(markups[0].labels, (std::vector<std::string>{ "lesion 4", "lesion 4" }));
  EXPECT_TRUE(remarks.empty());
  EXPECT_EQ(markups[0].points[1], Eigen::Vector3d(0.0, 0.0, 7.5));
}

TEST(DicomToColon, VerticesAndCentersAreMarkedAsSuch)
{
  DicomReportPoints line;
  line.name = "ruler";
  line.type = "POLYLINE";
  line.places.resize(2);
  DicomReportPoints circle;
  circle.name = "region";
  circle.type = "CIRCLE";
  circle.places.resize(1);
  Remarks remarks;
  EXPECT_EQ(MarkupsOfReport({ line, circle }, remarks)[0].labels,
            (std::vector<std::string>{ "ruler (vertex 1)", "ruler (vertex 2)", "region (center)" }));
  EXPECT_EQ(remarks,
            (Remarks{ "of 3 markers, 2 are vertices of lines or polygons and 1 are centers of circles or ellipses; "
                      "their labels say so" }));
}
