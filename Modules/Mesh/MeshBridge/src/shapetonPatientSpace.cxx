#include "shapetonPatientSpace.h"

#include "shapetonExceptions.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace shapeton
{
namespace
{
constexpr const char * SpaceName = "SPACE";
}

std::string
NameOf(PatientSpace space)
{
  return space == PatientSpace::LPS ? "LPS" : "RAS";
}

void
SetSpace(PatientSpace space, vtkFieldData & data)
{
  vtkNew<vtkStringArray> text;
  text->SetName(SpaceName);
  text->InsertNextValue(NameOf(space));
  data.AddArray(text); // replaces an array of the same name
}

PatientSpace
SpaceOf(vtkFieldData & data, PatientSpace otherwise)
{
  const auto * const text = vtkStringArray::SafeDownCast(data.GetAbstractArray(SpaceName));
  if (!text || text->GetNumberOfValues() == 0)
  {
    return otherwise;
  }
  const std::string name = const_cast<vtkStringArray *>(text)->GetValue(0);
  if (name != "LPS" && name != "RAS")
  {
    throw InputError("the field data state SPACE=" + name + "; expected LPS or RAS");
  }
  return name == "RAS" ? PatientSpace::RAS : PatientSpace::LPS;
}
} // namespace shapeton
