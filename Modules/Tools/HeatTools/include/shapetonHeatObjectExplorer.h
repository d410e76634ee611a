#ifndef shapetonHeatObjectExplorer_h
#define shapetonHeatObjectExplorer_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonHeatExplorer.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatSnapshot.h"

#include <memory>

namespace shapeton
{
class CommandLine;

/** \class HeatObjectExplorer
 * \brief The heat explorer of HeatObjects, in the folder named by the parameter `explorer`; nothing is written without
 * this parameter.
 *
 * \ingroup ShapetonHeatTools */
class ShapetonHeatTools_EXPORT HeatObjectExplorer
{
public:
  /** Throws OutputError. */
  explicit HeatObjectExplorer(CommandLine & commandLine);
  ~HeatObjectExplorer();

  /** The page opens with a color for each object. `heat` are the values of `file`, a heat volume or visits;
   * `objects` are those of the tree without offers, through which the first slices pass. Throws OutputError. */
  void
  Write(const itk::Image<float, 3> * gray,
        const itk::Image<float, 3> * heat,
        const HeatSnapshot &         file,
        const HeatObjectTree &       tree,
        const HeatObjectList &       objects);

private:
  std::unique_ptr<HeatExplorer> m_Explorer; ///< null without the parameter
};
} // namespace shapeton

#endif
