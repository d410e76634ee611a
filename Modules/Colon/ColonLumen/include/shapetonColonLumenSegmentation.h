#ifndef shapetonColonLumenSegmentation_h
#define shapetonColonLumenSegmentation_h

#include "ShapetonColonLumenExport.h"

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
/** Prior knowledge for SegmentColonLumen(): patient position and points in the colon.
 * \ingroup ShapetonColonLumen */
struct ColonLumenOptions
{
  /** DICOM Patient Position or a name, see GravityOfPatientPosition(). Empty: gravity is inferred from the levels. A
   * name is used as given. The code of a header is overridden, with a warning, by fluid levels of 50 cm^2 that are flat
   * in another direction and five times the area that is flat in its own. */
  std::string patientPosition;
  /** Points in LPS, mm. Pieces of gas or bright fluid that contain them are colon, overriding the automatic choice. */
  std::vector<itk::Point<double, 3>> seedPoints;
  /** Called with the completed fraction, 0..1, ascending, always from the calling thread. May throw to abort. */
  Progress progress;
};

/** Source of the direction of gravity. \ingroup ShapetonColonLumen */
enum class ColonGravitySource
{
  PatientPosition, ///< stated by the options
  Levels,          ///< inferred from the fluid levels in the data
  Assumed          ///< neither known: supine is assumed
};

/** Intensities in HU, all estimated from the data. \ingroup ShapetonColonLumen */
struct ColonThresholds
{
  double gas{ 0.0 };           ///< typical gas inside the body
  double tissue{ 0.0 };        ///< typical soft tissue
  double gasSeed{ 0.0 };       ///< certainly gas below this
  double gasBoundary{ 0.0 };   ///< half height between gas and tissue: the wall
  double fluid{ 0.0 };         ///< mode of tagged fluid, Hf; 0 if none was found
  double fluidSeed{ 0.0 };     ///< certainly fluid above this, "high"
  double fluidBoundary{ 0.0 }; ///< half height between tissue and Hf, "low"; labels use the local half height
};

/** A flat surface of fluid or other matter under gas. \ingroup ShapetonColonLumen */
struct ColonLevel
{
  itk::Point<double, 3> center;
  double                area{ 0.0 };    ///< mm^2 of its flat middle part
  double                tilt{ 0.0 };    ///< degrees from perpendicular to gravity
  double                fluidHU{ 0.0 }; ///< mean of the matter below it
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
  /** For gas too thin for a colon: points in it, one for each cell of 5 mm. */
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
  bool                      isTagged{ false }; ///< fluid brighter than tissue is under the gas of the colon
  std::vector<ColonLevel>   levels;            ///< largest first
  std::vector<LumenPiece>   pieces;            ///< largest first
  std::vector<ColonLeftOut> leftOut;           ///< largest first
  Remarks                   warnings;
  /** A certain catheter in the rectum, which is filled in, or a possible one; empty for a mask. */
  std::optional<RectalCatheter> catheter;
  /** Empty, or why this is not a usable colon: "no colon found: ...", "no distended colon found: the largest gas is
   * lung, ..." or "the colon is not distended or tagged enough: ..."; the labels then contain what was found. */
  std::string failure;
};

/** Segments the gas and the tagged fluid of the colon in a CT colonography, without seeds.
 *
 * `ct`: Hounsfield units; any axes (permuted, oblique, left-handed), spacing about 0.5 to 3 mm. Needs about 6 bytes per
 * voxel besides the input. The result is identical for any number of threads.
 *
 * Throws ParameterError when a seed point is outside the image or in neither gas nor bright matter, or when the patient
 * position is unknown; InputError when a dimension of the image is below 8 voxels. \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT ColonLumen
SegmentColonLumen(const itk::Image<float, 3> * ct, const ColonLumenOptions & options = {});

/** Why a mask on the grid of a CT in HU is not a colon lumen: most of its gas is lung. Empty if it may be a colon.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT std::string
                  FailureOfMask(const itk::Image<float, 3> * ct, const itk::Image<unsigned char, 3> * mask);
} // namespace shapeton

#endif
