#ifndef shapetonGraphCurvatureReport_h
#define shapetonGraphCurvatureReport_h

#include "ShapetonGraphToolsExport.h"
#include "shapetonConformalType.h"
#include "shapetonCsvTable.h"
#include "shapetonGraphCurvature.h"
#include "shapetonGraphPictures.h"
#include "shapetonJsonForward.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** One row per edge: names of the ends a and b, degreeA, degreeB, triangles, curvature, exact (a fraction). Cells of
 * loops are empty. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT CsvTable
EdgeTableOf(const Graph & graph, const GraphCurvature & curvature);

/** One row per node: node, degree, meanCurvature, sumCurvature. The mean of a node without edges is empty.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT CsvTable
NodeTableOf(const Graph & graph, const GraphCurvature & curvature);

/** Name of the curvature with its options, such as "Ollivier-Ricci curvature, idleness 0.5".
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT std::string
                          NameOfCurvature(const GraphCurvatureOptions & options);

/** A view with edges colored by their curvature, and circles colored by the mean over the edges of their nodes. The
 * color scale is symmetric about 0 and extends to the largest magnitude of any edge. \pre The certificate has the edges
 * of the curvature.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT GraphView
ViewOfCurvature(const EmbeddingCertificate &  certificate,
                const GraphCurvature &        curvature,
                const GraphCurvatureOptions & options);

/** Numbers of edges with negative, zero and positive curvature, the extremes and the mean.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT std::vector<std::pair<std::string, std::string>>
                          FactsOf(const GraphCurvature & curvature);

/** One row per ball: radius, nodes, boundaryNodes, dummies, rootRadius, modulus, resistance.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT CsvTable
BallTableOf(const ConformalTypeResult & result);

/** Draws modulus and resistance of the balls, see WriteGrowthSvg(). Throws OutputError. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT void
WriteConformalTypeSvg(const ConformalTypeResult & result, const std::string & path);

/** The verdict: root (its name), type, limitRadius as [least, most], and the evidence of packing and resistance.
 * Numbers that are undefined or infinite are null. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT Json
ConformalTypeToJson(const ConformalTypeResult & result, const std::string & rootName);
} // namespace shapeton

#endif
