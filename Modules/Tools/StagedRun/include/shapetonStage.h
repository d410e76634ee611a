#ifndef shapetonStage_h
#define shapetonStage_h

#include "StagedRunExport.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** \class Stage
 * \brief One call of a tool: its command line, and what of it decides on the result.
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
 * An argument without a flag is positional. \ingroup StagedRun */
class StagedRun_EXPORT Stage
{
public:
  /** Gives what an input holds, as far as it counts for this stage. */
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
    /** Of an input that is a folder: what the tool reads of it; empty for all. */
    std::vector<std::string> files;
  };

  /** The stage's folder has its name; the program lies beside the others. */
  Stage(const std::string & name, const std::string & program);
  ~Stage();

  /** Changes the result. */
  Stage &
  Option(const std::string & flag, const std::string & value);
  /** Does not, as the number of threads. */
  Stage &
  Idle(const std::string & flag, const std::string & value);
  /** Its content changes the result; IdentityOf() tells it unless another function is given. */
  Stage &
  Input(const std::string & flag, const std::string & path, const Identity & identity = {});
  /** A folder of which the tool reads these files, or those of them that are there; their contents change the result.
   */
  Stage &
  InputFolder(const std::string & flag, const std::string & path, const std::vector<std::string> & files);
  /** A file, or a folder, in the stage's folder; "" is that folder itself. Must be there when the tool is done. */
  Stage &
  Output(const std::string & flag, const std::string & name);
  /** Files that the tool writes without an argument for each. */
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
  /** Names in the stage's folder. */
  const std::vector<std::string> &
  GetExpected() const
  {
    return m_Expected;
  }
  /** What the program is called with, where the stage's folder is `folder`. */
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
