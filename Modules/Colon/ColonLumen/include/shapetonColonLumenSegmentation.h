#ifndef shapetonColonLumenSegmentation_h
#define shapetonColonLumenSegmentation_h

#include "ColonLumenExport.h"

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
/** What is known of a CT before its lumen is sought: position of the patient, points in the colon.
 * \ingroup ColonLumen */
struct ColonLumenOptions
{
  /** DICOM Patient Position or a name, see GravityOfPatientPosition(). Empty: gravity is inferred from the levels. A
   * name is taken as it is; the code of a header gives way, with a warning, to fluid levels of 50 cm^2 that are flat in
   * another direction, and five times what is flat in its own. */
  std::string patientPosition;
  /** Points in LPS, mm. The pieces of gas or bright fluid that hold them are colon, whatever the automatic choice says.
   */
  std::vector<itk::Point<double, 3>> seedPoints;
  /** Called with the share that is done, 0..1, ascending, always from the calling thread. May throw to abort. */
  Progress progress;
};

/** Where the direction of gravity comes from. \ingroup ColonLumen */
enum class ColonGravitySource
{
  PatientPosition, ///< the options say it
  Levels,          ///< the fluid levels in the data say it
  Assumed          ///< neither: supine is assumed
};

/** Intensities in HU, all from the data. \ingroup ColonLumen */
struct ColonThresholds
{
  double gas{ 0.0 };           ///< typical gas inside the body
  double tissue{ 0.0 };        ///< typical soft tissue
  double gasSeed{ 0.0 };       ///< surely gas below
  double gasBoundary{ 0.0 };   ///< half-height between gas and tissue: where the wall begins
  double fluid{ 0.0 };         ///< mode of tagged fluid, Hf; 0 where there is none
  double fluidSeed{ 0.0 };     ///< surely fluid above, "high"
  double fluidBoundary{ 0.0 }; ///< half-height between tissue and Hf, "low"; the labels follow the local half-height
};

/** A flat surface of what lies under gas. \ingroup ColonLumen */
struct ColonLevel
{
  itk::Point<double, 3> centre;
  double                area{ 0.0 };    ///< mm^2 of its flat middle part
  double                tilt{ 0.0 };    ///< degrees from perpendicular to gravity
  double                fluidHU{ 0.0 }; ///< what lies below it
  bool                  isTagged{ false };
  bool                  isColon{ false };
};

/** A connected part of the lumen. \ingroup ColonLumen */
struct LumenPiece
{
  double                gasMl{ 0.0 };
  double                fluidMl{ 0.0 };
  double                inscribedRadius{ 0.0 }; ///< mm, of the largest ball in it
  double                meanGasHU{ 0.0 };
  itk::Point<double, 3> centre;
};

/** Gas or bright matter that is not colon. \ingroup ColonLumen */
struct ColonLeftOut
{
  /** "lung", "airway or esophagus", "stomach", "small bowel or undistended colon", "outside air", "other bright matter"
   */
  std::string           what;
  std::string           why;
  double                ml{ 0.0 };
  double                inscribedRadius{ 0.0 }; ///< mm; 0 where not measured
  double                meanHU{ 0.0 };
  itk::Point<double, 3> centre;
  /** Of gas too thin for colon: points in it, one for each cell of 5 mm. */
  std::vector<itk::Point<double, 3>> places;
};

/** \class ColonLumen
 * \brief What SegmentColonLumen() found.
 * \ingroup ColonLumen */
struct ColonLumen
{
  using LabelImageType = itk::Image<unsigned char, 3>;
  /** On the input's grid: 1 gas, with the gas half of the layer between gas and fluid, 2 fluid, 0 anything else. */
  LabelImageType::Pointer   labels;
  itk::Vector<double, 3>    gravity; ///< unit vector, LPS
  ColonGravitySource        gravitySource{ ColonGravitySource::Assumed };
  ColonThresholds           thresholds;
  double                    noise{ 0.0 };      ///< standard deviation in soft tissue, HU
  double                    smoothing{ 0.0 };  ///< sigma of the prefilter in mm; 0 where the noise asks for none
  bool                      isTagged{ false }; ///< fluid brighter than tissue lies under the colon's gas
  std::vector<ColonLevel>   levels;            ///< the largest first
  std::vector<LumenPiece>   pieces;            ///< the largest first
  std::vector<ColonLeftOut> leftOut;           ///< the largest first
  Remarks                   warnings;
  /** A tube in the rectum: a catheter, which is filled in, or what may be one; none of a mask. */
  std::optional<RectalCatheter> catheter;
  /** Empty, or why this is not a usable colon: "no colon found: ...", "no distended colon found: the largest gas is
   * lung, ..." or "the colon is not distended or tagged enough: ..."; the labels then hold what was found. */
  std::string failure;
};

/** Finds the gas and the tagged fluid in the colon of a CT colonography, without seeds.
 *
 * `ct`: Hounsfield units; any axes (permuted, oblique, left-handed), spacing about 0.5 to 3 mm. Needs about 6 bytes for
 * each voxel besides the input. The same bytes for any number of threads.
 *
 * Throws ParameterError when a seed point lies outside the image or in neither gas nor bright matter, or when the
 * patient position is unknown; InputError when an extent of the image is below 8 voxels. \ingroup ColonLumen */
ColonLumen_EXPORT ColonLumen
SegmentColonLumen(const itk::Image<float, 3> * ct, const ColonLumenOptions & options = {});

/** Why a mask on the grid of a CT in HU is not a colon's lumen: most of its gas is lung. Empty where it may be a colon.
 * \ingroup ColonLumen */
ColonLumen_EXPORT std::string
                  FailureOfMask(const itk::Image<float, 3> * ct, const itk::Image<unsigned char, 3> * mask);
} // namespace shapeton

#endif
