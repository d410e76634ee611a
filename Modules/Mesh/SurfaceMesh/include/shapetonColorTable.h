#ifndef shapetonColorTable_h
#define shapetonColorTable_h

#include "ShapetonSurfaceMeshExport.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** Meaning and color of a value of a label map. \ingroup ShapetonSurfaceMesh */
struct LabelColor
{
  /** 1 to 32767; 0 is the background. */
  int         value{ 1 };
  std::string name;
  /** Red, green and blue in [0, 1]. */
  std::array<double, 3> color{ 1.0, 1.0, 1.0 };
};

/** A color that differs from those of the preceding labels: hues in steps of the golden angle, two saturations, two
 * values.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT std::array<double, 3>
                           ColorOfLabel(int label);

/** Writes a color table of 3D Slicer (.ctbl): one line per label, transparent background. Blanks in names become
 * underscores, as Slicer writes them. Throws ParameterError for another extension, std::invalid_argument for a value or
 * color out of range, a duplicate value or an empty name, and OutputError. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteColorTable(const std::vector<LabelColor> & labels, const std::string & path);
} // namespace shapeton

#endif
