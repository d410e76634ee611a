#include "shapetonColonPhantomParameters.h"

#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonExceptions.h"

#include <algorithm>
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
                       p.ileumLength == none.ileumLength && p.ileumContent == none.ileumContent;
  RequireParameter(p.valve == "lips" || isPlain,
                   "the parameters \"valveLength\", \"valveHeight\", \"valveFat\", \"ileumBore\", \"ileumLength\" and "
                   "\"ileumContent\" require a valve with lips; set the parameter \"valve\" to lips");
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
  Diverticula
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
  operator()(double & value, double low, double high)
  {
    const double drawn = m_Random.Uniform(low, high);
    value = value == drawnBySeed ? drawn : value;
  }

  void
  operator()(int & value, int low, int high)
  {
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

void
DrawValve(ColonPhantomParameters & p)
{
  Draw draw(p, Group::Valve);
  draw(p.valveLength, 15, 30);
  draw(p.valveHeight, 8, 15);
  const bool isFatty = draw.Chance() < 0.7;
  draw(p.valveFat, isFatty ? 0.7 : 0.0, isFatty ? 0.95 : 0.2);
  draw(p.ileumBore, 8, 12);
  draw(p.ileumLength, 60, 120);
  const double content = Draw(p, Group::Content, true).Chance();
  draw(p.ileumContent, content < 0.3 ? "collapsed" : (content < 0.65 ? "gas" : "fluid"));
}

void
DrawShape(ColonPhantomParameters & p)
{
  static constexpr double shortest[] = { 150, 350, 220, 550, 180, 60 };
  static constexpr double longest[] = { 180, 1200, 330, 1150, 330, 95 };
  static constexpr double narrowest[] = { 36, 24, 26, 32, 42, 50 };
  static constexpr double widest[] = { 54, 36, 44, 54, 68, 78 };
  Draw                    length(p, Group::Lengths);
  Draw                    caliber(p, Group::Caliber);
  // Half of the range from narrow to wide is drawn per patient, half per segment.
  const double build = caliber.Chance();
  for (std::size_t i = 0; i < p.lengths.size(); ++i)
  {
    length(p.lengths[i], shortest[i], longest[i]);
    const double middle = narrowest[i] + 0.5 * build * (widest[i] - narrowest[i]);
    caliber(p.caliber[i], middle, middle + 0.5 * (widest[i] - narrowest[i]));
  }
  Draw       cecum(p, Group::Cecum);
  const bool isMobile = cecum.Chance() < 0.3;
  cecum(p.cecumMobility, isMobile ? 30 : 0, isMobile ? 80 : 10);
}

void
DrawBowel(ColonPhantomParameters & p)
{
  Draw draw(p, Group::Bowel);
  draw(p.smallBowelTagged, 0.5, 1.0);
  draw(p.stomachIntensity, 100, 650);
}

void
DrawResidue(ColonPhantomParameters & p)
{
  Draw draw(p, Group::Residue);
  draw(p.stool, 0, 14);
  draw(p.stoolTagged, 0.3, 0.9);
  draw(p.bubbles, 0, 20);
  const bool hasFoam = draw.Chance() < 0.3;
  draw(p.foam, hasFoam ? 1 : 0, hasFoam ? 4 : 0);
}

void
DrawDiverticula(ColonPhantomParameters & p)
{
  Draw       draw(p, Group::Diverticula);
  const bool hasDiverticula = draw.Chance() < 0.4;
  draw(p.diverticula, hasDiverticula ? 3 : 0, hasDiverticula ? 25 : 0);
}

void
DrawCatheter(ColonPhantomParameters & p)
{
  Draw         draw(p, Group::Catheter);
  const double kind = draw.Chance();
  draw(p.catheter, kind < 0.4 ? "none" : (kind < 0.7 ? "rigid" : "soft"));
  draw(p.catheterBore, 4, 6);
  draw(p.catheterWall, 2, 2.6);
  draw(p.catheterIntensity, 120, 280);
  const bool isSoft = p.catheter == "soft";
  draw(p.catheterDepth, isSoft ? 75 : 55, isSoft ? 125 : 80);
  const bool isOpenAtItsEnd = draw.Chance() < 0.4;
  draw(p.catheterHoles, isOpenAtItsEnd ? 0 : 2, isOpenAtItsEnd ? 0 : 4);
  const double balloon = Draw(p, Group::Balloon).Chance();
  draw(p.balloon, balloon < 0.35 ? "none" : (balloon < 0.65 ? "gas" : (balloon < 0.8 ? "fluid" : "deflated")));
  draw(p.balloonDiameter, 22, 38);
}

void
DrawScanner(ColonPhantomParameters & p)
{
  Draw         draw(p, Group::Scanner);
  const double kernel = draw.Chance();
  draw(p.kernel, kernel < 1.0 / 3.0 ? "standard" : (kernel < 2.0 / 3.0 ? "soft" : "sharp"));
  draw(p.noise, 15, 60);
  draw(p.sliceThickness, 0.6, 2.5);
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
  DrawBowel(drawn);
  DrawResidue(drawn);
  DrawDiverticula(drawn);
  DrawScanner(drawn);
  DrawCatheter(drawn);
  if (drawn.valve == "lips")
  {
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
    parameters.polyps = 10;
    parameters.fluid = 0.25;
    parameters.roughness = 0.3;
    parameters.flattenedFolds = 0.2;
    parameters.foldSlide = 4.0;
    parameters.torsion = 25.0;
    parameters.noise = drawnBySeed;
    parameters.kernel = "drawn";
    parameters.sliceThickness = drawnBySeed;
    parameters.valve = "lips";
    parameters.lengths.fill(drawnBySeed);
    parameters.caliber.fill(drawnBySeed);
    parameters.cecumMobility = drawnBySeed;
    parameters.smallBowelTagged = drawnBySeed;
    parameters.stomachIntensity = drawnBySeed;
    parameters.stool = parameters.bubbles = parameters.foam = static_cast<int>(drawnBySeed);
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
  parameters.polyps = 12;
  parameters.fluid = 0.4;
  parameters.collapsed = 1;
  parameters.fakeHandles = 4;
  parameters.roughness = 0.4;
  parameters.flattenedFolds = 0.3;
  parameters.foldSlide = 6.0;
  parameters.distension = 0.95;
  parameters.torsion = 40.0;
  parameters.noise = 50.0;
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
  RequireSegmentValues(OptionInfo("lengths").AtLeast(40.0, "40").AtMost(1200.0, "1200"), p.lengths);
  RequireSegmentValues(OptionInfo("caliber").AtLeast(15.0, "15").AtMost(90.0, "90"), p.caliber);
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
