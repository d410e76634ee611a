#ifndef shapetonPlanarSubgraph_h
#define shapetonPlanarSubgraph_h

namespace shapeton
{
/** Selection of links that become edges. \ingroup ShapetonGraphModel */
enum class PlanarSubgraph
{
  None,   ///< all links: a unit-disk graph, which is not planar
  Gabriel ///< links with no other network device in their diametral disk; planar
};
} // namespace shapeton

#endif
