#include "shapetonFlatColonPictures.h"

#include "shapetonCsvTable.h"

#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr unsigned int samples = 2;        ///< in each direction of a pixel
constexpr double       mostSamples = 16e6; // of a picture; chosen, bounds the time

std::string
NoteOn(const FlatColonGrid & grid, FlatColoring coloring)
{
  constexpr int     widthOfOneLine = 800; // columns; a narrower page would require a smaller font
  const std::string end = grid.Columns() < widthOfOneLine ? "\n" : " ";
  const std::string light = coloring == FlatColoring::Curvature ? "" : ", light from the left";
  return "Seen from the lumen, rectum at the left" + light + "." + end + "A pixel is " +
         CsvTable::Rounded(grid.PixelSize(), 3) + " mm at the mean circumference of " +
         CsvTable::Rounded(grid.Circumference(), 3) + " mm." + end + "For research use; not a diagnosis.";
}
} // namespace

std::string
NameOf(FlatColoring coloring)
{
  return coloring == FlatColoring::Relief ? "relief" : coloring == FlatColoring::Curvature ? "curvature" : "volume";
}

FlatColonPictures::FlatColonPictures(const FlatColonParts & parts, double pixelSize)
  : m_Parts(parts), m_Grid(&parts.flat->Grid(PictureGridOptions(pixelSize)))
{
  FlatColonGridOptions painted = PictureGridOptions(pixelSize);
  if (static_cast<double>(m_Grid->Columns()) * m_Grid->Rows() * samples * samples <= mostSamples)
  {
    painted = PictureGridOptions(m_Grid->PixelSize() / samples);
    m_Fine = &parts.flat->Grid(painted);
  }
  m_Axis = &parts.flat->Axis(painted);
  m_Distances = DistanceOfColumns(*m_Grid);
  if (m_Distances.empty() && parts.centerline)
  {
    m_Distances = DistanceOfColumns(parts.flat->Axis(PictureGridOptions(pixelSize)), *parts.centerline);
  }
}

FlatColonPictures::~FlatColonPictures() = default;

Picture::Pointer
FlatColonPictures::Paint(FlatColoring coloring) const
{
  const FlatColonGrid & grid = m_Fine ? *m_Fine : *m_Grid;
  if (coloring == FlatColoring::Volume)
  {
    return PaintFlatVolume(grid, *m_Axis, m_Parts.ct, FlatVolumeOptions(), m_Parts.device);
  }
  return coloring == FlatColoring::Relief ? PaintFlatRelief(grid, *m_Axis) : PaintFlatCurvature(grid, *m_Axis);
}

Picture::Pointer
FlatColonPictures::Draw(FlatColoring coloring, const std::string & title, int greatestColumns) const
{
  if (coloring == FlatColoring::Volume && !m_Parts.ct)
  {
    throw std::invalid_argument("a volume rendering requires a CT");
  }
  Picture::Pointer strip = this->Paint(coloring);
  if (m_Fine)
  {
    strip = ReduceStrip(strip, samples, m_Grid->Columns(), m_Grid->Rows());
  }
  if (m_Parts.centerline && TellsHindrances(*m_Parts.centerline))
  {
    DrawFlatHatching(strip, *m_Grid, m_Distances, FindHinderedStretches(*m_Parts.centerline));
  }
  for (const FlatOutlines & outlines : m_Parts.outlines)
  {
    DrawFlatOutlines(strip, *m_Grid, outlines);
  }
  for (const FlatLine & line : m_Parts.lines)
  {
    DrawFlatLine(strip, *m_Grid, line);
  }
  FlatColonPageOptions options{ title, NoteOn(*m_Grid, coloring), greatestColumns };
  if (coloring == FlatColoring::Curvature)
  {
    options.colorBar = CurvatureScale();
  }
  return DrawFlatColonPage(strip, *m_Grid, m_Distances, m_Parts.annotations, options);
}
} // namespace shapeton
