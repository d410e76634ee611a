#ifndef shapetonHaustralFoldFiles_h
#define shapetonHaustralFoldFiles_h

#include "shapetonColorTable.h"
#include "shapetonCsvTable.h"
#include "shapetonHaustralFolds.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonVolumeWriter.h"

namespace shapeton
{
/** \defgroup HaustralFoldFiles Output files of folds
 * \ingroup ShapetonFlatColon */
///@{

/** Feature points as curves of one vertex each, LPS mm: three per fold, with the cell arrays fold (label), kind (0
 * center, 1 and 2 ends), reliability (0 to 1), uv (mm of the map), and arcLength (of the fold, mm along the centerline;
 * only if known for all folds). */
ShapetonFlatColon_EXPORT CurveSet
FeaturesOfFolds(const HaustralFolds & folds);

/** Writes the feature points and metadata as VTP; the file is empty if there are no folds. Throws OutputError. */
ShapetonFlatColon_EXPORT void
WriteFoldFeatures(const HaustralFolds &                                    folds,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path);

/** One row per fold with the values of HaustralFold, each written as the shortest text that is read back exactly.
 * Unknown values are empty; the column notAssessable is the name of the hindrance or empty. */
ShapetonFlatColon_EXPORT CsvTable
TableOfFolds(const HaustralFolds & folds);

/** Reads the folds from a table file; the values are restored exactly. Throws an InputError that states the file and
 * the line. */
ShapetonFlatColon_EXPORT std::vector<HaustralFold>
                         ReadFoldTable(const std::string & path);

/** Centers and ends as two lists of points for 3D Slicer, named by label; empty lists are omitted. */
ShapetonFlatColon_EXPORT std::vector<Markup>
                         MarkupsOfFolds(const HaustralFolds & folds);

/** A color for each label; neighbors along the colon have different colors. */
ShapetonFlatColon_EXPORT std::vector<LabelColor>
                         ColorsOfFolds(const HaustralFolds & folds);

/** Throws ParameterError unless the name is empty (not requested) or ends with .nrrd. */
ShapetonFlatColon_EXPORT const std::string &
                               RequireFoldLabelsName(const std::string & path);

/** Writes a compressed NRRD file whose header contains the pixel size and circumference of the grid and `metadata`.
 * Throws OutputError if the file cannot be written, and ParameterError for another extension. */
ShapetonFlatColon_EXPORT void
WriteFoldLabels(const HaustralFolds &  folds,
                const FlatColonGrid &  grid,
                const std::string &    path,
                const VolumeMetadata & metadata = {});

/** Reads a file written by WriteFoldLabels(). Throws an InputError that states the file and the error.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT itk::Image<unsigned short, 2>::Pointer
                         ReadFoldLabels(const std::string & path);

/** Fold label at the center of each face of a flat surface; 0 for wall. Throws InputError if the surface lacks the
 * point array uv. */
ShapetonFlatColon_EXPORT std::vector<unsigned short>
                         FoldsOfFaces(const SurfaceMesh & flat, const itk::Image<unsigned short, 2> & labels);
///@}
} // namespace shapeton

#endif
