// CHD and shapetons on real volumes.
#include "ShapetonComparison.h"

#include "shapetonImageGrid.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeReader.h"

#include "itkRegionOfInterestImageFilter.h"

#include <array>
#include <stdexcept>

using namespace shapeton;

namespace
{
/** Larger volumes are cropped to their object voxels. */
constexpr std::size_t largestVolume = std::size_t{ 1 } << 25;

struct RealCase
{
  std::string                 name;
  std::string                 title;
  std::string                 file;
  std::string                 labels; ///< empty: without labels
  double                      lower;
  double                      upper;
  double                      p;
  double                      distance;
  std::array<unsigned int, 2> axes;   ///< axes of the two displayed planes
  std::array<double, 2>       places; ///< positions in [0, 1] along these axes
  std::string                 sees;
};

/** Crops to the bounding box of the object voxels plus eight voxels on all sides, inside the volume. */
void
CropToObjects(TrialVolume & volume)
{
  const auto whole = volume.image->GetLargestPossibleRegion();
  const auto size = whole.GetSize();
  auto       lowest = whole.GetUpperIndex(), highest = whole.GetIndex();
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (volume.IsObject(i))
    {
      const std::array<std::size_t, 3> at{ i % size[0], i / size[0] % size[1], i / size[0] / size[1] };
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        lowest[axis] = std::min<itk::IndexValueType>(lowest[axis], at[axis]);
        highest[axis] = std::max<itk::IndexValueType>(highest[axis], at[axis]);
      }
    }
  }
  itk::ImageRegion<3> box;
  box.SetIndex(lowest);
  box.SetUpperIndex(highest);
  box.PadByRadius(8);
  box.Crop(whole);
  auto crop = itk::RegionOfInterestImageFilter<itk::Image<float, 3>, itk::Image<float, 3>>::New();
  crop->SetInput(volume.image);
  crop->SetRegionOfInterest(box);
  crop->Update();
  volume.image = crop->GetOutput();
}

TrialVolume
LoadTrialVolume(const Comparison & comparison, const RealCase & real)
{
  const std::string & folder = comparison.settings.dataFolder;
  TrialVolume         volume{ real.name, ReadVolume(folder + '/' + real.file).image, nullptr, real.lower, real.upper };
  if (volume.GetNumberOfVoxels() > largestVolume)
  {
    CropToObjects(volume);
  }
  if (!real.labels.empty())
  {
    const auto labels = ReadVolume(folder + '/' + real.labels).image;
    if (!HaveSameGrid(labels, volume.image))
    {
      throw std::runtime_error(real.labels + " has another grid than " + real.file);
    }
    volume.labels =
      MapVoxels<unsigned char>(labels.GetPointer(), [](float label) { return static_cast<unsigned char>(label); });
  }
  return volume;
}

void
ShowReal(const Comparison &         comparison,
         const RealCase &           real,
         const TrialVolume &        volume,
         const std::vector<Trial> & trials)
{
  const auto   size = volume.image->GetLargestPossibleRegion().GetSize();
  PictureSheet sheet(real.title + ", p = " + CsvTable::Number(real.p) + ", distance " +
                       CsvTable::Number(real.distance) + ", seed 1",
                     { 2, trials.size() + 1, 180, 180 });
  const auto   plane = [&](const itk::Image<unsigned char, 3> * levels, std::size_t row) {
    const unsigned int axis = real.axes[row];
    return DrawPlane(volume, levels, axis, static_cast<std::size_t>(real.places[row] * size[axis]), 180, 180);
  };
  for (std::size_t row = 0; row < 2; ++row)
  {
    sheet.Put(row, 0, "input", plane(nullptr, row));
  }
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    const auto levels = LevelsOf(volume, trials[i]);
    for (std::size_t row = 0; row < 2; ++row)
    {
      sheet.Put(row, i + 1, CaptionOf(trials[i]), plane(levels, row));
    }
  }
  comparison.Show(sheet, real.name);
}

void
CompareReal(const Comparison & comparison, const RealCase & real)
{
  const TrialVolume  volume = LoadTrialVolume(comparison, real);
  const auto         size = volume.image->GetLargestPossibleRegion().GetSize();
  const auto         published = comparison.Walk(65000, real.distance, 2500);
  const auto         controlled = comparison.Walk(400000, real.distance, 500);
  std::vector<Trial> trials;
  trials.push_back(RunHeat(volume, real.p, MatchedHeatSteps(volume, controlled)));
  trials.push_back(RunShapetons(volume, real.p, publishedWalk, published));
  trials.push_back(RunShapetons(volume, real.p, controlledWalk, controlled));
  const Trial final = RunHeat(volume, real.p, 100000);
  comparison.report.AddText("## " + real.title + "\n\n" + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
                            " x " + std::to_string(size[2]) + " voxels, window " + CsvTable::Number(real.lower) +
                            " to " + CsvTable::Number(real.upper) + ", p = " + CsvTable::Number(real.p) +
                            ", distance " + CsvTable::Number(real.distance) + ", seed 1.");
  CsvTable                 table(Columns(columnsOfTrials +
                         " | rank correlation with the first row, voxels | the same, blocks of 4^3 voxels | rank "
                                         "correlation of organ means | variance between organs | adjusted Rand index"));
  std::vector<std::string> trapped, ranks;
  for (const Trial * trial : std::array<const Trial *, 4>{ &trials[0], &final, &trials[1], &trials[2] })
  {
    const auto own = CellsOf(volume, *trial);
    ranks.push_back(Hundredths(RankCorrelationOfFields(volume, trials[0].field, trial->field, 1)));
    trapped.push_back(own[4]);
    Cells cells;
    cells << own << ranks.back() << Hundredths(RankCorrelationOfFields(volume, trials[0].field, trial->field, 4));
    if (volume.labels)
    {
      const double organs =
        RankCorrelation(Values(MeansOfObjects(volume, trials[0].field)), Values(MeansOfObjects(volume, trial->field)));
      cells << Hundredths(organs) << Percent(VarianceBetweenObjects(volume, trial->field))
            << Hundredths(CompareClasses(volume, *trial).adjustedRand);
    }
    else
    {
      cells << std::vector<std::string>(3);
    }
    table.AddRow(cells);
  }
  comparison.report.AddRows("volumes", table);
  comparison.report.AddText("Published and controlled walk: " + trapped[2] + " and " + trapped[3] +
                            " of the shapetons are trapped; the rank correlation with CHD is " + ranks[2] + " and " +
                            ranks[3] + ".");
  ShowReal(comparison, real, volume, trials);
  comparison.report.AddText(real.sees);
}

const std::vector<RealCase> realCases = {
  { "head",
    "MR head (ch2)",
    "volumes/ch2.nii.gz",
    "",
    20.0,
    200.0,
    15.0,
    0.01,
    { { 2, 0 } },
    { { 0.5, 0.5 } },
    "CHD shows nested shells: scalp, skull, and the brain from its convoluted rim to its core, with the walls of the "
    "ventricles. The published walk separates the smooth inside of the brain from all regions with edges. The "
    "controlled walk shows the same as CHD, with noise." },
  { "abdomen",
    "Abdomen CT (TotalSegmentator)",
    "ct/totalsegmentator/example_ct.nii.gz",
    "ct/totalsegmentator/example_seg_fast_force_split.nii.gz",
    -160.0,
    240.0,
    8.0,
    0.01,
    { { 2, 1 } },
    { { 0.5, 0.5 } },
    "CHD shows hot bones and a warm body that cools towards its border. The published walk shows homogeneous tissue: "
    "visits accumulate in fat, muscle and bladder, and are rare in bones, bowel and other regions with many edges. The "
    "controlled walk shows bones and bowel walls. None of them segments organs." },
  { "ankle",
    "CT of the feet (Visible Human Female, cropped)",
    "ct/visible-female-ankle",
    "",
    -200.0,
    1000.0,
    9.0,
    0.01,
    { { 2, 1 } },
    { { 0.5, 0.5 } },
    "CHD shows hot bones, hottest where they are small, in warm feet. Half of the published shapetons are trapped in "
    "spongy bone, whose voxels are closed on all sides, and leave other voxels there unvisited (black). The others "
    "accumulate in the smooth heel. The controlled walk shows the bones, with noise." },
  { "bonsai",
    "Bonsai",
    "volumes/bonsai.nii.gz",
    "",
    20.0,
    255.0,
    8.5,
    0.01,
    { { 1, 0 } },
    { { 0.5, 0.5 } },
    "CHD and the controlled walk show the earth in the pot as hot, then the trunk. The leaves are coolest, because "
    "they leak into the air. In the published walk, trunk and leaves are slightly above the rough earth. None "
    "separates leaves from twigs." },
};
} // namespace

void
CompareRealVolumes(const Comparison & comparison)
{
  for (const RealCase & real : realCases)
  {
    CompareReal(comparison, real);
  }
}

void
CompareEngineByP(const Comparison & comparison)
{
  const std::vector<double> steepness{ 4.0, 9.0, 15.0, 20.0 };
  const TrialVolume         volume{
    "engine", ReadVolume(comparison.settings.dataFolder + "/volumes/engine.nii.gz").image, nullptr, 0.0, 255.0
  };
  comparison.report.AddText("## Figure 3.8: p on the engine\n\n256 x 256 x 128 voxels, distance 0.05, 1,300 steps, "
                            "65,000 shapetons, published rule, seed 1; CHD 52,000 steps (Table 3.2).");
  CsvTable     table(Columns("p | CHD, seconds | shapetons, seconds | coverage | trapped | rank correlation with CHD, "
                             "voxels | rank correlation, blocks of 4^3 voxels"));
  PictureSheet sheet("Figure 3.8: engine, distance 0.05, 65,000 shapetons, seed 1", { 2, 4, 160, 134 });
  for (std::size_t i = 0; i < steepness.size(); ++i)
  {
    const Trial heat = RunHeat(volume, steepness[i], comparison.settings.quick ? 1000 : 52000);
    const Trial walk = RunShapetons(volume, steepness[i], publishedWalk, comparison.Walk(65000, 0.05, 1300));
    table.AddRow(Cells() << steepness[i] << Rounded(heat.seconds, 2) << Rounded(walk.seconds, 2)
                         << Percent(walk.measures.GetCoverage()) << Percent(walk.measures.trappedShapetons / 65000.0)
                         << Hundredths(RankCorrelationOfFields(volume, heat.field, walk.field, 1))
                         << Hundredths(RankCorrelationOfFields(volume, heat.field, walk.field, 4)));
    const std::string caption = ", p = " + CsvTable::Number(steepness[i]) + ", ";
    sheet.Put(0, i, "CHD" + caption + "52,000 steps", RenderLevels(LevelsOf(volume, heat), 160, 134, 210));
    sheet.Put(1, i, "shapetons" + caption + "1,300", RenderLevels(LevelsOf(volume, walk), 160, 134, 210));
  }
  comparison.report.AddRows("engine", table);
  comparison.Show(sheet, "engine");
  comparison.report.AddText("A larger p closes more voxels and traps more shapetons. At p = 15 and 20, nearly all "
                            "shapetons are trapped by noise. With ten visits per voxel, a value is accurate to about "
                            "30 %, so most of the picture is noise. CHD shows the same closed parts without noise.");
}
