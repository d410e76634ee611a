#include "Tables.h"
#include "ShapeCollection.h"
#include "ValidationReport.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

using namespace shapeton;

namespace
{
using Distance = std::function<double(const ShapeSignature &, const ShapeSignature &)>;

struct Method
{
  std::string name;
  Distance    distance;
};

double
Squared(double a, double b)
{
  return std::pow(std::log(a / b), 2);
}

/** Baseline: volume, surface and elongation. */
double
MeasuresDistance(const ShapeSignature & a, const ShapeSignature & b)
{
  return std::sqrt(Squared(a.volume, b.volume) + Squared(a.surface, b.surface) + Squared(a.elongation, b.elongation));
}

/** Scale-invariant baseline: surface, elongation and flatness. */
double
ProportionsDistance(const ShapeSignature & a, const ShapeSignature & b)
{
  const SignatureDifference difference = DifferenceOf(a, b);
  return std::hypot(difference.surface, difference.elongation, difference.flatness);
}

/** Baseline: mean heat kernel signature of the surface at 16 logarithmically spaced times, scaled to area 1. */
double
HeatKernelDistance(const ShapeSignature & a, const ShapeSignature & b)
{
  const auto mean = [](const ShapeSignature & shape, double time) {
    double sum = 1.0;
    for (const double eigenvalue : shape.spectrum)
    {
      sum += std::exp(-eigenvalue * time);
    }
    return sum;
  };
  double sum = 0.0;
  for (int k = 0; k < 16; ++k)
  {
    const double time = 0.01 * std::pow(100.0, k / 15.0);
    sum += Squared(mean(a, time), mean(b, time));
  }
  return std::sqrt(sum);
}

std::vector<Method>
Methods()
{
  return { { "signature", SignatureDistance },
           { "volume, surface, elongation", MeasuresDistance },
           { "surface / volume^(2/3), elongation, flatness", ProportionsDistance },
           { "heat kernel signature alone", HeatKernelDistance } };
}

std::vector<CollectedShape>
Collect(const ValidationSettings & settings)
{
  constexpr std::size_t       number = 40;
  std::vector<CollectedShape> shapes = PresetShapes();
  const auto                  append = [&](const std::vector<CollectedShape> & more) {
    shapes.insert(shapes.end(), more.begin(), more.end());
  };
  if (!settings.dataFolder.empty())
  {
    append(BonesOfFeet(settings.dataFolder, 8));
    append(Organs(settings.dataFolder, 11));
  }
  append(GeneratedShapes(100, static_cast<int>(number - shapes.size())));
  if (settings.quick)
  {
    shapes.resize(6);
  }
  return shapes;
}

/** Whether the nearest original of a signature has this name. */
bool
IsNearest(const std::string &                name,
          const ShapeSignature &             signature,
          const std::vector<MeasuredShape> & shapes,
          const Distance &                   distance)
{
  const auto nearest =
    std::min_element(shapes.begin(), shapes.end(), [&](const MeasuredShape & a, const MeasuredShape & b) {
      return distance(signature, a.original) < distance(signature, b.original);
    });
  return nearest->name == name;
}

/** For each shape, the fraction of copies whose nearest original is the correct one. */
std::vector<double>
NearestIsRight(const std::vector<MeasuredShape> & shapes, const Distance & distance)
{
  std::vector<double> shares;
  for (const MeasuredShape & shape : shapes)
  {
    int right = 0;
    for (const ShapeCopy & copy : shape.copies)
    {
      right += IsNearest(shape.name, copy.signature, shapes, distance) ? 1 : 0;
    }
    shares.push_back(ShareOf(right, static_cast<int>(shape.copies.size())));
  }
  return shares;
}

/** Retrieval score of one signature among all others; signatures of the same shape are relevant. */
double
AveragePrecision(const ShapeSignature &             query,
                 std::size_t                        queryShape,
                 const std::vector<MeasuredShape> & shapes,
                 const Distance &                   distance)
{
  std::vector<std::pair<double, bool>> ranking;
  const auto                           add = [&](const ShapeSignature & other, std::size_t shape) {
    if (&other != &query)
    {
      ranking.emplace_back(distance(query, other), shape == queryShape);
    }
  };
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    add(shapes[i].original, i);
    std::for_each(
      shapes[i].copies.begin(), shapes[i].copies.end(), [&](const ShapeCopy & copy) { add(copy.signature, i); });
  }
  std::stable_sort(ranking.begin(), ranking.end(), [](const auto & a, const auto & b) { return a.first < b.first; });
  double precision = 0.0;
  int    wanted = 0;
  for (std::size_t rank = 0; rank < ranking.size(); ++rank)
  {
    if (ranking[rank].second)
    {
      precision += static_cast<double>(++wanted) / static_cast<double>(rank + 1);
    }
  }
  return precision / wanted;
}

/** For each shape, the mean over the shape and its copies. */
std::vector<double>
AveragePrecisions(const std::vector<MeasuredShape> & shapes, const Distance & distance)
{
  std::vector<double> means;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    std::vector<double> precisions{ AveragePrecision(shapes[i].original, i, shapes, distance) };
    for (const ShapeCopy & copy : shapes[i].copies)
    {
      precisions.push_back(AveragePrecision(copy.signature, i, shapes, distance));
    }
    means.push_back(MeanOf(precisions));
  }
  return means;
}

void
ReportMethods(const std::vector<MeasuredShape> & shapes, ValidationReport & report)
{
  CsvTable table({ "distance by", "nearest right", "bound", "", "mean average precision" });
  for (const Method & method : Methods())
  {
    const auto right = NearestIsRight(shapes, method.distance);
    const bool isOurs = method.name == "signature";
    table.AddRow(Cells() << method.name << MeanWithInterval(right) << (isOurs ? "at least 0.95" : "")
                         << (isOurs ? report.Check(MeanOf(right) >= 0.95) : "")
                         << MeanWithInterval(AveragePrecisions(shapes, method.distance)));
  }
  report.AddTable(table);
}

void
ReportKinds(const std::vector<MeasuredShape> & shapes, ValidationReport & report)
{
  std::map<std::string, std::vector<MeasuredShape>> kinds;
  for (const MeasuredShape & shape : shapes)
  {
    for (const ShapeCopy & copy : shape.copies)
    {
      kinds[copy.kind].push_back(shape);
      kinds[copy.kind].back().copies = { copy };
    }
  }
  std::vector<std::string> columns{ "kind of copy", "number" };
  for (const Method & method : Methods())
  {
    columns.push_back(method.name);
  }
  CsvTable table(columns);
  for (const auto & [kind, copies] : kinds)
  {
    std::vector<std::string> cells{ kind, std::to_string(copies.size()) };
    for (const Method & method : Methods())
    {
      int right = 0;
      for (const MeasuredShape & copy : copies)
      {
        right += IsNearest(copy.name, copy.copies[0].signature, shapes, method.distance) ? 1 : 0;
      }
      cells.push_back(Rounded(ShareOf(right, static_cast<int>(copies.size()))));
    }
    table.AddRow(cells);
  }
  report.AddText("Share of correct nearest originals by kind of copy:");
  report.AddRows("kinds", table);
}

/** Results of queries to a database that lacks a fifth of the shapes. */
struct Answers
{
  std::vector<double>                  unknownOfLeftOut; ///< for each shape, the share of its copies
  std::vector<double>                  rightOfEntries;
  std::vector<std::pair<double, bool>> probabilities; ///< whether the nearest shape is correct
};

Answers
AskWithoutAFifth(const std::vector<MeasuredShape> & shapes)
{
  constexpr std::size_t            folds = 5;
  Answers                          answers;
  std::vector<std::vector<double>> right(shapes.size());
  for (std::size_t fold = 0; fold < folds; ++fold)
  {
    std::vector<NamedShape> entries;
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      if (i % folds != fold)
      {
        entries.push_back({ shapes[i].name, shapes[i].original });
      }
    }
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      std::vector<double> unknown;
      for (const ShapeCopy & copy : shapes[i].copies)
      {
        const auto result = FindShape(copy.signature, entries, { 1 });
        const bool isRight = entries[result.neighbors.front().entry].name == shapes[i].name;
        answers.probabilities.emplace_back(result.probability, isRight);
        unknown.push_back(result.IsUnknown() ? 1.0 : 0.0);
        right[i].push_back(isRight && !result.IsUnknown() ? 1.0 : 0.0);
      }
      if (i % folds == fold)
      {
        answers.unknownOfLeftOut.push_back(MeanOf(unknown));
        right[i].resize(right[i].size() - unknown.size()); // these were not in the database
      }
    }
  }
  std::transform(right.begin(), right.end(), std::back_inserter(answers.rightOfEntries), MeanOf);
  return answers;
}

void
ReportCalibration(const std::vector<std::pair<double, bool>> & probabilities, ValidationReport & report)
{
  constexpr int       bins = 5;
  std::vector<double> sum(bins, 0.0);
  std::vector<int>    right(bins, 0), number(bins, 0);
  double              score = 0.0;
  for (const auto & [probability, isRight] : probabilities)
  {
    const int bin = std::min(bins - 1, static_cast<int>(probability * bins));
    sum[bin] += probability;
    right[bin] += isRight ? 1 : 0;
    ++number[bin];
    score += std::pow(probability - (isRight ? 1.0 : 0.0), 2) / static_cast<double>(probabilities.size());
  }
  CsvTable table({ "probability", "answers", "its mean", "nearest right" });
  for (int bin = 0; bin < bins; ++bin)
  {
    table.AddRow(Cells() << Rounded(bin / 5.0) + " to " + Rounded((bin + 1) / 5.0) << number[bin]
                         << (number[bin] > 0 ? Rounded(sum[bin] / number[bin]) : "")
                         << (number[bin] > 0 ? Rounded(ShareOf(right[bin], number[bin])) : ""));
  }
  report.AddText("Brier score of the probability that the nearest shape is correct: " + Rounded(score) + ".");
  report.AddRows("probabilities", table);
}

void
ReportUnknown(const std::vector<MeasuredShape> & shapes, bool quick, ValidationReport & report)
{
  const Answers answers = AskWithoutAFifth(shapes);
  const double  unknown = MeanOf(answers.unknownOfLeftOut);
  report.AddText("## Unknown shapes\n\nEvery fifth shape is omitted from a database of the originals; the copies of "
                 "all shapes are searched.");
  CsvTable table({ "copies of", "answer", "share", "bound", "" });
  table.AddRow(Cells() << "shapes left out"
                       << "unknown" << MeanWithInterval(answers.unknownOfLeftOut)
                       << (quick ? "none for so few shapes" : "at least 0.9")
                       << (quick ? "" : report.Check(unknown >= 0.9)));
  table.AddRow({ "shapes in the database", "correct name", MeanWithInterval(answers.rightOfEntries), "", "" });
  report.AddTable(table);
  ReportCalibration(answers.probabilities, report);
}
} // namespace

void
ValidateSearchOfShapes(const ValidationSettings & settings, ValidationReport & report)
{
  const auto  shapes = Measure(Collect(settings));
  std::size_t copies = 0;
  CsvTable    table({ "shape", "copies" });
  for (const MeasuredShape & shape : shapes)
  {
    copies += shape.copies.size();
    table.AddRow({ shape.name, std::to_string(shape.copies.size()) });
  }
  report.AddText(
    std::to_string(shapes.size()) + " shapes that were not used for fitting: objects of `ShapePhantom`'s presets, " +
    (settings.dataFolder.empty()
       ? std::string("no real ones (SHAPETON_TEST_DATA_DIR is not set)")
       : std::string("bones of two feet (CT of the Visible Human Female, above 350 HU, opened by 2 mm), organs of an "
                     "abdomen (labels of TotalSegmentator's example)")) +
    ", and generated shapes (seeds from 100 on). " + std::to_string(copies) +
    " copies: rotated by 30 degrees; scaled by 0.5 and by 2, with isotropic voxels; resampled to oblique voxels 1.3 x "
    "1.3 x 2.6 times as large; noisy (a fifth of the boundary voxels change sides); and all of these combined, scaled "
    "by 0.8 with voxels 0.9 x 0.9 x 1.8 times as large. Values are means over shapes with 95 % intervals.");
  report.AddRows("shapes", table);
  report.AddText("## Nearest neighbor\n\nNearest original of each copy. Average precision: retrieval of originals and "
                 "copies among all others.");
  ReportMethods(shapes, report);
  ReportKinds(shapes, report);
  ReportUnknown(shapes, settings.quick, report);
}
