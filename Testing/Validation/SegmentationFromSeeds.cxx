#include "Tables.h"
#include "SampledScenes.h"
#include "SeedTrial.h"
#include "ValidationReport.h"
#include "ValidationVolumes.h"

#include "shapetonImageGrid.h"
#include "shapetonSeededHeatSolver.h"
#include "shapetonTestImages.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace shapeton;

namespace
{
using ImageType = LabeledVolume::ImageType;

constexpr int judgedNumber = 20; // seeds per label at which the bounds apply

// ---- volumes ----

/** Intensities scaled to [0, 1] by a window, the input of all methods. */
template <typename TImage>
ImageType::Pointer
Windowed(const TImage * image, double lower, double upper)
{
  return MapVoxels<float>(image, [=](double value) { return std::clamp((value - lower) / (upper - lower), 0.0, 1.0); });
}

/** Sets label 1 for the background and for parts that are too small or not selected (empty: all are selected), then one
 * label per part. */
template <typename TImage>
void
SetTruth(const TImage * parts, std::size_t leastVoxels, const std::set<int> & wanted, LabeledVolume & volume)
{
  const std::size_t          number = parts->GetLargestPossibleRegion().GetNumberOfPixels();
  std::map<int, std::size_t> voxels;
  for (std::size_t i = 0; i < number; ++i)
  {
    ++voxels[static_cast<int>(parts->GetBufferPointer()[i])];
  }
  std::map<int, unsigned short> labels;
  volume.names = { "background" };
  for (const auto & [part, count] : voxels)
  {
    const bool isTaken = part != 0 && count >= leastVoxels && (wanted.empty() || wanted.count(part) != 0);
    if (isTaken)
    {
      volume.names.push_back(std::to_string(part));
    }
    labels[part] = isTaken ? static_cast<unsigned short>(volume.names.size()) : 1;
  }
  volume.truth = MapVoxels<unsigned short>(parts, [&](auto part) { return labels[static_cast<int>(part)]; });
}

LabeledVolume
Phantom(const std::string & preset, unsigned int side, double noise, double blur)
{
  ShapePhantomOptions options;
  options.noise = noise;
  options.blur = blur;
  const auto    source = SampledScene(ShapeScene::Load(preset), itk::Size<3>::Filled(side), options);
  LabeledVolume volume;
  volume.name = preset + ", noise " + Rounded(noise) + " HU, blur " + Rounded(blur) + " voxels";
  volume.image = Windowed(source->GetOutput(), 0.0, 1000.0);
  SetTruth(source->GetLabelOutput(), 1, {}, volume);
  return volume;
}

LabeledVolume
LabeledAbdomen(const std::string & dataFolder, const std::string & name, const std::set<int> & organs)
{
  constexpr std::size_t leastVoxels = 1000;
  const auto [ct, parts] = ReadAbdomen(dataFolder);
  LabeledVolume volume;
  volume.name = name;
  volume.image = Windowed(ct.image.GetPointer(), -160.0, 240.0);
  SetTruth(parts.image.GetPointer(), leastVoxels, organs, volume);
  return volume;
}

// ---- trials ----

/** Draws of one method for one number of seeds; empty if the method is not available. */
struct Scores
{
  void
  Add(const LabeledVolume & volume, const Segmentation & segmentation)
  {
    dice.push_back(DiceOfLabels(volume, segmentation.labels));
    meanDice.push_back(MeanOf(dice.back()));
    cpuSeconds.push_back(segmentation.cpuSeconds);
    stopped += segmentation.hasConverged ? 0 : 1;
  }

  std::vector<std::vector<double>> dice; ///< of each label
  std::vector<double>              meanDice;
  std::vector<double>              cpuSeconds;
  int                              stopped{ 0 }; ///< number of draws that did not converge
};

struct MethodScores
{
  std::string           name;
  std::map<int, Scores> ofNumber; ///< keyed by the number of seeds
};

/** Seeds of all draws, by their number. */
std::map<int, std::vector<DrawnSeeds>>
DrawAll(const LabeledVolume & volume, const std::vector<int> & numbers, int draws)
{
  std::map<int, std::vector<DrawnSeeds>> seeds;
  for (const int number : numbers)
  {
    for (int draw = 1; draw <= draws; ++draw)
    {
      seeds[number].push_back(DrawSeeds(volume, number, static_cast<unsigned int>(draw)));
    }
  }
  return seeds;
}

MethodScores
RunMethod(const std::string &                                                           name,
          const std::function<Segmentation(const LabeledVolume &, const SeedImage *)> & segment,
          const LabeledVolume &                                                         volume,
          const std::map<int, std::vector<DrawnSeeds>> &                                seeds)
{
  MethodScores scores{ name, {} };
  for (const auto & [number, draws] : seeds)
  {
    for (const DrawnSeeds & draw : draws)
    {
      ValidationReport::Progress(volume.name + ": " + name + ", " + std::to_string(number) + " seeds");
      scores.ofNumber[number].Add(volume, segment(volume, draw.image));
    }
  }
  return scores;
}

MethodScores
RunRandomWalker(const LabeledVolume & volume, const std::map<int, std::vector<DrawnSeeds>> & seeds)
{
  MethodScores                    scores{ "random walker (scikit-image)", {} };
  std::vector<SeedImage::Pointer> images;
  for (const auto & [number, draws] : seeds)
  {
    scores.ofNumber[number];
    std::transform(
      draws.begin(), draws.end(), std::back_inserter(images), [](const DrawnSeeds & draw) { return draw.image; });
  }
  ValidationReport::Progress(volume.name + ": " + scores.name);
  const auto segmentations = SegmentByRandomWalker(volume, images);
  if (!segmentations)
  {
    return scores;
  }
  auto next = segmentations->begin();
  for (const auto & [number, draws] : seeds)
  {
    for (std::size_t i = 0; i < draws.size(); ++i)
    {
      scores.ofNumber[number].Add(volume, *next++);
    }
  }
  return scores;
}

/** Methods in order: Shapeton, random walker, others. */
std::vector<MethodScores>
RunMethods(const LabeledVolume & volume, const std::map<int, std::vector<DrawnSeeds>> & seeds)
{
  return { RunMethod("seeded heat", SegmentByHeat, volume, seeds),
           RunRandomWalker(volume, seeds),
           RunMethod("watershed (ITK)", SegmentByWatershed, volume, seeds),
           RunMethod("confidence connected (ITK)", SegmentByConfidence, volume, seeds) };
}

// ---- tables ----

/** Results of all volumes. */
struct Results
{
  CsvTable methods{ Columns("volume | voxels | labels | draws | labels with seeds at the border | seeds of each label "
                            "| method | mean Dice of the labels | CPU seconds") };
  CsvTable differences{ Columns("volume | seeded heat | less random walker (scikit-image), at least -0.01 | less "
                                "watershed (ITK), above 0 | less confidence connected (ITK), above 0") };
  std::vector<CsvTable> labels;
};

void
AddMeans(const LabeledVolume &                          volume,
         const std::map<int, std::vector<DrawnSeeds>> & seeds,
         const std::vector<MethodScores> &              methods,
         CsvTable &                                     table)
{
  const auto        size = volume.image->GetLargestPossibleRegion().GetSize();
  const std::string voxels =
    std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
  for (const auto & [number, draws] : seeds)
  {
    for (const MethodScores & method : methods)
    {
      const Scores &    scores = method.ofNumber.at(number);
      const bool        hasRun = !scores.dice.empty();
      const std::string remark = scores.stopped == 0 ? "" : "; " + std::to_string(scores.stopped) + " did not converge";
      table.AddRow(Cells() << volume.name << voxels << volume.names.size() << draws.size() << draws.front().thinLabels
                           << number << method.name
                           << (hasRun ? MeanWithInterval(scores.meanDice) : "not run: python3-skimage is missing")
                           << (hasRun ? Rounded(MeanOf(scores.cpuSeconds)) + remark : ""));
    }
  }
}

/** Difference between Shapeton and each peer, per draw. */
void
AddDifferences(const LabeledVolume &             volume,
               const std::vector<MethodScores> & methods,
               ValidationReport &                report,
               CsvTable &                        table)
{
  const auto &             ours = methods.front().ofNumber.at(judgedNumber).meanDice;
  std::vector<std::string> cells{ volume.name, MeanWithInterval(ours) };
  for (std::size_t i = 1; i < methods.size(); ++i)
  {
    auto difference = methods[i].ofNumber.at(judgedNumber).meanDice;
    if (difference.empty())
    {
      cells.push_back("not run");
      continue;
    }
    std::transform(ours.begin(), ours.end(), difference.begin(), difference.begin(), std::minus<>());
    const bool isWalker = i == 1;
    const bool isReached = isWalker ? MeanOf(difference) >= -0.01 : MeanOf(difference) > 0.0;
    cells.push_back(MeanWithInterval(difference) + ": " + report.Check(isReached));
  }
  table.AddRow(cells);
}

CsvTable
LabelTable(const LabeledVolume & volume, const std::vector<MethodScores> & methods)
{
  std::vector<std::size_t> voxels(volume.names.size(), 0);
  const auto * const       truth = volume.truth->GetBufferPointer();
  for (std::size_t i = 0; i < volume.truth->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
  {
    ++voxels[truth[i] - 1];
  }
  std::vector<std::string> columns{ "label", "voxels" };
  for (const MethodScores & method : methods)
  {
    columns.push_back(method.name);
  }
  CsvTable table(columns);
  for (std::size_t label = 0; label < voxels.size(); ++label)
  {
    std::vector<std::string> cells{ volume.names[label], std::to_string(voxels[label]) };
    for (const MethodScores & method : methods)
    {
      std::vector<double> dice;
      for (const std::vector<double> & draw : method.ofNumber.at(judgedNumber).dice)
      {
        dice.push_back(draw[label]);
      }
      cells.push_back(dice.empty() ? "" : Rounded(MeanOf(dice)));
    }
    table.AddRow(cells);
  }
  return table;
}

std::vector<int>
NumbersOfSeeds(const ValidationSettings & settings)
{
  if (settings.seedsOfLabel > 0)
  {
    return { settings.seedsOfLabel };
  }
  return settings.quick ? std::vector<int>{ judgedNumber } : std::vector<int>{ 5, judgedNumber, 100 };
}

void
AddVolume(const LabeledVolume &      volume,
          bool                       hasLabels,
          const ValidationSettings & settings,
          ValidationReport &         report,
          Results &                  results)
{
  const int  draws = settings.draws > 0 ? settings.draws : settings.quick ? 2 : 3;
  const auto seeds = DrawAll(volume, NumbersOfSeeds(settings), draws);
  const auto methods = RunMethods(volume, seeds);
  AddMeans(volume, seeds, methods, results.methods);
  if (seeds.count(judgedNumber) == 0)
  {
    return;
  }
  AddDifferences(volume, methods, report, results.differences);
  if (hasLabels)
  {
    results.labels.push_back(LabelTable(volume, methods));
  }
}

/** `remark` is printed after the differences. */
void
ReportResults(const std::string & data, const Results & results, const std::string & remark, ValidationReport & report)
{
  report.AddText("## Mean Dice\n\n" + data);
  if (!results.differences.GetRows().empty())
  {
    report.AddText("The table is for 20 seeds per label. The columns after the first value are differences on the same "
                   "draws, with their bounds.");
    report.AddTable(results.differences);
  }
  if (!remark.empty())
  {
    report.AddText(remark);
  }
  report.AddRows("methods", results.methods);
  for (const CsvTable & table : results.labels)
  {
    report.AddText("Dice of each label, mean over the draws:");
    report.AddRows("labels", table);
  }
}

void
ReportMethod(ValidationReport & report)
{
  report.AddText("Seeds are voxels of each label, drawn from the truth eroded by one voxel, or from the whole label if "
                 "that leaves too few. The background is a label with as many seeds. All methods use the same seeds, "
                 "the same intensities, scaled to [0, 1] by a window, and their defaults: seeded heat (p = 100, least "
                 "weight 0.2); scikit-image's `random_walker` (beta 130, mode `cg_j`, tolerance 1e-3; mode `cg_mg` "
                 "requires pyamg, which Debian 12 lacks); ITK's `MorphologicalWatershedFromMarkers` on the gradient "
                 "magnitude; ITK's `ConfidenceConnected` per label (overlaps get the label of the nearest mean, the "
                 "rest is background). Dice: mean over all labels, with the 95 % confidence interval over the draws, "
                 "seeds 1, 2, and so on. CPU seconds: sum over all threads, mean over the draws.");
}

void
AddPhantoms(const ValidationSettings & settings, ValidationReport & report, Results & results)
{
  std::vector<std::pair<double, double>> conditions{ { 20.0, 0.0 }, { 20.0, 0.7 } };
  if (settings.quick)
  {
    conditions.resize(1);
  }
  for (const std::string preset : { "figure3.4", "hydrogen" })
  {
    for (const auto & [noise, blur] : conditions)
    {
      AddVolume(Phantom(preset, settings.quick ? 32 : 64, noise, blur), false, settings, report, results);
    }
  }
}

// ---- agreement ----

/** Phantom with values 0 and 1. */
LabeledVolume
TwoValues(unsigned int side)
{
  LabeledVolume volume = Phantom("figure3.4", side, 20.0, 0.0);
  auto * const  values = volume.image->GetBufferPointer();
  std::transform(
    values, values + volume.image->GetLargestPossibleRegion().GetNumberOfPixels(), values, [](float value) {
      return value > 0.02F ? 1.0F : 0.0F; // noise turns every sixth background voxel into a 1
    });
  return volume;
}

double
StandardDeviation(const ImageType * image)
{
  const std::size_t number = image->GetLargestPossibleRegion().GetNumberOfPixels();
  double            sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < number; ++i)
  {
    const double value = image->GetBufferPointer()[i];
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(number);
  return std::sqrt(squares / static_cast<double>(number) - mean * mean);
}

/** Greatest difference of a probability over voxels and labels. */
double
GreatestDifference(const LabeledVolume &                   volume,
                   const SeedImage *                       seeds,
                   double                                  weight,
                   const std::vector<ImageType::Pointer> & expected)
{
  const auto            size = volume.image->GetLargestPossibleRegion().GetSize();
  VolumeGradientOptions options;
  options.p = 1.0 - weight;
  options.intensityWindow = { { 0.0, 1.0 } };
  const VolumeGradientOperator volumeGradient(
    VolumeView(volume.image->GetBufferPointer(), { { size[0], size[1], size[2] } }),
    options,
    VolumeGradientOperator::Conductance::Physical,
    1e-4);
  SeededHeatSolver   solver(volumeGradient);
  const auto &       result = solver.Solve(seeds->GetBufferPointer());
  std::vector<float> probabilities(result.labels.size());
  double             greatest = 0.0;
  for (const unsigned short label : result.labelValues)
  {
    solver.GetProbabilities(label, probabilities.data());
    for (std::size_t i = 0; i < probabilities.size(); ++i)
    {
      const double difference = probabilities[i] - expected[label - 1]->GetBufferPointer()[i];
      greatest = std::max(greatest, std::abs(difference));
    }
  }
  return greatest;
}

void
ReportAgreement(const ValidationSettings & settings, ValidationReport & report)
{
  const unsigned int  side = settings.quick ? 24 : 64;
  const LabeledVolume volume = TwoValues(side);
  const double        deviation = StandardDeviation(volume.image);
  const auto          seeds = DrawSeeds(volume, judgedNumber, 1).image;
  report.AddText("## Probabilities compared with scikit-image\n\nA volume of " + std::to_string(side) +
                 "^3 voxels of 0 and 1, for which the weights of both methods can be made equal. The weight between 0 "
                 "and 1 is 1 - p for seeded heat and exp(-beta / (10 s)) + 1e-10 for `random_walker`, with s the "
                 "standard deviation of the volume; beta follows. Tolerance of `random_walker`: 1e-9. " +
                 std::to_string(volume.names.size()) + " labels, " + std::to_string(judgedNumber) + " seeds each.");
  CsvTable table({ "weight between 0 and 1", "beta", "greatest difference of a probability", "bound", "" });
  for (const double weight : { 0.5, 0.1, 0.01 })
  {
    const double beta = -10.0 * deviation * std::log(weight);
    const auto   expected = RandomWalkerProbabilities(volume, seeds, beta, 1e-9);
    if (!expected)
    {
      table.AddRow({ Rounded(weight), Rounded(beta), "not run: python3-skimage is missing", "", "" });
      continue;
    }
    const double difference = GreatestDifference(volume, seeds, weight, *expected);
    table.AddRow(Cells() << Rounded(weight) << Rounded(beta) << Rounded(difference) << "at most 1e-4"
                         << report.Check(difference <= 1e-4));
  }
  report.AddTable(table);
}
} // namespace

void
ValidateSegmentationFromSeeds(const ValidationSettings & settings, ValidationReport & report)
{
  ReportMethod(report);
  ReportAgreement(settings, report);
  Results     results;
  std::string data = "Phantoms have a contrast of 450 to 1000 HU and a window of 0 to 1000 HU.";
  AddPhantoms(settings, report, results);
  if (settings.dataFolder.empty())
  {
    data += " No abdomen: SHAPETON_TEST_DATA_DIR is not set.";
  }
  else if (!settings.quick)
  {
    data += " The abdomen is TotalSegmentator's example (CT, 3 mm, window -160 to 240 HU) with the labels 1 spleen, 2 "
            "and 3 kidneys, 5 liver, 52 aorta; all else is background.";
    AddVolume(LabeledAbdomen(settings.dataFolder, "Five organs of an abdomen", { 1, 2, 3, 5, 52 }),
              true,
              settings,
              report,
              results);
  }
  const bool isComplete = !settings.dataFolder.empty() && !settings.quick;
  ReportResults(data,
                results,
                isComplete ? "The 95 % intervals of both failed differences contain 0. For the organs, the reason is "
                             "too few background seeds ([notes](seeded-heat.md#seededheat))."
                           : "",
                report);
}

void
ValidateSegmentationOfOrgans(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("For seeds, methods and measures see [seeded-heat](seeded-heat.md).");
  Results results;
  AddVolume(LabeledAbdomen(settings.dataFolder, "All organs of an abdomen", {}), true, settings, report, results);
  ReportResults("TotalSegmentator's example (CT, 3 mm, window -160 to 240 HU) with all labels of at least 1000 voxels; "
                "smaller ones are background.",
                results,
                "",
                report);
}
