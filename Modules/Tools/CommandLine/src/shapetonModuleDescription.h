#ifndef shapetonModuleDescription_h
#define shapetonModuleDescription_h

#include <string>
#include <vector>

namespace shapeton
{
/** A 3D Slicer module description, as far as a command line needs it. */
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
    std::string              minimum;
    std::string              maximum;
    std::vector<std::string> elements;
    int                      index{ -1 };
    bool                     multiple{ false };

    /** Three coordinates. */
    bool
    IsPoint() const;
    /** Several numbers with commas between them. */
    bool
    IsVector() const;
    bool
    IsNumeric() const;
    bool
    IsInteger() const;
    /** Names a file or folder. */
    bool
    IsPath() const;
    bool
    IsPositional() const
    {
      return index >= 0;
    }
    /** How a message names it. */
    std::string
    Display() const;
  };

  std::string            title;
  std::string            description;
  std::string            version;
  std::string            documentationUrl;
  std::vector<Parameter> parameters;

  /** In the order of their index. */
  std::vector<const Parameter *>
  Positionals() const;
};

/** Throws std::logic_error for malformed XML: the description is part of the program. */
ModuleDescription
ParseModuleDescription(const char * xml);
} // namespace shapeton

#endif
