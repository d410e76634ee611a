#ifndef shapetonPanelPlans_h
#define shapetonPanelPlans_h

#include "shapetonEmbeddedGraph.h"
#include "shapetonGraphPictures.h"
#include "shapetonSvgPanel.h"

#include <list>

namespace shapeton
{
/** What a panel shows. */
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

/** The panels that show an embedding; the second one has the circles. */
std::vector<PanelPlan>
PlansOf(const EmbeddedGraph & graph, DiskModel model);

/** One window for all spheres: the square around theirs. A plan for each graph. */
void
UniteWindows(const std::list<EmbeddedGraph> & graphs, std::vector<PanelPlan> & plans);
} // namespace shapeton

#endif
