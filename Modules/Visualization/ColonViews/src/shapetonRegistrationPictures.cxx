#include "shapetonRegistrationPictures.h"

#include "shapetonAlignedColons.h"
#include "shapetonColonLandmarkPictures.h"
#include "shapetonFlatColonOverlay.h"
#include "shapetonFlatColonPage.h"

#include <algorithm>
#include <array>
#include <map>

namespace shapeton
{
namespace
{
const RGBColor colorOfAlone = MakeColor(24, 24, 28);
const RGBColor colorOfDoubt = MakeColor(230, 20, 20);
constexpr char seenFrom[] = "Seen from the lumen, rectum at the left. For research use; not a diagnosis.";

/** Colors of consecutive folds differ, and contrast with the mucosa, black and red. */
RGBColor
ColorOfPair(std::size_t pair)
{
  static const std::array<RGBColor, 5> colors{ MakeColor(0, 229, 255),
                                               MakeColor(255, 255, 255),
                                               MakeColor(40, 90, 255),
                                               MakeColor(60, 235, 70),
                                               MakeColor(255, 225, 0) };
  return colors[pair % colors.size()];
}

bool
IsDoubtful(const MatchedFolds & match)
{
  return !match.IsFollowed() || match.verdict == FoldVerdict::Wrong;
}

std::map<int, const HaustralFold *>
FoldsByLabel(const ColonPositionFiles & files)
{
  std::map<int, const HaustralFold *> folds;
  for (const HaustralFold & fold : files.position.folds)
  {
    folds[fold.label] = &fold;
  }
  return folds;
}

/** Which point of a fold was matched: 0 and 1 for an end, -1 for its center, that is, the whole fold. */
int
MatchedEnd(const HaustralFold & fold, const Eigen::Vector3d & point)
{
  const double center = (fold.center - point).norm();
  const double first = (fold.ends[0] - point).norm();
  const double second = (fold.ends[1] - point).norm();
  return center <= std::min(first, second) ? -1 : first <= second ? 0 : 1;
}

/** Draws crests, or dots at matched ends, on both strips, and collects the links between them. */
class FoldDrawing
{
public:
  FoldDrawing(const RegistrationParts & parts, const AlignedColons & colons, FlatColonPair & pair)
    : m_Parts(parts), m_Colons(colons), m_Pair(pair)
  {}

  void
  Draw(Picture * upper, Picture * lower)
  {
    std::map<int, const HaustralFold *> supine = FoldsByLabel(*m_Parts.supine);
    std::map<int, const HaustralFold *> prone = FoldsByLabel(*m_Parts.prone);
    std::vector<FlatDot>                upperDots;
    std::vector<FlatDot>                lowerDots;
    const auto &                        matches = m_Parts.results->matches;
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
      const auto from = supine.find(matches[i].supineFold);
      const auto to = prone.find(matches[i].proneFold);
      if (from == supine.end() || to == prone.end())
      {
        continue; // from another run of ColonFolds: shown as unmatched
      }
      const RGBColor color = IsDoubtful(matches[i]) ? colorOfDoubt : ColorOfPair(i);
      const int      end = MatchedEnd(*from->second, matches[i].supinePoint);
      if (end >= 0)
      {
        const int other = std::max(0, MatchedEnd(*to->second, matches[i].pronePoint));
        upperDots.push_back({ from->second->endUv[end], color, radiusOfEnds });
        lowerDots.push_back({ m_Colons.InSupineFrame(to->second->endUv[other]), color, radiusOfEnds });
        m_Pair.links.push_back({ upperDots.back().uv, lowerDots.back().uv, color });
        continue;
      }
      this->DrawCrest(upper, *from->second, false, color, 3.0);
      this->DrawCrest(lower, *to->second, true, color, 3.0);
      m_Pair.links.push_back({ from->second->centerUv, m_Colons.InSupineFrame(to->second->centerUv), color });
      supine.erase(from);
      prone.erase(to);
    }
    this->DrawAlone(supine, prone, upper, lower);
    this->DrawDots(upper, upperDots);
    this->DrawDots(lower, lowerDots);
  }

private:
  static constexpr double radiusOfEnds = 4.0; // pixels

  void
  DrawAlone(const std::map<int, const HaustralFold *> & supine,
            const std::map<int, const HaustralFold *> & prone,
            Picture *                                   upper,
            Picture *                                   lower) const
  {
    for (const auto & [label, fold] : supine)
    {
      this->DrawCrest(upper, *fold, false, colorOfAlone, 2.0);
    }
    for (const auto & [label, fold] : prone)
    {
      this->DrawCrest(lower, *fold, true, colorOfAlone, 2.0);
    }
  }

  void
  DrawDots(Picture * strip, const std::vector<FlatDot> & dots) const
  {
    for (const FlatDot & dot : dots)
    {
      DrawFlatDot(strip, m_Colons.Grid(), dot);
    }
  }

  void
  DrawCrest(Picture * strip, const HaustralFold & fold, bool isProne, const RGBColor & color, double thickness) const
  {
    FlatLine line{ {}, color, thickness };
    for (const Eigen::Vector2d & uv : { fold.endUv[0], fold.centerUv, fold.endUv[1] })
    {
      line.places.push_back(isProne ? m_Colons.InSupineFrame(uv) : uv);
    }
    DrawFlatLine(strip, m_Colons.Grid(), line);
  }

  const RegistrationParts & m_Parts;
  const AlignedColons &     m_Colons;
  FlatColonPair &           m_Pair;
};

Picture::Pointer
PaintRelief(const FlatColonGrid & grid, const FlatColonAxis & axis)
{
  return PaintFlatRelief(grid, axis);
}

Picture::Pointer
PaintCurvature(const FlatColonGrid & grid, const FlatColonAxis & axis)
{
  return PaintFlatCurvature(grid, axis);
}

/** Whether ends of folds were matched, as for the published map. */
bool
AreEnds(const RegistrationParts & parts)
{
  const auto folds = FoldsByLabel(*parts.supine);
  const auto isEnd = [&](const MatchedFolds & match) {
    const auto fold = folds.find(match.supineFold);
    return fold != folds.end() && MatchedEnd(*fold->second, match.supinePoint) >= 0;
  };
  const auto & matches = parts.results->matches;
  return std::any_of(matches.begin(), matches.end(), isEnd);
}

std::string
NoteOnMatches(const RegistrationParts & parts)
{
  const RegistrationResults & results = *parts.results;
  std::size_t                 doubtful = 0;
  for (const MatchedFolds & match : results.matches)
  {
    doubtful += IsDoubtful(match);
  }
  return std::to_string(results.matches.size()) + " pairs of " + (AreEnds(parts) ? "ends of folds" : "folds") +
         ", each of one color in both; red: " + std::to_string(doubtful) +
         (results.points.empty() ? " that the map contradicts" : " contradicted or wrong") +
         "; black: unmatched.\nThe prone wall is drawn as mapped. Striped: no correspondence (collapsed, narrow or not "
         "scanned in one position).\n" +
         seenFrom;
}
} // namespace

Picture::Pointer
DrawAlignedColons(const RegistrationParts & parts, const AlignedColonsOptions & options)
{
  const AlignedColons    colons(parts, options.pixelsAround);
  const Picture::Pointer upper = colons.PaintSupine(PaintRelief);
  const Picture::Pointer lower = colons.PaintProne(PaintRelief);
  FlatColonPair          pair{ upper, lower, "supine", "prone", {} };
  FoldDrawing(parts, colons, pair).Draw(upper, lower);
  colons.Hatch(upper);
  colons.Hatch(lower);
  FlatColonPageOptions page{ "Both positions, the prone one in the supine frame",
                             NoteOnMatches(parts),
                             options.greatestColumns };
  return DrawFlatColonPairPage(
    pair, colons.Grid(), colons.Distances(), SegmentAnnotations(parts.supine->segments), page);
}

Picture::Pointer
DrawCurvatureCheckerboard(const RegistrationParts & parts, const AlignedColonsOptions & options)
{
  static const RGBColor  green = MakeColor(90, 190, 90);
  constexpr double       shareOfGreen = 0.12; // in the squares of the prone wall
  const AlignedColons    colons(parts, options.pixelsAround);
  const Picture::Pointer board = colons.PaintSupine(PaintCurvature);
  const Picture::Pointer prone = colons.PaintProne(PaintCurvature);
  const int              rows = colons.Grid().Rows();
  constexpr int          squaresAround = 4; // even, so colors also alternate across the cut
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < colons.Grid().Columns(); ++column)
    {
      if ((squaresAround * row / rows + squaresAround * column / rows) % 2 != 0)
      {
        const Picture::IndexType pixel{ { column, row } };
        board->SetPixel(pixel, MixColors(prone->GetPixel(pixel), green, shareOfGreen));
      }
    }
  }
  colons.Hatch(board);
  FlatColonPageOptions page{
    "Curvature of both walls in squares",
    std::string("Greenish squares: prone; the others: supine. Folds continue across squares where the map is "
                "correct.\nStriped: no correspondence, narrow or hidden.\n") +
      seenFrom,
    options.greatestColumns
  };
  return DrawFlatColonPage(board, colons.Grid(), colons.Distances(), SegmentAnnotations(parts.supine->segments), page);
}
} // namespace shapeton
