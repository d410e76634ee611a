#include "shapetonSurfaceRaster.h"

#include "shapetonLighting.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr int rowsOfBand = 36; // pixels; one task each, chosen

/** The first sample with its center at or after a position, and the last one at or before it. */
int
FirstSample(int place)
{
  return (place - subsamples / 2 + subsamples - 1) >> 6;
}

int
LastSample(int place)
{
  return (place - subsamples / 2) >> 6;
}

static_assert(subsamples == 1 << 6, "the shifts above");

/** Faces that overlap each band, in order. */
class BandFaces
{
public:
  BandFaces(const ScreenPart & part, int columns, int bands) : m_Begin(bands + 1, 0)
  {
    const auto forEach = [&](const auto & visit) {
      for (Eigen::Index face = 0; face < part.faces->rows(); ++face)
      {
        int first;
        int last;
        if (BandsOf(part, face, columns, bands, first, last))
        {
          for (int band = first; band <= last; ++band)
          {
            visit(band, static_cast<int>(face));
          }
        }
      }
    };
    forEach([&](int band, int) { ++m_Begin[band + 1]; });
    for (int band = 0; band < bands; ++band)
    {
      m_Begin[band + 1] += m_Begin[band];
    }
    m_Faces.resize(m_Begin[bands]);
    std::vector<std::size_t> next(m_Begin.begin(), m_Begin.end() - 1);
    forEach([&](int band, int face) { m_Faces[next[band]++] = face; });
  }

  const int *
  Begin(int band) const
  {
    return m_Faces.data() + m_Begin[band];
  }
  const int *
  End(int band) const
  {
    return m_Faces.data() + m_Begin[band + 1];
  }

private:
  /** Returns false if the face covers no sample. */
  static bool
  BandsOf(const ScreenPart & part, Eigen::Index face, int columns, int bands, int & first, int & last)
  {
    const ScreenVertex & a = part.vertices[(*part.faces)(face, 0)];
    const ScreenVertex & b = part.vertices[(*part.faces)(face, 1)];
    const ScreenVertex & c = part.vertices[(*part.faces)(face, 2)];
    const int            left = FirstSample(std::min({ a.x, b.x, c.x }));
    const int            right = LastSample(std::max({ a.x, b.x, c.x }));
    const int            top = FirstSample(std::min({ a.y, b.y, c.y }));
    const int            bottom = LastSample(std::max({ a.y, b.y, c.y }));
    if (left > right || top > bottom || right < 0 || left >= columns || bottom < 0 || top >= bands * rowsOfBand)
    {
      return false;
    }
    first = std::max(top, 0) / rowsOfBand;
    last = std::min(bottom / rowsOfBand, bands - 1);
    return true;
  }

  std::vector<std::size_t> m_Begin;
  std::vector<int>         m_Faces;
};

/** A face on the screen, with interpolation at its samples. */
class ScreenFace
{
public:
  ScreenFace(const ScreenPart & part, int face)
  {
    for (int k = 0; k < 3; ++k)
    {
      m_Corner[k] = &part.vertices[(*part.faces)(face, k)];
    }
    m_Area = Edge(0, 1, m_Corner[2]->x, m_Corner[2]->y);
    m_IsFront = m_Area < 0; // y runs downwards
  }

  bool
  IsFront() const
  {
    return m_IsFront;
  }

  /** Calls visit(row, column, w1, w2) for the samples inside, with the weights of the second and third corner. */
  template <typename TVisit>
  void
  ForEachSample(int firstRow, int endRow, int columns, const TVisit & visit) const
  {
    if (m_Area == 0)
    {
      return;
    }
    const int left = std::max(FirstSample(std::min({ m_Corner[0]->x, m_Corner[1]->x, m_Corner[2]->x })), 0);
    const int right = std::min(LastSample(std::max({ m_Corner[0]->x, m_Corner[1]->x, m_Corner[2]->x })), columns - 1);
    const int top = std::max(FirstSample(std::min({ m_Corner[0]->y, m_Corner[1]->y, m_Corner[2]->y })), firstRow);
    const int bottom = std::min(LastSample(std::max({ m_Corner[0]->y, m_Corner[1]->y, m_Corner[2]->y })), endRow - 1);
    const std::int64_t          sign = m_IsFront ? -1 : 1;
    const float                 scale = 1.0F / static_cast<float>(sign * m_Area);
    std::array<std::int64_t, 3> start; // opposite to each corner, at the first sample of a row
    std::array<std::int64_t, 3> stepX;
    std::array<std::int64_t, 3> stepY;
    std::array<std::int64_t, 3> least;
    for (int k = 0; k < 3; ++k)
    {
      const int a = (k + 1) % 3;
      const int b = (k + 2) % 3;
      start[k] = sign * Edge(a, b, left * subsamples + subsamples / 2, top * subsamples + subsamples / 2);
      stepX[k] = -sign * subsamples * (std::int64_t{ m_Corner[b]->y } - m_Corner[a]->y);
      stepY[k] = sign * subsamples * (std::int64_t{ m_Corner[b]->x } - m_Corner[a]->x);
      // A sample on an edge belongs to one of the two faces that share it.
      least[k] = stepX[k] > 0 || (stepX[k] == 0 && stepY[k] > 0) ? 0 : 1;
    }
    for (int row = top; row <= bottom; ++row)
    {
      std::array<std::int64_t, 3> e = start;
      for (int column = left; column <= right; ++column)
      {
        if (e[0] >= least[0] && e[1] >= least[1] && e[2] >= least[2])
        {
          visit(row, column, static_cast<float>(e[1]) * scale, static_cast<float>(e[2]) * scale);
        }
        for (int k = 0; k < 3; ++k)
        {
          e[k] += stepX[k];
        }
      }
      for (int k = 0; k < 3; ++k)
      {
        start[k] += stepY[k];
      }
    }
  }

  float
  DepthAt(float w1, float w2) const
  {
    return m_Corner[0]->z + w1 * (m_Corner[1]->z - m_Corner[0]->z) + w2 * (m_Corner[2]->z - m_Corner[0]->z);
  }

  /** Components to the right, up and towards the viewer, flipped to face the viewer; unit length. */
  std::array<float, 3>
  NormalAt(float w1, float w2) const
  {
    const float          w0 = 1.0F - w1 - w2;
    std::array<float, 3> normal;
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = w0 * m_Corner[0]->normal[i] + w1 * m_Corner[1]->normal[i] + w2 * m_Corner[2]->normal[i];
    }
    const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (length < 1e-3F)
    {
      return { { 0.0F, 0.0F, 1.0F } };
    }
    const float scale = (m_IsFront ? 1.0F : -1.0F) / length;
    return { { scale * normal[0], scale * normal[1], scale * normal[2] } };
  }

private:
  std::int64_t
  Edge(int a, int b, int x, int y) const
  {
    return (std::int64_t{ m_Corner[b]->x } - m_Corner[a]->x) * (std::int64_t{ y } - m_Corner[a]->y) -
           (std::int64_t{ m_Corner[b]->y } - m_Corner[a]->y) * (std::int64_t{ x } - m_Corner[a]->x);
  }

  std::array<const ScreenVertex *, 3> m_Corner;
  std::int64_t                        m_Area;
  bool                                m_IsFront;
};

std::array<float, 3>
ColorAt(const ScreenPart & part, int face, float w1, float w2)
{
  std::array<float, 3> color;
  if (part.vertexColors.empty() || !part.faceColors.empty())
  {
    const RGBColor & one = part.faceColors.empty() ? part.color : part.faceColors[face];
    std::copy(one.Begin(), one.End(), color.begin());
    return color;
  }
  const RGBColor & a = part.vertexColors[(*part.faces)(face, 0)];
  const RGBColor & b = part.vertexColors[(*part.faces)(face, 1)];
  const RGBColor & c = part.vertexColors[(*part.faces)(face, 2)];
  for (int i = 0; i < 3; ++i)
  {
    color[i] = (1.0F - w1 - w2) * a[i] + w1 * b[i] + w2 * c[i];
  }
  return color;
}

/** Lit color of a point on a face. */
std::array<float, 3>
ShadeAt(const ScreenPart & part, int face, float w1, float w2, const std::array<float, 3> & normal)
{
  // Right, up, towards the viewer; see Lighting::DirectionToLight. The half vector is the mean with (0, 0, 1).
  constexpr float toLight[3] = { -0.33686077F, 0.42107596F, 0.84215192F };
  constexpr float halfway[3] = { -0.17549822F, 0.21937277F, 0.95972702F };
  // Wrap lighting shows the shape of surfaces facing away from the light.
  constexpr float around = 0.35F;
  const auto      product = [&normal](const float(&direction)[3]) {
    return normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2];
  };
  const Lighting light =
    Lighting::Of(std::max((product(toLight) + around) / (1.0F + around), 0.0F), std::max(product(halfway), 0.0F));
  std::array<float, 3> color = ColorAt(part, face, w1, w2);
  for (float & channel : color)
  {
    channel = std::clamp(channel * light.brightness + 255.0F * light.highlight, 0.0F, 255.0F);
  }
  return color;
}

/** Nearest opaque surface in a sample. */
struct SolidSample
{
  float depth{ std::numeric_limits<float>::infinity() };
  int   part{ -1 };
  int   face{ 0 };
  float w1{ 0.0F };
  float w2{ 0.0F };
};

/** Transparent faces in front of the opaque surface. */
struct VeilSample
{
  float color[3]{ 0.0F, 0.0F, 0.0F };
  float weight{ 0.0F };
  float transmittance{ 1.0F };
};

/** \class BandPainter
 * \brief Draws the rows of one band. */
class BandPainter
{
public:
  BandPainter(const std::vector<ScreenPart> & parts, const std::vector<BandFaces> & faces, int columns, int band)
    : m_Parts(parts)
    , m_Faces(faces)
    , m_Columns(columns)
    , m_Band(band)
    , m_FirstRow(band * rowsOfBand)
    , m_Solid(static_cast<std::size_t>(columns) * rowsOfBand)
  {}

  void
  Paint(int rows, SeenSample * samples)
  {
    for (std::size_t part = 0; part < m_Parts.size(); ++part)
    {
      if (m_Parts[part].opacity >= 1.0F)
      {
        this->PaintSolid(static_cast<int>(part));
      }
    }
    for (std::size_t part = 0; part < m_Parts.size(); ++part)
    {
      if (m_Parts[part].opacity < 1.0F)
      {
        m_Veil.resize(m_Solid.size());
        this->PaintVeil(static_cast<int>(part));
      }
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows) * m_Columns; ++i)
    {
      samples[i] = this->SeenIn(i);
    }
  }

private:
  template <typename TVisit>
  void
  ForEachSample(int part, const TVisit & visit)
  {
    for (const int * face = m_Faces[part].Begin(m_Band); face != m_Faces[part].End(m_Band); ++face)
    {
      const ScreenFace screen(m_Parts[part], *face);
      screen.ForEachSample(
        m_FirstRow, m_FirstRow + rowsOfBand, m_Columns, [&](int row, int column, float w1, float w2) {
          visit(screen, *face, static_cast<std::size_t>(row - m_FirstRow) * m_Columns + column, w1, w2);
        });
    }
  }

  void
  PaintSolid(int part)
  {
    this->ForEachSample(part, [&](const ScreenFace & screen, int face, std::size_t sample, float w1, float w2) {
      const float depth = screen.DepthAt(w1, w2);
      if (depth < m_Solid[sample].depth)
      {
        m_Solid[sample] = { depth, part, face, w1, w2 };
      }
    });
  }

  void
  PaintVeil(int part)
  {
    this->ForEachSample(part, [&](const ScreenFace & screen, int face, std::size_t sample, float w1, float w2) {
      if (screen.DepthAt(w1, w2) >= m_Solid[sample].depth)
      {
        return;
      }
      const std::array<float, 3> normal = screen.NormalAt(w1, w2);
      // A layer of uniform thickness is denser at grazing angles.
      const float                flat = 1.0F - std::min(std::fabs(normal[2]), 1.0F);
      const float                opacity = m_Parts[part].opacity * (0.25F + 0.75F * flat * flat);
      const std::array<float, 3> color = ColorAt(m_Parts[part], face, w1, w2);
      VeilSample &               veil = m_Veil[sample];
      for (int i = 0; i < 3; ++i)
      {
        veil.color[i] += opacity * color[i];
      }
      veil.weight += opacity;
      veil.transmittance *= 1.0F - opacity;
    });
  }

  SeenSample
  SeenIn(std::size_t i) const
  {
    std::array<float, 4> seen{ { 0.0F, 0.0F, 0.0F, 0.0F } }; // the last one is coverage
    SeenSample           sample;
    float                behind = 1.0F;
    if (!m_Veil.empty() && m_Veil[i].weight > 0.0F)
    {
      const VeilSample & veil = m_Veil[i];
      behind = veil.transmittance;
      for (int k = 0; k < 3; ++k)
      {
        seen[k] = (1.0F - behind) * veil.color[k] / veil.weight;
      }
      seen[3] = 255.0F * (1.0F - behind);
    }
    const SolidSample & solid = m_Solid[i];
    if (solid.part >= 0)
    {
      const ScreenPart & part = m_Parts[solid.part];
      const ScreenFace   screen(part, solid.face);
      const auto         color = ShadeAt(part, solid.face, solid.w1, solid.w2, screen.NormalAt(solid.w1, solid.w2));
      for (int k = 0; k < 3; ++k)
      {
        seen[k] += behind * color[k];
      }
      seen[3] = 255.0F;
      sample.depth = part.hasDepthShading ? solid.depth : sample.depth;
    }
    for (int k = 0; k < 3; ++k)
    {
      sample.color[k] = static_cast<unsigned char>(std::min(seen[k] + 0.5F, 255.0F));
    }
    sample.coverage = static_cast<unsigned char>(std::min(seen[3] + 0.5F, 255.0F));
    return sample;
  }

  const std::vector<ScreenPart> & m_Parts;
  const std::vector<BandFaces> &  m_Faces;
  int                             m_Columns;
  int                             m_Band;
  int                             m_FirstRow;
  std::vector<SolidSample>        m_Solid;
  std::vector<VeilSample>         m_Veil;
};
} // namespace

std::vector<SeenSample>
RasterizeParts(const std::vector<ScreenPart> & parts, unsigned int width, unsigned int height)
{
  const int              columns = static_cast<int>(width) * samplesAlongPixel;
  const int              rows = static_cast<int>(height) * samplesAlongPixel;
  const int              bands = (rows + rowsOfBand - 1) / rowsOfBand;
  std::vector<BandFaces> faces;
  for (const ScreenPart & part : parts)
  {
    faces.emplace_back(part, columns, bands);
  }
  std::vector<SeenSample> samples(static_cast<std::size_t>(columns) * rows);
  ParallelFor(static_cast<std::size_t>(bands), [&](std::size_t band) {
    const auto firstRow = static_cast<int>(band) * rowsOfBand;
    BandPainter(parts, faces, columns, static_cast<int>(band))
      .Paint(std::min(rowsOfBand, rows - firstRow), samples.data() + static_cast<std::size_t>(firstRow) * columns);
  });
  return samples;
}
} // namespace shapeton
