#ifndef shapetonPatientSpace_h
#define shapetonPatientSpace_h

#include "ShapetonMeshBridgeExport.h"

#include <string>

class vtkFieldData;

namespace shapeton
{
/** Axes of positions in mm: LPS for DICOM and ITK, RAS for 3D Slicer scenes and NIfTI. They differ by negated x and y,
 * a half turn that preserves surface orientation. \ingroup ShapetonMeshBridge */
enum class PatientSpace
{
  LPS,
  RAS
};

/** "LPS", "RAS". \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT std::string
                          NameOf(PatientSpace space);

/** Writes the space to the field data SPACE, as 3D Slicer does. \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT void
SetSpace(PatientSpace space, vtkFieldData & data);

/** The space stated in the field data, else `otherwise`. Throws InputError for any other value.
 * \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT PatientSpace
SpaceOf(vtkFieldData & data, PatientSpace otherwise);
} // namespace shapeton

#endif
