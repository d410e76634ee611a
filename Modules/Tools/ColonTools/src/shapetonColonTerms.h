#ifndef shapetonColonTerms_h
#define shapetonColonTerms_h

#include "ShapetonColonToolsExport.h"
#include "shapetonDicomCode.h"

#include <string>

namespace shapeton
{
/** \brief Colon terms from SNOMED CT, DICOM, UCUM and LOINC, and private codes where none exists. */
namespace colonterms
{
inline const DicomCode anatomy{ "123037004", "SCT", "Anatomical Structure" };
inline const DicomCode substance{ "91720002", "SCT", "Body Substance" };
inline const DicomCode abnormal{ "49755003", "SCT", "Morphologically Abnormal Structure" };

inline const DicomCode colon{ "71854001", "SCT", "Colon" };
inline const DicomCode ileum{ "34516001", "SCT", "Ileum" };
inline const DicomCode gas{ "74947009", "SCT", "Gas" };
inline const DicomCode fluid{ "442170005", "SCT", "Intraluminal fluid" };
inline const DicomCode lesion{ "52988006", "SCT", "Lesion" };
inline const DicomCode polyp{ "68496003", "SCT", "Polyp of colon" };
inline const DicomCode sessile{ "5712003", "SCT", "Sessile" };
inline const DicomCode pedunculated{ "25126001", "SCT", "Pedunculated" };
inline const DicomCode flat{ "6041008", "SCT", "Flat" };
inline const DicomCode fold{ "FOLD", "99SHAPETON", "Haustral fold" };

inline const DicomCode ct{ "25045-6", "LN", "CT unspecified body region" };
inline const DicomCode findingSite{ "363698007", "SCT", "Finding Site" };
inline const DicomCode morphology{ "MORPHOLOGY", "99SHAPETON", "Morphology of a polyp" };
inline const DicomCode colonAssessment{ "112222", "DCM", "Colon Overall Assessment" };
inline const DicomCode extracolonicAssessment{ "EXTRACOLONIC", "99SHAPETON", "Extracolonic assessment" };
inline const DicomCode polypSize{ "373197004", "SCT", "Polyp size, largest dimension" };
inline const DicomCode diameter{ "81827009", "SCT", "Diameter" };
inline const DicomCode length{ "410668003", "SCT", "Length" };
inline const DicomCode height{ "121207", "DCM", "Height" };
inline const DicomCode volume{ "118565006", "SCT", "Volume" };
inline const DicomCode pathLength{ "121211", "DCM", "Path length" };
inline const DicomCode distanceFromAnus{ "112233", "DCM", "Distance from anus" };
inline const DicomCode attenuation{ "112031", "DCM", "Attenuation Coefficient" };
inline const DicomCode certainty{ "111012", "DCM", "Certainty of Finding" };
inline const DicomCode mean{ "373098007", "SCT", "Mean" };
inline const DicomCode median{ "373099004", "SCT", "Median" };
inline const DicomCode maximum{ "56851009", "SCT", "Maximum" };

inline const DicomCode mm{ "mm", "UCUM", "mm" };
inline const DicomCode mm3{ "mm3", "UCUM", "mm3" };
inline const DicomCode ml{ "ml", "UCUM", "ml" };
inline const DicomCode hounsfield{ "[hnsf'U]", "UCUM", "Hounsfield unit" };
inline const DicomCode percent{ "%", "UCUM", "Percent" };

/** Code of a colon segment, 1 rectum to 6 cecum; other numbers return the code of the colon. */
const DicomCode &
CodeOfSegment(int segment);

/** Code of a C-RADS category, version 2023 (Yee et al., Radiology 2024): "C0" to "C4" and "E0" to "E4", as in
 * ReaderAssessment. DICOM CID 6200 has C0 to C4; its subdivisions C2a and C2b, and the extracolonic categories, have
 * private codes. Throws std::out_of_range for another word. */
ShapetonColonTools_EXPORT const DicomCode &
CodeOfCategory(const std::string & category);
} // namespace colonterms
} // namespace shapeton

#endif
