#ifndef Diffusion_h
#define Diffusion_h

#include "Errors.h"

#include "shapetonProgress.h"

#include "itkCommand.h"

namespace shapeton::python
{
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
