#ifndef shapetonExceptions_h
#define shapetonExceptions_h

#include "ShapetonCommonExport.h"

#include "itkMacro.h"

#include <functional>
#include <string>

namespace shapeton
{
/** \class Exception
 * \brief Base class of all errors of Shapeton; derived from itk::ExceptionObject.
 *
 * what() returns the description unchanged. It is one line with the error, the file or parameter, and the remedy. It
 * refers to a parameter as `the parameter "name"`, which a command-line tool can replace by its option. File, line and
 * location refer to the throwing code. Throw one of the derived classes.
 *
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT Exception : public itk::ExceptionObject
{
public:
  ~Exception() override;

  const char *
  what() const noexcept override;

  const char *
  GetNameOfClass() const override;

protected:
  Exception(const std::string & description, const char * file, unsigned int line, const char * function);
};

// The default arguments are evaluated at the call site of the constructor.
#define SHAPETON_EXCEPTION(name)                                                                                       \
  explicit name(const std::string & description,                                                                       \
                const char *        file = __builtin_FILE(),                                                           \
                unsigned int        line = __builtin_LINE(),                                                           \
                const char *        function = __builtin_FUNCTION());                                                         \
  ~name() override;                                                                                                    \
  const char * GetNameOfClass() const override

/** \class ParameterError
 * \brief A parameter is missing, out of range or contradicts another one; the call is invalid for any input data.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT ParameterError : public Exception
{
public:
  SHAPETON_EXCEPTION(ParameterError);
};

/** \class InputError
 * \brief The input is missing, unreadable, malformed or unsuitable.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT InputError : public Exception
{
public:
  SHAPETON_EXCEPTION(InputError);
};

/** \class OutputError
 * \brief A result cannot be written.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT OutputError : public Exception
{
public:
  SHAPETON_EXCEPTION(OutputError);
};

/** \class DeviceError
 * \brief A requested GPU is not available.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT DeviceError : public Exception
{
public:
  SHAPETON_EXCEPTION(DeviceError);
};

#undef SHAPETON_EXCEPTION

/** Throws ParameterError with the description if the condition is false.
 * \ingroup ShapetonCommon */
inline void
RequireParameter(bool                condition,
                 const std::string & description,
                 const char *        file = __builtin_FILE(),
                 unsigned int        line = __builtin_LINE(),
                 const char *        function = __builtin_FUNCTION())
{
  if (!condition)
  {
    throw ParameterError(description, file, line, function);
  }
}

/** The text with each reference to a parameter, `the parameter "name"`, replaced by what `spell` returns for the name.
 * The second argument of `spell` is true, and ` = ` is also replaced, if a value follows the name.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      SpellParameters(const std::string &                                                         text,
                                      const std::function<std::string(const std::string & name, bool hasValue)> & spell);

/** The description of an ITK exception, excluding the prefix added by ITK's macros, "ITK ERROR: Class(0x55d0c0a8): ",
 * and the location that precedes the prefix in a rethrown exception. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      WithoutItkPrefix(const std::string & description);
} // namespace shapeton

#endif
