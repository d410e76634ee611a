#include "shapetonFoldMask.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include <cmath>

namespace shapeton
{
namespace
{
using Graph = cv::detail::GCGraph<double>;

/** A cost greater than the sum of all others, which forces a pixel to be wall. */
constexpr double never = 1e9;

class FoldCut
{
public:
  FoldCut(const FoldPicture & picture, const HaustralFoldOptions & options)
    : m_Picture(picture)
    , m_Options(options)
    , m_Graph(static_cast<unsigned int>(picture.Size()), static_cast<unsigned int>(4 * picture.Size()))
  {}

  void
  AddPixels(const CurvatureMixture & mixture)
  {
    for (std::size_t pixel = 0; pixel < m_Picture.Size(); ++pixel)
    {
      const int    vertex = m_Graph.addVtx();
      const double odds = mixture.LogOdds(m_Picture.curvature[pixel]) * m_Picture.AreaOf(pixel);
      const bool   isWall = m_Picture.isWall[pixel] && m_Picture.curvature[pixel] > 0.0F;
      m_Graph.addTermWeights(vertex, isWall ? std::max(odds, 0.0) : 0.0, isWall ? std::max(-odds, 0.0) : never);
    }
  }

  void
  AddNeighbors()
  {
    for (int row = 0; row < m_Picture.rows; ++row)
    {
      const int below = (row + 1) % m_Picture.rows;
      for (int column = 0; column < m_Picture.columns; ++column)
      {
        const std::size_t pixel = m_Picture.Index(column, row);
        this->AddEdge(pixel, m_Picture.Index(column, below));
        if (column + 1 < m_Picture.columns)
        {
          this->AddEdge(pixel, m_Picture.Index(column + 1, row));
        }
      }
    }
  }

  std::vector<char>
  Solve()
  {
    m_Graph.maxFlow();
    std::vector<char> mask(m_Picture.Size());
    for (std::size_t pixel = 0; pixel < mask.size(); ++pixel)
    {
      mask[pixel] = m_Graph.inSourceSegment(static_cast<int>(pixel));
    }
    return mask;
  }

private:
  void
  AddEdge(std::size_t a, std::size_t b)
  {
    const double change = (m_Picture.curvature[a] - m_Picture.curvature[b]) / m_Options.contrast;
    const double side = 0.5 * (m_Picture.scale[a] + m_Picture.scale[b]) * m_Picture.pixelSize;
    const double weight = m_Options.smoothness * side * std::exp(-0.5 * change * change);
    m_Graph.addEdges(static_cast<int>(a), static_cast<int>(b), weight, weight);
  }

  const FoldPicture &         m_Picture;
  const HaustralFoldOptions & m_Options;
  Graph                       m_Graph;
};
} // namespace

std::vector<char>
CutFolds(const FoldPicture & picture, const CurvatureMixture & mixture, const HaustralFoldOptions & options)
{
  FoldCut cut(picture, options);
  cut.AddPixels(mixture);
  cut.AddNeighbors();
  return cut.Solve();
}

std::vector<char>
ThresholdFolds(const FoldPicture & picture, const HaustralFoldOptions & options)
{
  std::vector<char> mask(picture.Size());
  for (std::size_t pixel = 0; pixel < mask.size(); ++pixel)
  {
    const double value = picture.curvature[pixel];
    mask[pixel] = picture.isWall[pixel] && value >= options.publishedLow && value <= options.publishedHigh;
  }
  return mask;
}
} // namespace shapeton
