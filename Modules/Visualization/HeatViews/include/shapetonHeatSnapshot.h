#ifndef shapetonHeatSnapshot_h
#define shapetonHeatSnapshot_h

#include "ShapetonHeatViewsExport.h"

#include "itkImage.h"

#include <cstdint>
#include <optional>
#include <string>

namespace shapeton
{
/** A heat volume on disk and its time step, if known.
 * \ingroup ShapetonHeatViews */
struct HeatSnapshot
{
  std::string                  path;
  std::optional<std::uint64_t> timeStep;
};

/** Finds a heat volume.
 *
 * `path` is a heat volume, or a folder of snapshots named heat-<time step, 9 digits>.nrrd. `timeStep` selects a
 * snapshot of a folder (by default the last one). For a single volume it must match the time step in the header (key
 * `timeStep`; NRRD and MetaImage), if there is one. Throws InputError for a missing path and for a folder without
 * snapshots, and ParameterError for a missing time step, listing the available ones. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatSnapshot
FindHeatSnapshot(const std::string & path, std::optional<std::uint64_t> timeStep = {});

/** The name of a snapshot in its folder: "heat-000001000.nrrd" for time step 1000.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::string
                         HeatSnapshotName(std::uint64_t timeStep);

/** Shapeton visits of a volume: integers, some above 1. The file header must state the time step, so other volumes are
 * not mistaken for visits. Null for any other volume. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT itk::Image<std::uint32_t, 3>::Pointer
                         VisitsOf(const itk::Image<float, 3> * values, const HeatSnapshot & file);
} // namespace shapeton

#endif
