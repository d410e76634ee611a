#ifndef LandmarkTrial_h
#define LandmarkTrial_h

#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

/** Synthetic patient in one position whose colon is flattened. */
struct LandmarkCase
{
  shapeton::ColonPhantomParameters parameters;
  /** Voxel spacing (mm). */
  double spacing{ 0.8 };
  /** Whether the model is computed from the CT; otherwise from the true lumen on the same grid. */
  bool isFromCt{ false };
};

/** Input of the landmark search, and the truth. */
struct LandmarkExam
{
  std::shared_ptr<const shapeton::ColonAnatomy> anatomy;
  /** Flat colon as computed by ColonFlattening from the simplified wall. */
  shapeton::SurfaceMesh flat;
  shapeton::CurveSet    centerline;
  /** Wall at full resolution, without handles. */
  shapeton::SurfaceMesh wall;
  /** Empty, or the reason why the model is missing; then the surfaces are empty. */
  std::string failure;
};

/** Exam with additional data to evaluate candidates. */
struct ColonExam : LandmarkExam
{
  /** 1: gas, 2: fluid. */
  itk::Image<unsigned char, 3>::Pointer lumen;
  /** Cleansed CT (HU); null if the model is not computed from a CT. */
  itk::Image<float, 3>::Pointer ct;
  /** Axis of a detected rectal catheter, see CurveOfCatheter(). */
  shapeton::CurveSet catheter;
};

/** Exam of a validation patient, see ValidationSettings::Seeds(). */
LandmarkCase
ValidationCase(const std::string & preset,
               unsigned int        seed,
               const std::string & position,
               double              spacing,
               bool                isFromCt);

/** Supine and prone exam of each validation patient. */
std::vector<LandmarkCase>
BothPositions(const std::string & preset, const std::vector<unsigned int> & seeds, double spacing, bool isFromCt);

/** The phantom of a case, centered. */
shapeton::ColonPhantomImageSource::Pointer
MakePhantom(const LandmarkCase & one);

/** Computes phantom and model. The position of the patient is that of the case. */
shapeton::ColonModel
MakeTrialModel(const LandmarkCase & one, shapeton::ColonModelSettings settings = {});

/** Computes phantom, model and flat map. */
LandmarkExam
MakeLandmarkExam(const LandmarkCase & one);

/** Exam with images, cropped to 15 mm around the lumen. */
ColonExam
MakeColonExam(const LandmarkCase & one);

/** Relaxation of bounds if the colon is segmented from CT: fractions may be lower by the first value, and errors may be
 * larger by the second factor. */
inline constexpr double lossFromCt = 0.03;
inline constexpr double growthFromCt = 1.3;

/** "Preset hard, from CT of 0.8 mm". */
std::string
TitleOfColumn(const std::string & preset, bool isFromCt, double spacing);

/** "seed 100, supine". */
std::string
NameOfCase(const LandmarkCase & one);

#endif
