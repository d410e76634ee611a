#ifndef shapetonFilterOptions_h
#define shapetonFilterOptions_h

#include "shapetonOptions.h"

#include "itkProcessObject.h"

#include <cctype>
#include <ostream>
#include <string>

namespace shapeton
{
/** \class FilterWithOptions
 * \brief Mixin for filters whose parameters are the members of a struct. The generated mixins, such as
 * VolumeGradientOptionsMethods, add the Set and Get methods of declared options.
 *
 * \tparam TOptions the struct, generated or derived from generated ones: it has VisitOptions().
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
    CheckOptions(m_Options);
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    TSuperclass::PrintSelf(os, indent);
    TOptions::VisitOptions(m_Options, [&](const OptionInfo & info, const auto & option) {
      std::string name = info.GetName();
      name.front() = static_cast<char>(std::toupper(name.front())); // as in the Set method
      PrintOption(os << indent << name << ": ", info, option);
      os << std::endl;
    });
  }

  TOptions m_Options;
};
} // namespace shapeton

#endif
