#ifndef itkGraphInSpace_h
#define itkGraphInSpace_h

#include "GraphViewExport.h"
#include "itkEmbeddingCertificate.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** Throws InputError where WriteGraphInSpace has no surface in space: genus 2 and more.
 * \ingroup GraphView */
GraphView_EXPORT void
RequireSurfaceInSpace(int genus);

/** Writes nodes (points) and edges (polylines) of a graph of genus 1 on a torus in space (see TorusInSpace) as VTP, of
 * genus 0 on the unit sphere as WriteGraphVtp() does. Cell arrays of the torus: kind (0 node, 1 edge), id. Field
 * arrays: tubeRadius, of a torus of radius 1, and dilatation. Dummies are left out. Throws OutputError, and InputError
 * as RequireSurfaceInSpace(). \ingroup GraphView */
GraphView_EXPORT void
WriteGraphInSpace(const EmbeddingCertificate &                             certificate,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path);
} // namespace itk

#endif
