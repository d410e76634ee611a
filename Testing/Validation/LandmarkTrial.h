#ifndef LandmarkTrial_h
#define LandmarkTrial_h

#include "shapetonColonAnatomy.h"

#include "itkImage.h"

#include <memory>
#include <string>

/** A synthetic patient in one position, whose colon is flattened. */
struct LandmarkCase
{
  shapeton::ColonPhantomParameters parameters;
  /** mm. */
  double spacing{ 0.8 };
  /** The model is made from the CT; else from the true lumen on the same grid. */
  bool isFromCt{ false };
};

/** What landmarks are looked for on, and the truth. */
struct LandmarkExam
{
  std::shared_ptr<const shapeton::ColonAnatomy> anatomy;
  /** As ColonFlattening makes it from the simplified wall. */
  shapeton::SurfaceMesh flat;
  shapeton::CurveSet    centreline;
  /** Of full resolution, without handles. */
  shapeton::SurfaceMesh wall;
  /** Empty, or why there is no model; then the surfaces are empty. */
  std::string failure;
};

/** With what else candidates are judged by. */
struct ColonExam : LandmarkExam
{
  /** 1 gas, 2 fluid. */
  itk::Image<unsigned char, 3>::Pointer lumen;
  /** HU, cleansed; null where the model is not made from a CT. */
  itk::Image<float, 3>::Pointer ct;
  /** The axis of a rectal catheter that was found, see CurveOfCatheter(). */
  shapeton::CurveSet catheter;
};

/** A patient of the validation, see ValidationSettings::Seeds(). */
LandmarkCase
ValidationCase(const std::string & preset,
               unsigned int        seed,
               const std::string & position,
               double              spacing,
               bool                isFromCt);

/** Phantom, model, flat map. Where SHAPETON_LANDMARK_CACHE names a folder, exams are kept there and taken from
 * there: for development alone, as nothing tells whether the programs have changed since. */
LandmarkExam
MakeLandmarkExam(const LandmarkCase & one);

/** The same with images, as far as 15 mm around the lumen. */
ColonExam
MakeColonExam(const LandmarkCase & one);

/** Bounds of shares lose this, and errors may grow by this factor, where the colon is found in the CT. */
inline constexpr double lossFromCt = 0.03;
inline constexpr double growthFromCt = 1.3;

/** "Preset hard, from CT of 0.8 mm". */
std::string
TitleOfColumn(const std::string & preset, bool isFromCt, double spacing);

/** "seed 100, supine". */
std::string
NameOfCase(const LandmarkCase & one);

#endif
