#ifndef shapetonColonoscopyStages_h
#define shapetonColonoscopyStages_h

#include "shapetonStagedRun.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** A stage that is created once its predecessors have completed, and its fraction of the run time. */
struct ColonoscopyStage
{
  std::string                             name;
  double                                  share;
  std::function<Stage(const StagedRun &)> make;
};

/** One of the series of a run. For the second series, the options specific to a series (seriesUID, lumen, markers,
 * seedPoint, position) have the prefix "second". */
enum class ColonoscopySeries
{
  First,
  Second
};

/** Folder for the results of a series, inside the output folder of the run. */
std::string
FolderOfSeries(const std::string & outputFolder, ColonoscopySeries series);

/** Parameter of the tool that sets this option for this series, such as seriesUID or secondSeriesUID, inputVolume
 * or second. */
std::string
ParameterOfSeries(const std::string & option, ColonoscopySeries series);

/** Stages of a series up to its landmarks, in order, with their options from the command line. */
std::vector<ColonoscopyStage>
StagesOfSeries(const CommandLine & commandLine, ColonoscopySeries series);

/** The fold stage of a series; requires its landmarks. */
ColonoscopyStage
StageOfFolds(const CommandLine & commandLine, ColonoscopySeries series);

/** The registration of both series; requires that both have completed. */
ColonoscopyStage
StageOfRegistration(const CommandLine & commandLine);

/** The polyp search in the first series alone; the candidates of the second series are compared with its results. */
ColonoscopyStage
StageOfSearch(const CommandLine & commandLine);

/** The polyp search in a series. With two series, candidates are weighted by the findings at the corresponding position
 * in the other one: the second series uses the results of StageOfSearch(), and the first series the results of the
 * second. */
ColonoscopyStage
StageOfPolyps(const CommandLine & commandLine, ColonoscopySeries series);

/** The viewer page of the run, with both positions if there are two. */
ColonoscopyStage
StageOfViewer(const CommandLine & commandLine);

/** Throws ParameterError if DICOM results are requested and a series is not DICOM, or if they are not requested, but
 * one of their options is given. */
void
CheckDicomResults(const CommandLine & commandLine);

/** The results of a series as DICOM objects; runs after all other stages. */
ColonoscopyStage
StageOfDicomResults(const CommandLine & commandLine, ColonoscopySeries series);
} // namespace shapeton

#endif
