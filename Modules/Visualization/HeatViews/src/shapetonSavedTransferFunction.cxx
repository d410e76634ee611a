#include "shapetonSavedTransferFunction.h"

#include "shapetonColorMap.h"
#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonJson.h"

#include <set>

namespace shapeton
{
namespace
{
[[noreturn]] void
Refuse(const std::string & path, const std::string & fault)
{
  throw InputError(path + " is not a transfer function saved by the heat explorer: " + fault + "; save it again");
}

/** Reader of one file; errors include its name. */
class Reader
{
public:
  explicit Reader(const std::string & path) : m_Path(path) {}

  void
  RequireKeys(const Json & object, const std::string & name, const std::set<std::string> & keys) const
  {
    if (!object.is_object())
    {
      Refuse(m_Path, name + " is not an object");
    }
    for (const auto & [key, value] : object.items())
    {
      if (keys.count(key) == 0)
      {
        Refuse(m_Path, name + " has the unknown key \"" + key + "\"");
      }
    }
    for (const std::string & key : keys)
    {
      if (!object.contains(key))
      {
        Refuse(m_Path, name + " lacks \"" + key + "\"");
      }
    }
  }

  double
  Number(const Json & object, const std::string & key) const
  {
    if (!object[key].is_number())
    {
      Refuse(m_Path, "\"" + key + "\" is not a number");
    }
    return object[key].get<double>();
  }

  TransferFunctionLine
  Line(const Json & object) const
  {
    this->RequireKeys(object, "a line", { "lower", "upper", "color", "opacity" });
    const auto color = object["color"].is_string() ? ColorOf(object["color"].get<std::string>()) : std::nullopt;
    if (!color)
    {
      Refuse(m_Path, "\"color\" is not a color #rrggbb");
    }
    return { this->Number(object, "lower"), this->Number(object, "upper"), *color, this->Number(object, "opacity") };
  }

  ShapeTransferFunction
  Lines(const Json & array) const
  {
    if (!array.is_array() || array.empty())
    {
      Refuse(m_Path, "\"lines\" is not a non-empty list");
    }
    std::vector<TransferFunctionLine> lines;
    for (const Json & line : array)
    {
      lines.push_back(this->Line(line));
    }
    try
    {
      return ShapeTransferFunction(std::move(lines));
    }
    catch (const ParameterError & error)
    {
      throw InputError(m_Path + ": " + error.what());
    }
  }

private:
  const std::string m_Path;
};
} // namespace

SavedTransferFunction
ReadTransferFunction(const std::string & path)
{
  const Json   document = ReadJson(path);
  const Reader reader(path);
  reader.RequireKeys(document, "it", { "shapeton", "version", "quantity", "timeStep", "lines" });
  if (document["shapeton"] != "transfer function" || document["version"] != 1)
  {
    Refuse(path, "its kind or version is unsupported");
  }
  if (document["quantity"] != "heat" && document["quantity"] != "density")
  {
    Refuse(path, "\"quantity\" is neither heat nor density");
  }
  if (!document["timeStep"].is_number_unsigned())
  {
    Refuse(path, "\"timeStep\" is not a time step");
  }
  return { document["quantity"].get<std::string>(),
           document["timeStep"].get<std::uint64_t>(),
           reader.Lines(document["lines"]) };
}

ShapeTransferFunction
TransferFunctionOf(const Json & lines, const std::string & name)
{
  return Reader(name).Lines(lines);
}

void
WriteTransferFunction(const SavedTransferFunction & transferFunction, const std::string & path)
{
  WriteJson({ { "shapeton", "transfer function" },
              { "version", 1 },
              { "quantity", transferFunction.quantity },
              { "timeStep", transferFunction.timeStep },
              { "lines", JsonOf(transferFunction.lines) } },
            path);
}
} // namespace shapeton
