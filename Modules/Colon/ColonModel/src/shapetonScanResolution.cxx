#include "shapetonScanResolution.h"

#include "shapetonNumberText.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double     SamplesAcrossPolyp = 3.0;            // rule set in advance; colon-polyps.md has the measurements
constexpr double     SmallestReported = 6.0;              // mm; C-RADS, see the header
constexpr double     ThickestSlice = 3.0;                 // mm; ACR and ESGAR, see the header
constexpr const char BelowArray[] = "notAssessableBelow"; // field array of the centerline, mm

/** Rounded to tenths of mm, so that rounding errors in headers do not cause a limit to be exceeded. */
double
ToTenths(double mm)
{
  constexpr double tenths = 10.0; // per mm
  return std::round(tenths * mm) / tenths;
}

std::string
InMm(double mm)
{
  return NumberText(mm, 4);
}

/** Width of the voxel or slice, whichever is wider. */
double
CoarsestSample(const ScanResolution & resolution)
{
  return std::max({ resolution.spacing[0], resolution.spacing[1], resolution.spacing[2], resolution.sliceThickness });
}
} // namespace

ScanResolution
MeasureScanResolution(const itk::ImageBase<3> * grid, double sliceThickness, double smoothing)
{
  const double   widthPerSigma = 2.0 * std::sqrt(2.0 * std::log(2.0)); // of a Gaussian, at half maximum
  ScanResolution resolution;
  resolution.spacing = grid->GetSpacing();
  resolution.sliceThickness = sliceThickness;
  resolution.blur = std::hypot(CoarsestSample(resolution), widthPerSigma * smoothing);
  resolution.smallestPolyp = ToTenths(SamplesAcrossPolyp * resolution.blur);
  return resolution;
}

std::string
InWords(const ScanResolution & resolution)
{
  std::string text =
    InMm(resolution.spacing[0]) + " x " + InMm(resolution.spacing[1]) + " x " + InMm(resolution.spacing[2]) + " mm";
  if (resolution.sliceThickness > 0.0)
  {
    text += ", slices " + InMm(resolution.sliceThickness) + " mm thick";
  }
  return text + (resolution.smallestPolyp > SmallestReported ? ": " + NotAssessableInWords(resolution.smallestPolyp)
                 : resolution.isOfMask                       ? ""
                                       : ": polyps of " + InMm(SmallestReported) + " mm and more are evaluable");
}

Remarks
WarningsOf(const ScanResolution & resolution)
{
  Remarks      warnings;
  const double coarsest = ToTenths(CoarsestSample(resolution));
  if (resolution.smallestPolyp > SmallestReported)
  {
    warnings.push_back("the colon is " + NotAssessableInWords(resolution.smallestPolyp) +
                       ": in the coarsest direction, the scan resolves " + InMm(resolution.blur) + " mm");
  }
  if (coarsest > ThickestSlice)
  {
    warnings.push_back("slices of " + InMm(coarsest) + " mm; CT colonography requires at most " + InMm(ThickestSlice) +
                       " mm");
  }
  return warnings;
}

void
SetNotAssessableBelow(const ScanResolution & resolution, CurveSet & centerline)
{
  if (resolution.smallestPolyp > SmallestReported)
  {
    centerline.fieldArrays.push_back(
      { BelowArray, SurfaceArray::ValueMatrix::Constant(1, 1, resolution.smallestPolyp), false });
  }
}

double
NotAssessableBelow(const CurveSet & centerline)
{
  const SurfaceArray * const array = FindSurfaceArray(centerline.fieldArrays, BelowArray);
  return array != nullptr && array->values.size() == 1 ? array->values(0, 0) : 0.0;
}

std::string
NotAssessableInWords(double below)
{
  return below > 0.0 ? "not evaluable for polyps below " + InMm(below) + " mm" : "";
}
} // namespace shapeton
