#include "shapetonLiveSession.h"

#include "shapetonColorMap.h"
#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonInterruption.h"
#include "shapetonObjectParameters.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonSessionCommands.h"
#include "shapetonSessionFiles.h"
#include "shapetonSessionFrames.h"
#include "shapetonSessionObjects.h"
#include "shapetonSessionWalk.h"
#include "shapetonShownVolume.h"
#include "shapetonVisitDensity.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeRendering.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string_view>
#include <thread>

namespace shapeton
{
namespace
{
using ImageType = itk::Image<float, 3>;
using Clock = std::chrono::steady_clock;

/** Voxels of the reduced volume that the page renders: 4 MB of bins, 10 times a second over a local connection. */
constexpr std::size_t greatestReduced = std::size_t{ 1 } << 21;
/** Edge length of a brick in voxels of the reduced volume. */
constexpr std::size_t brickLength = 32;
/** Duration of a piece of the walk; commands wait for its end. */
constexpr double secondsOfPiece = 0.03;
/** The histogram and its lines take a pass over all voxels, so they are renewed less often than the picture. */
constexpr double secondsBetweenHistograms = 1.0;

/** Clears a flag at the end of its scope. */
struct Reset
{
  ~Reset() { flag = false; }
  bool & flag;
};

/** Work was left because a command has arrived. */
struct Interrupted
{};

double
SecondsSince(const Clock::time_point & start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t
StrideFor(const std::array<std::size_t, 3> & size)
{
  std::size_t stride = 1;
  for (auto reduced = size; reduced[0] * reduced[1] * reduced[2] > greatestReduced;)
  {
    reduced = ReducedSize(size, ++stride);
  }
  return stride;
}

/** An image of blocks in the place of the image they were averaged from. */
ImageType::Pointer
ImageOfBlocks(const BlockValues & blocks, const ImageType * original)
{
  auto                image = ImageType::New();
  ImageType::SizeType size;
  auto                spacing = original->GetSpacing();
  std::copy(blocks.size.begin(), blocks.size.end(), size.begin());
  itk::ContinuousIndex<double, 3> middle;
  middle.Fill((static_cast<double>(blocks.factor) - 1.0) / 2.0);
  ImageType::PointType origin;
  original->TransformContinuousIndexToPhysicalPoint(middle, origin);
  spacing *= static_cast<double>(blocks.factor);
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(original->GetDirection());
  image->Allocate();
  std::copy(blocks.values.begin(), blocks.values.end(), image->GetBufferPointer());
  return image;
}
} // namespace

struct LiveSession::Impl
{
  enum class Shown
  {
    Density,
    Heat
  };
  /** The shown heat. */
  enum class HeatState
  {
    None,
    Coarse,
    Exact
  };

  Impl(Volume given, const LiveSessionSettings & settings)
    : volume(std::move(given))
    , options(settings.walk)
    , files(volume, settings)
    , walk(volume.image)
    , view(volume.image.GetPointer())
    , size(view.size)
    , stride(StrideFor(size))
    , gray(WindowOf(volume.image, IntensityWindow()))
    , goal(settings.walk.timeSteps)
    , heatSteps(settings.walk.timeSteps)
  {
    const auto window = WindowOf(options, view);
    if (window[0] < window[1])
    {
      options.intensityWindow = window; // the saved script names all values
    }
    files.Note("start: " + TextOfJson(JsonOfOptions(options)));
  }

  // ---- work ----
  bool
  IsWorkLeft() const
  {
    return error.empty() && (shown == Shown::Heat ? heatState != HeatState::Exact || areObjectsWanted
                                                  : isStale || walk.IsParked() || walk.GetMeasures().step < goal);
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
      if (isInterrupted && !isStepping)
      {
        throw Interrupted();
      }
    };
    const Interruption interruption(check);
    try
    {
      shown == Shown::Heat ? WorkOnHeat() : WorkOnWalk();
    }
    catch (const Interrupted &)
    {}
    catch (const std::domain_error & failure) // no voxel to start from
    {
      error = failure.what();
    }
    catch (const std::overflow_error & failure) // too many visits of a voxel
    {
      error = failure.what();
    }
    catch (const InputError & failure) // no object can be found
    {
      error = failure.what();
      CancelObjects();
    }
    catch (const std::bad_alloc &)
    {
      error = "not enough memory; use fewer shapetons";
    }
    stage.clear();
    ++stateVersion;
  }

  void
  PlaceIfStale()
  {
    if (isStale)
    {
      DropHeat();
      walk.Place(options, mask, [] { Interruption::Check(); });
      isStale = false;
      pieceStart = Clock::now();
      isHistogramOld = true;
      ++version;
    }
    walk.Resume([] { Interruption::Check(); });
  }

  /** A large volume takes some time until its shapetons move; a coarse picture comes first. */
  bool
  IsPreviewNeeded() const
  {
    return isStale && preview.values.empty() && size[0] * size[1] * size[2] > greatestReduced;
  }

  void
  ShowPreview()
  {
    if (!coarseWalk)
    {
      coarseWalk.emplace(view);
    }
    preview = coarseWalk->Start(options, mask);
    isHistogramOld = true;
    ++version;
  }

  void
  WorkOnWalk()
  {
    if (IsPreviewNeeded())
    {
      ShowPreview();
      return;
    }
    PlaceIfStale();
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
    isStepping = true; // an interrupted step would leave some shapetons behind
    const Reset reset{ isStepping };
    walk.Advance(steps);
    preview.values.clear();
    const double seconds = std::max(SecondsSince(start), 1e-6);
    stepsPerSecond = static_cast<double>(steps) / seconds;
    pieceStart = Clock::now();
    ++version;
    isHistogramOld =
      isHistogramOld || SecondsSince(histogramTime) > secondsBetweenHistograms || walk.GetMeasures().step == goal;
  }

  /** Steps until the next command is read; 0 if the limited speed allows none yet. */
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

  void
  WorkOnHeat()
  {
    if (isChoiceWanted)
    {
      ChooseParameters();
      return;
    }
    if (heatState == HeatState::Exact)
    {
      isComputingHeat = true;
      const Reset reset{ isComputingHeat };
      Tell("objects", 0.0);
      objects.Find(files.AsWritten(heat), [this](double part) { Tell("objects", part); });
      areObjectsWanted = false;
      return;
    }
    if (heatState == HeatState::None)
    {
      Tell("coarse heat", 0.0);
      if (!coarse)
      {
        coarse.emplace(view, HeatSettings());
      }
      blocks = coarse->After(heatSteps);
      heatState = HeatState::Coarse;
    }
    else
    {
      walk.Park();
      auto exact = ImageType::New();
      exact->CopyInformation(volume.image);
      exact->SetRegions(volume.image->GetBufferedRegion());
      exact->Allocate();
      Tell("heat", 0.0);
      isComputingHeat = true;
      const Reset reset{ isComputingHeat };
      DiffuseCumulativeHeat(
        view, HeatSettings(), exact->GetBufferPointer(), nullptr, {}, [this](double part) { Tell("heat", part); });
      heat = exact;
      heatState = HeatState::Exact;
    }
    isHistogramOld = true;
    ++version;
  }

  /** Sets window, p, smoothing and time such that objects separate. */
  void
  ChooseParameters()
  {
    walk.Park();
    Tell("choosing parameters", 0.0);
    isComputingHeat = true;
    const Reset reset{ isComputingHeat };
    auto        settings = HeatSettings();
    settings.intensityWindow.reset();
    const auto choice =
      ChooseObjectParameters(view, settings, {}, [this](double part) { Tell("choosing parameters", part); });
    isChoiceWanted = false;
    options.intensityWindow = choice.intensityWindow;
    options.p = choice.p;
    options.smoothing = choice.smoothing;
    heatSteps = choice.timeSteps;
    Restart("options for objects: " + TextOfJson(JsonOfOptions(options)));
    areObjectsWanted = true;
    files.Note("heat after " + std::to_string(heatSteps) + " time steps");
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
  /** A change of the diffusion: everything is computed again. */
  void
  Restart(const std::string & change)
  {
    files.Note("step " + std::to_string(isStale ? 0 : walk.GetMeasures().step) + ": " + change);
    ++changes;
    isStale = true;
    error.clear();
    coarse.reset();
    preview.values.clear();
    DropHeat();
    goal = std::max<std::uint64_t>(goal, 1);
  }

  void
  DropHeat()
  {
    heat = nullptr;
    heatState = HeatState::None;
    CancelObjects();
    objects.Clear();
  }

  /** A change made after objects were asked for wins. */
  void
  CancelObjects()
  {
    isChoiceWanted = areObjectsWanted = false;
  }

  void
  Show(Shown what)
  {
    if (shown != what)
    {
      shown = what;
      error.clear();
      isHistogramOld = true;
      ++version;
    }
  }

  void
  SetRegion(const Json & command)
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
    else if (kind == "file")
    {
      RequireKeys(command, { "region", "name", "label" });
      region = MaskOfFile(command);
    }
    else
    {
      RequireParameter(kind == "everywhere", "the key \"region\" must be everywhere, balls, object, selected or file");
      RequireKeys(command, { "region" });
    }
    RequireParameter(region || kind == "everywhere", "the start region contains no voxel of the volume");
    mask = region;
    maskName.clear();
    regionName = kind;
    Restart("start region: " + kind);
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
    const ShownVolume values = GetShown();
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
    RequireKeys(command, { "name", "labels", "lines", "objects" });
    SavedResult result;
    result.name = ResultNameOf(command, "name");
    for (const char * ending :
         { "-density.nrrd", "-heat.nrrd", "-labels.nrrd", "-objects.nrrd", "-objects.csv", ".json", ".vp", ".sh" })
    {
      files.GetFolder().PathOf(result.name + ending); // before anything is written
    }
    result.isHeat = shown == Shown::Heat;
    result.wantLabels = FlagOf(command, "labels");
    if (command.contains("lines") && !command["lines"].empty())
    {
      result.lines = TransferFunctionOf(command["lines"], "the command");
    }
    if (FlagOf(command, "objects"))
    {
      result.objects = objects.GetList();
      RequireParameter(result.isHeat && result.objects, "no objects have been found yet; find them first");
    }
    std::vector<std::string> names;
    if (result.isHeat)
    {
      RequireParameter(heatState == HeatState::Exact, "the heat is not yet exact; wait until it is computed");
      result.timeStep = heatSteps;
      names = files.Save(result, options, heat);
    }
    else
    {
      RequireParameter(!isStale && !walk.IsParked() && walk.GetMeasures().step > 0,
                       "no voxel has been visited yet; move the shapetons first");
      if (mask && maskName.empty())
      {
        maskName = files.SaveMask(mask);
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
    const std::uint64_t     step = isStale ? 0 : walk.GetMeasures().step;
    RequireKeys(command, name == "step" ? std::vector<std::string>{ "steps" } : std::vector<std::string>());
    if (name == "step")
    {
      goal = step + CountOf(command, "steps", 1, mostSteps);
    }
    else if (name == "pause")
    {
      goal = isStale ? 1 : step;
    }
    else
    {
      goal = step < options.timeSteps ? options.timeSteps : step + options.timeSteps;
    }
    pieceStart = Clock::now();
    error.clear();
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
      Restart(SetOptions(command, options));
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
      answer["selected"] = objects.GetSelected();
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
      CancelObjects();
      Show(Shown::Density);
      return;
    }
    constexpr std::uint64_t mostSteps = 1000000000;
    RequireKeys(command, { "timeSteps" });
    const std::uint64_t steps = CountOf(command, "timeSteps", 1, mostSteps);
    CancelObjects();
    if (steps != heatSteps || heatState == HeatState::None)
    {
      heatSteps = steps;
      error.clear();
      DropHeat();
      files.Note("heat after " + std::to_string(steps) + " time steps");
      ++changes;
    }
    Show(Shown::Heat);
  }

  // ---- objects ----
  void
  WantObjects(const Json & command)
  {
    RequireKeys(command, { "choose" });
    if (FlagOf(command, "choose"))
    {
      isChoiceWanted = true;
      Show(Shown::Heat);
    }
    RequireParameter(shown == Shown::Heat, "objects are those of heat; show the heat first");
    areObjectsWanted = isChoiceWanted || !objects.AreFound();
    error.clear();
  }

  /** {"object": N}, with 0 for none, or {"point": [x, y, z]}. */
  void
  Select(const Json & command)
  {
    RequireKeys(command, { "object", "point" });
    if (command.contains("point"))
    {
      objects.Select(objects.ObjectAt(PointOf(command, "point")));
    }
    else if (const auto object = CountOf(command, "object", 0, std::numeric_limits<unsigned short>::max()))
    {
      objects.Select(static_cast<int>(object));
    }
    else
    {
      objects.Deselect();
    }
    isHistogramOld = true;
    ++version;
  }

  /** The exact heat, in the selected object only if there is one. */
  ImageType::Pointer
  GetShownHeat() const
  {
    return objects.GetSelectedHeat() != nullptr ? ImageType::Pointer(objects.GetSelectedHeat()) : heat;
  }

  // ---- what is shown ----
  bool
  IsShowable() const
  {
    return shown == Shown::Heat ? heatState != HeatState::None
                                : !preview.values.empty() || (!isStale && !walk.IsParked() && walk.IsPlaced());
  }

  /** The blocks, if a coarse picture is shown, otherwise null. */
  const BlockValues *
  GetBlocks() const
  {
    const bool isHeat = shown == Shown::Heat;
    return isHeat && heatState == HeatState::Coarse ? &blocks : !isHeat && !preview.values.empty() ? &preview : nullptr;
  }

  ShownVolume
  GetShown() const
  {
    return GetBlocks()            ? ShownVolume(size, *GetBlocks())
           : shown == Shown::Heat ? ShownVolume(size, GetShownHeat()->GetBufferPointer())
                                  : ShownVolume(size, walk.GetVisits()->GetBufferPointer(), GetGreatest());
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
    const bool               isHeat = shown == Shown::Heat;
    const bool               isMoving = !isHeat && IsWorkLeft();
    Json                     state;
    state["shown"] = isHeat ? "heat" : "density";
    state["quality"] = !IsShowable() ? "none" : GetBlocks() ? "coarse" : "exact";
    state["quantity"] = JsonOf(isHeat ? ShapeQuantity() : ShapeQuantity::Density(GetGreatest()));
    state["step"] = isStale ? 0 : measures.step;
    state["goal"] = goal;
    state["isMoving"] = isMoving;
    state["speed"] = speed;
    state["stepsPerSecond"] = RoundedJson(stepsPerSecond, 3);
    state["coverage"] = RoundedJson(measures.GetCoverage());
    state["trapped"] = measures.trappedShapetons;
    state["heatSteps"] = heatSteps;
    state["objects"] = objects.AreFound() ? Json(objects.GetNumber()) : Json();
    state["selected"] = objects.GetSelected();
    state["region"] = regionName;
    state["changes"] = changes;
    state["options"] = JsonOfOptions(options);
    state["stage"] = stage;
    state["share"] = RoundedJson(share, 3);
    state["error"] = error;
    return state;
  }

  // ---- frames ----
  void
  AddSlices(SessionViewer & viewer, SessionFrame & frame) const
  {
    const ShownVolume values = GetShown();
    frame.header["slices"] = Json::array();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const std::size_t at = std::min(viewer.place[axis], size[axis] - 1);
      const HeatBins    bins = values.Slice(axis, at);
      const bool        isGrayNew = viewer.slices[axis] != static_cast<std::int64_t>(at);
      frame.header["slices"].push_back({ { "axis", axis }, { "index", at }, { "hasGray", isGrayNew } });
      frame.Add(bins.data(), bins.size());
      if (isGrayNew)
      {
        const auto grays = GraySlice(axis, at);
        frame.Add(grays.data(), grays.size());
        viewer.slices[axis] = static_cast<std::int64_t>(at);
      }
    }
  }

  std::vector<std::uint8_t>
  GraySlice(unsigned int axis, std::size_t at) const
  {
    constexpr double           white = 255.0;
    const unsigned int         across = axis == 0 ? 1 : 0;
    const unsigned int         down = axis == 2 ? 1 : 2;
    const float * const        intensities = volume.image->GetBufferPointer();
    std::vector<std::uint8_t>  grays;
    std::array<std::size_t, 3> index{};
    index[axis] = at;
    grays.reserve(size[across] * size[down]);
    for (index[down] = 0; index[down] < size[down]; ++index[down])
    {
      for (index[across] = 0; index[across] < size[across]; ++index[across])
      {
        const double intensity = intensities[(index[2] * size[1] + index[1]) * size[0] + index[0]];
        const double part = std::clamp((intensity - gray.lower) / (gray.upper - gray.lower), 0.0, 1.0);
        grays.push_back(static_cast<std::uint8_t>(std::lround(white * part)));
      }
    }
    return grays;
  }

  const HeatBins &
  ReducedBins()
  {
    if (reducedVersion != version)
    {
      reduced = GetShown().Reduced(stride);
      reducedVersion = version;
    }
    return reduced;
  }

  /** The bricks that have changed, with the checksums that the viewer has. */
  void
  AddBricks(SessionViewer & viewer, SessionFrame & frame)
  {
    const HeatBins &           bins = ReducedBins();
    const auto                 grid = ReducedSize(size, stride);
    const auto                 bricks = ReducedSize(grid, brickLength);
    std::vector<std::uint16_t> brick;
    viewer.bricks.resize(bricks[0] * bricks[1] * bricks[2], 0);
    frame.header["bricks"] = Json::array();
    for (std::size_t b = 0; b < viewer.bricks.size(); ++b)
    {
      const std::array<std::size_t, 3> first{ b % bricks[0] * brickLength,
                                              b / bricks[0] % bricks[1] * brickLength,
                                              b / (bricks[0] * bricks[1]) * brickLength };
      const std::size_t                width = std::min(brickLength, grid[0] - first[0]);
      brick.clear();
      for (std::size_t z = first[2]; z < std::min(first[2] + brickLength, grid[2]); ++z)
      {
        for (std::size_t y = first[1]; y < std::min(first[1] + brickLength, grid[1]); ++y)
        {
          const std::uint16_t * const row = bins.data() + (z * grid[1] + y) * grid[0] + first[0];
          brick.insert(brick.end(), row, row + width);
        }
      }
      const std::string_view bytes(reinterpret_cast<const char *>(brick.data()), brick.size() * sizeof(brick[0]));
      const std::size_t      checksum = std::hash<std::string_view>()(bytes) | 1; // 0 stands for none
      if (checksum != viewer.bricks[b])
      {
        viewer.bricks[b] = checksum;
        frame.header["bricks"].push_back(first);
        frame.Add(brick.data(), brick.size());
      }
    }
  }

  void
  RenewHistogram()
  {
    if (!isHistogramOld)
    {
      return;
    }
    isHistogramOld = false;
    histogramTime = Clock::now();
    ++histogramVersion;
    const std::uint64_t    step = shown == Shown::Heat ? heatSteps : walk.GetMeasures().step;
    std::vector<HeatClass> classes;
    histogram = HeatHistogram({ step });
    if (shown == Shown::Density && !GetBlocks())
    {
      AddVisitsToRow(walk.GetVisits(), 0, histogram);
      classes = FindVisitClasses(histogram, 0, GetGreatest());
      axis = BalanceClasses(histogram, 0, classes);
    }
    else
    {
      const float * const values = GetBlocks() ? GetBlocks()->values.data() : GetShownHeat()->GetBufferPointer();
      histogram.AddToRow(0, values, GetBlocks() ? GetBlocks()->values.size() : size[0] * size[1] * size[2]);
      classes = FindHeatClasses(histogram, 0);
      axis = histogram;
    }
    lines = JsonOf(ShapeTransferFunction::FromClasses(classes, HeatAxis(axis)));
  }

  void
  AddHistogram(SessionViewer & viewer, SessionFrame & frame)
  {
    RenewHistogram();
    if (viewer.histogram != histogramVersion)
    {
      viewer.histogram = histogramVersion;
      frame.header["histogram"] = { { "step", histogram.GetTimeSteps()[0] }, { "lines", lines } };
      frame.Add(histogram.GetRow(0), HeatHistogram::NumberOfBins);
      frame.Add(axis.GetRow(0), HeatHistogram::NumberOfBins);
    }
  }

  Json
  Info() const
  {
    HeatExplorerContent content;
    content.title = "Shapeton session";
    content.gray = volume.image;
    content.window = gray;
    Json info = InfoOf(content, std::numeric_limits<std::size_t>::max());
    info["stride"] = stride;
    info["brickLength"] = brickLength;
    return info;
  }

  /** All values, and the labels of the objects if they have changed. */
  void
  AddWhole(SessionViewer & viewer, SessionFrame & frame) const
  {
    if (IsShowable() && viewer.version != version)
    {
      frame.header["volume"] = Info()["volume"];
      const auto values = GetShown().Values();
      frame.Add(values.data(), values.size());
      viewer.version = version;
    }
    viewer.isPlaceNew = false;
    if (objects.AreFound() && viewer.objects != objects.GetVersion())
    {
      frame.header["objects"] = objects.List();
      frame.Add(objects.GetList()->labels->GetBufferPointer(), size[0] * size[1] * size[2]);
      viewer.objects = objects.GetVersion();
    }
  }

  std::string
  Update(SessionViewer & viewer)
  {
    SessionFrame frame;
    frame.header["kind"] = "update";
    frame.header["state"] = State();
    viewer.stateVersion = stateVersion;
    if (viewer.isWhole)
    {
      AddWhole(viewer, frame);
    }
    else if (IsShowable() && (viewer.version != version || viewer.isPlaceNew))
    {
      AddSlices(viewer, frame);
      if (viewer.version != version)
      {
        AddBricks(viewer, frame);
        AddHistogram(viewer, frame);
      }
      viewer.version = version;
      viewer.isPlaceNew = false;
    }
    return frame.GetBytes();
  }

  std::string
  Draw(const Json & request)
  {
    constexpr double least = 16.0, most = 2048.0; // pixels
    constexpr double farthest = 1e6, leastZoom = 0.1, mostZoom = 100.0;
    constexpr double half = 90.0, whole = 360.0; // degrees
    RequireKeys(request, { "azimuth", "elevation", "zoom", "width", "height", "quality", "lines" });
    VolumeRenderingOptions view;
    view.azimuth = std::remainder(NumberOf(request, "azimuth", -farthest, farthest), whole);
    view.elevation = NumberOf(request, "elevation", -half, half);
    view.zoom = NumberOf(request, "zoom", leastZoom, mostZoom);
    view.width = static_cast<unsigned int>(NumberOf(request, "width", least, most));
    view.height = static_cast<unsigned int>(NumberOf(request, "height", least, most));
    const int quality = static_cast<int>(CountOf(request, "quality", 1, 100));
    RequireParameter(request.contains("lines"), "the command lacks the key \"lines\"");
    RequireParameter(IsShowable(), "there is nothing to draw yet");
    const auto transferFunction = TransferFunctionOf(request["lines"], "the command");
    if (!renderer || rendererVersion != version || rendererLines != transferFunction.ToText())
    {
      renderer = std::make_unique<VolumeRenderer>(ShownImage(), transferFunction, options.device);
      rendererVersion = version;
      rendererLines = transferFunction.ToText();
    }
    const std::string jpeg = EncodeJpeg(renderer->Render(view), quality);
    SessionFrame      frame;
    frame.header = { { "kind", "picture" }, { "bytes", jpeg.size() }, { "device", renderer->GetDeviceUse().device } };
    frame.Add(jpeg.data(), jpeg.size());
    return frame.GetBytes();
  }

  ImageType::Pointer
  ShownImage() const
  {
    return GetBlocks()            ? ImageOfBlocks(*GetBlocks(), volume.image)
           : shown == Shown::Heat ? GetShownHeat()
                                  : NormalizeVisits(walk.GetVisits());
  }

  const Volume                     volume;
  ParticleDiffusionOptions         options;
  SessionFiles                     files;
  SessionWalk                      walk;
  const VolumeView                 view;
  const std::array<std::size_t, 3> size;
  const std::size_t                stride;
  const IntensityWindow            gray;

  Shown              shown{ Shown::Density };
  bool               isStale{ true }; ///< the walk must start again
  std::uint64_t      goal;            ///< the walk moves up to this step
  double             speed{ 0.0 };    ///< largest number of steps per second; 0: no limit
  double             stepsPerSecond{ 0.0 };
  Clock::time_point  pieceStart{ Clock::now() };
  StartMask::Pointer mask;
  std::string        maskName;
  std::string        regionName{ "everywhere" };

  std::optional<CoarseWalk> coarseWalk;
  BlockValues               preview; ///< of a walk that has not yet moved; empty for none

  std::uint64_t             heatSteps;
  HeatState                 heatState{ HeatState::None };
  std::optional<CoarseHeat> coarse;
  BlockValues               blocks;
  ImageType::Pointer        heat;
  bool                      isComputingHeat{ false };
  bool                      isChoiceWanted{ false };
  bool                      areObjectsWanted{ false };
  SessionObjects            objects;

  bool          isInterrupted{ false };
  bool          isStepping{ false };
  std::string   stage; ///< of long work
  double        share{ 0.0 };
  std::string   error;
  std::uint64_t changes{ 0 };
  std::uint64_t version{ 1 };
  std::uint64_t stateVersion{ 1 };

  HeatBins          reduced;
  std::uint64_t     reducedVersion{ 0 };
  bool              isHistogramOld{ true };
  Clock::time_point histogramTime{};
  std::uint64_t     histogramVersion{ 0 };
  HeatHistogram     histogram;
  HeatHistogram     axis;
  Json              lines = Json::array();

  std::unique_ptr<VolumeRenderer> renderer;
  std::uint64_t                   rendererVersion{ 0 };
  std::string                     rendererLines;
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
  if (m_Impl->IsWorkLeft())
  {
    m_Impl->Work(poll);
  }
  return m_Impl->IsWorkLeft();
}

bool
LiveSession::IsComputingHeat() const
{
  return m_Impl->isComputingHeat;
}

Json
LiveSession::GetInfo() const
{
  return m_Impl->Info();
}

Json
LiveSession::GetState() const
{
  return m_Impl->State();
}

bool
LiveSession::IsNewFor(const SessionViewer & viewer) const
{
  const bool isPictureNew = viewer.isPlaceNew || viewer.version != m_Impl->version;
  return viewer.stateVersion != m_Impl->stateVersion || (isPictureNew && m_Impl->IsShowable());
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
