#include "shapetonColonLumenSegmentation.h"

#include "shapetonColonPieces.h"
#include "shapetonColonGravity.h"
#include "shapetonTaggedPools.h"
#include "shapetonColonEvidence.h"
#include "shapetonLumenReport.h"
#include "shapetonColonVolume.h"
#include "shapetonLumenVoxels.h"
#include "shapetonLungEvidence.h"
#include "shapetonPlaceInWords.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shapeton
{
namespace
{
constexpr double   GasByDefinition = -1000.0; // HU
constexpr double   SeedShareOfGas = 0.2;      // fraction of the range from gas to tissue
const char * const asColon = " are classified as colon: no small bowel is that wide";
const char * const asRectum = " are classified as rectum or sigmoid: no other colon is near the anus";
const char * const asCatheter = ": a rectal catheter, which was filled in";
const char * const asTube = ": it may be a catheter; the evidence is inconclusive";
constexpr double   TolerableNoise = 50.0; // a quarter of the range from gas to its seed threshold

class LumenSegmentation
{
public:
  LumenSegmentation(const ColonImage * ct, const ColonLumenSettings & options)
    : m_Image(ct), m_Options(options), m_Position(PatientPositionOf(ct, options.position))
  {}

  ColonLumen
  Run()
  {
    this->CheckInput();
    this->Load();
    this->FindGasPieces();
    FindGravity(m_Position, m_Evidence, m_Result);
    m_Options.progress(0.55);
    MeasureFluid(m_Evidence);
    this->ReviewGas();
    this->KeepSeeds();
    MeasureFluid(m_Evidence);
    AddTiltedLevels(m_Evidence);
    FindBright(m_Evidence);
    this->AddFluidWithoutGas();
    m_Options.progress(0.6);
    this->DecideLabels();
    m_Options.progress(1.0);
    return std::move(m_Result);
  }

private:
  void
  CheckInput() const
  {
    const auto size = m_Image->GetBufferedRegion().GetSize();
    for (int a = 0; a < 3; ++a)
    {
      if (size[a] < 8)
      {
        throw InputError("the image has " + std::to_string(size[a]) + " voxels along an axis; at least 8 are required");
      }
    }
    GivenGravity(m_Position);
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
    m_Options.progress(0.1);
    if (e.noise > TolerableNoise)
    {
      this->Smooth();
    }
    constexpr float leastOfBody = -400.0F; // HU; chosen between lung and fat
    e.bodyMl =
      e.grid.VoxelVolume() * 1e-3 * std::count_if(e.hu.begin(), e.hu.end(), [](float v) { return v > leastOfBody; });
    this->SetGasThresholds(GasByDefinition);
    m_Options.progress(0.2);
  }

  /** Increases smoothing until the noise is tolerable. */
  void
  Smooth()
  {
    constexpr double step = 0.3, most = 0.85; // mm, standard deviation
    auto &           e = m_Evidence;
    while (e.remainingNoise > TolerableNoise && e.smoothing < most)
    {
      const double next = e.smoothing + step;
      SmoothVoxels(e.grid, e.hu, std::sqrt(next * next - e.smoothing * e.smoothing));
      e.smoothing = next;
      e.thresholds.tissue = ModeOfTissue(e.hu);
      e.remainingNoise = NoiseInTissue(e.grid, e.hu, e.thresholds.tissue);
    }
    std::ostringstream text;
    text << "the image noise is high (standard deviation " << std::lround(e.noise)
         << " HU); the volume was smoothed with sigma " << InTenths(e.smoothing) << " mm before segmentation";
    m_Result.warnings.push_back(text.str());
  }

  void
  ReviewGas()
  {
    for (const int piece : ReviewCore(m_Evidence))
    {
      const GasPiece & gas = m_Evidence.gas.pieces[piece];
      m_Result.warnings.push_back(std::to_string(std::lround(gas.ml)) + " ml of gas around " +
                                  PlaceInWords(gas.center) + asRectum);
    }
  }

  void
  AddFluidWithoutGas()
  {
    for (const auto & found : TakeFluidWithoutGas(m_Evidence))
    {
      m_Result.warnings.push_back(std::to_string(std::lround(found.ml)) + " ml of tagged fluid without gas around " +
                                  PlaceInWords(found.center) + (found.isRectum ? asRectum : asColon));
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

  void
  FindGasPieces()
  {
    auto &     e = m_Evidence;
    LumenSeeds seeds = FindSeedVoxels(e, m_Options.seedPoint);
    m_GasSeeds = std::move(seeds.gas);
    e.brightSeeds = std::move(seeds.bright);
    e.gas = FindGas(e.grid, e.hu, e.thresholds.gasSeed, m_GasSeeds);
    m_Options.progress(0.3);
    MeasureDepth(e.grid, e.hu, e.gas);
    ChooseCore(e);
    this->MeasureGas();
    this->KeepSeeds();
    m_Options.progress(0.45);
  }

  /** Marks pieces at seed points as colon; throws if one of them is lung. */
  void
  KeepSeeds()
  {
    for (const auto & seed : m_GasSeeds)
    {
      const auto run = m_Evidence.gas.set.Find(seed[0], seed[1], seed[2]);
      const int  piece = m_Evidence.gas.labels.ofRun[run];
      RequireParameter(!m_Evidence.lung[piece].IsLung(),
                       "the seed point at " +
                         PlaceInWords(m_Evidence.grid.Position(Eigen::Vector3d(seed[0], seed[1], seed[2]))) +
                         " is in lung; give a point inside the lumen of the colon, in LPS, mm");
      m_Evidence.isColon[piece] = m_Evidence.isCandidate[piece] = piece > 0;
    }
  }

  /** Estimates typical gas deep inside the core pieces. */
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
      m_Evidence.thresholds.gasSeed = seed; // the pieces are unchanged
    }
  }

  void
  DecideLabels()
  {
    m_Result.labels = NewImageOn<ColonLumen::LabelImageType>(m_Image, true);
    if (!BoxOfColon(m_Evidence).IsEmpty())
    {
      const LumenVoxels voxels = DecideVoxels(m_Image, m_Evidence);
      this->ReportCatheter(voxels.catheter);
      m_Options.progress(0.9);
      WriteLabels(m_Image, voxels, m_Result);
      DescribePieces(voxels, m_Result);
      DescribeLevels(m_Evidence, voxels, m_Result);
      DescribeOtherBright(voxels, m_Result);
    }
    DescribeRest(m_Evidence, m_Result);
    JudgeLumen(m_Evidence, m_Result);
  }

  void
  ReportCatheter(const std::optional<RectalCatheter> & catheter)
  {
    m_Result.catheter = catheter;
    if (catheter)
    {
      const auto & axis = catheter->axis;
      m_Result.warnings.push_back("a tube of " + InTenths(catheter->outerDiameter) +
                                  " mm was found in the rectum from " + PlaceInWords(axis.front()) + " to " +
                                  PlaceInWords(axis.back()) + (catheter->isSure ? asCatheter : asTube));
    }
  }

  const ColonImage *              m_Image;
  const ColonLumenSettings &      m_Options;
  const std::string               m_Position;
  ColonEvidence                   m_Evidence;
  ColonLumen                      m_Result;
  std::vector<std::array<int, 3>> m_GasSeeds;
};
} // namespace

ColonLumen
SegmentColonLumen(const itk::Image<float, 3> * ct, const ColonLumenSettings & options)
{
  return LumenSegmentation(ct, options).Run();
}

std::string
FailureOfMask(const itk::Image<float, 3> * ct, const itk::Image<unsigned char, 3> * mask)
{
  constexpr float            lungBelow = -600.0F; // HU; includes lung at quiet breathing
  constexpr double           leastMl = 20.0;      // minimum volume of a classified piece
  constexpr double           mostly = 0.5;        // minimum fraction of lung in the gas of a rejected mask
  const ColonGrid            grid = GridOfImage(ct);
  const VoxelValues          hu = LoadVoxels(ct, grid);
  std::vector<unsigned char> isGas(grid.NumberOfVoxels());
  ForEachVoxel(ct, grid, [&](std::size_t from, std::size_t to) {
    isGas[to] = mask->GetBufferPointer()[from] != 0 && hu[to] < lungBelow;
  });
  GasOfVolume gas;
  gas.set = CollectRuns(grid, [&](std::size_t p) { return isGas[p] != 0; });
  gas.labels = LabelRuns(gas.set);
  gas.isOutsideRun.assign(gas.set.runs.size(), 0);
  for (const RunPiece & measured : PiecesOfRuns(gas.set, gas.labels))
  {
    gas.pieces.emplace_back();
    gas.pieces.back().box = measured.box;
    gas.pieces.back().ml = grid.VoxelVolume() * 1e-3 * static_cast<double>(measured.voxels);
  }
  const double     tissue = ModeOfTissue(hu);
  const LungSearch lungs(grid, hu, gas, tissue, NoiseInTissue(grid, hu, tissue));
  double           all = 0.0;
  double           lung = 0.0;
  for (int p = 1; p <= gas.labels.number; ++p)
  {
    all += gas.pieces[p].ml;
    lung += gas.pieces[p].ml >= leastMl && lungs.Measure(p).IsLung() ? gas.pieces[p].ml : 0.0;
  }
  return lung <= mostly * all
           ? ""
           : "no distended colon found: the mask is lung, " + std::to_string(std::lround(lung)) + " of its " +
               std::to_string(std::lround(all)) + " ml of gas; give a mask of the lumen of the colon";
}
} // namespace shapeton
