#ifndef shapetonShapeTransferFunction_h
#define shapetonShapeTransferFunction_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonPicture.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkVolumeProperty;

namespace shapeton
{
/** A line of the heat histogram selected for display: the voxels with lowerHeat <= heat < upperHeat (dissertation 2.5).
 * \ingroup ShapetonHeatViews */
struct TransferFunctionLine
{
  double   lowerHeat{ 0.0 };
  double   upperHeat{ 0.0 };
  RGBColor color;
  /** In [0, 1]; 1 is opaque. */
  double opacity{ 1.0 };
  /** Name in legends; by default its range. */
  std::string name{};
};

/** \class ShapeTransferFunction
 * \brief The shape-based transfer function of the dissertation (2.5, Figures 2.6 and 2.9): selected lines of the heat
 * histogram, each with a color and an opacity; heat outside the lines is invisible.
 *
 * The lines do not overlap and are sorted by heat. There are at most MaximumNumberOfLines, because a line of 3D
 * Slicer's volume property file has at most 1023 characters.
 *
 * \ingroup ShapetonHeatViews
 */
class ShapetonHeatViews_EXPORT ShapeTransferFunction
{
public:
  static constexpr std::size_t MaximumNumberOfLines = 12; // chosen

  ShapeTransferFunction() = default;

  /** Throws ParameterError with the faulty line for a range that is outside [0, 1], empty, narrower than 1e-7 or
   * overlaps another one, for an opacity outside [0, 1], and for too many lines. */
  explicit ShapeTransferFunction(std::vector<TransferFunctionLine> lines);

  /** One line per class, in this order: line i of n covers the values from i / n to (i + 1) / n. For pictures of class
   * numbers: there may be more lines than 3D Slicer can read. The ranges of the lines are replaced. */
  static ShapeTransferFunction
  OfClasses(std::vector<TransferFunctionLine> lines);

  /** Reads `a-b:color:opacity,...`, for example `0.18-0.21:red:1,1e-3-2e-3:#3366cc:0.4`.
   *
   * a and b are unsigned decimal numbers, optionally with an exponent (1e-3); spaces around the parts are allowed. The
   * syntax is unambiguous: a sign that directly follows `e` or `E` belongs to an exponent, any other `-` separates a
   * from b. The color is a name (ColorNames()) or `#rrggbb`. Throws ParameterError with the faulty part. */
  static ShapeTransferFunction
  Parse(const std::string & text);

  /** One line per class, in its ColorOfClass(), except the background and, if there are other classes, the
   * surroundings, which would hide them. Incoherent classes are transparent; of the others, large classes are more
   * transparent, so small ones inside them stay visible. Throws as the constructor for too many classes. */
  static ShapeTransferFunction
  FromClasses(const std::vector<HeatClass> & classes);

  const std::vector<TransferFunctionLine> &
  GetLines() const
  {
    return m_Lines;
  }

  /** Index of the line that contains a heat value; -1 if there is none. */
  int
  LineOf(float heat) const;

  /** A transfer function with only one of the lines (Figure 2.6). Throws std::out_of_range. */
  ShapeTransferFunction
  OnlyLine(std::size_t line) const;

  /** Text that Parse() converts back to the same lines. */
  std::string
  ToText() const;

  /** For a VTK volume of heat: color and opacity per heat, shaded, with nearest-neighbor interpolation. (Interpolating
   * between two objects would show every class whose heat is between theirs.) */
  vtkSmartPointer<vtkVolumeProperty>
  ToVolumeProperty() const;

  /** Writes a 3D Slicer volume property, `.vp`, that shows the heat volume with this transfer function. `unit` is the
   * value in the displayed volume that corresponds to heat 1: 1, or the maximum number of visits. Slicer samples heat
   * at 16,384 places: narrower lines are widened to 3 / 16,000, which moves those after them. Throws OutputError. */
  void
  WriteVolumeProperty(const std::string & path, double unit = 1.0) const;

private:
  std::vector<TransferFunctionLine> m_Lines;
};
} // namespace shapeton

#endif
