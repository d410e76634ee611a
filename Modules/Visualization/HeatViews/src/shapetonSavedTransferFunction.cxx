#include "shapetonSavedTransferFunction.h"

#include "shapetonColorMap.h"
#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonJson.h"

#include <limits>
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

/** Objects were added in the second version. */
int
VersionOf(bool hasObjects)
{
  return hasObjects ? 2 : 1;
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

  /** Requires a list, which must not be empty if `isRequired`. */
  void
  RequireList(const Json & array, const std::string & name, bool isRequired) const
  {
    if (!array.is_array() || (isRequired && array.empty()))
    {
      Refuse(m_Path, "\"" + name + "\" is not a " + (isRequired ? "non-empty " : "") + "list");
    }
  }

  RGBColor
  Color(const Json & object) const
  {
    const auto color = object["color"].is_string() ? ColorOf(object["color"].get<std::string>()) : std::nullopt;
    if (!color)
    {
      Refuse(m_Path, "\"color\" is not a color #rrggbb");
    }
    return *color;
  }

  /** A number of an object or of its label. */
  int
  ObjectNumber(const Json & value) const
  {
    if (!value.is_number_unsigned() || value < 1 || value > std::numeric_limits<unsigned short>::max())
    {
      Refuse(m_Path, "an object has a number or label that is not from 1 to 65535");
    }
    return value.get<int>();
  }

  TransferFunctionLine
  Line(const Json & object) const
  {
    this->RequireKeys(object, "a line", { "lower", "upper", "color", "opacity" });
    return {
      this->Number(object, "lower"), this->Number(object, "upper"), this->Color(object), this->Number(object, "opacity")
    };
  }

  ObjectColor
  Object(const Json & object) const
  {
    this->RequireKeys(object, "an object", { "number", "labels", "voxels", "color", "opacity" });
    this->RequireList(object["labels"], "labels", true);
    if (!object["voxels"].is_number_unsigned())
    {
      Refuse(m_Path, "\"voxels\" is not a number of voxels");
    }
    ObjectColor colored{ this->ObjectNumber(object["number"]),
                         {},
                         object["voxels"].get<std::uint64_t>(),
                         this->Color(object),
                         this->Number(object, "opacity") };
    for (const Json & label : object["labels"])
    {
      colored.labels.push_back(this->ObjectNumber(label));
    }
    if (!(colored.opacity >= 0.0 && colored.opacity <= 1.0))
    {
      Refuse(m_Path, "the opacity of object " + std::to_string(colored.number) + " is not from 0 to 1");
    }
    return colored;
  }

  std::vector<ObjectColor>
  Objects(const Json & array) const
  {
    constexpr std::size_t most = 200; // with the lines, they fit into the bytes of a ClassifiedVolume
    this->RequireList(array, "objects", true);
    if (array.size() > most)
    {
      Refuse(m_Path, "it has more than " + std::to_string(most) + " objects");
    }
    std::vector<ObjectColor> objects;
    for (const Json & object : array)
    {
      objects.push_back(this->Object(object));
    }
    return objects;
  }

  ShapeTransferFunction
  Lines(const Json & array, bool isRequired = true) const
  {
    this->RequireList(array, "lines", isRequired);
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
  const Json            document = ReadJson(path);
  const Reader          reader(path);
  std::set<std::string> keys{ "shapeton", "version", "quantity", "timeStep", "lines" };
  const bool            hasObjects = document.is_object() && document.contains("objects");
  if (hasObjects)
  {
    keys.insert("objects");
  }
  reader.RequireKeys(document, "it", keys);
  if (document["shapeton"] != "transfer function" || document["version"] != VersionOf(hasObjects))
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
           reader.Lines(document["lines"], !hasObjects),
           hasObjects ? reader.Objects(document["objects"]) : std::vector<ObjectColor>() };
}

ShapeTransferFunction
TransferFunctionOf(const Json & lines, const std::string & name)
{
  return Reader(name).Lines(lines);
}

void
WriteTransferFunction(const SavedTransferFunction & transferFunction, const std::string & path)
{
  Json document{ { "shapeton", "transfer function" },
                 { "version", VersionOf(!transferFunction.objects.empty()) },
                 { "quantity", transferFunction.quantity },
                 { "timeStep", transferFunction.timeStep },
                 { "lines", JsonOf(transferFunction.lines) } };
  for (const ObjectColor & object : transferFunction.objects)
  {
    document["objects"].push_back({ { "number", object.number },
                                    { "labels", object.labels },
                                    { "voxels", object.voxels },
                                    { "color", HexOf(object.color) },
                                    { "opacity", object.opacity } });
  }
  WriteJson(document, path);
}
} // namespace shapeton
