#ifndef shapetonDeviceHeatEngine_h
#define shapetonDeviceHeatEngine_h

#include "shapetonHeatEngine.h"
#include "shapetonHeatSnapshots.h"
#include "shapetonPaddedGrid.h"

namespace shapeton
{
/** A volume, or some slices of one, as the plug-in for GPUs sees it: see VolumeGradientOperator. */
struct DeviceHeatVolume
{
  PaddedGrid                   grid;
  std::array<const float *, 3> conductances;
};

/** \class DeviceHeatEngine
 * \brief An engine whose fields stay in the memory of a GPU. */
class DeviceHeatEngine : public HeatEngine
{
public:
  /** `values`: a field on the padded grid. */
  virtual void
  Upload(Field field, const float * values) = 0;
  /** `number` slices from `first` on, with the layer around each; `values` is the begin of the field on the host. */
  virtual void
  Download(Field field, float * values, std::size_t first, std::size_t number) = 0;
};

/** The type of the plug-in's function ShapetonMakeHeatEngine(). The engine takes the heat from `heat` and gives it back
 * there by Finish(); without it, or without snapshots, fields are exchanged by hand and nothing is shown. */
using MakeDeviceHeatEngineFunction = DeviceHeatEngine *(const DeviceHeatVolume & volume,
                                                        float *                  heat,
                                                        HeatSnapshots *          snapshots);
} // namespace shapeton

#endif
