#ifndef shapetonHeatSnapshot_h
#define shapetonHeatSnapshot_h

#include "HeatViewsExport.h"

#include "itkImage.h"

#include <cstdint>
#include <optional>
#include <string>

namespace shapeton
{
/** A heat volume on disk and the time step that it shows, where that is known.
 * \ingroup HeatViews */
struct HeatSnapshot
{
  std::string                  path;
  std::optional<std::uint64_t> timeStep;
};

/** Finds a heat volume.
 *
 * `path` is a heat volume, or a folder of snapshots named heat-<time step, 9 digits>.nrrd. `timeStep` picks a snapshot
 * of a folder (by default the last one); of a single volume, it must agree with the time step in its header (key
 * `timeStep`; NRRD and MetaImage), where there is one. Throws InputError for a path that is missing and for a folder
 * without snapshots, and ParameterError for a time step that is not there, with those that are. \ingroup HeatViews */
HeatViews_EXPORT HeatSnapshot
FindHeatSnapshot(const std::string & path, std::optional<std::uint64_t> timeStep = {});

/** The name of a snapshot in its folder: "heat-000001000.nrrd" for time step 1000.
 * \ingroup HeatViews */
HeatViews_EXPORT std::string
                 HeatSnapshotName(std::uint64_t timeStep);

/** Throws InputError, which names `path`, when a value is not in [0, 1] (within 1e-4): such a volume is no heat.
 * \ingroup HeatViews */
HeatViews_EXPORT void
RequireHeat(const itk::Image<float, 3> * heat, const std::string & path);

/** The visits of shapetons that a volume holds: whole numbers, some above 1, in a file whose header states their time
 * step (so that no other volume is taken for visits). Null for any other volume. \ingroup HeatViews */
HeatViews_EXPORT itk::Image<std::uint32_t, 3>::Pointer
                 VisitsOf(const itk::Image<float, 3> * values, const HeatSnapshot & file);
} // namespace shapeton

#endif
