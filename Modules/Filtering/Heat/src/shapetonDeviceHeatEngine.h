#ifndef shapetonDeviceHeatEngine_h
#define shapetonDeviceHeatEngine_h

#include "shapetonHeatEngine.h"
#include "shapetonHeatSnapshots.h"
#include "shapetonPaddedGrid.h"

namespace shapeton
{
/** A volume, or a range of slices, as passed to the GPU plug-in; see VolumeGradientOperator. */
struct DeviceHeatVolume
{
  PaddedGrid                   grid;
  std::array<const float *, 3> conductances;
};

/** \class DeviceHeatEngine
 * \brief A heat engine with fields in GPU memory. */
class DeviceHeatEngine : public HeatEngine
{
public:
  /** `values`: a field on the padded grid. */
  virtual void
  Upload(Field field, const float * values) = 0;
  /** `number` slices, starting with `first`, with the border around each; `values` is the start of the field on the
   * host. */
  virtual void
  Download(Field field, float * values, std::size_t first, std::size_t number) = 0;
};

/** Type of the plug-in's function ShapetonMakeHeatEngine(). The engine reads the heat from `heat` and writes it back
 * in Finish(). Without `heat`, or without snapshots, fields are exchanged explicitly and snapshots are not passed on.
 */
using MakeDeviceHeatEngineFunction = DeviceHeatEngine *(const DeviceHeatVolume & volume,
                                                        float *                  heat,
                                                        HeatSnapshots *          snapshots);
} // namespace shapeton

#endif
