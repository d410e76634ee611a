#include "Overlaps.h"
#include "SampledScenes.h"
#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"

#include <numeric>

using namespace shapeton;

namespace
{
/** Fraction of an object's voxels in its main class (the class with most of its voxels), averaged over the objects, and
 * the number of main classes shared by objects. */
struct Agreement
{
  double      purity{ 0.0 };
  std::size_t objects{ 0 };
  std::size_t classes{ 0 };
};

Agreement
Compare(const itk::Image<unsigned char, 3> * truth, const itk::Image<unsigned char, 3> * labels)
{
  Overlaps counts = OverlapsOf(
    truth->GetBufferPointer(), labels->GetBufferPointer(), truth->GetLargestPossibleRegion().GetNumberOfPixels());
  counts.erase(0);
  Agreement          agreement;
  std::map<int, int> classes;
  for (const auto & object : counts)
  {
    double total = 0.0, best = 0.0;
    int    main = 0;
    for (const auto & count : object.second)
    {
      total += count.second;
      main = count.second > best ? count.first : main;
      best = std::max(best, count.second);
    }
    ++classes[main];
    agreement.purity += best / total;
  }
  agreement.objects = counts.size();
  agreement.classes = classes.size();
  agreement.purity /= std::max<std::size_t>(1, agreement.objects);
  return agreement;
}

Agreement
RunPhantom(const std::string & preset, unsigned int side, double noise, double blur, std::uint64_t seed)
{
  ShapePhantomOptions options;
  options.noise = noise;
  options.blur = blur;
  options.seed = seed;
  const auto source = SampledScene(ShapeScene::Load(preset), itk::Size<3>::Filled(side), options);
  auto       filter = CumulativeHeatDiffusionImageFilter<itk::Image<short, 3>>::New();
  filter->SetInput(source->GetOutput());
  filter->UseParameters(ChooseHeatParameters(VolumeView(source->GetOutput()), filter->GetOptions()));
  filter->WantComponentsOn();
  filter->Update();
  const auto classification = ClassifyHeat(filter->GetOutput(), filter->GetResult());
  return Compare(source->GetLabelOutput(), classification.labels);
}
} // namespace

void
ValidateClassesOfPhantoms(const ValidationSettings & settings, ValidationReport & report)
{
  constexpr unsigned int side = 96; // the bounds are for this size
  const unsigned int     seeds = settings.quick ? 1 : 10;
  report.AddText(
    "Phantoms of " + std::to_string(side) + "^3 voxels, contrast 1000 HU, Gaussian noise, seeds 100 to " +
    std::to_string(99 + seeds) +
    ", chosen parameters. Purity: share of an object's voxels in its main class, mean over the objects, with the 95 % "
    "confidence interval over the seeds. Bound without blur: mean purity at least 0.9 and one class per object. "
    "Blurred edges leak by design (an edge over k voxels requires p above k / contrast), so they have no bound.");
  CsvTable table({ "phantom", "noise SD, HU", "blur, voxels", "seeds", "purity", "objects", "classes", "" });
  double   sharpest = 1.0, blurred = 1.0;
  for (const std::string preset : { "figure2.7a", "figure2.7b" })
  {
    for (const auto & c : { std::array<double, 2>{ 0.0, 0.0 }, { 20.0, 0.0 }, { 50.0, 0.0 }, { 20.0, 0.7 } })
    {
      std::vector<double> purities, classes;
      Agreement           agreement;
      bool                distinct = true;
      for (unsigned int seed = 100; seed < 100 + (c[0] > 0.0 ? seeds : 1); ++seed)
      {
        agreement = RunPhantom(preset, side, c[0], c[1], seed);
        purities.push_back(agreement.purity);
        classes.push_back(static_cast<double>(agreement.classes));
        distinct &= agreement.classes == agreement.objects;
      }
      const double mean = std::accumulate(purities.begin(), purities.end(), 0.0) / purities.size();
      double &     lowest = c[1] == 0.0 ? sharpest : blurred;
      lowest = std::min(lowest, mean);
      table.AddRow(Cells() << preset << c[0] << c[1] << purities.size() << MeanWithInterval(purities)
                           << agreement.objects << MeanWithInterval(classes)
                           << (c[1] == 0.0 ? report.Check(mean >= 0.9 && distinct) : ""));
    }
  }
  report.AddRows("phantoms", table);
  report.AddText("Lowest mean purity: " + Rounded(sharpest, 4) + " without blur, " + Rounded(blurred, 4) +
                 " with blur.");
}
