#ifndef shapetonGraphComparisonPictures_h
#define shapetonGraphComparisonPictures_h

#include "ShapetonGraphToolsExport.h"
#include "shapetonDynamicTables.h"
#include "shapetonGraphComparison.h"
#include "shapetonOutputPath.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Options of pictures that show graphs side by side.
 * \ingroup ShapetonGraphTools */
struct GraphSideBySide
{
  /** Output folder. */
  std::string folder;
  /** Whether nodes are labeled with their names. */
  bool hasLabels{ false };
  /** Provenance for the report. */
  std::vector<std::pair<std::string, std::string>> provenance{};
  std::vector<std::string>                         warnings{};
};

/** Writes comparison.svg and index.html: both graphs, with corresponding circles in one color and unmatched ones gray,
 * and a list of differences with numbers. Throws OutputError. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT void
WriteComparisonPictures(const GraphComparison & comparison, const GraphSideBySide & sheet, const OutputPath & output);

/** Maximum number of steps in a picture of a sequence. Longer sequences are sampled evenly from the first to the last
 * step. \ingroup ShapetonGraphTools */
constexpr int mostStepsOfPicture = 12;

/** Writes steps.svg (small multiples: nodes changed since the previous step green, others red, tracked ones in
 * TrackColors() and enlarged in a second row), correspondence.svg (one color per name through all steps), and
 * index.html with the first of them. If two steps are compared, also writes compare.svg with the changes in green.
 * Throws OutputError. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT void
WriteSequencePictures(const DynamicSequence &          sequence,
                      const std::vector<int> &         compared,
                      const std::vector<std::string> & tracked,
                      const GraphSideBySide &          sheet,
                      const OutputPath &               output);
} // namespace shapeton

#endif
