#ifndef shapetonSessionFiles_h
#define shapetonSessionFiles_h

#include "shapetonHeatObjects.h"
#include "shapetonLiveSession.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonStartRegion.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** What is saved under one name: NAME-density.nrrd or NAME-heat.nrrd, NAME-labels.nrrd, NAME.json and NAME.vp; for
 * objects of heat, NAME-objects.nrrd and NAME-objects.csv, and for one of them NAME-object.nrrd and NAME-object.csv. */
struct SavedResult
{
  std::string                          name; ///< in the folder
  bool                                 isHeat{ false };
  std::uint64_t                        timeStep{ 0 };
  bool                                 wantLabels{ false };
  std::string                          mask; ///< file name; empty for none
  std::optional<ShapeTransferFunction> lines;
  std::string                          barrier;            ///< file name; empty for none
  std::optional<HeatObjectList>        objects;            ///< all objects of the heat, if they are to be saved
  std::vector<int>                     selection;          ///< objects to be saved alone
  const HeatObjectList *               offered{ nullptr }; ///< objects and offers, which `selection` numbers
};

/** \class SessionFiles
 * \brief Writes the results of a session as the tools do, and the script that repeats it with the tools. */
class SessionFiles
{
public:
  using VisitsType = itk::Image<std::uint32_t, 3>;
  using HeatType = itk::Image<float, 3>;

  SessionFiles(const Volume & volume, const LiveSessionSettings & settings);

  const SessionFolder &
  GetFolder() const
  {
    return m_Folder;
  }

  /** Adds a line about a change to the script. */
  void
  Note(const std::string & change);

  /** Write the files of a result and add the commands to the script. `options` are those of the walk, with all values.
   * They return the names of the files. Throw ParameterError, OutputError. */
  ///@{
  std::vector<std::string>
  Save(const SavedResult & result, const ParticleDiffusionOptions & options, const VisitsType * visits);
  std::vector<std::string>
  Save(const SavedResult & result, const ParticleDiffusionOptions & options, const HeatType * heat);
  ///@}

  /** The same voxels on the rounded grid that a tool reads from the saved file. */
  HeatType::Pointer
  AsWritten(const HeatType * heat) const;

  /** Writes a mask under this name and a number, and returns its file name. */
  std::string
  SaveMask(const StartMask * mask, const std::string & name);

  /** Writes the script. */
  void
  SaveScript(const std::string & name) const;

  /** The script as text. */
  std::string
  GetScript() const;

private:
  using Arguments = std::vector<std::string>;
  using Body = std::function<void(CommandLine &)>;

  void
  RunTool(const char * xml, const std::string & tool, const Arguments & arguments, const Body & body) const;
  void
  AddInput(CommandLine & commandLine) const;
  /** A mask in the folder of the session, as an argument, and in the last line of the script; none if `file` is empty.
   */
  ///@{
  void
  AddMask(const std::string & option, const std::string & file, Arguments & arguments) const;
  void
  NoteMask(const std::string & option, const std::string & file);
  ///@}
  /** Writes objects of the heat, which must already have been written: all, or those with these numbers. */
  std::vector<std::string>
  WriteObjects(const SavedResult & result, const HeatObjectList & list, const std::vector<int> & selection);
  std::vector<std::string>
  WriteLines(const SavedResult & result, double unit);
  void
  NoteCommand(const std::string & tool, const std::vector<std::string> & inResults, const Arguments & arguments);

  const Volume &                 m_Volume;
  const std::string              m_Input;
  const std::vector<std::string> m_ReadingArguments;
  const SessionFolder            m_Folder;
  unsigned int                   m_Masks{ 0 };
  std::vector<std::string>       m_Lines; ///< of the script
};
} // namespace shapeton

#endif
