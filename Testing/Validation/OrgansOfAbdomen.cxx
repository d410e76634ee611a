#include "Overlaps.h"
#include "Tables.h"
#include "ValidationReport.h"
#include "ValidationVolumes.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"
#include "shapetonImageGrid.h"

using namespace shapeton;

void
ValidateOrgansOfAbdomen(const ValidationSettings & settings, ValidationReport & report)
{
  const auto [ct, organs] = ReadAbdomen(settings.dataFolder);
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
    const Overlaps      overlaps = OverlapsOf(organs.image->GetBufferPointer(),
                                         classification.labels->GetBufferPointer(),
                                         organs.image->GetLargestPossibleRegion().GetNumberOfPixels());
    for (const auto & [organ, fit] : BestFits(overlaps))
    {
      if (organ != 0 && fit.members >= 200.0)
      {
        dice.push_back(fit.dice);
        table.AddRow(Cells() << organ << static_cast<std::uint64_t>(fit.members) << fit.part << Rounded(fit.dice, 2));
      }
    }
    report.AddRows("organs", table);
    report.AddText("Mean Dice over " + std::to_string(dice.size()) + " organs: " + MeanWithInterval(dice) + ".");
  }
  report.AddText("Heat classes do not segment organs: heat flows across soft edges of a few HU, so many organs share a "
                 "class. The classes separate air with lung and gas, fat, the soft-tissue body as a whole, and dense "
                 "bone. The dissertation itself calls the result a weak segmentation (2.5).");
}
