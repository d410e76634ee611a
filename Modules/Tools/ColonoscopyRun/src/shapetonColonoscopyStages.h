#ifndef shapetonColonoscopyStages_h
#define shapetonColonoscopyStages_h

#include "shapetonStagedRun.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** A stage that is made when those before it have come to their end, and its share of the time. */
struct ColonoscopyStage
{
  std::string                             name;
  double                                  share;
  std::function<Stage(const StagedRun &)> make;
};

/** One of the series of a run. Options that belong to one series alone (seriesUID, lumen, markers, seedPoint, position)
 * have "second" in front for the second one. */
enum class ColonoscopySeries
{
  First,
  Second
};

/** Where results of a series lie in the output folder of the run. */
std::string
FolderOfSeries(const std::string & outputFolder, ColonoscopySeries series);

/** The parameter of the tool that gives this option to this series: seriesUID or secondSeriesUID; inputVolume or
 * second. */
std::string
ParameterOfSeries(const std::string & option, ColonoscopySeries series);

/** The stages of a series up to its landmarks, in their order, with the options that the command line gives them. */
std::vector<ColonoscopyStage>
StagesOfSeries(const CommandLine & commandLine, ColonoscopySeries series);

/** The folds of a series, when its landmarks are there. */
ColonoscopyStage
StageOfFolds(const CommandLine & commandLine, ColonoscopySeries series);

/** What looks at both series, when each has come to its end. */
ColonoscopyStage
StageOfRegistration(const CommandLine & commandLine);

/** The candidates of the first series alone, which those of the second are compared with. */
ColonoscopyStage
StageOfSearch(const CommandLine & commandLine);

/** The search for polyps in a series. Where there are two, candidates are weighed by what the other one shows at their
 * place; that of the second takes the results of StageOfSearch(), that of the first those of the second. */
ColonoscopyStage
StageOfPolyps(const CommandLine & commandLine, ColonoscopySeries series);

/** The page on which a person reads the run, with both positions where there are two. */
ColonoscopyStage
StageOfViewer(const CommandLine & commandLine);

/** Throws ParameterError where results in DICOM are asked for and a series is no DICOM that they could belong to. */
void
CheckDicomResults(const CommandLine & commandLine);

/** The results of a series as DICOM objects beside it, when all else has come to its end. */
ColonoscopyStage
StageOfDicomResults(const CommandLine & commandLine, ColonoscopySeries series);
} // namespace shapeton

#endif
