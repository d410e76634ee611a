#ifndef shapetonShapeTable_h
#define shapetonShapeTable_h

#include "shapetonLabelShapes.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "shapetonShapeSignature.h"
#include "shapetonShapeTableOptions.h"

#include <string>

namespace shapeton
{
/** A shape of a label map. \ingroup ShapetonShapeSignature */
struct ShapeRow
{
  int label{ 0 };
  /** 1 for the largest component of the label; 0 for the whole label. */
  int         component{ 0 };
  std::size_t voxels{ 0 };
  /** Mean and deviation of the intensities of its voxels, to help a user recognize the shape; not part of the
   * signature. */
  double         meanIntensity{ 0.0 };
  double         intensityDeviation{ 0.0 };
  ShapeSignature signature;

  /** "7" or, for a component, "7.1". */
  ShapetonShapeSignature_EXPORT std::string
                                Name() const;
};

/** The shapes of a label map. \ingroup ShapetonShapeSignature */
struct ShapeTable
{
  std::vector<ShapeRow> rows; ///< by label, then component
  Remarks               remarks;
};

/** Describes each label, or each connected component of each label. Shapes too small or too thin for a signature are
 * skipped with a remark. `intensities` has the grid of `labels`. Throws InputError if no shape remains, and the
 * exceptions of LabelsOf(). Throws std::invalid_argument if the sizes differ. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT ShapeTable
DescribeShapes(const itk::Image<float, 3> * intensities,
               const LabelMap *             labels,
               const ShapeTableOptions &    options = {},
               const Progress &             progress = {});

/** Writes a CSV file with one line per shape; numbers read back unchanged. Throws OutputError.
 * \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT void
WriteShapeTable(const ShapeTable & table, const std::string & path);

/** Reads a table written by WriteShapeTable(). Throws InputError with file and line if it is not such a table, or a
 * number is out of range. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT ShapeTable
ReadShapeTable(const std::string & path);

/** Throws InputError with the prefix `what` for a signature that no shape can have. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT void
RequireSound(const ShapeSignature & signature, const std::string & what);
} // namespace shapeton

#endif
