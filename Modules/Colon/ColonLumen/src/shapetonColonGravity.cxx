#include "shapetonColonGravity.h"

#include "shapetonDicomFields.h"
#include "shapetonExceptions.h"

#include <array>

namespace shapeton
{
namespace
{
struct Position
{
  const char *           name;
  const char *           codeEnd; // the part after HF or FF
  itk::Vector<double, 3> gravity;
};

const std::array<Position, 4> &
Positions()
{
  static const auto direction = [](double x, double y) {
    itk::Vector<double, 3> v;
    v[0] = x;
    v[1] = y;
    v[2] = 0.0;
    return v;
  };
  static const std::array<Position, 4> positions{ { { "supine", "S", direction(0, 1) },
                                                    { "prone", "P", direction(0, -1) },
                                                    { "leftDecubitus", "DL", direction(1, 0) },
                                                    { "rightDecubitus", "DR", direction(-1, 0) } } };
  return positions;
}

bool
Matches(const std::string & code, const Position & position)
{
  return code == position.name || code == std::string("HF") + position.codeEnd ||
         code == std::string("FF") + position.codeEnd;
}
} // namespace

std::optional<itk::Vector<double, 3>>
GravityOfPatientPosition(const std::string & code)
{
  for (const auto & position : Positions())
  {
    if (Matches(code, position))
    {
      return position.gravity;
    }
  }
  return std::nullopt;
}

std::string
PatientPositionOf(const itk::Object * image, const std::string & given)
{
  return given.empty() || given == "auto" ? DicomField(image, DicomPatientPosition) : given;
}

std::optional<itk::Vector<double, 3>>
GivenGravity(const std::string & position)
{
  const auto gravity = GravityOfPatientPosition(position);
  RequireParameter(gravity || position.empty() || position == "auto",
                   "the patient position \"" + position +
                     "\" is unknown; give supine, prone, leftDecubitus or rightDecubitus");
  return gravity;
}

std::string
NameOfGravity(const itk::Vector<double, 3> & gravity)
{
  const Position * best = &Positions()[0];
  for (const auto & position : Positions())
  {
    best = position.gravity * gravity > best->gravity * gravity ? &position : best;
  }
  return best->name;
}
} // namespace shapeton
