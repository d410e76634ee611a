#ifndef shapetonLiveExplorer_h
#define shapetonLiveExplorer_h

#include "ShapetonHeatViewsExport.h"
#include "shapetonHeatExplorer.h"
#include "shapetonShapeAnalysis.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Progress of a run, as text. \ingroup ShapetonHeatViews */
struct LiveState
{
  std::uint64_t timeStep{ 0 };
  std::string   progress;
  bool          isFinished{ false };
};

/** \class LiveExplorer
 * \brief The HeatExplorer page for a running computation; polls for a new state every few seconds.
 *
 * Each state is a single file, replaced by renaming, so the page never reads a partial state. The page keeps the
 * histogram of the states so far, at most 64 rows.
 *
 * \ingroup ShapetonHeatViews */
class ShapetonHeatViews_EXPORT LiveExplorer
{
public:
  /** The page is next to its data folder, DataFolder(), which must exist. */
  LiveExplorer(const std::string & page, const OutputPath & outputPath);

  /** "now-data" for "now.html", including the path of their folder. */
  std::string
  DataFolder() const;
  /** Files written by WritePage(). */
  std::vector<std::string>
  PageFiles() const;
  /** File written by WriteState(). */
  std::string
  StateFile() const;

  /** Uses title, image, window and scale of the content. Throws OutputError. */
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
