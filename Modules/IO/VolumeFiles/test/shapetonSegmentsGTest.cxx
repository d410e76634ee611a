#include "shapetonFileBytes.h"
#include "shapetonSegments.h"
#include "shapetonTestImages.h"
#include "shapetonTestFolder.h"
#include "shapetonVolumeReader.h"

#include <gtest/gtest.h>

TEST(Segments, AreEntriesOfTheHeaderThat3DSlicerReads)
{
  const auto labels = basetest::NewImage<itk::Image<unsigned char, 3>>({ { 4, 3, 2 } });
  labels->FillBuffer(0);
  labels->GetBufferPointer()[5] = 7;
  const std::vector<shapeton::Segment> segments{ { 2, "object 2", { 1.0, 0.5, 0.0 } },
                                                 { 7, "class 7: heat 0.1 to 0.2", { 0.0, 1.0 / 3.0, 1.0 } } };
  const basetest::Folder               folder;
  const std::string                    path = folder / "labels.seg.nrrd";
  shapeton::WriteVolume<unsigned char>(labels, path, shapeton::SegmentMetadata(labels, segments));
  const std::string file = shapeton::ReadFileBytes(path);
  for (const char * const entry : { "Segment0_ID:=Segment_2\n",
                                    "Segment0_Name:=object 2\n",
                                    "Segment0_Color:=1 0.5 0\n",
                                    "Segment0_LabelValue:=2\n",
                                    "Segment0_Layer:=0\n",
                                    "Segment0_Extent:=0 3 0 2 0 1\n",
                                    "Segment0_Tags:=TerminologyEntry:Segmentation category and type",
                                    "Segment1_ID:=Segment_7\n",
                                    "Segment1_Name:=class 7: heat 0.1 to 0.2\n",
                                    "Segment1_Color:=0 0.333333 1\n",
                                    "Segmentation_MasterRepresentation:=Binary labelmap\n" })
  {
    EXPECT_NE(file.find(entry), std::string::npos) << entry;
  }
  EXPECT_EQ(shapeton::ReadVolume(path).image->GetBufferPointer()[5], 7.0F) << "it is still a volume";

  const auto read = shapeton::SegmentsOfFile(path);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].label, 7U);
  EXPECT_EQ(read[1].name, "class 7: heat 0.1 to 0.2");
  EXPECT_EQ(read[0].color, (std::array<double, 3>{ 1.0, 0.5, 0.0 }));
  auto named = read;
  named[0].tags = "TerminologyEntry:mine|";
  named[0].name = "left\\new"; // escaped in the file
  shapeton::WriteVolume<unsigned char>(labels, path, shapeton::SegmentMetadata(labels, named));
  EXPECT_EQ(shapeton::SegmentsOfFile(path)[0].tags, "TerminologyEntry:mine|");
  EXPECT_EQ(shapeton::SegmentsOfFile(path)[0].name, "left\\new");
  EXPECT_EQ(shapeton::SegmentsOfFile(path)[1].tags, read[1].tags);
}
