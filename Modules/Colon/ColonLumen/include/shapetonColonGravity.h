#ifndef shapetonColonGravity_h
#define shapetonColonGravity_h

#include "ShapetonColonLumenExport.h"

#include "itkObject.h"
#include "itkVector.h"

#include <optional>
#include <string>

namespace shapeton
{
/** The direction of gravity, a unit vector in LPS, for a DICOM Patient Position (0018,5100): HFS, HFP, HFDR, HFDL, FFS,
 * FFP, FFDR, FFDL, or one of the names supine, prone, leftDecubitus, rightDecubitus (DL: lying on the left side).
 * Whether the head or the feet are first is irrelevant, since LPS is fixed to the patient. Empty for any other text,
 * such as a sitting position.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::optional<itk::Vector<double, 3>>
                          GravityOfPatientPosition(const std::string & code);

/** The given position; for "auto" or an empty text, the Patient Position among the DICOM fields of the image, see
 * DicomField().
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::string
                          PatientPositionOf(const itk::Object * image, const std::string & given);

/** GravityOfPatientPosition(), or no value for "auto" or an empty text. Throws ParameterError for any other unknown
 * text.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::optional<itk::Vector<double, 3>>
                          GivenGravity(const std::string & position);

/** "supine", "prone", "leftDecubitus" or "rightDecubitus", whichever is closest to a direction in LPS.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::string
                          NameOfGravity(const itk::Vector<double, 3> & gravity);
} // namespace shapeton

#endif
