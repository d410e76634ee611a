#ifndef ShapetonComparison_h
#define ShapetonComparison_h

#include "ShapetonPictures.h"
#include "ShapetonTrial.h"
#include "Tables.h"
#include "ValidationReport.h"

#include <algorithm>
#include <string>
#include <vector>

/** Data shared by all parts of the comparison. */
struct Comparison
{
  const ValidationSettings & settings;
  ValidationReport &         report;

  /** Writes the sheet to the picture folder and shows it on the page. */
  void
  Show(const PictureSheet & sheet, const std::string & name) const
  {
    sheet.Write(settings.pictureFolder + "/shapeton-" + name + ".png");
    report.AddText("![" + name + "](../pictures/shapeton-" + name + ".png)");
  }
  itk::Size<3>
  Cube(unsigned int side) const
  {
    return itk::Size<3>::Filled(settings.quick ? 32 : side);
  }
  WalkSettings
  Walk(std::uint32_t shapetons, double distance, std::uint64_t steps) const
  {
    return settings.quick ? WalkSettings{ std::min(shapetons, 20000U), std::max(distance, 0.02), steps / 10 }
                          : WalkSettings{ shapetons, distance, steps };
  }
};

/** Formats a value with two decimals. */
std::string
Hundredths(double value);

/** Values in the order of the keys. */
std::vector<double>
Values(const std::map<int, double> & map);

/** Short description of method and settings. */
std::string
CaptionOf(const Trial & trial);

/** First columns of all tables of trials. */
inline const std::string columnsOfTrials =
  "method | shapetons x steps | seconds | coverage | trapped | visits per object voxel";
std::vector<std::string>
CellsOf(const TrialVolume & volume, const Trial & trial);

/** Figure 7.1. */
void
CompareScales(const Comparison & comparison);
/** Figure 3.7. */
void
CompareDistances(const Comparison & comparison);
/** MR head, abdomen, feet, bonsai. */
void
CompareRealVolumes(const Comparison & comparison);
/** Figure 3.8. */
void
CompareEngineByP(const Comparison & comparison);
/** Table 3.1 and Figure 3.6. */
void
TabulateCubeByShapetons(const Comparison & comparison);
/** Table 3.2. */
void
TabulatePublishedVolumes(const Comparison & comparison);

#endif
