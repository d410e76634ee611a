#ifndef shapetonITKCompatibility_h
#define shapetonITKCompatibility_h

#include "itkMacro.h"

// All that the sources must know about versions of ITK, 5.2 to 6.0; for CMake it is CMake/ShapetonITKTargets.cmake.

// From 5.4 on in place of itkTypeMacro, which 6.0 drops.
#ifndef itkOverrideGetNameOfClassMacro
#  define itkOverrideGetNameOfClassMacro(thisClass)                                                                    \
    const char * GetNameOfClass() const override { return #thisClass; }                                                \
    ITK_MACROEND_NOOP_STATEMENT
#endif

// ITK's macros of inputs call this by its bare name, which 6.0 has in the namespace itk.
#if ITK_VERSION_MAJOR >= 6
namespace shapeton
{
using itk::itkDynamicCastInDebugMode;
}
#endif

#endif
