#include "shapetonLungEvidence.h"

#include "shapetonParallelFor.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
// Measured on clinical CT (median HU above room air, parenchyma, vessels per 100 cm^2): lungs in a chest CT 108, .99,
// 9.5; lung bases 92, .91, 11.7; gas in colons 3 to 38, .03 to .15 (.30 in one piece of 38 ml), 0 to 0.2. The limits
// are halfway between lung and colon.
constexpr double LungExcess = 105.0;      // HU above air; denser gas is always lung
constexpr double ParenchymaExcess = 60.0; // HU above air
constexpr double DensestExcess = 500.0;   // HU above air; lung at full expiration
constexpr double MixedShare = 0.2;        // relative to the variance of a mixture of gas and tissue with the same mean
constexpr double MostlyParenchyma = 0.5;  // sufficient with few vessels
constexpr double FewVessels = 1.5;        // per 100 cm^2
constexpr double SomeParenchyma = 0.2;    // sufficient with many vessels, since emphysema is nearly as dark as air
constexpr double ManyVessels = 4.0;       // per 100 cm^2
constexpr double ShareInPiece = 0.3;      // of a block
constexpr double ShareInside = 0.9;       // of a block
constexpr int    NearBlocks = 2;          // 10 mm
constexpr double LeastSection = 300.0;    // mm^2 of gas in an axial slice
constexpr double LeastVessel = 3.0;       // mm^2
constexpr double LargestVessel = 100.0;   // mm^2; a larger one is a fold or a wall
constexpr float  VesselHU = -500.0F;      // a vessel reaches half of the contrast even when blurred by the scanner
constexpr float  Padding = -1095.0F;      // values outside the reconstruction circle are below

/** Gas area (mm^2) in a slice, and number of tissue islands enclosed by the gas. */
struct SliceCount
{
  double area{ 0.0 };
  int    vessels{ 0 };
};

/** Islands in the gas of a piece in one slice; visited pixels are cleared. */
class SliceIslands
{
public:
  SliceIslands(const unsigned char * gas, int width, int height)
    : m_Width(width), m_Height(height), m_IsOpen(static_cast<std::size_t>(width) * height)
  {
    std::transform(gas, gas + m_IsOpen.size(), m_IsOpen.begin(), [](unsigned char g) { return g == 0; });
    for (int i = 0; i < width; ++i)
    {
      this->Fill(i, 0, 1, [](int, int) {});
      this->Fill(i, height - 1, 1, [](int, int) {});
    }
    for (int j = 0; j < height; ++j)
    {
      this->Fill(0, j, 1, [](int, int) {});
      this->Fill(width - 1, j, 1, [](int, int) {});
    }
  }

  /** Calls `body(i, j)` for the pixels of an island; returns false if none is left. */
  template <typename TBody>
  bool
  Take(int i, int j, const TBody & body)
  {
    return this->Fill(i, j, 2, body);
  }

private:
  /** `reach` 1: 4-connected; 2: 8-connected. */
  template <typename TBody>
  bool
  Fill(int i, int j, int reach, const TBody & body)
  {
    if (!this->Close(i, j))
    {
      return false;
    }
    m_Stack.assign(1, { { i, j } });
    while (!m_Stack.empty())
    {
      const auto place = m_Stack.back();
      m_Stack.pop_back();
      body(place[0], place[1]);
      for (int y = -1; y <= 1; ++y)
      {
        for (int x = -1; x <= 1; ++x)
        {
          const int p = place[0] + x;
          const int q = place[1] + y;
          if (std::abs(x) + std::abs(y) <= reach && p >= 0 && q >= 0 && p < m_Width && q < m_Height &&
              this->Close(p, q))
          {
            m_Stack.push_back({ { p, q } });
          }
        }
      }
    }
    return true;
  }

  bool
  Close(int i, int j)
  {
    char &     isOpen = m_IsOpen[i + static_cast<std::size_t>(j) * m_Width];
    const bool wasOpen = isOpen != 0;
    isOpen = 0;
    return wasOpen;
  }

  int                             m_Width;
  int                             m_Height;
  std::vector<char>               m_IsOpen;
  std::vector<std::array<int, 2>> m_Stack;
};
} // namespace

bool
LungEvidence::IsVascularLung() const
{
  return parenchyma > MostlyParenchyma && vessels > ManyVessels;
}

bool
LungEvidence::IsLung() const
{
  return excess > LungExcess || (parenchyma > MostlyParenchyma && vessels > FewVessels) ||
         (parenchyma > SomeParenchyma && vessels > ManyVessels);
}

double
RoomAir(const ColonGrid & grid, const VoxelValues & hu, const GasOfVolume & gas)
{
  constexpr int         margin = 3;   // voxels; excludes partial volume at the body or the table
  constexpr std::size_t least = 1000; // voxels; chosen: fewer are not representative
  std::vector<float>    values;
  ForEachRun(gas.set, [&](std::size_t r, int j, int k) {
    const VoxelRun run = gas.set.runs[r];
    for (int i = run.begin + margin; gas.isOutsideRun[r] && i < run.end - margin; i += margin)
    {
      const float value = hu[grid.Index(i, j, k)];
      if (value > Padding)
      {
        values.push_back(value);
      }
    }
  });
  constexpr double air = -1000.0, brightestAir = -950.0; // HU
  if (values.size() < least)
  {
    return air;
  }
  return std::clamp<double>(UpperMedian(std::move(values)), air, brightestAir);
}

/** Block statistics of a piece. */
struct LungSearch::Shares
{
  std::size_t         parenchyma{ 0 };
  std::size_t         gas{ 0 };
  std::vector<double> means; ///< of blocks completely inside
};

LungSearch::LungSearch(const ColonGrid &   grid,
                       const VoxelValues & hu,
                       const GasOfVolume & gas,
                       double              tissue,
                       double              noise)
  : m_Grid(grid)
  , m_HU(hu)
  , m_Gas(gas)
  , m_Air(RoomAir(grid, hu, gas))
  , m_Contrast(tissue - m_Air)
  , m_Noise(noise)
  , m_Blocks(MeasureBlocks(grid, hu))
  , m_IsOutside(m_Blocks.grid.NumberOfVoxels(), 0)
{
  ForEachRun(gas.set, [&](std::size_t r, int j, int k) {
    const VoxelRun run = gas.set.runs[r];
    if (gas.isOutsideRun[r] && m_Blocks.HoldRow(j, k))
    {
      const int last = std::min((run.end - 1) / m_Blocks.edge[0], m_Blocks.grid.size[0] - 1);
      for (int i = run.begin / m_Blocks.edge[0]; i <= last; ++i)
      {
        m_IsOutside[m_Blocks.grid.Index(i, j / m_Blocks.edge[1], k / m_Blocks.edge[2])] = 1;
      }
    }
  });
}

LungEvidence
LungSearch::Measure(int piece) const
{
  Shares       shares = this->SharesOf(piece);
  LungEvidence evidence;
  evidence.vessels = this->VesselsIn(piece);
  if (shares.parenchyma + shares.gas > 0)
  {
    evidence.parenchyma = static_cast<double>(shares.parenchyma) / static_cast<double>(shares.parenchyma + shares.gas);
  }
  if (!shares.means.empty())
  {
    evidence.excess = UpperMedian(shares.means) - m_Air;
  }
  return evidence;
}

/** Whether a block is uniform and denser than air; blocks across the border between gas and tissue are not uniform. */
bool
LungSearch::IsParenchyma(std::size_t block) const
{
  const double excess = m_Blocks.mean[block] - m_Air;
  if (m_IsOutside[block] || excess < ParenchymaExcess || excess > DensestExcess)
  {
    return false;
  }
  const double deviation = m_Blocks.deviation[block];
  return deviation * deviation - m_Noise * m_Noise < MixedShare * excess * (m_Contrast - excess);
}

LungSearch::Shares
LungSearch::SharesOf(int piece) const
{
  const VoxelGrid & grid = m_Blocks.grid;
  std::vector<int>  voxels(grid.NumberOfVoxels(), 0);
  const double      ofBlock = static_cast<double>(m_Blocks.edge[0]) * m_Blocks.edge[1] * m_Blocks.edge[2];
  ForEachRun(m_Gas.set, [&](std::size_t r, int j, int k) {
    if (m_Gas.labels.ofRun[r] == piece && m_Blocks.HoldRow(j, k))
    {
      for (int i = m_Gas.set.runs[r].begin; i < std::min(m_Gas.set.runs[r].end, m_Blocks.edge[0] * grid.size[0]); ++i)
      {
        ++voxels[grid.Index(i / m_Blocks.edge[0], j / m_Blocks.edge[1], k / m_Blocks.edge[2])];
      }
    }
  });
  std::vector<char> isNear(voxels.size(), 0);
  for (std::size_t b = 0; b < voxels.size(); ++b)
  {
    if (voxels[b] <= ShareInPiece * ofBlock)
    {
      continue;
    }
    const auto v = grid.Voxel(b);
    for (int k = std::max(0, v[2] - NearBlocks); k <= std::min(grid.size[2] - 1, v[2] + NearBlocks); ++k)
    {
      for (int j = std::max(0, v[1] - NearBlocks); j <= std::min(grid.size[1] - 1, v[1] + NearBlocks); ++j)
      {
        const int begin = std::max(0, v[0] - NearBlocks);
        const int end = std::min(grid.size[0], v[0] + NearBlocks + 1);
        std::fill(&isNear[grid.Index(begin, j, k)], &isNear[grid.Index(begin, j, k)] + (end - begin), 1);
      }
    }
  }
  Shares shares;
  for (std::size_t b = 0; b < voxels.size(); ++b)
  {
    shares.parenchyma += isNear[b] && this->IsParenchyma(b);
    shares.gas += voxels[b] > ShareInside * ofBlock && m_Blocks.mean[b] - m_Air <= ParenchymaExcess;
    if (voxels[b] == static_cast<int>(ofBlock))
    {
      shares.means.push_back(m_Blocks.mean[b]);
    }
  }
  return shares;
}

double
LungSearch::VesselsIn(int piece) const
{
  const VoxelBox          box = m_Grid.Widened(m_Gas.pieces[piece].box, 1e-6);
  const ColonGrid         part = m_Grid.Part(box);
  const auto              mask = MaskOfRuns(m_Grid, m_Gas.set, m_Gas.labels, piece, box);
  const double            pixel = m_Grid.spacing[0] * m_Grid.spacing[1];
  std::vector<SliceCount> counts(part.size[2]);
  ParallelFor(counts.size(), [&](std::size_t k) {
    const unsigned char * slice = &mask[k * part.stride[2]];
    SliceCount &          count = counts[k];
    count.area = pixel * static_cast<double>(std::count(slice, slice + part.stride[2], 1));
    if (count.area < LeastSection)
    {
      count.area = 0.0;
      return;
    }
    SliceIslands islands(slice, part.size[0], part.size[1]);
    for (int j = 0; j < part.size[1]; ++j)
    {
      for (int i = 0; i < part.size[0]; ++i)
      {
        float      brightest = -1100.0F;
        int        pixels = 0;
        const auto measure = [&](int p, int q) {
          ++pixels;
          brightest =
            std::max(brightest, m_HU[m_Grid.Index(p + box.low[0], q + box.low[1], static_cast<int>(k) + box.low[2])]);
        };
        count.vessels += islands.Take(i, j, measure) && brightest > VesselHU && pixels * pixel >= LeastVessel &&
                         pixels * pixel < LargestVessel;
      }
    }
  });
  double area = 0.0;
  double vessels = 0.0;
  for (const SliceCount & count : counts)
  {
    area += count.area;
    vessels += count.vessels;
  }
  constexpr double unitArea = 1e4; // mm^2; 100 cm^2
  return area > 0.0 ? unitArea * vessels / area : 0.0;
}
} // namespace shapeton
