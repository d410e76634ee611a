#ifndef ShapetonPictures_h
#define ShapetonPictures_h

#include "ShapetonTrial.h"

#include "shapetonPicture.h"

#include <optional>
#include <string>
#include <vector>

/** Number of color levels of a field. */
constexpr unsigned int numberOfLevels = 12;

/** Color levels of the result in the object voxels, from 1 (blue, lowest) to numberOfLevels (red, highest) with equally
 * many voxels each; 0 elsewhere and in voxels without visits. Values in one bin of the heat histogram have the same
 * level. */
itk::Image<unsigned char, 3>::Pointer
LevelsOf(const TrialVolume & volume, const Trial & trial);

/** Renders the volume from the front, rotated and slightly from above, with each level in its color. */
shapeton::Picture::Pointer
RenderLevels(const itk::Image<unsigned char, 3> * levels, unsigned int width, unsigned int height, double azimuth = 30);

/** Draws one slice perpendicular to an axis at the largest possible size: levels in color, gray elsewhere; all gray
 * without levels. Uses the radiological orientation. */
shapeton::Picture::Pointer
DrawPlane(const TrialVolume &                  volume,
          const itk::Image<unsigned char, 3> * levels,
          unsigned int                         axis,
          std::size_t                          slice,
          unsigned int                         width,
          unsigned int                         height);

/** \class PictureSheet
 * \brief Panels in rows and columns under a title, with a caption above each and, optionally, the color scale of
 * shapetons below. */
class PictureSheet
{
public:
  struct Layout
  {
    std::size_t  rows{ 1 };
    std::size_t  columns{ 3 };
    unsigned int width{ 320 }; ///< width of a panel
    unsigned int height{ 240 };
    bool         hasScale{ true }; ///< shows the color scale of shapetons
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
