#ifndef shapetonHeatObjectExplorer_h
#define shapetonHeatObjectExplorer_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonHeatExplorer.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatSnapshot.h"

#include <memory>
#include <vector>

namespace shapeton
{
class CommandLine;

/** A heat volume, or a density of shapetons, and its file. \ingroup ShapetonHeatTools */
struct HeatFile
{
  itk::Image<float, 3>::Pointer image;
  HeatSnapshot                  file;
};

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

  /** The page opens with a color for each object. It contains all heats, but only the first if their windows differ,
   * because a page has one heat per time step. Throws OutputError. */
  void
  Write(const itk::Image<float, 3> * gray, const std::vector<HeatFile> & heats, const HeatObjectList & list);

private:
  std::unique_ptr<HeatExplorer> m_Explorer; ///< null without the parameter
};
} // namespace shapeton

#endif
