#ifndef shapetonIndexedOutputs_h
#define shapetonIndexedOutputs_h

#include "itkProcessObject.h"

/** \def shapetonIndexedOutputsMacro
 * For filters with outputs of several types, created by MakeOutput(index): an output disconnected from the pipeline is
 * replaced by an object of the same type. itk::ImageSource would use the type of the first output. */
#define shapetonIndexedOutputsMacro()                                                                                  \
  itk::DataObject::Pointer MakeOutput(const itk::ProcessObject::DataObjectIdentifierType & name) override              \
  {                                                                                                                    \
    return this->MakeOutput(this->MakeIndexFromOutputName(name));                                                      \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT

#endif
