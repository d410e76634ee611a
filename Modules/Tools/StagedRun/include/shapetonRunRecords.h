#ifndef shapetonRunRecords_h
#define shapetonRunRecords_h

#include "StagedRunExport.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** \class RunRecords
 * \brief What the records in the folder of a StagedRun say, for programs that take its results.
 *
 * A run that was interrupted, or goes on at this moment, leaves results of stages that were made from older results of
 * others. Nobody should take both for one examination.
 *
 * \ingroup StagedRun */
class StagedRun_EXPORT RunRecords
{
public:
  explicit RunRecords(const std::string & folder);

  /** Throws InputError unless a file of a stage is the one that the stage wrote when it had come to its end, and all
   * results that it was made from, through all stages before, are those that lie in the run now. */
  void
  RequireCurrent(const std::string & stage, const std::string & file) const;

  /** The same of all that a stage wrote, without reading it: throws InputError where the stage has come to its end and
   * was made from results that are no longer there. */
  void
  RequireCurrent(const std::string & stage) const;

  /** Remarks of the tool of a stage; none where it has no record. */
  Remarks
  WarningsOf(const std::string & stage) const;

private:
  std::string
  PathOf(const std::string & stage) const;

  std::string m_Folder;
};
} // namespace shapeton

#endif
