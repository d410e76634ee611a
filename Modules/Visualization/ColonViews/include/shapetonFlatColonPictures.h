#ifndef shapetonFlatColonPictures_h
#define shapetonFlatColonPictures_h

#include "shapetonFlatColon.h"
#include "shapetonFlatColonOverlay.h"
#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonStrip.h"

namespace shapeton
{
/** Shading of a flat picture. \ingroup ShapetonColonViews */
enum class FlatColoring
{
  Relief,
  Curvature,
  /** Requires a CT. */
  Volume
};

/** "relief", "curvature", "volume". \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::string
                          NameOf(FlatColoring coloring);

/** Inputs of flat pictures of a colon. Not owned. \ingroup ShapetonColonViews */
struct FlatColonParts
{
  const FlatColon * flat{ nullptr };
  /** One curve with the point array arcLength. Provides the ruler if the surface has no arcLength, and the sections
   * that cannot be assessed, which are hatched. */
  const CurveSet * centerline{ nullptr };
  /** Hounsfield units. */
  const itk::Image<float, 3> * ct{ nullptr };
  std::vector<FlatAnnotation>  annotations;
  /** \name Overlays, drawn in this order */
  ///@{
  std::vector<FlatOutlines> outlines;
  std::vector<FlatLine>     lines;
  ///@}
  /** Device that renders the CT; see ChooseFlatVolumeDevice(). */
  DeviceUse device{};
};

/** \class FlatColonPictures
 * \brief Pages of one flat colon, with settings suited to reading.
 *
 * Strips are painted with 2 x 2 samples per page pixel, at most 16 million in total, and averaged.
 * Curvature is averaged over 2 mm, normals over 1 mm.
 *
 * \ingroup ShapetonColonViews */
class ShapetonColonViews_EXPORT FlatColonPictures
{
public:
  /** The parts must outlive the object. Throws InputError and ParameterError as FlatColonGrid and DistanceOfColumns()
   * do.
   */
  FlatColonPictures(const FlatColonParts & parts, double pixelSize);
  ~FlatColonPictures();

  /** Grid with one pixel for each pixel of the strip on the page. */
  const FlatColonGrid &
  Grid() const
  {
    return *m_Grid;
  }
  /** Distance of each column, mm; empty if neither surface nor centerline provides it. */
  const std::vector<double> &
  Distances() const
  {
    return m_Distances;
  }
  /** Throws std::invalid_argument for Volume without a CT, and the exceptions of PaintFlatVolume() and
   * DrawFlatColonPage().
   */
  Picture::Pointer
  Draw(FlatColoring coloring, const std::string & title, int greatestColumns = 1500) const;

private:
  Picture::Pointer
  Paint(FlatColoring coloring) const;

  FlatColonParts        m_Parts;
  const FlatColonGrid * m_Grid;
  const FlatColonGrid * m_Fine{ nullptr }; ///< set only if it differs
  const FlatColonAxis * m_Axis{ nullptr }; ///< axis of the finer grid
  std::vector<double>   m_Distances;
};
} // namespace shapeton

#endif
