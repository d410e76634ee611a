#ifndef shapetonPanelPlans_h
#define shapetonPanelPlans_h

#include "shapetonEmbeddedGraph.h"
#include "shapetonGraphPictures.h"
#include "shapetonSvgPanel.h"

#include <list>

namespace shapeton
{
/** Content of a panel. */
struct PanelPlan
{
  std::string         title;
  PictureMap          picture;
  PictureWindow       window;
  std::vector<Motion> tiles{ Motion{} };
  bool                hasCircles{ false };
  bool                hasDual{ true };
  bool                hasTiles{ false };
  bool                hasRim{ false };
};

/** Four panels: stereographic from `outer`, overlap graph and circles; front and back of the sphere. */
std::vector<PanelPlan>
PlansOfSphere(const EmbeddedGraph & graph, const Place & outer);

/** Panels of an embedding; the second one shows the circles. */
std::vector<PanelPlan>
PlansOf(const EmbeddedGraph & graph, const GraphPictureOptions & options);

/** Sets a common window for all spheres: their bounding square. One plan per graph. */
void
UniteWindows(const std::list<EmbeddedGraph> & graphs, std::vector<PanelPlan> & plans);

/** Plans that enlarge the circles of nodes with these names and of their neighbors; those of spheres have a common
 * window. A graph without such nodes is shown as before. */
std::vector<PanelPlan>
EnlargedPlans(const std::list<EmbeddedGraph> & graphs,
              const std::vector<PanelPlan> &   plans,
              const std::vector<std::string> & names);
} // namespace shapeton

#endif
