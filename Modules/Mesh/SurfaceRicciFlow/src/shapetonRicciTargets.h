#ifndef shapetonRicciTargets_h
#define shapetonRicciTargets_h

#include "shapetonSurfaceRicciFlow.h"

namespace shapeton
{
/** Topological properties of a surface that matter to a flow. */
struct RicciTopology
{
  int  characteristic{ 0 };
  int  genus{ 0 };
  int  boundaries{ 0 };
  bool isTube{ false };
};

/** The geometry for `Auto`, and a check of the requested one. Throws InputError or ParameterError. */
RicciGeometry
ChooseGeometry(const SurfaceRicciFlowSettings & options, const RicciTopology & topology, const std::string & what);

/** Target curvature of each vertex. Throws ParameterError. */
Eigen::VectorXd
FindTargets(const SurfaceRicciFlowSettings & options,
            RicciGeometry                    geometry,
            const RicciTopology &            topology,
            const SurfaceConnectivity &      connectivity,
            const Eigen::VectorXd &          lengths);
} // namespace shapeton

#endif
