#ifndef shapetonShapeTransferFunction_h
#define shapetonShapeTransferFunction_h

#include "HeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonPicture.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkVolumeProperty;

namespace shapeton
{
/** A line of the heat histogram, chosen for display: the voxels with lowerHeat <= heat < upperHeat (dissertation 2.5).
 * \ingroup HeatViews */
struct TransferFunctionLine
{
  double   lowerHeat{ 0.0 };
  double   upperHeat{ 0.0 };
  RGBColor color;
  /** In [0, 1]; 1 hides what lies behind. */
  double opacity{ 1.0 };
};

/** \class ShapeTransferFunction
 * \brief The shape-based transfer function of the dissertation (2.5, Figures 2.6 and 2.9): chosen lines of the heat
 * histogram with a colour and an opacity each; heat outside the lines is invisible.
 *
 * The lines do not overlap and are kept in the order of their heats. At most MaximumNumberOfLines, because a line of 3D
 * Slicer's volume property file has at most 1023 characters.
 *
 * \ingroup HeatViews
 */
class HeatViews_EXPORT ShapeTransferFunction
{
public:
  static constexpr std::size_t MaximumNumberOfLines = 12;

  ShapeTransferFunction() = default;

  /** Throws ParameterError, which names the line, for a range outside [0, 1], empty, narrower than 1e-7 or overlapping
   * another one, for an opacity outside [0, 1], and for too many lines. */
  explicit ShapeTransferFunction(std::vector<TransferFunctionLine> lines);

  /** Reads `a-b:colour:opacity,...`, for example `0.18-0.21:red:1,1e-3-2e-3:#3366cc:0.4`.
   *
   * a and b are unsigned decimal numbers, with an exponent if wanted (1e-3); spaces around the parts are allowed. The
   * text reads one way only: a sign belongs to an exponent when it directly follows `e` or `E`, and any other `-`
   * separates a from b. The colour is a name (ColorNames()) or `#rrggbb`. Throws ParameterError that names the faulty
   * piece. */
  static ShapeTransferFunction
  Parse(const std::string & text);

  /** One line for each class but the background and, where there are others, the surroundings (borderShare above one
   * half), which would hide them: its colour is that of its mean heat on the axis, so that similar
   * classes look similar; large classes are made more transparent, so that small ones inside them stay visible. Where
   * there are more than MaximumNumberOfLines classes, those with neighbouring heats are joined until few enough are
   * left, the closest ones on the axis first; the joined range includes the heats between them. */
  static ShapeTransferFunction
  FromClasses(const std::vector<HeatClass> & classes, const HeatAxis & axis);

  const std::vector<TransferFunctionLine> &
  GetLines() const
  {
    return m_Lines;
  }

  /** The index of the line that holds a heat; -1 when none does. */
  int
  LineOf(float heat) const;

  /** Another transfer function with one line alone (Figure 2.6). Throws std::out_of_range. */
  ShapeTransferFunction
  OnlyLine(std::size_t line) const;

  /** The text that Parse() reads back to the same lines. */
  std::string
  ToText() const;

  /** For a VTK volume of heat: colour and opacity per heat, nearest-neighbour interpolation (interpolating between two
   * objects would show, between them, every class whose heat lies between theirs), shaded. */
  vtkSmartPointer<vtkVolumeProperty>
  ToVolumeProperty() const;

  /** Writes a 3D Slicer volume property, `.vp`, that shows the heat volume with this transfer function. `unit`
   * is what a heat of 1 is in the volume that is shown: 1, or for visits their greatest number. Throws OutputError. */
  void
  WriteVolumeProperty(const std::string & path, double unit = 1.0) const;

private:
  std::vector<TransferFunctionLine> m_Lines;
};
} // namespace shapeton

#endif
