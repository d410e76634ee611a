#ifndef shapetonHaustralFoldFiles_h
#define shapetonHaustralFoldFiles_h

#include "shapetonColorTable.h"
#include "shapetonCsvTable.h"
#include "shapetonHaustralFolds.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonVolumeWriter.h"

namespace shapeton
{
/** \defgroup HaustralFoldFiles What is written about folds
 * \ingroup HaustralFolds */
///@{

/** The feature points as curves of one vertex, LPS mm: three for each fold, with the cell arrays fold (its label), kind
 * (0 centre, 1 and 2 ends), reliability (0 to 1), uv (mm of the map), and arcLength (mm along the centreline, of the
 * fold; only where all are known). */
HaustralFolds_EXPORT CurveSet
FeaturesOfFolds(const HaustralFolds & folds);

/** Writes them with these facts as VTP; no points where there are no folds. Throws OutputError. */
HaustralFolds_EXPORT void
WriteFoldFeatures(const HaustralFolds &                                    folds,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path);

/** A row for each fold, of the numbers of HaustralFold, in the shortest text that reads back to the same number; empty
 * cells for what is not known, and in the column notAssessable the name of the hindrance, or nothing. */
HaustralFolds_EXPORT CsvTable
TableOfFolds(const HaustralFolds & folds);

/** The folds of such a table as a file: exactly those that were written. Throws InputError that names the file and the
 * line. */
HaustralFolds_EXPORT std::vector<HaustralFold>
                     ReadFoldTable(const std::string & path);

/** The centres and the ends as two lists of points for 3D Slicer, named by label. Lists without points are left out. */
HaustralFolds_EXPORT std::vector<Markup>
                     MarkupsOfFolds(const HaustralFolds & folds);

/** A colour for each label; neighbours along the colon differ. */
HaustralFolds_EXPORT std::vector<LabelColor>
                     ColorsOfFolds(const HaustralFolds & folds);

/** Throws ParameterError unless the name is empty (not wanted) or ends with .nrrd. */
HaustralFolds_EXPORT const std::string &
                           RequireFoldLabelsName(const std::string & path);

/** Writes NRRD, compressed; pixel size and circumference of the grid stand beside `metadata` in its header. Throws
 * OutputError when the file cannot be written, ParameterError for another extension. */
HaustralFolds_EXPORT void
WriteFoldLabels(const HaustralFolds &  folds,
                const FlatColonGrid &  grid,
                const std::string &    path,
                const VolumeMetadata & metadata = {});

/** Reads what WriteFoldLabels() has written. Throws InputError that names the file and the fault.
 * \ingroup HaustralFolds */
HaustralFolds_EXPORT itk::Image<unsigned short, 2>::Pointer
                     ReadFoldLabels(const std::string & path);

/** The fold of each face of a flat surface, by such labels at its middle; 0 for none. Throws InputError where the
 * surface has no point array uv. */
HaustralFolds_EXPORT std::vector<unsigned short>
                     FoldsOfFaces(const SurfaceMesh & flat, const itk::Image<unsigned short, 2> & labels);
///@}
} // namespace shapeton

#endif
