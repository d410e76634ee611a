#ifndef Diffusion_h
#define Diffusion_h

#include "Errors.h"

#include "shapetonProgress.h"

#include "itkCommand.h"

#include <optional>
#include <utility>

namespace shapeton::python
{
/** The least and the greatest intensity; none: those of the image. */
using Window = std::optional<std::pair<double, double>>;

template <typename TFilter>
void
SetWindow(const Window & window, TFilter * filter)
{
  if (window)
  {
    filter->SetIntensityWindow(window->first, window->second);
  }
}

/** Update() that reports the filter's progress as that of a stage. Observers of the filter are taken off it. */
template <typename TFilter>
void
UpdateWithProgress(TFilter * filter, const char * stage, const Progress & progress)
{
  filter->RemoveAllObservers(); // of a call before, which has ended
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { progress(stage, filter->GetProgress()); });
  Update(filter);
}
} // namespace shapeton::python

#endif
