#include "ValidationReport.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"
#include "shapetonSameGrid.h"
#include "shapetonVolumeReader.h"

#include <map>
#include <stdexcept>

using namespace shapeton;

namespace
{
/** Class with the greatest Dice overlap for each organ. */
struct Overlap
{
  double        dice{ 0.0 };
  unsigned int  label{ 0 };
  std::uint64_t voxels{ 0 };
};

std::map<int, Overlap>
CompareOrgans(const itk::Image<float, 3> * organs, const itk::Image<unsigned char, 3> * labels)
{
  std::map<int, std::map<int, double>> shared;
  std::map<int, double>                organSizes, classSizes;
  const std::size_t                    voxels = organs->GetLargestPossibleRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const int organ = static_cast<int>(organs->GetBufferPointer()[i]);
    const int label = labels->GetBufferPointer()[i];
    shared[organ][label] += 1.0;
    organSizes[organ] += 1.0;
    classSizes[label] += 1.0;
  }
  std::map<int, Overlap> overlaps;
  for (const auto & organ : shared)
  {
    Overlap & overlap = overlaps[organ.first];
    overlap.voxels = static_cast<std::uint64_t>(organSizes[organ.first]);
    for (const auto & count : organ.second)
    {
      const double dice = 2.0 * count.second / (organSizes[organ.first] + classSizes[count.first]);
      if (dice > overlap.dice)
      {
        overlap.dice = dice;
        overlap.label = static_cast<unsigned int>(count.first);
      }
    }
  }
  overlaps.erase(0);
  return overlaps;
}
} // namespace

void
ValidateOrgansOfAbdomen(const ValidationSettings & settings, ValidationReport & report)
{
  const std::string folder = settings.dataFolder + "/ct/totalsegmentator";
  const Volume      ct = ReadVolume(folder + "/example_ct.nii.gz");
  const Volume      organs = ReadVolume(folder + "/example_seg_fast_force_split.nii.gz");
  if (!HaveSameGrid(ct.image, organs.image))
  {
    throw std::runtime_error("the organ labels have another grid than the CT");
  }
  report.AddText("Abdomen CT of TotalSegmentator's tests (122 x 101 x 112 voxels of 3 mm, Apache-2.0) with its organ "
                 "labels. Window -160 to 240 HU, p = 7. Dice: overlap of each organ with its best heat class.");
  for (const std::uint64_t steps :
       settings.quick ? std::vector<std::uint64_t>{ 1000 } : std::vector<std::uint64_t>{ 100, 1000, 100000 })
  {
    auto filter = CumulativeHeatDiffusionImageFilter<Volume::ImageType>::New();
    filter->SetInput(ct.image);
    filter->SetIntensityWindow(-160.0, 240.0);
    filter->SetTimeSteps(steps);
    filter->Update();
    const auto classification = ClassifyHeat(filter->GetOutput());
    report.AddText("## After " + std::to_string(steps) +
                   " steps: " + std::to_string(classification.classes.size() - 1) + " classes");
    CsvTable            table({ "organ label", "voxels", "best class", "Dice" });
    std::vector<double> dice;
    for (const auto & organ : CompareOrgans(organs.image, classification.labels))
    {
      if (organ.second.voxels >= 200)
      {
        dice.push_back(organ.second.dice);
        table.AddRow({ std::to_string(organ.first),
                       std::to_string(organ.second.voxels),
                       std::to_string(organ.second.label),
                       CsvTable::Rounded(organ.second.dice, 2) });
      }
    }
    report.AddRows("organs", table);
    report.AddText("Mean Dice over " + std::to_string(dice.size()) + " organs: " + MeanWithInterval(dice) + ".");
  }
  report.AddText("Heat classes do not segment organs: heat flows across soft edges of a few HU, so many organs share a "
                 "class. The classes separate air with lung and gas, fat, the soft-tissue body as a whole, and dense "
                 "bone. The dissertation itself calls the result a weak segmentation (2.5).");
}
