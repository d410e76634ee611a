#ifndef Diffusion_h
#define Diffusion_h

#include "Errors.h"

#include "shapetonProgress.h"

#include "itkCommand.h"

#include <optional>
#include <utility>

namespace shapeton::python
{
/** Lower and upper intensity; if absent, minimum and maximum of the image. */
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

/** Calls Update() and reports the filter's progress as progress of a stage. Removes all observers of the filter. */
template <typename TFilter>
void
UpdateWithProgress(TFilter * filter, const char * stage, const Progress & progress)
{
  filter->RemoveAllObservers(); // left by a previous call
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { progress(stage, filter->GetProgress()); });
  Update(filter);
}
} // namespace shapeton::python

#endif
