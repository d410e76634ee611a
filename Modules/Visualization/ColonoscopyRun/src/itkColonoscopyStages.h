#ifndef itkColonoscopyStages_h
#define itkColonoscopyStages_h

#include "itkStagedRun.h"

#include <functional>
#include <string>
#include <vector>

namespace itk
{
class CommandLine;

/** A stage that is made when those before it have come to their end, and its share of the time. */
struct ColonoscopyStage
{
  std::string                             name;
  double                                  share;
  std::function<Stage(const StagedRun &)> make;
};

/** The stages in their order, with the options that the command line gives them. */
std::vector<ColonoscopyStage>
StagesOfColonoscopy(const CommandLine & commandLine);
} // namespace itk

#endif
