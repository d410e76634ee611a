#ifndef shapetonHeatEngineOnGpu_h
#define shapetonHeatEngineOnGpu_h

#include "shapetonDevice.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatEngine.h"

#include <functional>
#include <memory>

namespace shapeton
{
/** Whether the fields of a volume fit on a GPU; for a requested GPU, whether the fields of a slab fit. */
DeviceUse
ChooseDeviceForHeat(Device wanted, const PaddedGrid & grid);

/** Creates an engine on the chosen GPU with all fields in GPU memory or, if they do not fit, with fields in host memory
 * and slabs on the GPU. Arguments as for HeatEngineOnCpu. */
std::unique_ptr<HeatEngine>
MakeHeatEngineOnGpu(const DeviceUse &              use,
                    const VolumeGradientOperator & volumeGradient,
                    PaddedField &                  heat,
                    HeatSnapshots &                snapshots,
                    const std::function<void()> &  allocated);
} // namespace shapeton

#endif
