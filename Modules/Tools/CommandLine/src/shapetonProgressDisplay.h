#ifndef shapetonProgressDisplay_h
#define shapetonProgressDisplay_h

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Progress on stdout: a bar with the remaining time on a terminal, 3D Slicer's XML otherwise, or nothing.
 * May be called from any thread. */
class ProgressDisplay
{
public:
  enum class Mode
  {
    Bar,
    XML,
    Off
  };

  /** Bar on a terminal, XML otherwise. */
  static Mode
  ModeOfStdout();

  void
  SetMode(Mode mode)
  {
    m_Mode = mode;
  }

  /** Fractions are clamped to [0, 1] and never decrease. A new stage name ends the previous stage; an empty name
   * continues it. Only Complete() shows the end of the run. */
  void
  Update(const std::string & stage, double stageFraction, double fraction);
  /** Marks the run as successful: shows the fraction 1 once, unless nothing was reported. */
  void
  Complete();
  void
  Comment(const std::string & text);
  /** Prints a line on a terminal. */
  void
  Print(const std::string & line);
  void
  End();
  /** Completed stages in the order they were first started, with their durations in seconds; recorded even if nothing
   * is shown. */
  std::vector<std::pair<std::string, double>>
  StageSeconds() const
  {
    return m_StageSeconds;
  }

private:
  using Clock = std::chrono::steady_clock;

  void
  StartStage(const std::string & stage);
  void
  EndStage();
  void
  CountStage(double seconds);
  bool
  IsNews() const;
  void
  Show();
  void
  DrawBar();
  void
  ClearBar();

  std::mutex                                  m_Mutex;
  Mode                                        m_Mode{ Mode::XML };
  std::string                                 m_Stage;
  double                                      m_Fraction{ 0.0 };
  double                                      m_StageFraction{ 0.0 };
  double                                      m_ShownFraction{ -1.0 }; // negative: nothing shown for this stage yet
  double                                      m_ShownStageFraction{ -1.0 };
  bool                                        m_HasReports{ false };
  std::size_t                                 m_BarWidth{ 0 }; // width of the text on the terminal
  std::vector<std::pair<std::string, double>> m_StageSeconds;
  Clock::time_point                           m_Start{ Clock::now() };
  Clock::time_point                           m_StageStart{ m_Start };
};
} // namespace shapeton

#endif
