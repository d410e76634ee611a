#include "shapetonShapeAnalysis.h"

#include "shapetonHeatClassification.h"
#include "shapetonVisitDensity.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Share of the border above which the class with the fewest visits is surroundings that shapetons reached: at least
 * 0.19 in eight volumes (CT, micro-CT). No object there is the class with the fewest visits. */
constexpr double leastBorderOfHalo = 0.1;

void
MarkHalo(std::vector<HeatClass> & classes)
{
  if (classes.size() > 1 && classes[1].borderShare > leastBorderOfHalo)
  {
    classes[1].isSurroundings = true;
  }
}
} // namespace

ShapeAnalysis
AnalyzeHeat(const itk::Image<float, 3> * heat, std::uint64_t timeStep, bool wantLabels)
{
  ShapeAnalysis analysis;
  analysis.values = heat;
  analysis.histogram = HeatHistogram({ timeStep });
  analysis.histogram.AddToRow(0, heat->GetBufferPointer(), heat->GetBufferedRegion().GetNumberOfPixels());
  analysis.classes = FindHeatClasses(analysis.histogram, 0);
  if (wantLabels)
  {
    analysis.labels = LabelHeat(heat, analysis.classes);
  }
  analysis.axisHistogram = analysis.histogram;
  return analysis;
}

ShapeAnalysis
AnalyzeVisits(const itk::Image<std::uint32_t, 3> * visits, std::uint64_t timeStep, bool wantLabels)
{
  ShapeAnalysis analysis;
  analysis.quantity = ShapeQuantity::Density(std::max(1U, GreatestVisits(visits)));
  analysis.values = NormalizeVisits(visits).GetPointer();
  analysis.histogram = HeatHistogram({ timeStep });
  AddVisitsToRow(visits, 0, analysis.histogram);
  analysis.classes = FindVisitClasses(analysis.histogram, 0, analysis.quantity.greatestVisits);
  if (wantLabels)
  {
    analysis.labels = LabelHeat(analysis.values, analysis.classes);
    MeasureContiguity(analysis.labels, analysis.classes);
    MarkHalo(analysis.classes);
  }
  analysis.axisHistogram = BalanceClasses(analysis.histogram, 0, analysis.classes);
  return analysis;
}
} // namespace shapeton
