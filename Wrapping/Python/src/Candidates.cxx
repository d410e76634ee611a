#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonPolypSearch.h"

namespace shapeton::python
{
namespace
{
using Candidates = std::vector<PolypCandidate>;

Candidates
Search(const SurfaceMesh &                                  wall,
       const PolypLumenImage::Pointer &                     lumen,
       const std::optional<CurveSet> &                      centerline,
       const std::optional<itk::Image<float, 3>::Pointer> & ct,
       const std::shared_ptr<FlatColon> &                   flat,
       const std::optional<SurfaceMesh> &                   segments,
       const std::optional<CurveSet> &                      catheter,
       const Given<PolypSearchOptions> &                    given,
       const Progress &                                     progress)
{
  PolypColon colon;
  colon.wall = wall;
  colon.lumen = lumen;
  colon.centerline = centerline.value_or(CurveSet());
  colon.catheter = catheter.value_or(CurveSet());
  colon.ct = ct ? *ct : nullptr;
  colon.flat = flat;
  colon.segments = segments.value_or(SurfaceMesh());
  return SearchPolyps(colon, { given.options, progress });
}

Candidates
InOtherPosition(const SurfaceMesh &           map,
                Candidates                    candidates,
                const Candidates &            others,
                const std::optional<double> & confidence)
{
  FindInOtherPosition(map, "the map", AsOthers(others), candidates);
  if (confidence)
  {
    WeighByOtherPosition(*confidence, candidates);
  }
  return candidates;
}

void
AddCandidate(py::module_ & module)
{
  py::class_<PolypInOtherPosition>(
    module, "PolypInOtherPosition", "Position of a candidate in the other position of the patient.")
    .def_readonly("point", &PolypInOtherPosition::point, "Point on the other wall; LPS, mm.")
    .def_readonly(
      "distance", &PolypInOtherPosition::distance, "Distance to the most similar candidate in the other position, mm.")
    .def_readonly("candidate", &PolypInOtherPosition::candidate, "Number of the most similar candidate; 0 for none.")
    .def_readonly("likeness", &PolypInOtherPosition::likeness, "Similarity of location, width and score, 0 to 1.")
    .def_readonly("own_score", &PolypInOtherPosition::ownScore, "Score before weighting; otherwise NaN.")
    .def_readonly("is_seen", &PolypInOtherPosition::isSeen, "Whether a similar candidate was found.")
    .def_readonly(
      "is_excluded", &PolypInOtherPosition::isExcluded, "Whether the corresponding wall cannot be assessed.")
    .def_readonly("confidence", &PolypInOtherPosition::confidence, "Confidence of the registration, 0 to 1.");

  py::class_<PolypCandidate>(module, "PolypCandidate", "A polyp-like location on the wall; not a clinical finding.")
    .def_readonly("number", &PolypCandidate::number, "Rank by descending score, from 1.")
    .def_readonly("score", &PolypCandidate::score, "Score of shape and tissue, 0 to 1.")
    .def_readonly("shape_score", &PolypCandidate::shapeScore, "Score of the shape only, 0 to 1.")
    .def_readonly("position", &PolypCandidate::position, "Center of the head; LPS, mm.")
    .def_readonly("apex", &PolypCandidate::apex, "Most protruding point; LPS, mm.")
    .def_readonly("axis", &PolypCandidate::axis, "Unit vector from the wall into the lumen.")
    .def_readonly("vertices", &PolypCandidate::vertices, "Wall vertices of the head.")
    .def_readonly("diameter", &PolypCandidate::diameter, "Largest width, mm.")
    .def_readonly("least_diameter", &PolypCandidate::leastDiameter, "Smallest width, mm.")
    .def_readonly("height", &PolypCandidate::height, "Height above the surrounding ring, mm.")
    .def_readonly("arc_length", &PolypCandidate::arcLength, "mm along the centerline; NaN if unknown.")
    .def_readonly("segment", &PolypCandidate::segment, "1 rectum to 6 cecum; 0 unknown.")
    .def_readonly("uv", &PolypCandidate::uv, "Position on the flat map, mm; NaN without one.")
    .def_readonly("attenuation", &PolypCandidate::attenuation, "Median HU inside; NaN without a CT.")
    .def_property_readonly(
      "tissue", [](const PolypCandidate & c) { return NameOf(c.tissue); }, "For example \"soft tissue\".")
    .def_property_readonly(
      "size", [](const PolypCandidate & c) { return NameOf(SizeOf(c.diameter)); }, "For example \"6-9 mm\".")
    .def_readonly("submerged_share", &PolypCandidate::submergedShare, "Fraction covered by tagged fluid, 0 to 1.")
    .def_readonly("film_share", &PolypCandidate::filmShare, "Fraction of the surface coated with contrast, 0 to 1.")
    .def_readonly("remark", &PolypCandidate::remark, "For example \"the ileocecal valve\"; otherwise empty.")
    .def_readonly("other", &PolypCandidate::other, "Result in the other position; None if it was not searched.");
}
} // namespace

void
AddCandidates(py::module_ & module)
{
  AddCandidate(module);
  module.def("find_candidates", Reporting(&Search), ReleaseGil());
  module.def("find_in_other_position", &InOtherPosition, ReleaseGil());
  module.def("sizes_if_confirmed", &SizesIfConfirmed);
}
} // namespace shapeton::python
