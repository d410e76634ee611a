#ifndef shapetonModuleDescription_h
#define shapetonModuleDescription_h

#include <string>
#include <vector>

namespace shapeton
{
/** The parts of a 3D Slicer module description that a command line needs. */
struct ModuleDescription
{
  struct Parameter
  {
    std::string              tag; ///< image, double, string-enumeration, ...
    std::string              name;
    std::string              flag;     ///< without hyphen
    std::string              longflag; ///< without hyphens
    std::string              description;
    std::string              defaultValue;
    std::string              channel;
    std::string              group; ///< label of its group
    std::string              minimum;
    std::string              maximum;
    std::vector<std::string> elements;
    int                      index{ -1 };
    bool                     multiple{ false };
    std::vector<std::string> extensions; ///< of files, such as .png; a path without may be a folder

    /** Whether the type is a point of three coordinates. */
    bool
    IsPoint() const;
    /** Whether the type is a comma-separated list of numbers. */
    bool
    IsVector() const;
    bool
    IsNumeric() const;
    bool
    IsInteger() const;
    /** Whether the value names a file or folder. */
    bool
    IsPath() const;
    bool
    IsPositional() const
    {
      return index >= 0;
    }
    /** Name of the parameter in messages. */
    std::string
    Display() const;
  };

  std::string            title;
  std::string            description;
  std::string            version;
  std::string            documentationUrl;
  std::vector<Parameter> parameters;

  /** Positional parameters, ordered by index. */
  std::vector<const Parameter *>
  Positionals() const;
};

/** Throws std::logic_error for malformed XML: the description is part of the program. */
ModuleDescription
ParseModuleDescription(const char * xml);
} // namespace shapeton

#endif
