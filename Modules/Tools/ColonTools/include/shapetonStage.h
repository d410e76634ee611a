#ifndef shapetonStage_h
#define shapetonStage_h

#include "ShapetonColonToolsExport.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** \class Stage
 * \brief One call of a tool: its command line, and the arguments that affect the result.
 *
 * \code
 * Stage stage("flattening", "ColonFlattening");
 * stage.Input("", run.PathOf("segmentation", "wall-simplified.vtp"))
 *   .Output("", "flat.vtp")
 *   .Output("statistics", "flat.json")
 *   .Option("metric", "euclidean")
 *   .Idle("threads", "4");
 * \endcode
 *
 * An argument without a flag is positional. \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT Stage
{
public:
  /** Returns the identity of the part of an input that affects this stage. */
  using Identity = std::function<std::string(const std::string & path)>;

  struct Argument
  {
    enum class Kind
    {
      Option,
      Idle,
      Input,
      Output
    };
    Kind        kind{ Kind::Option };
    std::string flag;
    std::string value;
    Identity    identity;
    /** Input folders only: the files that the tool reads; empty for all. */
    std::vector<std::string> files;
  };

  /** `name` is also the name of the stage's folder; the program must be in the tool folder. */
  Stage(const std::string & name, const std::string & program);

  /** An option that affects the result. */
  Stage &
  Option(const std::string & flag, const std::string & value);
  /** An option that does not affect the result, such as the number of threads. */
  Stage &
  Idle(const std::string & flag, const std::string & value);
  /** An input whose content affects the result; identified by IdentityOf() unless another function is given. */
  Stage &
  Input(const std::string & flag, const std::string & path, const Identity & identity = {});
  /** An input folder from which the tool reads these files, if they exist; their contents affect the result. */
  Stage &
  InputFolder(const std::string & flag, const std::string & path, const std::vector<std::string> & files);
  /** A file or folder in the stage's folder; "" is that folder itself. Must exist after the tool has finished. */
  Stage &
  Output(const std::string & flag, const std::string & name);
  /** Files that the tool writes without a separate argument. */
  Stage &
  Expect(const std::vector<std::string> & names);

  const std::string &
  GetName() const
  {
    return m_Name;
  }
  const std::string &
  GetProgram() const
  {
    return m_Program;
  }
  const std::vector<Argument> &
  GetArguments() const
  {
    return m_Arguments;
  }
  /** Names of the outputs in the stage's folder. */
  const std::vector<std::string> &
  GetExpected() const
  {
    return m_Expected;
  }
  /** Arguments of the program if the stage's folder is `folder`. */
  std::vector<std::string>
  CommandIn(const std::string & folder) const;

private:
  std::string              m_Name;
  std::string              m_Program;
  std::vector<Argument>    m_Arguments;
  std::vector<std::string> m_Expected;
};
} // namespace shapeton

#endif
