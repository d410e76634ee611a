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

/** Feature points as curves of one vertex, LPS mm: three for each fold, with the cell arrays fold (its label), kind (0
 * center, 1 and 2 ends), reliability (0 to 1), uv (mm of the map), and arcLength (mm along the centerline, of the fold;
 * only if known for all). */
ShapetonFlatColon_EXPORT CurveSet
FeaturesOfFolds(const HaustralFolds & folds);

/** Writes the feature points with these facts as VTP; without folds the file has no points. Throws OutputError. */
ShapetonFlatColon_EXPORT void
WriteFoldFeatures(const HaustralFolds &                                    folds,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path);

/** One row per fold with the values of HaustralFold, in the shortest text that reads back exactly; unknown values are
 * empty, and the column notAssessable has the name of the hindrance, or is empty. */
ShapetonFlatColon_EXPORT CsvTable
TableOfFolds(const HaustralFolds & folds);

/** Reads the folds of such a table from a file, exactly as written. Throws InputError with the file and the
 * line. */
ShapetonFlatColon_EXPORT std::vector<HaustralFold>
                     ReadFoldTable(const std::string & path);

/** Centers and ends as two lists of points for 3D Slicer, named by label. Empty lists are left out. */
ShapetonFlatColon_EXPORT std::vector<Markup>
                     MarkupsOfFolds(const HaustralFolds & folds);

/** A color for each label; neighbors along the colon differ. */
ShapetonFlatColon_EXPORT std::vector<LabelColor>
                     ColorsOfFolds(const HaustralFolds & folds);

/** Throws ParameterError unless the name is empty (not requested) or ends with .nrrd. */
ShapetonFlatColon_EXPORT const std::string &
                           RequireFoldLabelsName(const std::string & path);

/** Writes compressed NRRD; its header contains pixel size and circumference of the grid and `metadata`. Throws
 * OutputError when the file cannot be written, ParameterError for another extension. */
ShapetonFlatColon_EXPORT void
WriteFoldLabels(const HaustralFolds &  folds,
                const FlatColonGrid &  grid,
                const std::string &    path,
                const VolumeMetadata & metadata = {});

/** Reads a file of WriteFoldLabels(). Throws InputError with the file and the error.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT itk::Image<unsigned short, 2>::Pointer
                     ReadFoldLabels(const std::string & path);

/** The fold of each face of a flat surface, from the label at its center; 0 for none. Throws InputError when the
 * surface has no point array uv. */
ShapetonFlatColon_EXPORT std::vector<unsigned short>
                     FoldsOfFaces(const SurfaceMesh & flat, const itk::Image<unsigned short, 2> & labels);
///@}
} // namespace shapeton

#endif
