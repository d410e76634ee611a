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
  const HeatObjectList *               objects{ nullptr }; ///< of the heat; null for none
  bool                                 wantObjects{ false };
  int                                  object{ 0 }; ///< number of the object to be saved alone; 0 for none
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

  /** Writes a start region and returns its name. */
  std::string
  SaveMask(const StartMask * mask);

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
  /** Writes all objects of the heat, or the one with this number. The heat must already have been written. */
  std::vector<std::string>
  WriteObjects(const SavedResult & result, int object);
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
