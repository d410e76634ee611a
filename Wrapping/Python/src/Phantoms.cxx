#include "Bindings.h"
#include "Conversions.h"
#include "Diffusion.h"

#include "shapetonColonPhantomImageSource.h"

namespace shapeton::python
{
namespace
{
using Source = ColonPhantomImageSource;

/** A synthetic patient with ground truth. */
struct ColonPhantom
{
  Source::ImageType::Pointer      ct; // null if only the ground truth was requested
  Source::LabelImageType::Pointer lumen;
  Source::LabelImageType::Pointer segments;
  CurveSet                        centerline;
};

ColonPhantom
MakePhantom(unsigned                            seed,
            const std::string &                 position,
            const std::string &                 preset,
            const std::array<unsigned int, 3> & size,
            const std::array<double, 3> &       spacing,
            bool                                truthOnly,
            const Progress &                    progress)
{
  ColonPhantomParameters parameters = ColonPhantomPreset(preset);
  parameters.seed = seed;
  parameters.position = position;
  const auto source = Source::New();
  source->SetParameters(parameters);
  source->SetSize({ { size[0], size[1], size[2] } });
  source->SetSpacing(Source::SpacingType(spacing.data()));
  source->CenterOutput();
  source->SetTruthOnly(truthOnly);
  UpdateWithProgress(source.GetPointer(), "Scanning the phantom", progress);
  return { truthOnly ? nullptr : source->GetOutput(),
           source->GetLumenOutput(),
           source->GetSegmentOutput(),
           source->GetAnatomy().Centerline() };
}
} // namespace

void
AddPhantoms(py::module_ & module)
{
  py::class_<ColonPhantom>(module, "ColonPhantom", "A synthetic patient for CT colonography, with ground truth.")
    .def_readonly("ct", &ColonPhantom::ct, "int16, HU; None if only the ground truth was requested.")
    .def_readonly("lumen", &ColonPhantom::lumen, "uint8: 1 gas, 2 fluid.")
    .def_readonly("segments", &ColonPhantom::segments, "uint8: 1 rectum to 6 cecum.")
    .def_readonly("centerline", &ColonPhantom::centerline, "The true centerline, from the anal verge to the cecum.");

  module.def("colon_phantom", Reporting(&MakePhantom), ReleaseGil());
}
} // namespace shapeton::python
