#include "FlatteningTrial.h"
#include "Tables.h"
#include "ValidationChart.h"
#include "ValidationReport.h"

#include "shapetonHeatDiffusionMetric.h"
#include "shapetonExceptions.h"

#include <cmath>

using namespace shapeton;

namespace
{
/** L2 distance between two histograms, as fractions of the faces (5.2.1). */
double
DistanceOfHistograms(const TriangleQuality & a, const TriangleQuality & b, int faces)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.histogram.size(); ++i)
  {
    sum += std::pow(static_cast<double>(a.histogram[i] - b.histogram[i]) / faces, 2);
  }
  return std::sqrt(sum);
}

/** Results of one metric of the tube. */
struct Metric
{
  Eigen::VectorXd lengths;
  TriangleQuality quality;
  /** Modulus of the flat colon; 0 if the map does not exist for these lengths. */
  double modulus{ 0.0 };
};

Metric
MetricOf(const TubeCase & plain, const Eigen::VectorXd & lengths)
{
  Metric metric{ lengths, MeasureTriangleQuality(SidesOfFaces(plain.connectivity, lengths)) };
  try
  {
    const TubeMap map = plain.Flatten(lengths);
    metric.modulus = std::sqrt(map.modulusU * map.modulusV);
  }
  catch (const InputError &)
  {
    // A violated triangle inequality is also a result.
  }
  return metric;
}

/** Adds the rows of one diffusion time; returns the differences for a chart. */
class QualityOfTime
{
public:
  QualityOfTime(const TubeCase & plain, const HeatDiffusionMetricSolver & solver, double factor, double h)
    : m_Plain(plain)
    , m_Solver(solver)
    , m_Factor(factor)
    , m_Time(factor * h * h)
    , m_Exact(MetricOf(plain, solver.Compute(m_Time).edgeLengths))
  {}

  /** Adds the row of a number of eigenpairs; returns their difference from the exact distances. */
  double
  AddPairs(const SurfaceSpectrum & spectrum, int pairs, CsvTable & table) const
  {
    const auto   distances = TruncatedHeatDiffusionMetric(m_Solver.Laplacian(), spectrum, m_Time, pairs);
    const Metric metric = MetricOf(m_Plain, distances.edgeLengths);
    const double rms = std::sqrt((metric.lengths.array() / m_Exact.lengths.array() - 1.0).square().mean());
    this->AddRow(std::to_string(pairs),
                 Rounded(std::exp(-2.0 * spectrum.eigenvalues[pairs - 1] * m_Time), 2),
                 100.0 * rms,
                 metric,
                 table);
    return rms;
  }
  void
  AddExact(CsvTable & table) const
  {
    this->AddRow("all (exact)", "", 0.0, m_Exact, table);
  }

private:
  void
  AddRow(const std::string & pairs, const std::string & last, double rms, const Metric & metric, CsvTable & table) const
  {
    const double histogram = DistanceOfHistograms(metric.quality, m_Exact.quality, m_Plain.tube.mesh.NumberOfFaces());
    table.AddRow(Cells() << Rounded(m_Factor) << Rounded(m_Time) << pairs << last << Rounded(rms)
                         << Rounded(100.0 * metric.quality.shareBelowThreshold) << Rounded(histogram, 2)
                         << (metric.modulus > 0.0 ? Rounded(metric.modulus / m_Exact.modulus, 4) : "no map"));
  }

  const TubeCase &                  m_Plain;
  const HeatDiffusionMetricSolver & m_Solver;
  double                            m_Factor;
  double                            m_Time;
  Metric                            m_Exact;
};

void
Explain(const SurfaceMesh & mesh, double h, ValidationReport & report)
{
  const TriangleQuality inSpace = MeasureTriangleQuality(SidesOfFaces(mesh.V, mesh.F));
  report.AddText("Heat diffusion distances of the edges of a tube like a colon (" +
                 std::to_string(mesh.NumberOfFaces()) + " faces, h = " + Rounded(h) +
                 " mm), from the first eigenpairs, compared with those from all eigenpairs (exact). rms: root mean "
                 "square of the relative difference of lengths. Below 0.6: share of triangles with these lengths whose "
                 "2r/R is below 0.6 (in space " +
                 Rounded(100.0 * inSpace.shareBelowThreshold) +
                 " %). Histogram: L2 distance of the 2r/R histogram (20 bins) from the exact one. Modulus: of the flat "
                 "colon in this metric.");
}
} // namespace

void
ValidateQualityOfMetric(const ValidationSettings & settings, ValidationReport & report)
{
  const TubeCase      plain(settings.quick ? GenerateTube(3000, 0, 1, 4, 500.0) : GenerateTube(12000, 0, 1));
  const SurfaceMesh & mesh = plain.tube.mesh;
  const HeatDiffusionMetricSolver solver(MakeSurfaceLaplacian(plain.connectivity, mesh.V));
  const std::vector<int>          numbers =
    settings.quick ? std::vector<int>{ 10, 50, 200 } : std::vector<int>{ 10, 20, 50, 100, 200, 500 };
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(solver.Laplacian(), numbers.back());
  const double          h = plain.lengths.mean();
  Explain(mesh, h, report);
  CsvTable table(Columns("t / h^2 | t, mm^2 | eigenpairs | exp(-2 lambda t) of the last | rms, % | below 0.6, % | "
                         "histogram | modulus over exact"));
  std::vector<ChartSeries> chart;
  double                   last = 0.0;
  for (const double factor : { 2.0, 4.0, 8.0, 16.0, 32.0 })
  {
    const QualityOfTime quality(plain, solver, factor, h);
    chart.push_back({ "t = " + Rounded(factor, 2) + " h^2", {} });
    for (const int pairs : numbers)
    {
      last = quality.AddPairs(spectrum, pairs, table);
      chart.back().points.emplace_back(pairs, std::max(last, 1e-10));
    }
    quality.AddExact(table);
  }
  report.AddRows("eigenpairs", table);
  report.AddText("Most pairs against exact at t = 32 h^2: rms " + Rounded(last, 2) +
                 ", bound 1e-5: " + report.Check(last <= 1e-5) +
                 ". Few pairs do not resolve the angles around a long tube, which then appears too thin or as a line. "
                 "Long times produce slivers for any number of pairs.\n\n![](flattening-quality.svg)");
  WriteLogarithmicChart(
    settings.outputFolder + "/flattening-quality.svg", "eigenpairs", "relative difference of lengths, rms", chart);
}
