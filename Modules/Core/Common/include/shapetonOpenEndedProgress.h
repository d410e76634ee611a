#ifndef shapetonOpenEndedProgress_h
#define shapetonOpenEndedProgress_h

#include "shapetonProgress.h"

namespace shapeton
{
/** \class OpenEndedProgress
 * \brief Reports progress of work with an unknown number of steps, such as an iteration.
 *
 * The completed fraction grows with each step toward 1; it is one half after the typical number of steps.
 *
 * \ingroup ShapetonCommon */
class OpenEndedProgress
{
public:
  OpenEndedProgress(Progress progress, double usualSteps) : m_Progress(std::move(progress)), m_Usual(usualSteps) {}

  /** Reports that one more step is complete. */
  void
  Step(const std::string & stage = {})
  {
    m_Steps += 1.0;
    m_Progress(stage, this->Share());
  }

  /** Progress callback for one more step, reported as `stage` of the whole. */
  Progress
  NextStep(const std::string & stage = {})
  {
    const double begin = this->Share();
    m_Steps += 1.0;
    return m_Progress.Part(stage, begin, this->Share());
  }

private:
  double
  Share() const
  {
    return m_Steps / (m_Steps + m_Usual);
  }

  Progress m_Progress;
  double   m_Usual;
  double   m_Steps{ 0.0 };
};
} // namespace shapeton

#endif
