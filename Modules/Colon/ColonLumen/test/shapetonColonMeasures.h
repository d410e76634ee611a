#ifndef shapetonColonMeasures_h
#define shapetonColonMeasures_h

#include "shapetonElectronicCleansing.h"

#include <iosfwd>
#include <string>

namespace shapeton
{
/** A volume for measurements: any input of ReadVolume(), or a NumPy file of 16-bit integers with voxels of 1 mm. */
itk::Image<float, 3>::Pointer
ReadColonTestVolume(const std::string & path, std::string & patientPosition);

/** Points of the 0.5 isosurface of an occupancy (LPS): crossings of 0.5 between face-adjacent voxels. */
std::vector<itk::Point<double, 3>>
HalfLevelPoints(const itk::Image<float, 3> * occupancy);

/** Prints Dice, leak and surface distances to the truth in a folder: lumen.nrrd (nonzero: lumen), wall.vtp.
 */
void
CompareWithTruth(const itk::Image<float, 3> * ct,
                 const ColonLumen &           lumen,
                 const CleansedColon &        cleansed,
                 const std::string &          folder,
                 std::ostream &               out);
} // namespace shapeton

#endif
