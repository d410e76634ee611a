#include "itkColonLumenSegmentation.h"

#include "itkFluidWithoutGas.h"
#include "itkColonGravity.h"
#include "itkLumenReport.h"
#include "itkColonStatistics.h"
#include "itkLumenVoxels.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
constexpr double GasByDefinition = -1000.0; // HU
constexpr double SeedShareOfGas = 0.2;      // of the way from gas to tissue
constexpr double TolerableNoise = 50.0;     // a quarter of the way from gas to its seed threshold
constexpr double ClearLevels = 500.0;       // mm^2
constexpr double ClearRatio = 3.0;
constexpr double SeedReach = 2.0; // mm

class LumenSegmentation
{
public:
  LumenSegmentation(const ColonImage * ct, const ColonLumenOptions & options) : m_Image(ct), m_Options(options) {}

  ColonLumen
  Run()
  {
    this->CheckInput();
    this->Load();
    this->FindGasPieces();
    this->FindGravity();
    MeasureFluid(m_Evidence);
    ReviewCore(m_Evidence);
    this->KeepSeeds();
    MeasureFluid(m_Evidence);
    FindBright(m_Evidence);
    this->AddFluidWithoutGas();
    this->Progress(0.6);
    this->DecideLabels();
    this->Progress(1.0);
    return std::move(m_Result);
  }

private:
  void
  Progress(double share) const
  {
    if (m_Options.progress)
    {
      m_Options.progress(share);
    }
  }

  void
  CheckInput() const
  {
    const auto size = m_Image->GetBufferedRegion().GetSize();
    for (int a = 0; a < 3; ++a)
    {
      if (size[a] < 8)
      {
        throw InputError("the image has " + std::to_string(size[a]) + " voxels along an axis; at least 8 are needed");
      }
    }
    RequireUsage(m_Options.patientPosition.empty() || GravityOfPatientPosition(m_Options.patientPosition),
                 "the patient position \"" + m_Options.patientPosition +
                   "\" is not known; give supine, prone, leftDecubitus or rightDecubitus");
  }

  void
  Load()
  {
    auto & e = m_Evidence;
    e.grid = GridOfImage(m_Image);
    e.hu = LoadVoxels(m_Image, e.grid);
    e.thresholds.tissue = ModeOfTissue(e.hu);
    e.noise = NoiseInTissue(e.grid, e.hu, e.thresholds.tissue);
    e.remainingNoise = e.noise;
    this->Progress(0.1);
    if (e.noise > TolerableNoise)
    {
      this->Smooth();
    }
    e.bodyMl =
      e.grid.VoxelVolume() * 1e-3 * std::count_if(e.hu.begin(), e.hu.end(), [](float v) { return v > -400.0F; });
    this->SetGasThresholds(GasByDefinition);
    this->Progress(0.2);
  }

  /** In steps of 0.3 mm, no more than the noise asks for. */
  void
  Smooth()
  {
    auto & e = m_Evidence;
    while (e.remainingNoise > TolerableNoise && e.smoothing < 0.85)
    {
      const double next = e.smoothing + 0.3;
      SmoothVoxels(e.grid, e.hu, std::sqrt(next * next - e.smoothing * e.smoothing));
      e.smoothing = next;
      e.thresholds.tissue = ModeOfTissue(e.hu);
      e.remainingNoise = NoiseInTissue(e.grid, e.hu, e.thresholds.tissue);
    }
    std::ostringstream text;
    text << "the noise is high (standard deviation " << std::lround(e.noise)
         << " HU); the volume was smoothed with a sigma of " << std::lround(10.0 * e.smoothing) / 10.0
         << " mm before it was segmented";
    m_Result.warnings.push_back(text.str());
  }

  void
  AddFluidWithoutGas()
  {
    for (const auto & found : TakeFluidWithoutGas(m_Evidence))
    {
      std::ostringstream text;
      text << std::lround(found.ml) << " ml of tagged fluid without gas around (" << std::lround(found.centre[0])
           << ", " << std::lround(found.centre[1]) << ", " << std::lround(found.centre[2])
           << ") mm are taken for colon, as no small bowel is so wide";
      m_Result.warnings.push_back(text.str());
    }
  }

  void
  SetGasThresholds(double gas)
  {
    auto & t = m_Evidence.thresholds;
    t.gas = gas;
    t.gasSeed = gas + SeedShareOfGas * (t.tissue - gas);
    t.gasBoundary = 0.5 * (gas + t.tissue);
  }

  /** The gas voxels at the seed points, or within SeedReach of them; points in no gas must lie in bright matter. */
  std::vector<std::array<int, 3>>
  GasSeeds()
  {
    std::vector<std::array<int, 3>> seeds;
    for (const auto & point : m_Options.seedPoints)
    {
      const auto   voxel = this->SeedVoxel(point);
      const auto & grid = m_Evidence.grid;
      const float  value = m_Evidence.hu[grid.Index(voxel[0], voxel[1], voxel[2])];
      if (value < m_Evidence.thresholds.gasSeed)
      {
        seeds.push_back(voxel);
      }
      else
      {
        m_Evidence.brightSeeds.push_back(voxel);
      }
    }
    return seeds;
  }

  /** The most extreme voxel, gas or bright, within SeedReach of a point. */
  std::array<int, 3>
  SeedVoxel(const Point<double, 3> & point) const
  {
    std::ostringstream name;
    name << "the seed point " << point[0] << ',' << point[1] << ',' << point[2];
    const auto &             grid = m_Evidence.grid;
    const Eigen::Vector3d    x = grid.VoxelOf(Eigen::Vector3d(point[0], point[1], point[2]));
    const std::array<int, 3> v{
      { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])), static_cast<int>(std::lround(x[2])) }
    };
    RequireUsage(x.allFinite() && grid.Holds(v[0], v[1], v[2]), name.str() + " lies outside the image");
    std::array<int, 3> best = v;
    double             least = m_Evidence.thresholds.gasSeed;
    double             most = m_Evidence.thresholds.tissue + 150.0;
    bool               found = false;
    const VoxelBox     box = grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, SeedReach);
    for (int pass = 0; pass < 2 && !found; ++pass)
    {
      for (int k = box.low[2]; k < box.high[2]; ++k)
      {
        for (int j = box.low[1]; j < box.high[1]; ++j)
        {
          for (int i = box.low[0]; i < box.high[0]; ++i)
          {
            const double value = m_Evidence.hu[grid.Index(i, j, k)];
            if (pass == 0 ? value < least : value > most)
            {
              (pass == 0 ? least : most) = value;
              best = { { i, j, k } };
              found = true;
            }
          }
        }
      }
    }
    RequireUsage(
      found, name.str() + " lies in neither gas nor bright fluid; give a point inside the colon's lumen in LPS, mm");
    return best;
  }

  void
  FindGasPieces()
  {
    auto &     e = m_Evidence;
    const auto seeds = this->GasSeeds();
    e.gas = FindGas(e.grid, e.hu, e.thresholds.gasSeed, seeds);
    this->Progress(0.3);
    MeasureDepth(e.grid, e.hu, e.gas);
    ChooseCore(e);
    this->MeasureGas();
    m_GasSeeds = seeds;
    this->KeepSeeds();
    this->Progress(0.45);
  }

  /** The pieces at seed points are colon. */
  void
  KeepSeeds()
  {
    for (const auto & seed : m_GasSeeds)
    {
      const auto run = m_Evidence.gas.set.Find(seed[0], seed[1], seed[2]);
      const int  piece = m_Evidence.gas.labels.ofRun[run];
      m_Evidence.isColon[piece] = m_Evidence.isCandidate[piece] = piece > 0;
    }
  }

  /** Typical gas is what lies deep inside the core. */
  void
  MeasureGas()
  {
    double sum = 0.0;
    double ml = 0.0;
    for (std::size_t p = 1; p < m_Evidence.gas.pieces.size(); ++p)
    {
      if (m_Evidence.isColon[p])
      {
        sum += m_Evidence.gas.pieces[p].inside * m_Evidence.gas.pieces[p].ml;
        ml += m_Evidence.gas.pieces[p].ml;
      }
    }
    if (ml > 0.0)
    {
      const double seed = m_Evidence.thresholds.gasSeed;
      this->SetGasThresholds(sum / ml);
      m_Evidence.thresholds.gasSeed = seed; // the pieces stay what they are
    }
  }

  std::vector<Level>
  LevelsAlong(const Eigen::Vector3d & gravity) const
  {
    const auto & e = m_Evidence;
    const Fall   fall(e.grid, gravity);
    const auto   floors = FloorsOfGas(e.grid, e.hu, e.gas.set, e.gas.labels, e.isCandidate, fall, e.thresholds);
    return FindLevels(e.grid, e.hu, floors, fall, e.thresholds.tissue);
  }

  void
  FindGravity()
  {
    const auto         given = GravityOfPatientPosition(m_Options.patientPosition);
    double             best = 0.0;
    double             areaOfGiven = 0.0;
    Vector<double, 3>  clearest;
    std::vector<Level> levelsOfClearest;
    for (const char * name : { "supine", "prone", "leftDecubitus", "rightDecubitus" })
    {
      const auto gravity = *GravityOfPatientPosition(name);
      auto       levels = this->LevelsAlong({ gravity[0], gravity[1], gravity[2] });
      double     area = 0.0;
      for (const auto & level : levels)
      {
        area += level.area;
      }
      if (given && *given == gravity)
      {
        areaOfGiven = area;
        m_Evidence.levels = levels;
      }
      if (area > best)
      {
        best = area;
        clearest = gravity;
        levelsOfClearest.swap(levels);
      }
    }
    const bool isClear = best >= ClearLevels && best > ClearRatio * areaOfGiven;
    m_Result.gravity = given ? *given : isClear ? clearest : *GravityOfPatientPosition("supine");
    m_Result.gravitySource = given     ? ColonGravitySource::PatientPosition
                             : isClear ? ColonGravitySource::Levels
                                       : ColonGravitySource::Assumed;
    if (!given)
    {
      m_Evidence.levels = isClear ? levelsOfClearest : this->LevelsAlong({ 0.0, 1.0, 0.0 });
    }
    this->WarnOfGravity(given && isClear && !(clearest == *given), clearest, best);
    m_Evidence.gravity = Eigen::Vector3d(m_Result.gravity[0], m_Result.gravity[1], m_Result.gravity[2]);
    this->Progress(0.55);
  }

  void
  WarnOfGravity(bool contradicts, const Vector<double, 3> & clearest, double area)
  {
    if (contradicts)
    {
      m_Result.warnings.push_back("the patient position \"" + m_Options.patientPosition +
                                  "\" contradicts the fluid levels in the data: " + std::to_string(std::lround(area)) +
                                  " mm^2 of flat levels say " + NameOfGravity(clearest) +
                                  "; the position given was used");
    }
    if (m_Result.gravitySource == ColonGravitySource::Assumed)
    {
      m_Result.warnings.push_back(
        "no patient position is given and the data show no clear fluid levels; supine is assumed");
    }
  }

  void
  DecideLabels()
  {
    m_Result.labels = EmptyLabels(m_Image);
    if (!BoxOfColon(m_Evidence).IsEmpty())
    {
      const LumenVoxels voxels = DecideVoxels(m_Image, m_Evidence);
      this->Progress(0.9);
      WriteLabels(m_Image, voxels, m_Result);
      DescribePieces(voxels, m_Result);
      DescribeLevels(m_Evidence, voxels, m_Result);
      DescribeOtherBright(voxels, m_Result);
    }
    DescribeRest(m_Evidence, m_Result);
    JudgeLumen(m_Evidence, m_Result);
  }

  const ColonImage *              m_Image;
  const ColonLumenOptions &       m_Options;
  ColonEvidence                   m_Evidence;
  ColonLumen                      m_Result;
  std::vector<std::array<int, 3>> m_GasSeeds;
};
} // namespace

ColonLumen
SegmentColonLumen(const Image<float, 3> * ct, const ColonLumenOptions & options)
{
  return LumenSegmentation(ct, options).Run();
}
} // namespace itk
