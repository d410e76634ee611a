#ifndef ShapetonPictures_h
#define ShapetonPictures_h

#include "ShapetonTrial.h"

#include "shapetonPicture.h"

#include <optional>
#include <string>
#include <vector>

/** The levels of colour that a field is drawn in. */
constexpr unsigned int numberOfLevels = 12;

/** The levels of the result in the object voxels: equal shares of these voxels from 1 (blue, least) to numberOfLevels
 * (red, most), 0 elsewhere and where no shapeton came. Equal values, to the width of a bin of the heat histogram, have
 * one level. */
itk::Image<unsigned char, 3>::Pointer
LevelsOf(const TrialVolume & volume, const Trial & trial);

/** The volume seen from the front, turned and from above a little, each level in its colour. */
shapeton::Picture::Pointer
RenderLevels(const itk::Image<unsigned char, 3> * levels, unsigned int width, unsigned int height, double azimuth = 30);

/** One slice perpendicular to an axis, as large as fits: levels in their colours, grey elsewhere; grey everywhere
 * without levels. Left and right, front and back are shown the radiological way. */
shapeton::Picture::Pointer
DrawPlane(const TrialVolume &                  volume,
          const itk::Image<unsigned char, 3> * levels,
          unsigned int                         axis,
          std::size_t                          slice,
          unsigned int                         width,
          unsigned int                         height);

/** \class PictureSheet
 * \brief Panels in rows and columns under a title, with a caption above each and, if wanted, the scale of colours of
 * shapetons below. */
class PictureSheet
{
public:
  struct Layout
  {
    std::size_t  rows{ 1 };
    std::size_t  columns{ 3 };
    unsigned int width{ 320 }; ///< of a panel
    unsigned int height{ 240 };
    bool         hasScale{ true }; ///< of shapetons
  };
  PictureSheet(const std::string & title, const Layout & layout);

  void
  Put(std::size_t row, std::size_t column, const std::string & caption, const shapeton::Picture * panel);
  void
  Write(const std::string & path) const;

  const Layout &
  GetLayout() const
  {
    return m_Layout;
  }

private:
  Layout                     m_Layout;
  shapeton::Picture::Pointer m_Picture;
};

#endif
