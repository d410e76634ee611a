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

  /** Bar or XML, by what stdout is. */
  static Mode
  ModeOfStdout();

  void
  SetMode(Mode mode)
  {
    m_Mode = mode;
  }

  /** Fractions are forced into [0, 1] and never go back; a new stage name ends the previous stage, an empty
   * one continues it. Complete() alone shows the end of the run. */
  void
  Update(const std::string & stage, double stageFraction, double fraction);
  /** The run has succeeded: shows the fraction 1, once, unless nothing was reported. */
  void
  Complete();
  void
  Comment(const std::string & text);
  void
  End();
  /** The stages that have ended, in the order of their first begin, and how long they took, in seconds; also where
   * nothing is shown. */
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
  double                                      m_ShownFraction{ -1.0 }; // negative: nothing of this stage yet
  double                                      m_ShownStageFraction{ -1.0 };
  bool                                        m_HasReports{ false };
  std::size_t                                 m_BarWidth{ 0 }; // of what stands on the terminal
  std::vector<std::pair<std::string, double>> m_StageSeconds;
  Clock::time_point                           m_Start{ Clock::now() };
  Clock::time_point                           m_StageStart{ m_Start };
};
} // namespace shapeton

#endif
