#include "shapetonHaustralFoldPicture.h"

#include "shapetonCsvTable.h"
#include "shapetonFlatColonOverlay.h"
#include "shapetonFlatColonStrip.h"

#include <array>

namespace shapeton
{
namespace
{
const RGBColor colorOfEnds = MakeColor(40, 220, 70);
const RGBColor colorOfTaeniae = MakeColor(255, 214, 0);

/** Colors of consecutive folds differ, and contrast with the mucosa, the green ends and the yellow taeniae. */
RGBColor
ColorOf(int label)
{
  static const std::array<RGBColor, 4> colors{
    MakeColor(0, 229, 255), MakeColor(255, 255, 255), MakeColor(40, 90, 255), MakeColor(214, 64, 255)
  };
  return colors[label % colors.size()];
}

void
DrawFolds(Picture * strip, const FlatColonGrid & grid, const HaustralFolds & folds)
{
  constexpr double leastRadius = 1.5;         // pixels, of an end with reliability 0
  constexpr double radiusOfReliability = 1.5; // pixels
  const auto       size = folds.labels->GetLargestPossibleRegion().GetSize();
  FlatOutlines     outlines{
    folds.labels->GetBufferPointer(), static_cast<int>(size[0]), static_cast<int>(size[1]), ColorOf
  };
  DrawFlatOutlines(strip, grid, outlines);
  for (const HaustralFold & fold : folds.folds)
  {
    for (int end = 0; end < 2; ++end)
    {
      DrawFlatDot(
        strip, grid, { fold.endUv[end], colorOfEnds, leastRadius + radiusOfReliability * fold.endReliability[end] });
    }
  }
}

void
DrawTaeniae(Picture * strip, const FlatColonGrid & grid, const CurveSet & taeniae)
{
  for (const std::vector<int> & curve : taeniae.curves)
  {
    std::vector<Eigen::Vector3d> points;
    for (const int vertex : curve)
    {
      points.emplace_back(taeniae.V.row(vertex));
    }
    DrawFlatLine(strip, grid, { PlacesOfCurve(grid, points), colorOfTaeniae, 2.0 });
  }
}

std::string
NoteOn(const HaustralFoldPictureContent & content)
{
  std::string note = std::to_string(content.folds->folds.size()) + " folds, green: their ends";
  note += content.taeniae ? ", yellow: taeniae" : "";
  return note + ". Seen from the lumen, rectum at the left. For research use; not a diagnosis.";
}
} // namespace

Picture::Pointer
DrawHaustralFolds(const HaustralFoldPictureContent & content,
                  double                             pixelSize,
                  const std::string &                title,
                  int                                greatestColumns)
{
  const FlatColonGrid &  grid = content.flat->Grid(PictureGridOptions(pixelSize));
  const Picture::Pointer strip = PaintFlatRelief(grid, content.flat->Axis(PictureGridOptions(pixelSize)));
  if (content.taeniae)
  {
    DrawTaeniae(strip, grid, *content.taeniae);
  }
  DrawFolds(strip, grid, *content.folds);
  FlatColonPageOptions options{ title, NoteOn(content), greatestColumns };
  return DrawFlatColonPage(strip, grid, DistanceOfColumns(grid), content.annotations, options);
}
} // namespace shapeton
