#ifndef shapetonHeatSnapshot_h
#define shapetonHeatSnapshot_h

#include "ShapetonHeatViewsExport.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** A heat volume on disk and its time step, if known.
 * \ingroup ShapetonHeatViews */
struct HeatSnapshot
{
  std::string                  path;
  std::optional<std::uint64_t> timeStep;
  /** The intensities mapped to 0 and 1; set by FindHeatWindows() only. */
  std::optional<std::array<double, 2>> intensityWindow{};
};

/** Finds a heat volume.
 *
 * `path` is a heat volume, or a folder of snapshots named heat-<time step, 9 digits>.nrrd. `timeStep` selects a
 * snapshot of a folder (by default the last one). For a single volume it must match the time step in the header (key
 * `timeStep`; NRRD and MetaImage), if there is one. Throws InputError for a missing path and for a folder without
 * snapshots, and ParameterError for a missing time step, listing the available ones. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatSnapshot
FindHeatSnapshot(const std::string & path, std::optional<std::uint64_t> timeStep = {});

/** A heat volume, or all snapshots of a folder by ascending time. Throws as FindHeatSnapshot().
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<HeatSnapshot>
                         FindHeatSnapshots(const std::string & path);

/** The heat volumes of a folder of windows, window-1.nrrd and so on, in this order; empty if `path` is not such a
 * folder. Time step and window are those of the headers (keys `timeStep`, `intensityWindow`). Throws InputError for a
 * header without a window.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<HeatSnapshot>
                         FindHeatWindows(const std::string & path);

/** The name of a window in its folder: "window-1.nrrd" for the first one. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::string
                         HeatWindowName(std::size_t number);

/** The name of a snapshot in its folder: "heat-000001000.nrrd" for time step 1000.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::string
                         HeatSnapshotName(std::uint64_t timeStep);

/** Throws InputError with `path` if a value is outside [0, 1] (tolerance 1e-4): such a volume is not a heat volume.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT void
RequireHeat(const itk::Image<float, 3> * heat, const std::string & path);

/** Shapeton visits of a volume: integers, some above 1. The file header must state the time step, so other volumes are
 * not mistaken for visits. Null for any other volume. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT itk::Image<std::uint32_t, 3>::Pointer
                         VisitsOf(const itk::Image<float, 3> * values, const HeatSnapshot & file);
} // namespace shapeton

#endif
