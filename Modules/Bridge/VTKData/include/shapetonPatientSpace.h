#ifndef shapetonPatientSpace_h
#define shapetonPatientSpace_h

#include "VTKDataExport.h"

#include <string>

class vtkFieldData;

namespace shapeton
{
/** The axes of positions in mm: DICOM and ITK have LPS, 3D Slicer's scene and NIfTI RAS. The one is the other with x
 * and y negated, a half turn, so that surfaces keep their outside. \ingroup VTKData */
enum class PatientSpace
{
  LPS,
  RAS
};

/** "LPS", "RAS". \ingroup VTKData */
VTKData_EXPORT std::string
               NameOf(PatientSpace space);

/** States the space as 3D Slicer does, in the field data SPACE. \ingroup VTKData */
VTKData_EXPORT void
SetSpace(PatientSpace space, vtkFieldData & data);

/** The space that the field data state, else `otherwise`. Throws InputError where they state a third one.
 * \ingroup VTKData */
VTKData_EXPORT PatientSpace
SpaceOf(vtkFieldData & data, PatientSpace otherwise);
} // namespace shapeton

#endif
