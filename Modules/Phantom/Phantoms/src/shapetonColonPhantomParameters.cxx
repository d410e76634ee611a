#include "shapetonColonPhantomParameters.h"

#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace shapeton
{
namespace
{
template <typename TOption>
bool
IsDrawnBySeed(const TOption & option)
{
  if constexpr (std::is_arithmetic_v<TOption>)
  {
    return option == drawnBySeed;
  }
  else
  {
    return false; // a word
  }
}

void
RequireValidValve(const ColonPhantomParameters & p)
{
  const ColonPhantomParameters none;
  const bool                   isPlain = p.valveLength == none.valveLength && p.valveHeight == none.valveHeight &&
                       p.valveFat == none.valveFat && p.ileumBore == none.ileumBore &&
                       p.ileumLength == none.ileumLength && p.ileumContent == none.ileumContent &&
                       p.ileumReflux == none.ileumReflux;
  RequireParameter(
    p.valve == "lips" || isPlain,
    "the parameters \"valveLength\", \"valveHeight\", \"valveFat\", \"ileumBore\", \"ileumLength\", "
    "\"ileumContent\" and \"ileumReflux\" require a valve with lips; set the parameter \"valve\" to lips");
  RequireParameter(
    p.ileumReflux != "gas" || p.ileumContent == "gas" || p.ileumContent == "drawn",
    "the parameter \"ileumReflux\" requires gas in the ileum; set the parameter \"ileumContent\" to gas");
}

// 0 to use the template.
void
RequireSegmentValues(const OptionInfo & info, const SegmentValues & values)
{
  for (const double value : values)
  {
    if (value != 0.0 && !IsDrawnBySeed(value))
    {
      info.Check(value);
    }
  }
}

/** Independent random streams, so that changes to one do not affect the others. */
enum class Group
{
  Valve = 1,
  Content,
  Catheter,
  Balloon,
  Lengths,
  Caliber,
  Cecum,
  Residue,
  Scanner,
  Bowel,
  Diverticula,
  Sigmoid,
  Reflux,
  Spasm,
  FilledStretch,
  TiltedLevel,
  Contact,
  SmallLevels
};

/** Draws parameters in a fixed order, so that given values do not affect drawn ones. */
class Draw
{
public:
  Draw(const ColonPhantomParameters & p, Group group, bool byPosition = false)
    : m_Random(p.seed, ColonStream::Drawn, byPosition ? PositionNumber(p.position) : 0)
  {
    m_Random.Seek(static_cast<std::uint32_t>(group));
  }

  void
  operator()(double & value, const DrawnRange & range)
  {
    const double drawn = m_Random.Uniform(range);
    value = value == drawnBySeed ? drawn : value;
  }

  void
  operator()(int & value, const DrawnRange & range)
  {
    const int low = static_cast<int>(range.low);
    const int high = static_cast<int>(range.high);
    const int drawn = low + static_cast<int>(m_Random.Uniform() * (high - low + 1));
    value = value == drawnBySeed ? drawn : value;
  }

  void
  operator()(std::string & value, const std::string & drawn)
  {
    value = value == "drawn" ? drawn : value;
  }

  double
  Chance()
  {
    return m_Random.Uniform();
  }

private:
  ColonRandom m_Random;
};

// Call before DrawValve(), which draws the remaining values of the ileum.
void
DrawReflux(ColonPhantomParameters & p)
{
  constexpr double     share = 0.3; // of the patients
  constexpr DrawnRange bore{ 10, 25 };
  constexpr double     shortest = 50.0;  // mm
  constexpr double     longest = 1500.0; // mm; lengths are uniform on a logarithmic scale
  Draw                 draw(p, Group::Reflux);
  draw(p.ileumReflux, draw.Chance() < share ? "gas" : "none");
  if (p.ileumReflux != "gas")
  {
    return;
  }
  draw(p.ileumBore, bore);
  const double length = shortest * std::pow(longest / shortest, draw.Chance());
  draw(p.ileumLength, { length, length });
  draw(p.ileumContent, "gas");
}

void
DrawValve(ColonPhantomParameters & p)
{
  constexpr DrawnRange length{ 15, 30 };
  constexpr DrawnRange height{ 8, 15 };
  constexpr DrawnRange fat{ 0.7, 0.95 };
  constexpr DrawnRange littleFat{ 0.0, 0.2 };
  constexpr DrawnRange bore{ 8, 12 };
  constexpr DrawnRange ileum{ 60, 120 };
  constexpr double     fattyShare = 0.7; // of the patients
  constexpr double     collapsedShare = 0.3;
  constexpr double     gasShare = 0.65; // with the collapsed ones
  Draw                 draw(p, Group::Valve);
  draw(p.valveLength, length);
  draw(p.valveHeight, height);
  const bool isFatty = draw.Chance() < fattyShare;
  draw(p.valveFat, isFatty ? fat : littleFat);
  draw(p.ileumBore, bore);
  draw(p.ileumLength, ileum);
  const double content = Draw(p, Group::Content, true).Chance();
  draw(p.ileumContent, content < collapsedShare ? "collapsed" : (content < gasShare ? "gas" : "fluid"));
}

void
DrawShape(ColonPhantomParameters & p)
{
  static constexpr double shortest[] = { 150, 350, 220, 550, 180, 60 };
  static constexpr double longest[] = { 180, 1200, 330, 1150, 330, 95 };
  static constexpr double narrowest[] = { 36, 24, 26, 32, 42, 50 }; // mm, diameter
  static constexpr double widest[] = { 54, 36, 44, 54, 68, 78 };    // mm, diameter
  Draw                    length(p, Group::Lengths);
  Draw                    caliber(p, Group::Caliber);
  // One half of the range from narrow to wide is drawn per patient, the other half per segment.
  const double build = caliber.Chance();
  for (std::size_t i = 0; i < p.lengths.size(); ++i)
  {
    length(p.lengths[i], { shortest[i], longest[i] });
    const double middle = narrowest[i] + 0.5 * build * (widest[i] - narrowest[i]);
    caliber(p.caliber[i], { middle, middle + 0.5 * (widest[i] - narrowest[i]) });
  }
  constexpr DrawnRange mobile{ 30, 80 };
  constexpr DrawnRange fixed{ 0, 10 };
  constexpr double     mobileShare = 0.3; // of the patients
  Draw                 cecum(p, Group::Cecum);
  const bool           isMobile = cecum.Chance() < mobileShare;
  cecum(p.cecumMobility, isMobile ? mobile : fixed);
}

// Loops of long sigmoids often rise to the mid abdomen; short sigmoids often lack a loop.
void
DrawSigmoid(ColonPhantomParameters & p)
{
  constexpr DrawnRange rise{ 30, 90 };
  constexpr DrawnRange straightness{ 0.7, 1.0 };
  constexpr double     redundantLength = 650.0; // mm, of sigmoids that may rise
  constexpr double     shortLength = 550.0;     // mm, of sigmoids that may be straight
  constexpr double     share = 0.6;             // of the long sigmoids, and of the short ones
  Draw                 draw(p, Group::Sigmoid);
  const double         length = p.lengths[1];
  const bool           isUnusual = draw.Chance() < share;
  draw(p.sigmoidRise, isUnusual && length >= redundantLength ? rise : DrawnRange{});
  draw(p.sigmoidStraightness, isUnusual && length <= shortLength ? straightness : DrawnRange{});
}

/** Draws a value from the range for a fraction of the patients, and 0 for the others. */
template <typename TValue>
void
DrawForShare(ColonPhantomParameters & p, Group group, double share, TValue & value, const DrawnRange & range)
{
  Draw       draw(p, group);
  const bool hasIt = draw.Chance() < share;
  draw(value, hasIt ? range : DrawnRange{});
}

void
DrawOccasional(ColonPhantomParameters & p)
{
  constexpr DrawnRange spasm{ 50, 150 };
  constexpr DrawnRange filled{ 30, 120 };
  constexpr DrawnRange slope{ 0.15, 0.35 };
  constexpr DrawnRange smallLevels{ 1, 3 };
  constexpr DrawnRange contact{ 40, 80 };
  constexpr DrawnRange diverticula{ 3, 25 };
  constexpr double     spasmShare = 0.25; // of the patients
  constexpr double     filledShare = 0.4;
  constexpr double     tiltedShare = 0.3;
  constexpr double     smallShare = 0.4;
  constexpr double     contactShare = 0.4;
  constexpr double     diverticulaShare = 0.4;
  DrawForShare(p, Group::Spasm, spasmShare, p.spasm, spasm);
  DrawForShare(p, Group::FilledStretch, filledShare, p.filledStretch, filled);
  DrawForShare(p, Group::TiltedLevel, tiltedShare, p.levelSlope, slope);
  DrawForShare(p, Group::SmallLevels, smallShare, p.smallLevels, smallLevels);
  DrawForShare(p, Group::Contact, contactShare, p.sigmoidContact, contact);
  DrawForShare(p, Group::Diverticula, diverticulaShare, p.diverticula, diverticula);
}

void
DrawBowel(ColonPhantomParameters & p)
{
  constexpr DrawnRange tagged{ 0.5, 1.0 };
  constexpr DrawnRange stomach{ 100, 650 };
  Draw                 draw(p, Group::Bowel);
  draw(p.smallBowelTagged, tagged);
  draw(p.stomachIntensity, stomach);
}

void
DrawResidue(ColonPhantomParameters & p)
{
  constexpr DrawnRange stool{ 0, 14 };
  constexpr DrawnRange tagged{ 0.3, 0.9 };
  constexpr DrawnRange bubbles{ 0, 20 };
  constexpr DrawnRange foam{ 1, 4 };
  constexpr double     foamShare = 0.3; // of the patients
  Draw                 draw(p, Group::Residue);
  draw(p.stool, stool);
  draw(p.stoolTagged, tagged);
  draw(p.bubbles, bubbles);
  const bool hasFoam = draw.Chance() < foamShare;
  draw(p.foam, hasFoam ? foam : DrawnRange{});
}

void
DrawCatheter(ColonPhantomParameters & p)
{
  constexpr DrawnRange bore{ 4, 6 };
  constexpr DrawnRange wall{ 2, 2.6 };
  constexpr DrawnRange intensity{ 120, 280 };
  constexpr DrawnRange softDepth{ 75, 125 };
  constexpr DrawnRange rigidDepth{ 55, 80 };
  constexpr DrawnRange holes{ 2, 4 };
  constexpr DrawnRange balloonDiameter{ 22, 38 };
  // Upper limits of the drawn number of each kind.
  constexpr double noCatheter = 0.4;
  constexpr double rigid = 0.7;
  constexpr double openAtItsEnd = 0.4;
  constexpr double noBalloon = 0.35;
  constexpr double gasBalloon = 0.65;
  constexpr double fluidBalloon = 0.8;
  Draw             draw(p, Group::Catheter);
  const double     kind = draw.Chance();
  draw(p.catheter, kind < noCatheter ? "none" : (kind < rigid ? "rigid" : "soft"));
  draw(p.catheterBore, bore);
  draw(p.catheterWall, wall);
  draw(p.catheterIntensity, intensity);
  draw(p.catheterDepth, p.catheter == "soft" ? softDepth : rigidDepth);
  const bool isOpenAtItsEnd = draw.Chance() < openAtItsEnd;
  draw(p.catheterHoles, isOpenAtItsEnd ? DrawnRange{} : holes);
  const double balloon = Draw(p, Group::Balloon).Chance();
  draw(p.balloon,
       balloon < noBalloon ? "none" : (balloon < gasBalloon ? "gas" : (balloon < fluidBalloon ? "fluid" : "deflated")));
  draw(p.balloonDiameter, balloonDiameter);
}

void
DrawScanner(ColonPhantomParameters & p)
{
  constexpr DrawnRange noise{ 15, 60 };
  constexpr DrawnRange thickness{ 0.6, 2.5 };
  Draw                 draw(p, Group::Scanner);
  const double         kernel = draw.Chance();
  draw(p.kernel, kernel < 1.0 / 3.0 ? "standard" : (kernel < 2.0 / 3.0 ? "soft" : "sharp"));
  draw(p.noise, noise);
  draw(p.sliceThickness, thickness);
}

/** Values of a preset other than standard; units as in the options. */
struct PresetValues
{
  int    polyps;
  double fluid;
  double roughness;
  double flattenedFolds;
  double foldSlide;
  double torsion;
};
constexpr PresetValues realisticValues{ 10, 0.25, 0.3, 0.2, 4.0, 25.0 };
constexpr PresetValues hardValues{ 12, 0.4, 0.4, 0.3, 6.0, 40.0 };

void
SetPreset(const PresetValues & values, ColonPhantomParameters & parameters)
{
  parameters.polyps = values.polyps;
  parameters.fluid = values.fluid;
  parameters.roughness = values.roughness;
  parameters.flattenedFolds = values.flattenedFolds;
  parameters.foldSlide = values.foldSlide;
  parameters.torsion = values.torsion;
}

void
RequireValidChest(const ColonPhantomParameters & p)
{
  RequireParameter(p.lungDensity == lungDensityOfState || HasWholeChest(p),
                   "the parameter \"lungDensity\" requires a whole chest; set the parameter \"lungs\" to inspiration,"
                   " quietBreathing or emphysema");
}
} // namespace

const std::vector<std::string> &
PhantomOrgans()
{
  static const std::vector<std::string> organs{ "table",   "lungs",   "heart",   "liver",      "spleen", "kidneys",
                                                "vessels", "bladder", "stomach", "smallBowel", "colon" };
  return organs;
}

bool
Contains(const ColonPhantomParameters & parameters, const std::string & organ)
{
  return std::find(parameters.contents.begin(), parameters.contents.end(), organ) != parameters.contents.end();
}

ColonPhantomParameters
Drawn(const ColonPhantomParameters & parameters)
{
  ColonPhantomParameters drawn = parameters;
  DrawShape(drawn);
  DrawSigmoid(drawn);
  DrawOccasional(drawn);
  DrawBowel(drawn);
  DrawResidue(drawn);
  DrawScanner(drawn);
  DrawCatheter(drawn);
  if (drawn.valve == "lips")
  {
    DrawReflux(drawn);
    DrawValve(drawn);
  }
  return drawn;
}

ColonPhantomParameters
ColonPhantomPreset(const std::string & name)
{
  ColonPhantomParameters parameters;
  if (name == "standard")
  {
    return parameters;
  }
  parameters.preset = name;
  CheckOptions<ColonPatientOptions>(parameters);
  if (name == "realistic")
  {
    SetPreset(realisticValues, parameters);
    parameters.noise = drawnBySeed;
    parameters.kernel = "drawn";
    parameters.sliceThickness = drawnBySeed;
    parameters.valve = "lips";
    parameters.ileumReflux = "drawn";
    parameters.lengths.fill(drawnBySeed);
    parameters.caliber.fill(drawnBySeed);
    parameters.cecumMobility = drawnBySeed;
    parameters.sigmoidRise = drawnBySeed;
    parameters.spasm = parameters.filledStretch = drawnBySeed;
    parameters.levelSlope = parameters.sigmoidContact = drawnBySeed;
    parameters.sigmoidStraightness = drawnBySeed;
    parameters.smallBowelTagged = drawnBySeed;
    parameters.stomachIntensity = drawnBySeed;
    parameters.stool = parameters.bubbles = parameters.foam = static_cast<int>(drawnBySeed);
    parameters.smallLevels = static_cast<int>(drawnBySeed);
    parameters.diverticula = static_cast<int>(drawnBySeed);
    parameters.catheter = "drawn";
    parameters.catheterBore = drawnBySeed;
    parameters.catheterWall = drawnBySeed;
    parameters.catheterIntensity = drawnBySeed;
    parameters.catheterDepth = drawnBySeed;
    parameters.catheterHoles = static_cast<int>(drawnBySeed);
    parameters.balloon = "drawn";
    return parameters;
  }
  constexpr double distensionOfHard = 0.95;
  constexpr double noiseOfHard = 50.0; // HU
  SetPreset(hardValues, parameters);
  parameters.collapsed = 1;
  parameters.fakeHandles = 4;
  parameters.distension = distensionOfHard;
  parameters.noise = noiseOfHard;
  return parameters;
}

void
RequireValid(const ColonPhantomParameters & p)
{
  CheckOptions<ColonPatientOptions>(p);
  ColonStructureOptions::VisitOptions(p, [](const OptionInfo & info, const auto & option) {
    if (!IsDrawnBySeed(option))
    {
      CheckOption(info, option);
    }
  });
  const OptionInfo lengths = OptionInfo("lengths").AtLeast(40.0, "40").AtMost(1200.0, "1200");
  const OptionInfo caliber = OptionInfo("caliber").AtLeast(15.0, "15").AtMost(90.0, "90");
  RequireSegmentValues(lengths, p.lengths);
  RequireSegmentValues(caliber, p.caliber);
  RequireValidValve(p);
  RequireValidChest(p);
  const auto & organs = PhantomOrgans();
  for (const std::string & organ : p.contents)
  {
    RequireParameter(std::find(organs.begin(), organs.end(), organ) != organs.end(),
                     "the parameter \"contents\": \"" + organ + "\" is not an organ of the phantom");
  }
}
} // namespace shapeton
