#include "shapetonColonPhantomParameters.h"

#include "shapetonExceptions.h"

#include <sstream>

namespace shapeton
{
namespace
{
void
RequireRange(const char * name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
  {
    std::ostringstream message;
    message << "the parameter \"" << name << "\" is " << value << "; give a number from " << low << " to " << high;
    throw ParameterError(message.str());
  }
}
} // namespace

ColonPhantomParameters
ColonPhantomPreset(const std::string & name)
{
  ColonPhantomParameters parameters;
  if (name == "standard")
  {
    return parameters;
  }
  RequireParameter(name == "hard", "the parameter \"preset\" is '" + name + "'; give standard or hard");
  parameters.preset = name;
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
  RequireParameter(
    p.position == "supine" || p.position == "prone" || p.position == "leftDecubitus" || p.position == "rightDecubitus",
    "the parameter \"position\" is '" + p.position + "'; give supine, prone, leftDecubitus or rightDecubitus");
  RequireParameter(p.preset == "standard" || p.preset == "hard",
                   "the parameter \"preset\" is '" + p.preset + "'; give standard or hard");
  RequireRange("polyps", p.polyps, 0, 50);
  RequireRange("fluid", p.fluid, 0, 1);
  RequireRange("collapsed", p.collapsed, 0, 5);
  RequireRange("fakeHandles", p.fakeHandles, 0, 8);
  RequireRange("roughness", p.roughness, 0, 1);
  RequireRange("flattenedFolds", p.flattenedFolds, 0, 1);
  RequireRange("foldSlide", p.foldSlide, 0, 10);
  RequireRange("distension", p.distension, 0.6, 1.3);
  RequireRange("torsion", p.torsion, 0, 90);
  RequireRange("noise", p.noise, 0, 300);
}
} // namespace shapeton
