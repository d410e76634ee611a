#ifndef shapetonLiveSession_h
#define shapetonLiveSession_h

#include "ShapetonLiveSessionExport.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonJsonForward.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonSessionFolder.h"
#include "shapetonVolume.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** What a viewer has received. \ingroup ShapetonLiveSession */
struct SessionViewer
{
  std::array<std::size_t, 3>  place{};      ///< voxel through which the slices pass
  std::uint64_t               version{ 0 }; ///< of the values
  std::uint64_t               stateVersion{ 0 };
  bool                        isPlaceNew{ true };
  std::array<std::int64_t, 3> slices{ { -1, -1, -1 } }; ///< indices of the gray slices
  std::vector<std::size_t>    bricks;                   ///< checksums of the bricks
  std::uint64_t               histogram{ 0 };           ///< version of the histogram
  /** Receives all voxels and the labels of the objects, instead of slices, bricks and histogram. */
  bool          isWhole{ false };
  std::uint64_t objects{ 0 }; ///< version of the objects
};

/** Settings of LiveSession. \ingroup ShapetonLiveSession */
struct LiveSessionSettings
{
  /** The input as given to the tool, and its reading options as arguments; for the script. */
  std::string              input;
  std::vector<std::string> readingArguments;
  /** Folder of all files that commands read and write. */
  std::string              folder{ "." };
  ParticleDiffusionOptions walk;
  /** ChooseHeatParameters() of the volume without given parameters; empty: computed when it is needed. */
  std::optional<HeatParameterChoice> choice;
};

/** \class LiveSession
 * \brief A diffusion that is watched and steered while it runs: the volume, the walk, the shown heat, and the commands
 * of a page; no network and no threads of its own.
 *
 * The owner calls Do() for each command and Work() as often as it returns true. Frames contain what a viewer lacks: the
 * state, three slices, changed bricks of a reduced volume, and the histogram; or, for another program, all voxels and
 * the labels of the objects.
 *
 * A change to an option or to the start region restarts the walk, so that the visits always belong to one set of
 * options. Therefore the files of a session equal those of ShapetonDiffusion and CumulativeHeatDiffusion, and the saved
 * script reproduces them.
 *
 * Memory: that of the tools, plus at most two volumes of 4 bytes per voxel.
 *
 * \ingroup ShapetonLiveSession */
class ShapetonLiveSession_EXPORT LiveSession
{
public:
  /** Called often during long work; may throw to end the session. Commands must not be executed inside. */
  using Poll = std::function<void()>;

  /** Throws InputError for a folder that does not exist. The device of the walk's options is used for all work. */
  LiveSession(Volume volume, const LiveSessionSettings & settings);
  ~LiveSession();
  LiveSession(const LiveSession &) = delete;
  LiveSession &
  operator=(const LiveSession &) = delete;

  /** Executes a command, an object {"do": NAME, ...}, and returns the answer, an object with the key "done". Throws
   * ParameterError for an unknown command or a wrong value, InputError and OutputError for files; the session is then
   * unchanged. Commands: see the README of the module. */
  Json
  Do(const Json & command);

  /** Makes the current call of Work() return soon; for use in a poll when a command has arrived. The next call
   * continues an interrupted heat computation unless the command changed something. */
  void
  Interrupt();

  /** Works for about 30 ms, or until the heat is computed or Interrupt() is called. Returns whether work remains. */
  bool
  Work(const Poll & poll = {});

  /** Whether Work() is computing exact heat. Its poll may then call Update(), which shows the coarse heat. */
  bool
  IsComputingHeat() const;

  /** Description of volume and views for the page. */
  Json
  GetInfo() const;

  Json
  GetState() const;

  /** Whether the viewer lacks something. */
  bool
  IsNewFor(const SessionViewer & viewer) const;

  /** The frame of what the viewer lacks. A frame consists of the length of its header (4 bytes, little-endian), the
   * header (JSON), and the arrays that the header describes. */
  std::string
  Update(SessionViewer & viewer);

  /** A picture of the shown volume, drawn by VolumeRenderer, as a frame with a JPEG file. Keys of the request: azimuth,
   * elevation, zoom, width, height, quality, lines. Throws ParameterError. */
  std::string
  Draw(const Json & request);

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // namespace shapeton

#endif
