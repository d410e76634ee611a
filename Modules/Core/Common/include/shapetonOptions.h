#ifndef shapetonOptions_h
#define shapetonOptions_h

#include "ShapetonCommonExport.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

// Structs of options are generated from declarations, Modules/<Group>/<Module>/options/<Struct>.json. Each has a static
// member function VisitOptions(options, visit), which calls `visit(info, member)` for each option.
namespace shapeton
{
/** \class OptionInfo
 * \brief Name, range and words of an option.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT OptionInfo
{
public:
  /** `name` must have static storage. */
  explicit OptionInfo(const char * name) : m_Name(name) {}

  ///@{
  /** Sets the limit on one side; `text` is its form in messages, with static storage. */
  OptionInfo &
  AtLeast(double value, const char * text);
  OptionInfo &
  Above(double value, const char * text);
  OptionInfo &
  AtMost(double value, const char * text);
  OptionInfo &
  Below(double value, const char * text);
  ///@}

  /** The names of the values of an enumeration, 0 first. */
  OptionInfo &
  Words(std::vector<const char *> words);

  const char *
  GetName() const
  {
    return m_Name;
  }
  const std::vector<const char *> &
  GetWords() const
  {
    return m_Words;
  }

  /** Throws ParameterError if the number is out of range or not finite. */
  void
  Check(double value) const;
  /** Throws ParameterError if there are words and this is not one of them. */
  void
  Check(const std::string & word) const;
  /** The position of a word, which is the number of its enumerator. Throws ParameterError, which lists the words. */
  std::size_t
  PositionOf(const std::string & word) const;

private:
  struct Limit
  {
    double       value;
    const char * text{ "" };
    bool         isExcluded{ false };
  };

  const char *              m_Name;
  Limit                     m_Least{ -std::numeric_limits<double>::infinity() };
  Limit                     m_Most{ std::numeric_limits<double>::infinity() };
  std::vector<const char *> m_Words;
};

/** Throws ParameterError if an option is a number out of range or an unknown word. \ingroup ShapetonCommon */
///@{
template <typename TOption>
void
CheckOption(const OptionInfo & info, const TOption & option)
{
  if constexpr (std::is_arithmetic_v<TOption>)
  {
    info.Check(static_cast<double>(option));
  }
  else if constexpr (std::is_same_v<TOption, std::string>)
  {
    info.Check(option);
  }
}
template <typename TOption>
void
CheckOption(const OptionInfo & info, const std::optional<TOption> & option)
{
  if (option)
  {
    CheckOption(info, *option);
  }
}
///@}

/** Throws ParameterError if a number among the options is out of range, or a word unknown. \ingroup ShapetonCommon */
template <typename TOptions>
void
CheckOptions(const TOptions & options)
{
  TOptions::VisitOptions(options, [](const OptionInfo & info, const auto & option) { CheckOption(info, option); });
}

/** The declared word of a value: WordOf(&DeviceOptions::device, Device::Cpu) is "cpu". \ingroup ShapetonCommon */
template <typename TOptions, typename TEnum>
const char *
WordOf(TEnum TOptions::*member, TEnum value)
{
  const TOptions options;
  const char *   word = nullptr;
  TOptions::VisitOptions(options, [&](const OptionInfo & info, const auto & option) {
    if (static_cast<const void *>(&option) == &(options.*member))
    {
      word = info.GetWords().at(static_cast<std::size_t>(value));
    }
  });
  return word;
}

/** Writes a value as in PrintSelf: a word of an enumeration, the number of elements of a list.
 * \ingroup ShapetonCommon */
template <typename TOption>
void
PrintOption(std::ostream & os, const OptionInfo & info, const TOption & option)
{
  if constexpr (std::is_enum_v<TOption>)
  {
    os << info.GetWords().at(static_cast<std::size_t>(option));
  }
  else
  {
    os << option;
  }
}
template <typename TElement>
void
PrintOption(std::ostream & os, const OptionInfo &, const std::vector<TElement> & elements)
{
  os << elements.size() << " elements";
}
inline void
PrintOption(std::ostream & os, const OptionInfo &, const std::array<double, 2> & pair)
{
  os << pair[0] << ", " << pair[1];
}
template <typename TOption>
void
PrintOption(std::ostream & os, const OptionInfo & info, const std::optional<TOption> & option)
{
  option ? PrintOption(os, info, *option) : static_cast<void>(os << "(none)");
}
} // namespace shapeton

#endif
