#ifndef shapetonHeatEngineOnGpu_h
#define shapetonHeatEngineOnGpu_h

#include "shapetonDevice.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatEngine.h"

#include <functional>
#include <memory>

namespace shapeton
{
/** Whether the fields of a volume have room on a GPU; where it is asked for, whether those of some slices have. */
DeviceUse
ChooseDeviceForHeat(Device wanted, const PaddedGrid & grid);

/** An engine on the GPU that was chosen: with all fields there, or, where they have no room, with the fields in the
 * memory of the host and slabs of them on the GPU. Arguments as of HeatEngineOnCpu. */
std::unique_ptr<HeatEngine>
MakeHeatEngineOnGpu(const DeviceUse &              use,
                    const VolumeGradientOperator & volumeGradient,
                    PaddedField &                  heat,
                    HeatSnapshots &                snapshots,
                    const std::function<void()> &  allocated);
} // namespace shapeton

#endif
