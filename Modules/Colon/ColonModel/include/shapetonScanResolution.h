#ifndef shapetonScanResolution_h
#define shapetonScanResolution_h

#include "ShapetonColonModelExport.h"
#include "shapetonCurveSet.h"
#include "shapetonRemarks.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** \class ScanResolution
 * \brief Resolution of a scan, and the smallest polyp that it supports.
 *
 * The rule is 3 samples across a polyp in the coarsest direction, regardless of how the axes are oriented in the
 * patient; see Documentation/validation/colon-polyps.md for the measurements. Polyps below 6 mm are not reported anyway
 * (C-RADS, Zalis et al., Radiology 2005; ESGAR, Neri et al., Eur Radiol 2013).
 * \ingroup ShapetonColonModel
 */
struct ScanResolution
{
  /** Along the image axes, mm. */
  itk::Vector<double, 3> spacing;
  /** mm; 0 if unknown, as in the case of a mask. */
  double sliceThickness{ 0.0 };
  /** Width at half maximum (mm) in the coarsest direction, due to the voxel or slice, whichever is wider, and to noise
   * smoothing. The blur of the scanner is not included. */
  double blur{ 0.0 };
  /** Diameter, mm. */
  double smallestPolyp{ 0.0 };
  /** Whether it is the grid of a mask: the scan may have been coarser. */
  bool isOfMask{ false };
};

/** Computes the resolution of a grid. `sliceThickness` is 0 if unknown; `smoothing` is the standard deviation of the
 * prefilter, mm. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ScanResolution
MeasureScanResolution(const itk::ImageBase<3> * grid, double sliceThickness, double smoothing);

/** For example "1.25 x 1.25 x 2 mm: polyps of 6 mm and more are evaluable". \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::string
                          InWords(const ScanResolution & resolution);

/** Warns if polyps of 6 mm are not evaluable, or if slices are thicker than the 3 mm allowed by the ACR-SAR-SCBT-MR
 * practice parameter and ESGAR. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT Remarks
WarningsOf(const ScanResolution & resolution);

/** Stores the smallest polyp in the field array notAssessableBelow (mm) of a centerline if it is above 6 mm.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT void
SetNotAssessableBelow(const ScanResolution & resolution, CurveSet & centerline);

/** The value stored by SetNotAssessableBelow(); 0 if polyps of 6 mm are assessable. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT double
NotAssessableBelow(const CurveSet & centerline);

/** "not evaluable for polyps below 9 mm"; empty for 0. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::string
                          NotAssessableInWords(double below);
} // namespace shapeton

#endif
