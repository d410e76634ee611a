#ifndef shapetonFlatColonPictures_h
#define shapetonFlatColonPictures_h

#include "shapetonFlatColon.h"
#include "shapetonFlatColonOverlay.h"
#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonStrip.h"

namespace shapeton
{
/** What a flat picture shows. \ingroup ColonViews */
enum class FlatColoring
{
  Relief,
  Curvature,
  /** Needs a CT. */
  Volume
};

/** "relief", "curvature", "volume". \ingroup ColonViews */
ColonViews_EXPORT std::string
                  NameOf(FlatColoring coloring);

/** What flat pictures of a colon are made of. Nothing is owned. \ingroup ColonViews */
struct FlatColonParts
{
  const FlatColon * flat{ nullptr };
  /** One curve with the point array arcLength; tells the distances of the ruler where the surface has no arcLength, and
   * what is hatched as not assessable where it tells that. */
  const CurveSet * centreline{ nullptr };
  /** Hounsfield units. */
  const itk::Image<float, 3> * ct{ nullptr };
  std::vector<FlatAnnotation>  annotations;
  /** \name What is drawn over the picture, in this order */
  ///@{
  std::vector<FlatOutlines> outlines;
  std::vector<FlatLine>     lines;
  ///@}
  /** Where the CT is rendered; see ChooseFlatVolumeDevice(). */
  DeviceUse device{};
};

/** \class FlatColonPictures
 * \brief Pages of one flat colon, with the settings that suit reading.
 *
 * Strips are painted with 2 x 2 pixels for each one of the page, as long as these are at most 16 million, and averaged.
 * Curvature is averaged over 2 mm, normals over 1 mm.
 *
 * \ingroup ColonViews */
class ColonViews_EXPORT FlatColonPictures
{
public:
  /** The parts must outlive the object. Throws InputError and ParameterError as FlatColonGrid and DistanceOfColumns()
   * do.
   */
  FlatColonPictures(const FlatColonParts & parts, double pixelSize);
  ~FlatColonPictures();

  /** A pixel for each of the page's strips. */
  const FlatColonGrid &
  Grid() const
  {
    return *m_Grid;
  }
  /** For each column, mm; empty where neither surface nor centreline tell. */
  const std::vector<double> &
  Distances() const
  {
    return m_Distances;
  }
  /** Throws std::invalid_argument for Volume without a CT, else as PaintFlatVolume() and DrawFlatColonPage(). */
  Picture::Pointer
  Draw(FlatColoring coloring, const std::string & title, int greatestColumns = 1500) const;

private:
  Picture::Pointer
  Paint(FlatColoring coloring) const;

  FlatColonParts        m_Parts;
  const FlatColonGrid * m_Grid;
  const FlatColonGrid * m_Fine{ nullptr }; ///< only where it is another one
  const FlatColonAxis * m_Axis{ nullptr }; ///< of the finer grid
  std::vector<double>   m_Distances;
};
} // namespace shapeton

#endif
