#ifndef shapetonLiveExplorer_h
#define shapetonLiveExplorer_h

#include "HeatExplorerExport.h"
#include "shapetonHeatExplorer.h"
#include "shapetonShapeAnalysis.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** How far a run has come, in words. \ingroup HeatExplorer */
struct LiveState
{
  std::uint64_t timeStep{ 0 };
  std::string   progress;
  bool          isFinished{ false };
};

/** \class LiveExplorer
 * \brief The page of HeatExplorer for a run that goes on: it looks for a new state every few seconds.
 *
 * The states are one file, so that the page never sees half of one when it is replaced by renaming. The page keeps the
 * histogram of the states so far, at most 64 of them.
 *
 * \ingroup HeatExplorer */
class HeatExplorer_EXPORT LiveExplorer
{
public:
  /** The page lies beside the folder of its data, DataFolder(), which is there already. */
  LiveExplorer(const std::string & page, const OutputPath & outputPath);

  /** "now-data" of "now.html", with the folder that both lie in. */
  std::string
  DataFolder() const;
  /** Files that WritePage() writes. */
  std::vector<std::string>
  PageFiles() const;
  /** The file that WriteState() writes. */
  std::string
  StateFile() const;

  /** Of the content, title, image, window and scale. Throws OutputError. */
  void
  WritePage(const HeatExplorerContent & content, double secondsBetweenStates) const;
  /** Throws OutputError. */
  void
  WriteState(const ShapeAnalysis & shape, const LiveState & state);

private:
  void
  Remember(const HeatHistogram & row);

  std::string                m_Page;
  OutputPath                 m_OutputPath;
  std::vector<HeatHistogram> m_Rows;
};
} // namespace shapeton

#endif
