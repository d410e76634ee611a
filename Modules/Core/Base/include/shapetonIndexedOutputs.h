#ifndef shapetonIndexedOutputs_h
#define shapetonIndexedOutputs_h

#include "itkProcessObject.h"

/** \def shapetonIndexedOutputsMacro
 * In a filter whose outputs are of several types, which it makes by MakeOutput(index): an output that is disconnected
 * from the pipeline is replaced by one of its own type. itk::ImageSource would make one of the type of the first. */
#define shapetonIndexedOutputsMacro()                                                                                  \
  itk::DataObject::Pointer MakeOutput(const itk::ProcessObject::DataObjectIdentifierType & name) override              \
  {                                                                                                                    \
    return this->MakeOutput(this->MakeIndexFromOutputName(name));                                                      \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT

#endif
