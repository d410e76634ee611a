#ifndef ShapetonComparison_h
#define ShapetonComparison_h

#include "ShapetonPictures.h"
#include "ShapetonTrial.h"
#include "ValidationReport.h"

#include <algorithm>
#include <string>
#include <vector>

/** What all parts of the comparison need. */
struct Comparison
{
  const ValidationSettings & settings;
  ValidationReport &         report;

  /** Writes the sheet beside the other pictures, and shows it. */
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

/** "12.3 %". */
std::string
Percent(double share);
/** With two digits after the point. */
std::string
Hundredths(double value);

std::vector<std::string>
Joined(std::vector<std::string> cells, const std::vector<std::string> & more);

/** The values in the order of the keys. */
std::vector<double>
Values(const std::map<int, double> & map);

/** Method and settings in few words. */
std::string
CaptionOf(const Trial & trial);

/** What all tables of trials begin with. */
extern const std::vector<std::string> columnsOfTrials;
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
