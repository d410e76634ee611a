"""Virtual colonoscopy: from CT colonography to lumen, wall, flat map, folds, landmarks, candidates, registration.

Each stage is a function; `build_colon` runs all stages up to the wall. `shapeton.flattening.flatten_tube` computes
the flat wall, the input of folds, landmarks and registration.
"""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

from . import _shapeton
from ._arguments import Lines, Path, Point, Points, Progress
from ._calls import constructor, public
from ._shapeton import (
    CenterlineGap,
    CleansedColon,
    ColonCenterline,
    ColonFlexure,
    ColonLandmarks,
    ColonLumen,
    ColonModel,
    ColonPhantom,
    ColonPiece,
    ColonPosition,
    ColonThresholds,
    ColonWall,
    FlatColon,
    HaustralFold,
    HaustralFolds,
    IleocecalValve,
    MatchedFolds,
    PolypCandidate,
    PolypInOtherPosition,
    Registration,
    SegmentDistension,
)
from .image import Image
from .mesh import Mesh

__all__ = [
    "CenterlineGap",
    "CleansedColon",
    "ColonCenterline",
    "ColonFlexure",
    "ColonLandmarks",
    "ColonLumen",
    "ColonModel",
    "ColonPhantom",
    "ColonPiece",
    "ColonPosition",
    "ColonThresholds",
    "ColonWall",
    "FlatColon",
    "HaustralFold",
    "HaustralFolds",
    "IleocecalValve",
    "MatchedFolds",
    "PolypCandidate",
    "PolypInOtherPosition",
    "Registration",
    "SegmentDistension",
    "build_colon",
    "build_colon_of_lumen",
    "build_wall",
    "build_wall_of_mask",
    "cleanse",
    "colon_phantom",
    "find_candidates",
    "find_folds",
    "find_in_other_position",
    "find_landmarks",
    "find_valve",
    "implied_category",
    "measure_distension",
    "read_position",
    "register_positions",
    "segment_lumen",
    "split_colon",
    "trace_centerline",
]


@constructor(FlatColon)
def _flat_colon(self: FlatColon, surface: Mesh, pixel_size: float = 1.0) -> None:
    """surface: from `flattening.flatten_tube`.
    pixel_size: mm on the map, used for folds and landmarks.
    """


@constructor(ColonPosition)
def _colon_position(
    self: ColonPosition, name: str, landmarks: ColonLandmarks, centerline: Lines, folds: HaustralFolds
) -> None:
    """name: "supine" or "prone", for messages.
    landmarks: from `find_landmarks`.
    centerline: from `trace_centerline`.
    folds: from `find_folds`.
    """


@public
def segment_lumen(
    ct: Image, *, position: str = "auto", seed_point: Points = (), progress: Optional[Progress] = None
) -> ColonLumen:
    """Segments gas and tagged fluid of the colon in a CT colonography.

    ct: Hounsfield units; any axes, spacing about 0.5 to 3 mm.
    position: "HFS", "HFP", ..., "supine", "prone", "leftDecubitus", "rightDecubitus"; "auto": gravity is inferred from fluid
        levels.
    seed_point: k x 3, LPS mm; the pieces of gas or fluid that contain them are colon.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.segment_lumen(ct, position, seed_point, progress)


@public
def cleanse(ct: Image, lumen: ColonLumen, *, progress: Optional[Progress] = None) -> CleansedColon:
    """Removes the tagged fluid of a colon from the CT from which `lumen` was segmented.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.cleanse(ct, lumen, progress)


@public
def trace_centerline(
    lumen: Image,
    *,
    start: Optional[Point] = None,
    seed_point: Points = (),
    exponent: int = 3,
    minimum_volume: float = 5.0,
    step: float = 1.0,
    smoothing: float = 4.0,
    progress: Optional[Progress] = None,
) -> ColonCenterline:
    """The centerline of the colon from a mask of its lumen (uint8, nonzero).

    start: start point in the rectum, LPS mm; None: detected.
    seed_point: k x 3, LPS mm; pieces next to them are used.
    exponent: one mm of path costs 1 / (distance to the wall)^exponent.
    minimum_volume: of a piece of lumen, ml.
    step: spacing of the points, mm.
    smoothing: standard deviation along the line, mm.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.trace_centerline(lumen, start, seed_point, exponent, minimum_volume, step, smoothing, progress)


@public
def measure_distension(centerline: Lines) -> List[SegmentDistension]:
    """Distension of each segment, with segments delimited by standard fractions of the length."""
    return _shapeton.measure_distension(centerline)


@public
def find_valve(
    labels: Image, centerline: Lines, ct: Optional[Image] = None
) -> Tuple[Optional[IleocecalValve], str]:
    """The ileocecal valve: (IleocecalValve or None, reason why it was not found).

    labels: nonzero in the lumen.
    centerline: from `trace_centerline`.
    ct: HU on the same grid; None: shape only.
    """
    return _shapeton.find_valve(labels, centerline, ct)


@public
def build_wall(
    occupancy: Image,
    centerline: Lines,
    *,
    faces: int = 0,
    bridge_radius: float = 2.0,
    keep_pieces: bool = False,
    progress: Optional[Progress] = None,
) -> ColonWall:
    """The wall as surfaces, from the occupancy computed by `cleanse`.

    centerline: from `trace_centerline`.
    faces: of the simplified wall; 0: chosen automatically.
    bridge_radius: radius of the tubes through gaps, mm.
    keep_pieces: keeps the pieces of a broken lumen separate.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.build_wall(occupancy, centerline, faces, bridge_radius, keep_pieces, progress)


@public
def build_wall_of_mask(
    mask: Image,
    centerline: Lines,
    *,
    faces: int = 0,
    bridge_radius: float = 2.0,
    keep_pieces: bool = False,
    progress: Optional[Progress] = None,
) -> ColonWall:
    """The wall from a mask of the lumen (uint8, nonzero); parameters as in `build_wall`."""
    return _shapeton.build_wall_of_mask(mask, centerline, faces, bridge_radius, keep_pieces, progress)


@public
def build_colon(
    ct: Image,
    *,
    lumen: Optional[Image] = None,
    position: str = "auto",
    seed_point: Points = (),
    faces: int = 0,
    keep_pieces: bool = False,
    keep_partial: bool = False,
    progress: Optional[Progress] = None,
) -> ColonModel:
    """Computes lumen, cleansed CT, centerline, valve, distension and wall from a CT colonography in HU.

    lumen: a mask (uint8, nonzero) on the grid of the CT that replaces the automatic one.
    position, seed_point: see `segment_lumen`.
    faces, keep_pieces: see `build_wall`.
    keep_partial: if the colon is not distended or tagged enough, continues as far as possible.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    An unusable colon does not raise an exception: see `failure`.
    """
    return _shapeton.build_colon(ct, lumen, position, seed_point, faces, keep_pieces, keep_partial, progress)


@public
def build_colon_of_lumen(
    lumen: Image,
    *,
    seed_point: Points = (),
    faces: int = 0,
    keep_pieces: bool = False,
    keep_partial: bool = False,
    progress: Optional[Progress] = None,
) -> ColonModel:
    """Computes the model from a mask of the lumen only (uint8, nonzero); parameters as in `build_colon`."""
    return _shapeton.build_colon_of_lumen(lumen, seed_point, faces, keep_pieces, keep_partial, progress)


@public
def find_folds(
    flat: FlatColon,
    *,
    scheme: str = "graphCut",
    minimum_length: float = 7.0,
    minimum_area: float = 12.0,
    minimum_elongation: float = 1.5,
    minimum_angle: float = 30.0,
    smoothing_time: float = 2.0,
    smoothness: float = 1.0,
    taeniae: Optional[Lines] = None,
    progress: Optional[Progress] = None,
) -> HaustralFolds:
    """Haustral folds on the flat wall of a colon.

    scheme: "graphCut" or "published".
    minimum_length: mm.
    minimum_area: mm^2.
    minimum_elongation: long over short axis.
    minimum_angle: against the tube, degrees.
    smoothing_time: of the curvature, mm^2.
    smoothness: cost of the outline.
    taeniae: curves on the wall along which merged folds are split.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.find_folds(
        flat,
        scheme,
        minimum_length,
        minimum_area,
        minimum_elongation,
        minimum_angle,
        smoothing_time,
        smoothness,
        taeniae,
        progress,
    )


@public
def find_landmarks(
    flat: FlatColon,
    centerline: Lines,
    *,
    flexure_rule: str = "ordered",
    taenia_rule: str = "joint",
    markers: Points = (),
    progress: Optional[Progress] = None,
) -> ColonLandmarks:
    """Flexures, segments, folds on the surface and taeniae of a flat colon.

    centerline: from `trace_centerline`.
    flexure_rule: "ordered" or "published".
    taenia_rule: "joint" or "published".
    markers: k x 3, LPS mm: points on taeniae placed by a person.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    A landmark that is not found does not raise an exception: it is absent, and `warnings` give the reason.
    """
    return _shapeton.find_landmarks(flat, centerline, flexure_rule, taenia_rule, markers, progress)


@public
def split_colon(
    landmarks: ColonLandmarks, *, progress: Optional[Progress] = None
) -> Tuple[List[ColonPiece], List[str]]:
    """Cuts the wall into its segments and maps each to a rectangle: (list of ColonPiece, warnings).

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.split_colon(landmarks, progress)


@public
def find_candidates(
    wall: Mesh,
    lumen: Image,
    *,
    centerline: Optional[Lines] = None,
    ct: Optional[Image] = None,
    flat: Optional[FlatColon] = None,
    segments: Optional[Mesh] = None,
    catheter: Optional[Lines] = None,
    preset: str = "default",
    sensitivity: float = 0.75,
    progress: Optional[Progress] = None,
) -> List[PolypCandidate]:
    """Polyp candidates on the wall of a colon, by descending score. For research use; not clinical findings.

    wall: full resolution, without handles (`ColonWall.repaired`).
    lumen: uint8, nonzero, on the grid of the CT.
    preset: "default" or "published".
    sensitivity: 0 to 1.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    Optional inputs add information to a candidate: centerline (with the valve), ct (HU, cleansed), flat, segments
    (`ColonLandmarks.segments`), catheter (`ColonLumen.catheter`).
    """
    return _shapeton.find_candidates(
        wall, lumen, centerline, ct, flat, segments, catheter, preset, sensitivity, progress
    )


@public
def find_in_other_position(
    map: Mesh,
    candidates: Sequence[PolypCandidate],
    others: Sequence[PolypCandidate],
    *,
    confidence: Optional[float] = None,
) -> List[PolypCandidate]:
    """The candidates with `other` set, from a map of `Registration`.

    map: `Registration.supine_to_prone` if the candidates are supine.
    others: the candidates of the other position.
    confidence: of the registration, 0 to 1. If given, scores are weighted by the other position: polyps stay in place,
        most stool moves.
    """
    return _shapeton.find_in_other_position(map, candidates, others, confidence)


@public
def implied_category(candidates: Sequence[PolypCandidate]) -> str:
    """C-RADS category implied by the candidate sizes only, as text."""
    return _shapeton.implied_category(candidates)


@public
def read_position(folder: Path, name: str) -> ColonPosition:
    """Reads a ColonPosition from a folder written by VirtualColonoscopy.

    name: "supine" or "prone", for messages.
    """
    return _shapeton.read_position(folder, name)


@public
def register_positions(
    supine: ColonPosition,
    prone: ColonPosition,
    *,
    map: str = "default",
    matching: str = "hungarian",
    refine: bool = False,
    segment_wise: bool = False,
    progress: Optional[Progress] = None,
) -> Registration:
    """A one-to-one map between the walls of a colon in two positions.

    map: "default" or "published".
    matching: of folds, "hungarian" or "dualDecomposition".
    refine: by the wall curvature.
    segment_wise: folds stay within their segment.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.register_positions(supine, prone, map, matching, refine, segment_wise, progress)


@public
def colon_phantom(
    *,
    seed: int = 1,
    position: str = "supine",
    preset: str = "standard",
    size: Tuple[int, int, int] = (256, 256, 240),
    spacing: Tuple[float, float, float] = (1.4, 1.4, 1.4),
    truth_only: bool = False,
    progress: Optional[Progress] = None,
) -> ColonPhantom:
    """A synthetic patient for CT colonography.

    seed: fixes the patient.
    position: "supine", "prone", "leftDecubitus" or "rightDecubitus".
    preset: "standard", "hard" or "realistic".
    size: voxels along x, y, z.
    spacing: along x, y, z, mm; the patient needs about 358 x 358 x 336 mm.
    truth_only: omits the CT, which takes most of the time.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.colon_phantom(seed, position, preset, size, spacing, truth_only, progress)
