#ifndef shapetonColonLumenSegmentation_h
#define shapetonColonLumenSegmentation_h

#include "ShapetonColonLumenExport.h"

#include "shapetonColonLumenOptions.h"
#include "shapetonRectalCatheter.h"
#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "itkImage.h"
#include "itkPoint.h"
#include "itkVector.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Settings of SegmentColonLumen(). Besides the values of the option, `position` may be a DICOM Patient Position, see
 * GravityOfPatientPosition(); see PatientPositionOf() for "auto" or an empty text. Without a position, gravity is
 * inferred from the fluid levels. A named position is always used. A DICOM code is overridden, with a warning, if the
 * levels that are flat in another direction have an area of at least 50 cm^2 and at least five times that of the levels
 * that agree with the code. \ingroup ShapetonColonLumen */
struct ColonLumenSettings : ColonLumenOptions
{
  /** Called on the calling thread with the completed fraction, which ascends from 0 to 1. May throw to abort. */
  Progress progress;
};

/** Source of the direction of gravity. \ingroup ShapetonColonLumen */
enum class ColonGravitySource
{
  PatientPosition, ///< given in the options
  Levels,          ///< inferred from the fluid levels in the data
  Assumed          ///< supine, by default
};

/** Intensities in HU, all estimated from the data. \ingroup ShapetonColonLumen */
struct ColonThresholds
{
  double gas{ 0.0 };           ///< typical gas inside the body
  double tissue{ 0.0 };        ///< typical soft tissue
  double gasSeed{ 0.0 };       ///< upper threshold of certain gas
  double gasBoundary{ 0.0 };   ///< half height between gas and tissue: the wall
  double fluid{ 0.0 };         ///< mode of tagged fluid, Hf; 0 if none was found
  double fluidSeed{ 0.0 };     ///< lower threshold of certain fluid, "high"
  double fluidBoundary{ 0.0 }; ///< half height between tissue and Hf, "low"; labels use the local half height
};

/** A flat interface between gas and fluid or other matter. \ingroup ShapetonColonLumen */
struct ColonLevel
{
  itk::Point<double, 3> center;
  double                area{ 0.0 };    ///< of the flat central part, mm^2
  double                tilt{ 0.0 };    ///< degrees from perpendicular to gravity
  double                fluidHU{ 0.0 }; ///< mean below the level
  bool                  isTagged{ false };
  bool                  isColon{ false };
};

/** A connected part of the lumen. \ingroup ShapetonColonLumen */
struct LumenPiece
{
  double                gasMl{ 0.0 };
  double                fluidMl{ 0.0 };
  double                inscribedRadius{ 0.0 }; ///< mm, of the largest ball inside
  double                meanGasHU{ 0.0 };
  itk::Point<double, 3> center;
};

/** Gas or bright matter that is not colon. \ingroup ShapetonColonLumen */
struct ColonLeftOut
{
  /** "lung", "airway or esophagus", "stomach", "small bowel or undistended colon", "outside air", "other bright matter"
   */
  std::string           what;
  std::string           why;
  double                ml{ 0.0 };
  double                inscribedRadius{ 0.0 }; ///< mm; 0 where not measured
  double                meanHU{ 0.0 };
  itk::Point<double, 3> center;
  /** Sample points in gas that is too thin for a colon, one per 5 mm cell. */
  std::vector<itk::Point<double, 3>> places;
};

/** \class ColonLumen
 * \brief Result of SegmentColonLumen().
 * \ingroup ShapetonColonLumen */
struct ColonLumen
{
  using LabelImageType = itk::Image<unsigned char, 3>;
  /** On the grid of the input: 1 gas, including the gas half of the layer between gas and fluid, 2 fluid, 0
   * otherwise. */
  LabelImageType::Pointer   labels;
  itk::Vector<double, 3>    gravity; ///< unit vector, LPS
  ColonGravitySource        gravitySource{ ColonGravitySource::Assumed };
  ColonThresholds           thresholds;
  double                    noise{ 0.0 };      ///< standard deviation in soft tissue, HU
  double                    smoothing{ 0.0 };  ///< sigma of the prefilter in mm; 0 for low noise
  bool                      isTagged{ false }; ///< whether fluid brighter than tissue is under the gas of the colon
  std::vector<ColonLevel>   levels;            ///< largest first
  std::vector<LumenPiece>   pieces;            ///< largest first
  std::vector<ColonLeftOut> leftOut;           ///< largest first
  Remarks                   warnings;
  /** A certain catheter in the rectum, which is added to the lumen, or a possible one, which is not; empty for a
   * mask. */
  std::optional<RectalCatheter> catheter;
  /** Reason why the colon is not usable, or empty: "no colon found: ...", "no distended colon found: the largest gas is
   * lung, ..." or "the colon is not distended or tagged enough: ..."; the labels then contain the partial result. */
  std::string failure;
};

/** Segments the gas and the tagged fluid of the colon in a CT colonography; seeds are not required.
 *
 * `ct` is in Hounsfield units with any axes (permuted, oblique, left-handed) and a spacing of about 0.5 to 3 mm. About
 * 6 bytes per voxel are required in addition to the input. The result does not depend on the number of threads.
 *
 * Throws ParameterError if a seed point is outside the image or is in neither gas nor bright matter, or if the patient
 * position is unknown, and InputError if an image dimension is below 8 voxels. \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT ColonLumen
SegmentColonLumen(const itk::Image<float, 3> * ct, const ColonLumenSettings & options = {});

/** Reason why a mask on the grid of a CT (HU) is not a colon lumen: most of its gas is lung. Empty otherwise.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::string
                          FailureOfMask(const itk::Image<float, 3> * ct, const itk::Image<unsigned char, 3> * mask);
} // namespace shapeton

#endif
