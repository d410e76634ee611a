#include "shapetonAlignedColons.h"

#include "shapetonParallelFor.h"
#include "shapetonExceptions.h"

#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr int  finer = 2; ///< painted pixels per strip pixel
const RGBColor noWall = MakeColor(150, 150, 156);
const RGBColor stripe = MakeColor(70, 74, 84);

FlatColonGridOptions
OptionsFor(const FlatColon & flat, double pixelsAround)
{
  return PictureGridOptions(flat.Grid().Circumference() / pixelsAround);
}

const FlatColonGrid &
GridOf(const ColonPositionFiles & files, double pixelsAround)
{
  const FlatColon & flat = *files.position.flat;
  return flat.Grid(OptionsFor(flat, pixelsAround));
}

const FlatColonAxis &
AxisOf(const ColonPositionFiles & files, double pixelsAround)
{
  const FlatColon & flat = *files.position.flat;
  return flat.Axis(OptionsFor(flat, pixelsAround));
}

void
RequireFit(const SurfaceMesh & map, const ColonPositionFiles & files)
{
  const SurfaceMesh & flat = files.position.flat->Surface();
  if (map.V.rows() != flat.V.rows() || map.F.rows() != flat.F.rows() || map.V != flat.V)
  {
    throw InputError("the registration does not belong to the " + files.position.name +
                     " examination; run ColonRegistration again");
  }
}
} // namespace

MapOfSurface::MapOfSurface(const SurfaceMesh & surface, const FlatColonGrid & grid, double circumference)
  : m_Grid(grid)
  , m_Uv(*FindSurfaceArray(surface.pointArrays, "mappedUv"))
  , m_Confidence(*FindSurfaceArray(surface.pointArrays, "confidence"))
  , m_Excluded(*FindSurfaceArray(surface.pointArrays, "excluded"))
  , m_Circumference(circumference)
{}

MapOfSurface::Place
MapOfSurface::AtPixel(int column, int row) const
{
  const FlatSample sample = m_Grid.SampleOfPixel(column, row);
  Place            place;
  place.uv.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (sample.face < 0)
  {
    return place;
  }
  const auto            corners = m_Grid.Faces().row(sample.face);
  const Eigen::Vector2d first = m_Uv.values.row(corners[0]);
  Eigen::Vector2d       uv = Eigen::Vector2d::Zero();
  double                excluded = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    Eigen::Vector2d corner = m_Uv.values.row(corners[k]);
    corner.y() = first.y() + std::remainder(corner.y() - first.y(), m_Circumference); // around the tube
    uv += sample.barycentric[k] * corner;
    place.confidence += sample.barycentric[k] * m_Confidence.values(corners[k], 0);
    excluded += sample.barycentric[k] * m_Excluded.values(corners[k], 0);
  }
  uv.y() -= m_Circumference * std::floor(uv.y() / m_Circumference);
  place.uv = uv;
  place.isExcluded = excluded >= 0.5;
  return place;
}

MapOfSurface::Place
MapOfSurface::At(const Eigen::Vector2d & uv) const
{
  const FlatPixel pixel = m_Grid.PixelOfUv(uv);
  return this->AtPixel(pixel.column, pixel.row);
}

AlignedColons::AlignedColons(const RegistrationParts & parts, int pixelsAround)
  : m_Parts(parts)
  , m_Grid(GridOf(*parts.supine, pixelsAround))
  , m_Fine(GridOf(*parts.supine, finer * pixelsAround))
  , m_FineAxis(AxisOf(*parts.supine, finer * pixelsAround))
  , m_Prone(GridOf(*parts.prone, finer * pixelsAround))
  , m_ProneAxis(AxisOf(*parts.prone, finer * pixelsAround))
  , m_Distances(m_Grid.HasArcLength()
                  ? DistanceOfColumns(m_Grid)
                  : DistanceOfColumns(AxisOf(*parts.supine, pixelsAround), parts.supine->position.centerline))
{
  RequireFit(parts.results->supineToProne, *parts.supine);
  RequireFit(parts.results->proneToSupine, *parts.prone);
}

Picture::Pointer
AlignedColons::Reduced(const Picture * fine) const
{
  return ReduceStrip(fine, finer, m_Grid.Columns(), m_Grid.Rows());
}

Picture::Pointer
AlignedColons::PaintSupine(const StripPainter & paint) const
{
  return this->Reduced(paint(m_Fine, m_FineAxis));
}

Picture::Pointer
AlignedColons::PaintProne(const StripPainter & paint) const
{
  const Picture::Pointer own = paint(m_Prone, m_ProneAxis);
  const MapOfSurface     map(m_Parts.results->supineToProne, m_Fine, m_Prone.Circumference());
  Picture::Pointer       warped = NewPicture(m_Fine.Columns(), m_Fine.Rows(), noWall);
  ParallelFor(static_cast<std::size_t>(m_Fine.Rows()), [&](std::size_t line) {
    const int row = static_cast<int>(line);
    for (int column = 0; column < m_Fine.Columns(); ++column)
    {
      const Eigen::Vector2d uv = map.AtPixel(column, row).uv;
      if (uv.allFinite())
      {
        const FlatPixel from = m_Prone.PixelOfUv(uv);
        warped->SetPixel({ { column, row } }, own->GetPixel({ { from.column, from.row } }));
      }
    }
  });
  return this->Reduced(warped);
}

void
AlignedColons::Hatch(Picture * strip) const
{
  constexpr int      period = 9; // pixels
  constexpr double   opacity = 0.75;
  const MapOfSurface map(m_Parts.results->supineToProne, m_Grid, m_Prone.Circumference());
  for (int row = 0; row < m_Grid.Rows(); ++row)
  {
    for (int column = 0; column < m_Grid.Columns(); ++column)
    {
      if ((column + row) % period < 2 && map.AtPixel(column, row).isExcluded)
      {
        const Picture::IndexType pixel{ { column, row } };
        strip->SetPixel(pixel, MixColors(strip->GetPixel(pixel), stripe, opacity));
      }
    }
  }
}

Eigen::Vector2d
AlignedColons::InSupineFrame(const Eigen::Vector2d & proneUv) const
{
  return MapOfSurface(m_Parts.results->proneToSupine, m_Prone, m_Grid.Circumference()).At(proneUv).uv;
}
} // namespace shapeton
