#include "shapetonLiveSession.h"

#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonInterruption.h"
#include "shapetonMappedImage.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonSessionCommands.h"
#include "shapetonSessionFiles.h"
#include "shapetonSessionHistory.h"
#include "shapetonSessionObjects.h"
#include "shapetonSessionPictures.h"
#include "shapetonSessionState.h"
#include "shapetonSessionWalk.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>
#include <utility>

namespace shapeton
{
namespace
{
using ImageType = itk::Image<float, 3>;
using Clock = std::chrono::steady_clock;

/** Placing a walk in more voxels than this takes a while, so a preview is shown first. */
constexpr std::size_t mostWithoutPreview = std::size_t{ 1 } << 21;
/** Duration of a piece of the walk; commands wait for its end. */
constexpr double secondsOfPiece = 0.03;
/** Ends a piece of work. */
struct Finish
{
  ~Finish() { work = SessionWork::None; }
  SessionWork & work;
};

/** Thrown to leave work because a command has arrived. */
struct Interrupted
{};

double
SecondsSince(const Clock::time_point & start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}
} // namespace

struct LiveSession::Impl
{
  Impl(Volume given, const LiveSessionSettings & settings)
    : volume(std::move(given))
    , options(settings.walk)
    , files(volume, settings)
    , walk(volume.image)
    , view(volume.image.GetPointer())
    , size(view.size)
    , pictures(volume.image)
    , goal(settings.walk.timeSteps)
    , heatSteps(settings.walk.timeSteps)
    , choice(settings.choice)
  {
    const auto window = WindowOf(options, view);
    if (window[0] < window[1])
    {
      options.intensityWindow = window; // the saved script names all values
    }
    files.Note("start: " + TextOfJson(JsonOfOptions(options)));
  }

  // ---- work ----
  /** Changes the state, and releases data that the new state does not include. */
  void
  Note(SessionEvent event)
  {
    state = After(state, event);
    if (state.heat == SessionState::Heat::None)
    {
      heat = nullptr;
      objects.Clear();
    }
    if (!state.hasFailed)
    {
      error.clear();
    }
  }

  SessionWork
  Next() const
  {
    return NextWork(state, walk.GetMeasures().step >= goal);
  }

  void
  Work(const Poll & poll)
  {
    isInterrupted = false;
    const auto check = [&] {
      if (poll)
      {
        poll();
      }
      if (isInterrupted && current != SessionWork::MoveWalk) // an interrupted step would leave some shapetons behind
      {
        throw Interrupted();
      }
    };
    const Interruption interruption(check);
    const SessionWork  work = Next();
    try
    {
      Perform(work);
    }
    catch (const Interrupted &)
    {}
    catch (const InputError & failure) // no voxel to start from, too many visits of a voxel, no object
    {
      Fail(work == SessionWork::FindObjects ? SessionEvent::ObjectsFailed : SessionEvent::Failed, failure.what());
    }
    catch (const std::bad_alloc &)
    {
      Fail(SessionEvent::Failed, "not enough memory; use fewer shapetons");
    }
    stage.clear();
    ++stateVersion;
  }

  void
  Fail(SessionEvent event, const std::string & message)
  {
    Note(event);
    error = message;
  }

  void
  Perform(SessionWork work)
  {
    current = work;
    const Finish finish{ current };
    switch (work)
    {
      case SessionWork::PlaceWalk:
        PlaceWalk();
        break;
      case SessionWork::MoveWalk:
        MoveWalk();
        break;
      case SessionWork::ChooseParameters:
        ChooseParameters();
        break;
      case SessionWork::ComputeCoarseHeat:
        ComputeCoarseHeat();
        break;
      case SessionWork::ComputeExactHeat:
        ComputeExactHeat();
        break;
      case SessionWork::FindObjects:
        FindObjects();
        break;
      case SessionWork::None:
        break;
    }
  }

  void
  ValuesHaveChanged()
  {
    pictures.OutdateHistogram();
    ++version;
  }

  /** Places the shapetons at the start, or where they were parked, and moves them. In a large volume, it takes a while
   * until shapetons move, so a coarse picture is shown first. */
  void
  PlaceWalk()
  {
    const auto poll = [] { Interruption::Check(); };
    if (state.walk == SessionState::Walk::Parked)
    {
      walk.Resume(poll);
    }
    else if (preview.values.empty() && view.NumberOfVoxels() > mostWithoutPreview)
    {
      ShowPreview();
      return;
    }
    else
    {
      Note(SessionEvent::HeatReleased);
      walk.Place(options, mask, poll);
      pieceStart = Clock::now();
      ValuesHaveChanged();
    }
    Note(SessionEvent::WalkPlaced);
    current = SessionWork::MoveWalk;
    MoveWalk();
  }

  void
  ParkWalk()
  {
    walk.Park();
    Note(SessionEvent::WalkParked);
  }

  void
  ShowPreview()
  {
    if (!coarseWalk)
    {
      coarseWalk.emplace(view);
    }
    preview = coarseWalk->Start(options, mask);
    ValuesHaveChanged();
  }

  void
  MoveWalk()
  {
    const std::uint64_t step = walk.GetMeasures().step;
    const std::uint64_t steps = std::min(goal - std::min(goal, step), StepsOfPiece());
    if (steps == 0)
    {
      if (step < goal)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(2)); // the speed is limited
      }
      return;
    }
    const auto start = Clock::now();
    walk.Advance(steps);
    preview.values.clear();
    const double seconds = std::max(SecondsSince(start), 1e-6);
    stepsPerSecond = static_cast<double>(steps) / seconds;
    pieceStart = Clock::now();
    ++version;
    walk.GetMeasures().step == goal ? pictures.OutdateHistogram() : pictures.OutdateOldHistogram();
  }

  /** Number of steps until the next command is read; 0 if the speed limit does not allow any yet. */
  std::uint64_t
  StepsOfPiece() const
  {
    const double piece = std::max(1.0, std::floor(stepsPerSecond * secondsOfPiece));
    const double allowed =
      speed > 0.0 ? std::floor(SecondsSince(pieceStart) * speed) : std::numeric_limits<double>::infinity();
    return static_cast<std::uint64_t>(std::min(piece, allowed));
  }

  CumulativeHeatDiffusionSettings
  HeatSettings() const
  {
    CumulativeHeatDiffusionSettings settings;
    static_cast<VolumeDiffusionOptions &>(settings) = options;
    settings.timeSteps = heatSteps;
    return settings;
  }

  /** The volume without the barrier. */
  VolumeView
  Domain() const
  {
    VolumeView domain = view;
    if (barrier)
    {
      std::vector<unsigned char>  isIn(view.NumberOfVoxels());
      const unsigned char * const first = barrier->GetBufferPointer();
      std::transform(
        first, first + isIn.size(), isIn.begin(), [](unsigned char isBarrier) { return isBarrier != 0 ? 0 : 1; });
      domain.domain = std::make_shared<const std::vector<unsigned char>>(std::move(isIn));
    }
    return domain;
  }

  void
  ComputeCoarseHeat()
  {
    Tell("coarse heat", 0.0);
    if (!coarse)
    {
      coarse.emplace(Domain(), HeatSettings());
    }
    blocks = coarse->After(heatSteps);
    Note(SessionEvent::CoarseHeatComputed);
    ValuesHaveChanged();
  }

  void
  ComputeExactHeat()
  {
    ParkWalk();
    const auto exact = NewImageOn<ImageType>(volume.image);
    Tell("heat", 0.0);
    DiffuseCumulativeHeat(
      Domain(), HeatSettings(), exact->GetBufferPointer(), nullptr, {}, [this](double part) { Tell("heat", part); });
    heat = exact;
    Note(SessionEvent::ExactHeatComputed);
    ValuesHaveChanged();
  }

  void
  FindObjects()
  {
    if (!objects.AreFound())
    {
      Tell("objects", 0.0);
      objects.Find(files.AsWritten(heat), barrier, [this](double part) { Tell("objects", part); });
    }
    Note(SessionEvent::ObjectsFound);
    ++version; // the slices have labels
  }

  /** Sets window, p, smoothing and time so that objects separate. The choice depends only on the volume. */
  void
  ChooseParameters()
  {
    if (!choice)
    {
      ParkWalk();
      Tell("choosing parameters", 0.0);
      auto settings = HeatSettings();
      settings.intensityWindow.reset();
      choice = ChooseHeatParameters(view, settings, {}, [this](double part) { Tell("choosing parameters", part); });
    }
    SessionValues values = Values();
    const auto    timeSteps = values.options.timeSteps;
    choice->ApplyTo(values.options);
    values.heatSteps = std::exchange(values.options.timeSteps, timeSteps);
    Use(values, "Find objects");
    Note(SessionEvent::ParametersChosen);
  }

  void
  Tell(const std::string & name, double part)
  {
    constexpr double least = 0.01; // change of the share that is worth a message
    if (name != stage || std::abs(part - share) >= least)
    {
      stage = name;
      share = part;
      ++stateVersion;
    }
  }

  // ---- commands ----
  SessionValues
  Values() const
  {
    return { options, heatSteps, state.view, barrier, barrierVoxels };
  }

  /** Takes other values by the command with this name; Undo reverts it. */
  void
  Change(const SessionValues & values, const std::string & name)
  {
    if (!ChangesBetween(Values(), values).empty())
    {
      history.Add(Values(), name == "heat" ? name : ""); // the time has a slider
    }
    Use(values, name);
  }

  /** The walk starts again only if an option differs. */
  void
  Use(const SessionValues & values, const std::string & name)
  {
    const std::string differences = ChangesBetween(Values(), values);
    lastChange = name + ": " + (differences.empty() ? "no value changes" : differences);
    const bool isWalkNew = JsonOfOptions(values.options) != JsonOfOptions(options);
    const bool isHeatNew = values.heatSteps != heatSteps || values.barrier != barrier;
    if (values.barrier != barrier)
    {
      coarse.reset();
      barrierName.clear();
    }
    options = values.options;
    heatSteps = values.heatSteps;
    barrier = values.barrier;
    barrierVoxels = values.barrierVoxels;
    if (isWalkNew)
    {
      Restart(lastChange);
    }
    else
    {
      NoteChange(lastChange);
    }
    if (isHeatNew && !isWalkNew)
    {
      Show(SessionEvent::HeatTimeChanged);
    }
    Show(values.view == SessionState::View::Heat ? SessionEvent::HeatShown : SessionEvent::DensityShown);
  }

  void
  NoteChange(const std::string & change)
  {
    files.Note("step " + std::to_string(StepOfWalk()) + ": " + change);
    ++changes;
  }

  /** A change to the diffusion: everything is recomputed. */
  void
  Restart(const std::string & change)
  {
    NoteChange(change);
    Note(SessionEvent::WalkChanged);
    coarse.reset();
    preview.values.clear();
    goal = std::max<std::uint64_t>(goal, 1);
  }

  std::uint64_t
  StepOfWalk() const
  {
    return state.walk == SessionState::Walk::Stale ? 0 : walk.GetMeasures().step;
  }

  bool
  IsHeat() const
  {
    return state.view == SessionState::View::Heat;
  }

  /** A command that shows one of the two quantities. */
  void
  Show(SessionEvent event)
  {
    const bool wasHeat = IsHeat();
    Note(event);
    if (IsHeat() != wasHeat)
    {
      ValuesHaveChanged();
    }
  }

  /** The voxels of the region that a command describes; null if there are none, or for "everywhere". */
  StartMask::Pointer
  RegionOf(const Json & command)
  {
    const std::string  kind = WordOf(command, "region");
    StartMask::Pointer region;
    if (kind == "balls")
    {
      RequireKeys(command, { "region", "balls" });
      region = MaskOfBalls(volume.image, BallsOf(command, "balls"));
    }
    else if (kind == "object")
    {
      RequireKeys(command, { "region", "point", "lower", "upper" });
      region = MaskOfObject(command);
    }
    else if (kind == "selected")
    {
      RequireKeys(command, { "region" });
      region = objects.GetMask();
      RequireParameter(region, "no object is selected");
    }
    else if (kind == "plane")
    {
      constexpr std::uint64_t lastAxis = 2;
      RequireKeys(command, { "region", "point", "axis" });
      itk::Index<3> voxel;
      RequireParameter(volume.image->TransformPhysicalPointToIndex(PointOf(command, "point"), voxel),
                       "the key \"point\" must be in the volume");
      region = MaskOfPlane(volume.image, voxel, static_cast<unsigned int>(CountOf(command, "axis", 0, lastAxis)));
    }
    else if (kind == "file")
    {
      RequireKeys(command, { "region", "name", "label" });
      region = MaskOfFile(command);
    }
    else
    {
      RequireParameter(kind == "everywhere",
                       "the key \"region\" must be everywhere, balls, object, selected, plane or file");
      RequireKeys(command, { "region" });
    }
    return region;
  }

  void
  SetRegion(const Json & command)
  {
    const std::string kind = WordOf(command, "region");
    const auto        region = RegionOf(command);
    RequireParameter(region || kind == "everywhere", "the start region contains no voxel of the volume");
    mask = region;
    maskName.clear();
    regionName = kind;
    Restart("start region: " + kind);
  }

  /** Adds a region to the barrier. Objects are found again if they had been found. */
  void
  Exclude(const Json & command)
  {
    const auto region = RegionOf(command);
    RequireParameter(region, "the barrier contains no voxel of the volume, or all");
    SessionValues values = Values();
    values.barrier = UnionOf(region, barrier);
    const unsigned char * const first = values.barrier->GetBufferPointer();
    values.barrierVoxels = std::accumulate(first, first + view.NumberOfVoxels(), std::uint64_t{ 0 });
    RequireParameter(values.barrierVoxels < view.NumberOfVoxels(), "the barrier contains all voxels of the volume");
    values.view = SessionState::View::Heat;
    const bool areObjectsWanted = objects.AreFound();
    Change(values, "exclude " + WordOf(command, "region"));
    if (areObjectsWanted)
    {
      Note(SessionEvent::ObjectsWanted);
    }
  }

  StartMask::Pointer
  MaskOfObject(const Json & command)
  {
    const auto    point = PointOf(command, "point");
    const double  lower = NumberOf(command, "lower", 0.0, 1.0);
    const double  upper = NumberOf(command, "upper", 0.0, 1.0);
    itk::Index<3> seed;
    RequireParameter(IsShowable() && volume.image->TransformPhysicalPointToIndex(point, seed),
                     "the key \"point\" must be in the volume");
    const ShownVolume values = Scene().Values(size);
    return MaskOfComponent(volume.image, seed, [&](std::size_t i) {
      const float value = values.GetValue(i % size[0], i / size[0] % size[1], i / (size[0] * size[1]));
      return value >= lower && value < upper;
    });
  }

  StartMask::Pointer
  MaskOfFile(const Json & command)
  {
    const std::string path = files.GetFolder().PathOf(WordOf(command, "name")).string();
    VolumeReadOptions reading;
    reading.allowSingleSlice = true;
    Volume labels = ReadVolume(path, reading);
    if (command.contains("label"))
    {
      constexpr std::uint64_t greatest = 65535;
      const auto              label = static_cast<float>(CountOf(command, "label", 1, greatest));
      float * const           begin = labels.image->GetBufferPointer();
      std::transform(begin, begin + labels.image->GetBufferedRegion().GetNumberOfPixels(), begin, [label](float value) {
        return value == label ? 1.0F : 0.0F;
      });
    }
    return MaskForImage(labels, path, volume.image);
  }

  Json
  Save(const Json & command)
  {
    RequireKeys(command, { "name", "labels", "lines", "objects", "selected" });
    SavedResult result;
    result.name = ResultNameOf(command, "name");
    for (const char * ending : { "-density.nrrd",
                                 "-heat.nrrd",
                                 "-labels.nrrd",
                                 "-objects.nrrd",
                                 "-objects.csv",
                                 "-object.nrrd",
                                 "-object.csv",
                                 ".json",
                                 ".vp",
                                 ".sh" })
    {
      files.GetFolder().PathOf(result.name + ending); // before anything is written
    }
    result.isHeat = IsHeat();
    result.wantLabels = FlagOf(command, "labels");
    if (command.contains("lines") && !command["lines"].empty())
    {
      result.lines = TransferFunctionOf(command["lines"], "the command");
    }
    const bool isFound = result.isHeat && objects.AreFound();
    if (FlagOf(command, "objects"))
    {
      RequireParameter(isFound, "no objects have been found yet; find them first");
      result.objects = objects.GetObjects();
    }
    if (FlagOf(command, "selected"))
    {
      result.selection = objects.GetSelection();
      RequireParameter(isFound && !result.selection.empty(), "no object is selected");
      result.offered = objects.GetList();
    }
    std::vector<std::string> names;
    if (result.isHeat)
    {
      RequireParameter(state.heat == SessionState::Heat::Exact, "the heat is not yet exact; wait until it is computed");
      result.timeStep = heatSteps;
      if (barrier && barrierName.empty())
      {
        barrierName = files.SaveMask(barrier, "barrier");
      }
      result.barrier = barrierName;
      names = files.Save(result, options, heat);
    }
    else
    {
      RequireParameter(state.walk == SessionState::Walk::Placed && walk.GetMeasures().step > 0,
                       "no voxel has been visited yet; move the shapetons first");
      if (mask && maskName.empty())
      {
        maskName = files.SaveMask(mask, "start");
      }
      result.mask = maskName;
      result.timeStep = walk.GetMeasures().step;
      names = files.Save(result, options, walk.GetVisits());
    }
    names.push_back(result.name + ".sh");
    files.SaveScript(names.back());
    return { { "done", "save" }, { "files", names } };
  }

  void
  Walk(const std::string & name, const Json & command)
  {
    constexpr std::uint64_t mostSteps = 1000000000;
    const std::uint64_t     step = StepOfWalk();
    RequireKeys(command, name == "step" ? std::vector<std::string>{ "steps" } : std::vector<std::string>());
    if (name == "step")
    {
      goal = step + CountOf(command, "steps", 1, mostSteps);
    }
    else if (name == "pause")
    {
      goal = state.walk == SessionState::Walk::Stale ? 1 : step;
    }
    else
    {
      goal = step < options.timeSteps ? options.timeSteps : step + options.timeSteps;
    }
    pieceStart = Clock::now();
    Note(SessionEvent::WalkMoved);
  }

  Json
  Do(const Json & command)
  {
    RequireParameter(command.is_object(), "a command must be an object");
    const std::string name = WordOf(command, "do");
    Json              answer = { { "done", name } };
    if (name == "pause" || name == "resume" || name == "step")
    {
      Walk(name, command);
    }
    else if (name == "speed")
    {
      constexpr double most = 1e6;
      RequireKeys(command, { "stepsPerSecond" });
      speed = NumberOf(command, "stepsPerSecond", 0.0, most);
      pieceStart = Clock::now();
    }
    else if (name == "set")
    {
      SessionValues values = Values();
      SetOptions(command, values.options);
      Change(values, "set");
    }
    else if (name == "undo" || name == "redo")
    {
      RequireKeys(command, {});
      Use(name == "undo" ? history.Undo(Values()) : history.Redo(Values()), name);
    }
    else if (name == "exclude")
    {
      Exclude(command);
    }
    else if (name == "start")
    {
      SetRegion(command);
    }
    else if (name == "density" || name == "heat")
    {
      ShowQuantity(name, command);
    }
    else if (name == "objects" || name == "select")
    {
      name == "objects" ? WantObjects(command) : Select(command);
      answer["objects"] = objects.List();
      answer["selected"] = GetSelected();
      answer["selection"] = objects.GetSelection();
    }
    else if (name == "save")
    {
      answer = Save(command);
    }
    else
    {
      throw ParameterError("unknown command \"" + name + "\"");
    }
    ++stateVersion;
    return answer;
  }

  void
  ShowQuantity(const std::string & name, const Json & command)
  {
    if (name == "density")
    {
      RequireKeys(command, {});
      Show(SessionEvent::DensityShown);
      return;
    }
    constexpr std::uint64_t mostSteps = 1000000000;
    RequireKeys(command, { "timeSteps" });
    const std::uint64_t steps = CountOf(command, "timeSteps", 1, mostSteps);
    if (steps == heatSteps)
    {
      Show(SessionEvent::HeatShown);
      return;
    }
    SessionValues values = Values();
    values.heatSteps = steps;
    values.view = SessionState::View::Heat;
    Change(values, name);
  }

  // ---- objects ----
  void
  WantObjects(const Json & command)
  {
    RequireKeys(command, { "choose" });
    if (FlagOf(command, "choose"))
    {
      history.Add(Values(), "");
      Show(SessionEvent::ChoiceWanted);
      return;
    }
    RequireParameter(IsHeat(), "objects are those of heat; show the heat first");
    if (!objects.AreFound())
    {
      Note(SessionEvent::ObjectsWanted);
    }
  }

  /** {"object": N}, with 0 for none, or {"point": [x, y, z]}. With "add", the object is added to the selected ones, or
   * removed if it is one of them; with "replace", it replaces the last one. */
  void
  Select(const Json & command)
  {
    RequireKeys(command, { "object", "point", "add", "replace" });
    const int        object = command.contains("point")
                                ? objects.ObjectAt(PointOf(command, "point"))
                                : static_cast<int>(CountOf(command, "object", 0, std::numeric_limits<unsigned short>::max()));
    std::vector<int> selection = objects.GetSelection();
    if (FlagOf(command, "replace") && !selection.empty())
    {
      selection.pop_back();
    }
    else if (!FlagOf(command, "add"))
    {
      selection.clear();
    }
    const auto others = std::remove(selection.begin(), selection.end(), object);
    const bool isRemoved = others != selection.end();
    selection.erase(others, selection.end());
    if (object > 0 && !isRemoved)
    {
      selection.push_back(object);
    }
    objects.Select(selection);
    files.Note("select: " + TextOfJson(objects.GetSelection()));
    ValuesHaveChanged();
  }

  /** The last selected object; 0 for none. */
  int
  GetSelected() const
  {
    return objects.GetSelection().empty() ? 0 : objects.GetSelection().back();
  }

  // ---- what is shown ----
  bool
  IsShowable() const
  {
    return IsHeat() ? state.heat != SessionState::Heat::None
                    : !preview.values.empty() || (state.walk == SessionState::Walk::Placed);
  }

  /** The displayed values, restricted to the selected object if there is one. */
  SessionScene
  Scene() const
  {
    SessionScene scene;
    scene.version = version;
    scene.step = IsHeat() ? heatSteps : walk.GetMeasures().step;
    scene.greatestVisits = GetGreatest();
    if (IsHeat())
    {
      scene.blocks = state.heat == SessionState::Heat::Coarse ? &blocks : nullptr;
      scene.labels = objects.AreFound() ? objects.GetList()->labels.GetPointer() : nullptr;
      scene.heat = objects.GetSelectedHeat() != nullptr ? objects.GetSelectedHeat() : heat.GetPointer();
    }
    else
    {
      scene.blocks = preview.values.empty() ? nullptr : &preview;
      scene.visits = walk.GetVisits();
    }
    return scene;
  }

  std::uint32_t
  GetGreatest() const
  {
    return std::max(1U, walk.GetMeasures().maximumVisits);
  }

  Json
  State() const
  {
    const ParticleMeasures & measures = walk.GetMeasures();
    const bool               isMoving = !IsHeat() && Next() != SessionWork::None;
    Json                     json;
    json["shown"] = IsHeat() ? "heat" : "density";
    json["quality"] = !IsShowable() ? "none" : Scene().blocks ? "coarse" : "exact";
    json["quantity"] = JsonOf(IsHeat() ? ShapeQuantity() : ShapeQuantity::Density(GetGreatest()));
    json["step"] = StepOfWalk();
    json["goal"] = goal;
    json["isMoving"] = isMoving;
    json["speed"] = speed;
    json["stepsPerSecond"] = RoundedJson(stepsPerSecond, 3);
    json["coverage"] = RoundedJson(measures.GetCoverage());
    json["trapped"] = measures.trappedShapetons;
    json["heatSteps"] = heatSteps;
    json["objects"] = objects.AreFound() ? Json(objects.GetNumber()) : Json();
    json["selected"] = GetSelected();
    json["selection"] = objects.GetSelection();
    json["region"] = regionName;
    json["changes"] = changes;
    json["lastChange"] = lastChange;
    json["undo"] = history.NumberToUndo();
    json["redo"] = history.NumberToRedo();
    json["options"] = JsonOfOptions(options);
    json["stage"] = stage;
    json["share"] = RoundedJson(share, 3);
    json["error"] = error;
    return json;
  }

  // ---- frames ----
  std::string
  Update(SessionViewer & viewer)
  {
    SessionFrame frame;
    frame.header["kind"] = "update";
    frame.header["state"] = State();
    viewer.stateVersion = stateVersion;
    if (IsShowable() && viewer.isWhole)
    {
      pictures.AddWhole(Scene(), viewer, frame);
    }
    else if (IsNewPicture(viewer))
    {
      pictures.AddParts(Scene(), viewer, frame);
    }
    if (IsShowable())
    {
      viewer.version = version;
    }
    viewer.isPlaceNew = viewer.isPlaceNew && !IsShowable() && !viewer.isWhole;
    if (viewer.isWhole)
    {
      pictures.AddObjects(objects, viewer, frame);
    }
    return frame.GetBytes();
  }

  bool
  IsNewPicture(const SessionViewer & viewer) const
  {
    return IsShowable() && (viewer.isPlaceNew || viewer.version != version);
  }

  std::string
  Draw(const Json & request)
  {
    RequireParameter(IsShowable(), "there is nothing to draw yet");
    return pictures.Draw(Scene(), request, options.device);
  }

  const Volume                     volume;
  ParticleDiffusionOptions         options;
  SessionFiles                     files;
  SessionWalk                      walk;
  const VolumeView                 view;
  const std::array<std::size_t, 3> size;
  SessionPictures                  pictures;

  SessionState state;
  SessionWork  current{ SessionWork::None };
  bool         isInterrupted{ false };
  std::string  error; ///< if the state has failed

  std::uint64_t      goal;         ///< the walk moves up to this step
  double             speed{ 0.0 }; ///< largest number of steps per second; 0: no limit
  double             stepsPerSecond{ 0.0 };
  Clock::time_point  pieceStart{ Clock::now() };
  StartMask::Pointer mask;
  std::string        maskName;
  std::string        regionName{ "everywhere" };

  std::optional<CoarseWalk> coarseWalk;
  BlockValues               preview; ///< of a walk that has not yet moved; empty for none

  std::uint64_t             heatSteps;
  std::optional<CoarseHeat> coarse;
  BlockValues               blocks;
  ImageType::Pointer        heat;
  SessionObjects            objects;
  StartMask::Pointer        barrier; ///< voxels that heat flows around; null for none
  std::uint64_t             barrierVoxels{ 0 };
  std::string               barrierName; ///< of its file; empty until it is saved

  SessionHistory                     history;
  std::string                        lastChange; ///< of values, as ChangesBetween() describes it
  std::optional<HeatParameterChoice> choice;

  std::string   stage; ///< of long work
  double        share{ 0.0 };
  std::uint64_t changes{ 0 };
  std::uint64_t version{ 1 };
  std::uint64_t stateVersion{ 1 };
};

LiveSession::LiveSession(Volume volume, const LiveSessionSettings & settings)
  : m_Impl(std::make_unique<Impl>(std::move(volume), settings))
{}

LiveSession::~LiveSession() = default;

Json
LiveSession::Do(const Json & command)
{
  return m_Impl->Do(command);
}

void
LiveSession::Interrupt()
{
  m_Impl->isInterrupted = true;
}

bool
LiveSession::Work(const Poll & poll)
{
  if (m_Impl->Next() != SessionWork::None)
  {
    m_Impl->Work(poll);
  }
  return m_Impl->Next() != SessionWork::None;
}

bool
LiveSession::IsComputingHeat() const
{
  return m_Impl->current == SessionWork::ChooseParameters || m_Impl->current == SessionWork::ComputeExactHeat ||
         m_Impl->current == SessionWork::FindObjects;
}

Json
LiveSession::GetInfo() const
{
  return m_Impl->pictures.Info();
}

Json
LiveSession::GetState() const
{
  return m_Impl->State();
}

bool
LiveSession::IsNewFor(const SessionViewer & viewer) const
{
  return viewer.stateVersion != m_Impl->stateVersion || m_Impl->IsNewPicture(viewer);
}

std::string
LiveSession::Update(SessionViewer & viewer)
{
  return m_Impl->Update(viewer);
}

std::string
LiveSession::Draw(const Json & request)
{
  return m_Impl->Draw(request);
}
} // namespace shapeton
