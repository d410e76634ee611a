#ifndef shapetonFilterOptions_h
#define shapetonFilterOptions_h

#include "shapetonOptions.h"

#include "itkProcessObject.h"

#include <functional>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/** \name Options of a filter
 * For the public part of a class derived from FilterWithOptions. */
///@{
/** Set and Get methods of a member of the options, and its line in PrintSelf. An enumeration needs NameOf(). */
#define shapetonOptionMacro(name, member) shapetonPrintedOptionMacro(name, member, this->m_Options.member)

/** The same for an enumeration without NameOf(); the names of its values follow. */
#define shapetonEnumOptionMacro(name, member, ...)                                                                     \
  shapetonPrintedOptionMacro(name, member, this->m_Options.member, std::vector<const char *>({ __VA_ARGS__ }))

#define shapetonPrintedOptionMacro(name, member, ...)                                                                  \
  virtual void Set##name(const decltype(OptionsType::member) & value)                                                  \
  {                                                                                                                    \
    if (this->m_Options.member != value)                                                                               \
    {                                                                                                                  \
      this->m_Options.member = value;                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual const decltype(OptionsType::member) & Get##name() const { return this->m_Options.member; }                   \
                                                                                                                       \
protected:                                                                                                             \
  const bool m_Prints##name{ this->PrintWithSelf(#name, __VA_ARGS__) };                                                \
                                                                                                                       \
public:                                                                                                                \
  ITK_MACROEND_NOOP_STATEMENT
///@}

namespace shapeton
{
/** \class FilterWithOptions
 * \brief Mixin for filters whose parameters are the members of a struct: one line per parameter declares its methods.
 *
 * \tparam TOptions the struct.
 * \tparam TSuperclass itk::ProcessObject or a class derived from it.
 * \ingroup ShapetonCommon */
template <typename TOptions, typename TSuperclass>
class FilterWithOptions : public TSuperclass
{
public:
  using OptionsType = TOptions;

  /** All options at once. */
  void
  SetOptions(const TOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  const TOptions &
  GetOptions() const
  {
    return m_Options;
  }

protected:
  using TSuperclass::TSuperclass;
  ~FilterWithOptions() override = default;

  /** Called by the generated Set methods. */
  template <typename TOption>
  void
  SetOption(TOption & option, const TOption & value)
  {
    if (option != value)
    {
      option = value;
      this->Modified();
    }
  }

  void
  VerifyPreconditions() const override
  {
    TSuperclass::VerifyPreconditions();
    if constexpr (IsDeclared<TOptions>::value)
    {
      CheckOptions(m_Options);
    }
  }

  /** Called by the macros; returns true. */
  template <typename TOption>
  bool
  PrintWithSelf(const char * name, const TOption & option)
  {
    m_Printers.push_back([name, &option](std::ostream & os) { PrintOption(os << name << ": ", option); });
    return true;
  }
  template <typename TEnum>
  bool
  PrintWithSelf(const char * name, const TEnum & option, std::vector<const char *> names)
  {
    m_Printers.push_back([name, &option, names = std::move(names)](std::ostream & os) {
      os << name << ": " << names.at(static_cast<std::size_t>(option));
    });
    return true;
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    TSuperclass::PrintSelf(os, indent);
    if constexpr (IsDeclared<TOptions>::value)
    {
      TOptions::VisitOptions(m_Options, [&](const OptionInfo & info, const auto & option) {
        shapeton::PrintOption(os << indent << info.GetName() << ": ", info, option);
        os << std::endl;
      });
    }
    for (const auto & print : m_Printers)
    {
      print(os << indent);
      os << std::endl;
    }
  }

  TOptions m_Options;

private:
  struct NoVisit
  {
    template <typename TOption>
    void
    operator()(const OptionInfo &, TOption &) const
    {}
  };
  template <typename T, typename = void>
  struct IsDeclared : std::false_type
  {};
  template <typename T>
  struct IsDeclared<T, std::void_t<decltype(T::VisitOptions(std::declval<T &>(), NoVisit()))>> : std::true_type
  {};

  template <typename TOption>
  static void
  PrintOption(std::ostream & os, const TOption & option)
  {
    if constexpr (std::is_enum_v<TOption>)
    {
      os << NameOf(option);
    }
    else
    {
      os << option;
    }
  }
  template <typename TElement>
  static void
  PrintOption(std::ostream & os, const std::vector<TElement> & elements)
  {
    os << elements.size();
  }
  template <typename TOption>
  static void
  PrintOption(std::ostream & os, const std::optional<TOption> & option)
  {
    option ? os << *option : os << "(automatic)";
  }

  std::vector<std::function<void(std::ostream &)>> m_Printers;
};
} // namespace shapeton

#endif
