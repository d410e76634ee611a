#ifndef shapetonITKCompatibility_h
#define shapetonITKCompatibility_h

#include "itkMacro.h"

// All source code that depends on the ITK version (5.2 to 6.0); for CMake, see CMake/ShapetonITKTargets.cmake.

// Replaces itkTypeMacro from 5.4 on; 6.0 no longer defines itkTypeMacro.
#ifndef itkOverrideGetNameOfClassMacro
#  define itkOverrideGetNameOfClassMacro(thisClass)                                                                    \
    const char * GetNameOfClass() const override { return #thisClass; }                                                \
    ITK_MACROEND_NOOP_STATEMENT
#endif

// Like itkNewMacro, but without the second semicolon that 5.2 leaves after the class member (-Wpedantic).
#define shapetonNewMacro(thisClass)                                                                                    \
  itkSimpleNewMacro(thisClass);                                                                                        \
  itkCreateAnotherMacro(thisClass);                                                                                    \
  itkCloneMacro(thisClass)

// ITK's input macros use this unqualified name, which 6.0 declares in the namespace itk.
#if ITK_VERSION_MAJOR >= 6
namespace shapeton
{
using itk::itkDynamicCastInDebugMode;
}
#endif

#endif
