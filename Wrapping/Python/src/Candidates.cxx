#include "Bindings.h"
#include "Conversions.h"

#include "shapetonPolypSearch.h"

namespace shapeton::python
{
namespace
{
using Candidates = std::vector<PolypCandidate>;

const Words<PolypPreset> presetWords{ { "default", PolypPreset::Default }, { "published", PolypPreset::Published } };

Candidates
Search(const SurfaceMesh &                                  wall,
       const PolypLumenImage::Pointer &                     lumen,
       const std::optional<CurveSet> &                      centreline,
       const std::optional<itk::Image<float, 3>::Pointer> & ct,
       const std::shared_ptr<FlatColon> &                   flat,
       const std::optional<SurfaceMesh> &                   segments,
       const std::optional<CurveSet> &                      catheter,
       const std::string &                                  preset,
       double                                               sensitivity,
       const Progress &                                     progress)
{
  PolypColon colon;
  colon.wall = wall;
  colon.lumen = lumen;
  colon.centreline = centreline.value_or(CurveSet());
  colon.catheter = catheter.value_or(CurveSet());
  colon.ct = ct ? *ct : nullptr;
  colon.flat = flat;
  colon.segments = segments.value_or(SurfaceMesh());
  PolypSearchOptions options;
  options.preset = ValueOf(preset, "preset", presetWords);
  options.sensitivity = sensitivity;
  options.progress = progress;
  return SearchPolyps(colon, options);
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
  py::class_<PolypInOtherPosition>(module, "PolypInOtherPosition", "Where a candidate lies in the other position.")
    .def_readonly("point", &PolypInOtherPosition::point, "On the other wall; LPS, mm.")
    .def_readonly("distance", &PolypInOtherPosition::distance, "To the candidate there that is most alike, mm.")
    .def_readonly("candidate", &PolypInOtherPosition::candidate, "Its number; 0 for none.")
    .def_readonly("likeness", &PolypInOtherPosition::likeness, "0 to 1: of place, width and score.")
    .def_readonly("own_score", &PolypInOtherPosition::ownScore, "The score before it was weighed; else NaN.")
    .def_readonly("is_seen", &PolypInOtherPosition::isSeen, "A candidate there is alike.")
    .def_readonly("is_excluded", &PolypInOtherPosition::isExcluded, "Nothing can be said there.")
    .def_readonly("confidence", &PolypInOtherPosition::confidence, "Of the registration, 0 to 1.");

  py::class_<PolypCandidate>(module, "PolypCandidate", "A place of the wall that looks like a polyp; no finding.")
    .def_readonly("number", &PolypCandidate::number, "From 1, by falling score.")
    .def_readonly("score", &PolypCandidate::score, "0 to 1, of shape and tissue.")
    .def_readonly("shape_score", &PolypCandidate::shapeScore, "0 to 1, of the shape alone.")
    .def_readonly("position", &PolypCandidate::position, "The middle of the head; LPS, mm.")
    .def_readonly("apex", &PolypCandidate::apex, "Where it stands out farthest; LPS, mm.")
    .def_readonly("axis", &PolypCandidate::axis, "Unit vector from the wall into the lumen.")
    .def_readonly("vertices", &PolypCandidate::vertices, "Of the wall, that the head is made of.")
    .def_readonly("diameter", &PolypCandidate::diameter, "The largest width, mm.")
    .def_readonly("least_diameter", &PolypCandidate::leastDiameter, "The smallest width, mm.")
    .def_readonly("height", &PolypCandidate::height, "Above a ring around it, mm.")
    .def_readonly("arc_length", &PolypCandidate::arcLength, "mm along the centreline; NaN where not known.")
    .def_readonly("segment", &PolypCandidate::segment, "1 rectum to 6 caecum; 0 unknown.")
    .def_readonly("uv", &PolypCandidate::uv, "On the flat map, mm; NaN where there is none.")
    .def_readonly("attenuation", &PolypCandidate::attenuation, "Median HU inside; NaN without a CT.")
    .def_property_readonly(
      "tissue", [](const PolypCandidate & c) { return NameOf(c.tissue); }, "For example \"soft tissue\".")
    .def_property_readonly(
      "size", [](const PolypCandidate & c) { return NameOf(SizeOf(c.diameter)); }, "For example \"6-9 mm\".")
    .def_readonly("submerged_share", &PolypCandidate::submergedShare, "Under tagged fluid, 0 to 1.")
    .def_readonly("remark", &PolypCandidate::remark, "For example \"the ileocaecal valve\"; else empty.")
    .def_readonly("other", &PolypCandidate::other, "In the other position; None unless it was sought.");
}
} // namespace

void
AddCandidates(py::module_ & module)
{
  AddCandidate(module);
  module.def("find_candidates",
             Reporting(&Search),
             "wall"_a,
             "lumen"_a,
             py::kw_only(),
             "centreline"_a = py::none(),
             "ct"_a = py::none(),
             "flat"_a = py::none(),
             "segments"_a = py::none(),
             "catheter"_a = py::none(),
             "preset"_a = WordOf(PolypSearchOptions().preset, presetWords),
             "sensitivity"_a = PolypSearchOptions().sensitivity,
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(Polyp candidates on the wall of a colon, by falling score. For research use; a candidate is no finding.

wall: of full resolution, without handles (`ColonWall.repaired`). lumen: uint8, not 0, on the grid of the CT.
What else is known tells more about a candidate: centreline (with the valve), ct (HU, cleansed), flat (FlatColon),
segments (`ColonLandmarks.segments`), catheter (`ColonLumen.catheter`).
preset: "default" or "published". sensitivity: 0 to 1.
progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.)");
  module.def("find_in_other_position",
             &InOtherPosition,
             "map"_a,
             "candidates"_a,
             "others"_a,
             py::kw_only(),
             "confidence"_a = py::none(),
             ReleaseGil(),
             R"(The candidates with `other` set, by a map of `Registration`.

map: `Registration.supine_to_prone`, where the candidates are supine. others: the candidates of the other position.
confidence: that of the registration, 0 to 1; where given, scores are weighed by what is seen there: a polyp stays where
it is, most stool moves.)");
  module.def("implied_category",
             &CategoryImplied,
             "candidates"_a,
             "What the sizes of the candidates alone would imply by C-RADS, in words.");
}
} // namespace shapeton::python
