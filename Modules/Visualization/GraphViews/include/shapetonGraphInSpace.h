#ifndef shapetonGraphInSpace_h
#define shapetonGraphInSpace_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"
#include "shapetonProvenance.h"

#include <string>

namespace shapeton
{
/** Writes nodes (points) and edges (polylines) of a graph on a surface in space as VTP: genus 0 on the unit sphere as
 * WriteGraphVtp() does, genus 1 on a torus (see TorusInSpace), higher genus on a sphere with handles (see
 * SurfaceWithHandles), whose triangles are also in the file. Dummies are omitted.
 *
 * Cell arrays for genus 1 and higher: kind (0 node, 1 edge, 2 triangle) and id, counted from 0 for each kind. Field
 * arrays of the torus, whose radius is 1: tubeRadius and dilatation; of the sphere with handles: twist, the turns of
 * the edges on each handle. Throws OutputError, and InputError if the handles do not all fit.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGraphInSpace(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path);
} // namespace shapeton

#endif
