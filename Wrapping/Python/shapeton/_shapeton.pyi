"""Written by make_stub.py from the docstrings of the module; do not edit."""

import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike, NDArray

from .image import Image
from .mesh import Curves, Mesh

class Error(Exception):
    """What all errors of Shapeton derive from."""

class ParameterError(Error, ValueError):
    """A parameter is out of range or contradicts another one; also a ValueError."""

class InputError(Error, ValueError):
    """The input is missing, unreadable, malformed or unsuitable; also a ValueError."""

class OutputError(Error, OSError):
    """A result cannot be written; also an OSError."""

class Aborted(Error, RuntimeError):
    """A progress function has returned False; also a RuntimeError."""

class CentrelineGap:
    """A stretch without lumen that a centreline bridges."""
    @property
    def begin(self) -> float:
        """mm along the line."""
        ...

    @property
    def distance(self) -> float:
        """Straight distance of the ends of the lumen, mm."""
        ...

    @property
    def end(self) -> float:
        """mm along the line."""
        ...

    @property
    def is_doubtful(self) -> bool:
        """Longer than a collapsed stretch is known to be."""
        ...


class CleansedColon:
    """What `cleanse` gives."""
    @property
    def ct(self) -> Image:
        """float32, HU: the CT with gas in place of fluid."""
        ...

    @property
    def occupancy(self) -> Image:
        """float32, 0 to 1, cropped: share of lumen in each voxel; the wall is where it is 0.5."""
        ...


class ColonCentreline:
    """The middle line of a colon from the rectum to the caecum."""
    @property
    def coverage(self) -> float:
        """Share of the lumen beside the line, 0 to 1."""
        ...

    @property
    def curve(self) -> Curves:
        """One curve; point arrays arcLength (mm), radius (mm), gap (1 on a bridge)."""
        ...

    @property
    def gaps(self) -> List[CentrelineGap]:
        """Stretches that it bridges."""
        ...

    @property
    def length(self) -> float:
        """mm."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is doubtful, a line for each."""
        ...


class ColonFlattening:
    """A flattened tube with what was measured."""
    @property
    def circumference(self) -> float:
        """Mean, mm."""
        ...

    @property
    def flat(self) -> Mesh:
        """The tube cut open: places in space, the point arrays uv (mm: along, around) and sourcePointId, the field arrays circumference and length (mm)."""
        ...

    @property
    def genus_after(self) -> int:
        """Handles of the surface that was flattened."""
        ...

    @property
    def genus_before(self) -> int:
        """Handles of the surface that was given."""
        ...

    @property
    def handles(self) -> List[SurfaceHandle]:
        """Those found; none on most walls."""
        ...

    @property
    def length(self) -> float:
        """Of the map, mm."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys that ColonFlattening writes: flips, dilatation, moduli, ..."""
        ...

    @property
    def surface(self) -> Mesh:
        """The tube that was flattened."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is doubtful, a line for each."""
        ...


class ColonFlexure:
    """A major bend of the colon, or a place where one was looked for."""
    @property
    def arc_length(self) -> float:
        """mm along the centreline."""
        ...

    @property
    def confidence(self) -> float:
        """0 to 1: that it lies within 30 mm."""
        ...

    @property
    def is_found(self) -> bool:
        """Whether it was found."""
        ...

    @property
    def name(self) -> str:
        """For example "splenic"."""
        ...

    @property
    def number(self) -> int:
        """1 rectosigmoid, 2 descending-sigmoid, 3 splenic, 4 hepatic."""
        ...

    @property
    def point(self) -> NDArray[Any]:
        """On the centreline; LPS, mm."""
        ...

    @property
    def reason(self) -> str:
        """Why not; else empty."""
        ...


class ColonLandmarks:
    """What `find_landmarks` gives."""
    @property
    def flexure_loops(self) -> Curves:
        """A closed loop on the wall for each flexure that was found; cell arrays flexure, arcLength, confidence."""
        ...

    @property
    def flexures(self) -> List[ColonFlexure]:
        """Four, from the rectum on."""
        ...

    @property
    def fold_surface(self) -> Mesh:
        """The flat wall with the cell array fold and the point array meanCurvature (1/mm)."""
        ...

    @property
    def is_mirrored(self) -> bool:
        """Situs inversus."""
        ...

    @property
    def segments(self) -> Mesh:
        """The flat wall with the cell array segment: 1 rectum to 6 caecum, 0 where it cannot be said."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of landmarks.json that ColonLandmarks writes."""
        ...

    @property
    def taeniae(self) -> Curves:
        """Three curves on the wall, or none; point arrays arcLength (mm), uv (mm), confidence, cell array taenia."""
        ...

    @property
    def valve(self) -> Optional[IleocaecalValve]:
        """As the centreline tells it, or None."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is missing, a line for each."""
        ...


class ColonLumen:
    """What `segment_lumen` finds."""
    @property
    def catheter(self) -> Optional[Curves]:
        """The axis of a rectal catheter as Curves; None where none is sure."""
        ...

    @property
    def failure(self) -> str:
        """Why this is no usable colon; else empty."""
        ...

    @property
    def gravity(self) -> NDArray[Any]:
        """Unit vector, LPS."""
        ...

    @property
    def is_tagged(self) -> bool:
        """Fluid brighter than tissue lies under the colon's gas."""
        ...

    @property
    def labels(self) -> Image:
        """uint8: 1 gas, 2 fluid, 0 anything else."""
        ...

    @property
    def noise(self) -> float:
        """Standard deviation in soft tissue, HU."""
        ...

    @property
    def thresholds(self) -> ColonThresholds:
        """HU."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is missing or doubtful, a line for each."""
        ...


class ColonModel:
    """A colon: lumen, centreline and wall."""
    @property
    def centreline(self) -> ColonCentreline:
        """ColonCentreline; its curve knows the valve."""
        ...

    @property
    def cleansed(self) -> Image:
        """float32, HU; None of a mask."""
        ...

    @property
    def distension(self) -> List[SegmentDistension]:
        """Of the segments."""
        ...

    @property
    def failure(self) -> str:
        """Why this is no usable colon; else empty."""
        ...

    @property
    def lumen(self) -> ColonLumen:
        """ColonLumen."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of quality.json that ColonSegmentation writes."""
        ...

    @property
    def valve(self) -> Optional[IleocaecalValve]:
        """IleocaecalValve; None where it was not found."""
        ...

    @property
    def wall(self) -> ColonWall:
        """ColonWall."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Of all stages, a line for each."""
        ...


class ColonPhantom:
    """A synthetic patient for CT colonography, and the truth."""
    @property
    def centreline(self) -> Curves:
        """The true one, from the anal verge to the caecum."""
        ...

    @property
    def ct(self) -> Image:
        """int16, HU; None of the truth alone."""
        ...

    @property
    def lumen(self) -> Image:
        """uint8: 1 gas, 2 fluid."""
        ...

    @property
    def segments(self) -> Image:
        """uint8: 1 rectum to 6 caecum."""
        ...


class ColonPiece:
    """A segment of the colon, cut open along a taenia and flattened."""
    @property
    def area(self) -> float:
        """mm^2."""
        ...

    @property
    def flat(self) -> Mesh:
        """In space, with the point array uv (mm of the rectangle)."""
        ...

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle: not less than the true one."""
        ...

    @property
    def modulus_v(self) -> float:
        """The same: not greater."""
        ...

    @property
    def name(self) -> str:
        """Of the segment."""
        ...

    @property
    def segment(self) -> int:
        """1 rectum to 6 caecum."""
        ...


class ColonPosition:
    """The colon in one position, to be registered.

    name: "supine" or "prone", for messages. landmarks: as `find_landmarks` gives them. centreline: Curves.
    folds: as `find_folds` gives them.
    """
    def __init__(self, name: str, landmarks: ColonLandmarks, centreline: Union[Curves, NDArray[Any]], folds: HaustralFolds) -> None: ...

    @property
    def name(self) -> str:
        """For messages."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is missing that registration can do without."""
        ...


class ColonThresholds:
    """Intensities in HU, all from the data."""
    @property
    def fluid(self) -> float:
        """Mode of tagged fluid; 0 where there is none."""
        ...

    @property
    def fluid_boundary(self) -> float:
        """Half-height between tissue and fluid."""
        ...

    @property
    def gas(self) -> float:
        """Typical gas inside the body."""
        ...

    @property
    def gas_boundary(self) -> float:
        """Half-height between them: where the wall begins."""
        ...

    @property
    def tissue(self) -> float:
        """Typical soft tissue."""
        ...


class ColonWall:
    """The wall of a colon in three forms, each open at rectum and caecum."""
    @property
    def genus_after(self) -> int:
        """Handles of the repaired wall."""
        ...

    @property
    def genus_before(self) -> int:
        """Handles of the raw wall."""
        ...

    @property
    def raw(self) -> Mesh:
        """With all its handles."""
        ...

    @property
    def repaired(self) -> Mesh:
        """Without handles, smoothed."""
        ...

    @property
    def simplified(self) -> Mesh:
        """The repaired one with fewer faces."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is doubtful, a line for each."""
        ...


class ConformalMap:
    """A surface on the plane, and how well."""
    @property
    def corners(self) -> List[int]:
        """Four vertices, of a rectangle of one boundary."""
        ...

    @property
    def dilatation(self) -> NDArray[Any]:
        """Of each face, from 1 (conformal) on."""
        ...

    @property
    def flat(self) -> Mesh:
        """The cut surface in space with the point array uv (mm of the plane)."""
        ...

    @property
    def flips(self) -> int:
        """Faces that the map turns over."""
        ...

    @property
    def genus(self) -> int:
        """0 unless there are handles."""
        ...

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle, or 2 pi / ln(R / r)."""
        ...

    @property
    def modulus_v(self) -> float:
        """The same from the conjugate; the gap is the error bar."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys that ConformalMap writes."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is doubtful, a line for each."""
        ...


class DicomDefect:
    """What is wrong with a DICOM series, or unusual about it."""
    @property
    def advice(self) -> str:
        """What can be done."""
        ...

    @property
    def files(self) -> List[str]:
        """The files concerned."""
        ...

    @property
    def message(self) -> str:
        """The defect in a sentence."""
        ...

    @property
    def name(self) -> str:
        """For example "gap"."""
        ...

    @property
    def slices(self) -> List[int]:
        """The slices concerned, from 1 along the normal."""
        ...


class DicomSeries:
    """A DICOM series of a folder, as `list_series` finds it."""
    @property
    def defects(self) -> List[DicomDefect]:
        """What keeps the series from being read as it is."""
        ...

    @property
    def description(self) -> str:
        """Series Description."""
        ...

    @property
    def is_usable(self) -> bool:
        """Whether a volume can be read without a repair."""
        ...

    @property
    def modality(self) -> str:
        """For example "CT"."""
        ...

    @property
    def number(self) -> int:
        """Series Number."""
        ...

    @property
    def patient_position(self) -> str:
        """For example "HFS"."""
        ...

    @property
    def refusal(self) -> str:
        """Why this is no volume where no defect says it; else empty."""
        ...

    @property
    def remarks(self) -> List[DicomDefect]:
        """What is unusual and keeps nobody from reading it."""
        ...

    @property
    def selector(self) -> str:
        """What `read_volume` takes as series_uid: the UID, with "#part" if need be."""
        ...

    @property
    def size(self) -> Tuple[Any, ...]:
        """Columns, rows, slices: the extents along x, y, z."""
        ...

    @property
    def spacing(self) -> Tuple[Any, ...]:
        """Of columns, rows, slices; mm, 0 where it is not known."""
        ...

    @property
    def uid(self) -> str:
        """Series Instance UID."""
        ...


class EmbeddingCertificate:
    """A graph on a surface and the circles that carry it.

    Places are unit vectors on the sphere (radius: the angle of a cap), else (x, y) in the plane or in the Poincare disk
    (radius: a length, of hyperbolic geometry in the disk). Half-edge 2e leaves the first end of edge e, 2e + 1 the second.
    """
    @property
    def face_positions(self) -> NDArray[Any]:
        """A row for each face of the packed graph; a view."""
        ...

    @property
    def face_radii(self) -> NDArray[Any]:
        """Of the circles of the faces; a view."""
        ...

    @property
    def genus(self) -> int:
        """Of the surface."""
        ...

    @property
    def geometry(self) -> str:
        """"spherical" (genus 0), "euclidean" (1) or "hyperbolic"."""
        ...

    @property
    def graph(self) -> Graph:
        """Graph."""
        ...

    @property
    def node_positions(self) -> NDArray[Any]:
        """A row for each packed node, first those of the graph; a view."""
        ...

    @property
    def node_radii(self) -> NDArray[Any]:
        """Of the circles of the packed nodes; a view."""
        ...

    @property
    def packed(self) -> Graph:
        """The graph with dummies that make it 3-connected."""
        ...

    @property
    def periods(self) -> NDArray[Any]:
        """Of the torus: x1, y1, x2, y2; empty on other surfaces."""
        ...

    @property
    def rotation(self) -> List[int]:
        """Half-edges that leave each node, counterclockwise, in one list."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """What was measured, by name."""
        ...

    @property
    def subdivided(self) -> List[List[int]]:
        """Edges that are paths of the packed graph, as half-edges."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What is doubtful, a line for each."""
        ...


class EmbeddingVerdict:
    """What `verify_embedding` finds."""
    @property
    def is_valid(self) -> bool:
        """No two edges cross: that is proved."""
        ...

    @property
    def measures(self) -> Dict[str, Any]:
        """What was measured, by name."""
        ...

    @property
    def refusal(self) -> str:
        """The first thing that is wrong; else empty."""
        ...


class FlatColon:
    """The flat wall of a colon with a grid of square pixels.

    surface: as `flatten_tube` gives it. pixel_size: mm of the map, in which folds and landmarks work.
    """
    def __init__(self, surface: Mesh, pixel_size: float=...) -> None: ...

    @property
    def circumference(self) -> float:
        """Mean, mm."""
        ...

    def coordinates(self) -> NDArray[Any]:
        """Rows x columns x 3, float32: the place of each pixel, LPS mm; NaN in holes."""
        ...

    def curvature(self) -> NDArray[Any]:
        """Rows x columns, float64: mean curvature, 1/mm; positive where the wall bulges into the lumen, NaN in holes."""
        ...

    def faces(self) -> NDArray[Any]:
        """Rows x columns, int32: the face at each pixel; -1 in holes."""
        ...

    def find(self, points: ArrayLike) -> Tuple[NDArray[Any], NDArray[Any]]:
        """Of places in space, k x 3 (LPS, mm): their uv on the map, k x 2, and distances from the wall, k; mm."""
        ...

    @property
    def length(self) -> float:
        """Of the map, mm."""
        ...

    @property
    def pixel_size(self) -> float:
        """mm of the map."""
        ...

    def pixels(self, uv: ArrayLike) -> NDArray[Any]:
        """Of places on the map, k x 2 (mm): their pixels [row, column], k x 2, int32. Rows may run against v."""
        ...

    @property
    def shape(self) -> Tuple[Any, ...]:
        """Rows (around the tube) and columns (along it) of the grid."""
        ...

    @property
    def surface(self) -> Mesh:
        """The flat surface."""
        ...


class Graph:
    """An undirected graph; loops and multiple edges are allowed.

    nodes: how many. edges: m x 2, indices of nodes. names: none, or one for each node.
    """
    def __init__(self, nodes: int, edges: ArrayLike, names: Sequence[str]=...) -> None: ...

    @property
    def edges(self) -> NDArray[Any]:
        """m x 2, int32: the ends of each edge; a view."""
        ...

    @property
    def names(self) -> List[str]:
        """None, or one for each node."""
        ...

    @property
    def nodes(self) -> int:
        """How many."""
        ...


class GraphComparison:
    """Two graphs side by side."""
    @property
    def a(self) -> EmbeddingCertificate:
        """Certificate of the first graph in canonical order."""
        ...

    @property
    def b(self) -> EmbeddingCertificate:
        """Certificate of the second graph in canonical order."""
        ...

    @property
    def correspondence(self) -> List[int]:
        """For each node of `a.graph` that of `b.graph`, or -1."""
        ...

    @property
    def correspondence_by(self) -> str:
        """"isomorphism", "names", "neighbourhoods" or "none"."""
        ...

    @property
    def differences(self) -> List[str]:
        """In sentences; none for isomorphic graphs."""
        ...

    @property
    def isomorphic(self) -> bool:
        """Whether they are one graph but for names."""
        ...


class HaustralFold:
    """A haustral fold."""
    @property
    def angle(self) -> float:
        """Of the long axis against the tube, degrees; 90 runs around it."""
        ...

    @property
    def arc_length(self) -> float:
        """mm along the centreline; NaN where not known."""
        ...

    @property
    def area(self) -> float:
        """mm^2."""
        ...

    @property
    def centre(self) -> NDArray[Any]:
        """LPS, mm."""
        ...

    @property
    def centre_uv(self) -> NDArray[Any]:
        """On the map, mm."""
        ...

    @property
    def crosses_cut(self) -> bool:
        """Lies on both sides of the cut."""
        ...

    @property
    def elongation(self) -> float:
        """Long over short axis."""
        ...

    @property
    def ends(self) -> NDArray[Any]:
        """2 x 3; LPS, mm."""
        ...

    @property
    def height(self) -> float:
        """Of the crest above the wall, mm; NaN where it cannot be seen."""
        ...

    @property
    def label(self) -> int:
        """Its value in the labels, from 1."""
        ...

    @property
    def length(self) -> float:
        """Along the crest, mm."""
        ...

    @property
    def mean_curvature(self) -> float:
        """1/mm."""
        ...

    @property
    def reliability(self) -> float:
        """0 to 1."""
        ...


class HaustralFolds:
    """What `find_folds` gives."""
    @property
    def folds(self) -> List[HaustralFold]:
        """HaustralFold, in the order of the labels."""
        ...

    @property
    def labels(self) -> NDArray[Any]:
        """Rows x columns, uint16: 0 wall, else the label of a fold."""
        ...

    @property
    def warnings(self) -> List[str]:
        """A line for each."""
        ...


class HeatClass:
    """A class of voxels with similar heat: a line of the heat histogram."""
    @property
    def border_share(self) -> float:
        """Share of the voxels at the border of the volume, 0 to 1."""
        ...

    @property
    def components(self) -> int:
        """Converged closed components in the class."""
        ...

    @property
    def label(self) -> int:
        """0 background; 1 the class of least heat."""
        ...

    @property
    def lower_heat(self) -> float:
        """The class holds lower_heat <= heat < upper_heat."""
        ...

    @property
    def mean_heat(self) -> float:
        """In [0, 1]."""
        ...

    @property
    def normalized_heat(self) -> float:
        """Free of scale, of these components; 0 for none."""
        ...

    @property
    def upper_heat(self) -> float:
        """See lower_heat."""
        ...

    @property
    def volume(self) -> float:
        """mm^3."""
        ...

    @property
    def voxels(self) -> int:
        """How many."""
        ...


class HeatDiffusionMetric:
    """Heat diffusion distances of the ends of all edges."""
    @property
    def drowned_edges(self) -> int:
        """Edges too short to be told from rounding, as at the tip of a needle: they have the least such length."""
        ...

    @property
    def edge_lengths(self) -> NDArray[Any]:
        """In the order of `surface_edges`; 1/mm."""
        ...

    @property
    def eigenpairs(self) -> int:
        """How many; 0 for all of them."""
        ...

    @property
    def time(self) -> float:
        """mm^2."""
        ...


class HeatHistogram:
    """Counts of voxels by heat, a row for each recorded time step."""
    @property
    def counts(self) -> NDArray[Any]:
        """Rows x 4097, uint32: voxels in each bin; a view."""
        ...

    @property
    def edges(self) -> NDArray[Any]:
        """4098 heats: bin b holds edges[b] <= heat < edges[b + 1]. Bin 0 is the background, the others 256 for each factor of two."""
        ...

    def equalization(self) -> List[float]:
        """4098 numbers from 0 to 1, ascending: the share of the counts without bin 0 below the lower edge of each bin, mean over the rows."""
        ...

    @property
    def time_steps(self) -> List[int]:
        """Of the rows, ascending."""
        ...


class HeatResult:
    """What `diffuse_heat` gives."""
    @property
    def cold(self) -> bool:
        """No edge in the volume: the heat is 0 everywhere."""
        ...

    @property
    def components(self) -> List[ShapeComponent]:
        """Largest first; empty unless they were asked for."""
        ...

    @property
    def heat(self) -> Image:
        """After the last step, in [0, 1]; float32, on the grid of the input."""
        ...

    @property
    def histogram(self) -> HeatHistogram:
        """A row for each of histogram_steps that was reached."""
        ...

    @property
    def initial_heat(self) -> Image:
        """The heat at step 0; None unless it was asked for."""
        ...

    @property
    def p(self) -> float:
        """The p that was used."""
        ...

    @property
    def reason_of_p(self) -> str:
        """Why, where p was chosen; else empty."""
        ...

    @property
    def steady(self) -> bool:
        """Whether it has become steady."""
        ...

    @property
    def time_step(self) -> int:
        """The last step that was taken."""
        ...

    @property
    def time_step_length(self) -> float:
        """dt, at most 1/12."""
        ...

    @property
    def window(self) -> Tuple[Any, ...]:
        """The intensities that count as 0 and 1."""
        ...


class IleocaecalValve:
    """Where the terminal ileum opens into a colon."""
    @property
    def arc_length(self) -> float:
        """mm along the centreline."""
        ...

    @property
    def attenuation(self) -> float:
        """Median HU inside; NaN without a CT."""
        ...

    @property
    def confidence(self) -> float:
        """0 to 1."""
        ...

    @property
    def length(self) -> float:
        """mm, greatest width."""
        ...

    @property
    def position(self) -> NDArray[Any]:
        """LPS, mm."""
        ...

    @property
    def width(self) -> float:
        """mm, least width."""
        ...


class MatchedFolds:
    """Two folds that are taken for one."""
    @property
    def prone_fold(self) -> int:
        """Its label."""
        ...

    @property
    def prone_point(self) -> NDArray[Any]:
        """Its middle; LPS, mm."""
        ...

    @property
    def residual(self) -> float:
        """From where the map takes one to the other, mm."""
        ...

    @property
    def segment(self) -> str:
        """Of the supine position; "" where not known."""
        ...

    @property
    def supine_fold(self) -> int:
        """Its label."""
        ...

    @property
    def supine_point(self) -> NDArray[Any]:
        """Its middle; LPS, mm."""
        ...

    @property
    def weight(self) -> float:
        """0 to 1: how much the map follows it; below 0.5 not."""
        ...


class NamedShape:
    """A signature with a name, which several may share."""
    def __init__(self, name: str, signature: ShapeSignature) -> None: ...

    @property
    def name(self) -> str:
        """Any text."""
        ...

    @property
    def signature(self) -> ShapeSignature:
        """A ShapeSignature."""
        ...


class PolypCandidate:
    """A place of the wall that looks like a polyp; no finding."""
    @property
    def apex(self) -> NDArray[Any]:
        """Where it stands out farthest; LPS, mm."""
        ...

    @property
    def arc_length(self) -> float:
        """mm along the centreline; NaN where not known."""
        ...

    @property
    def attenuation(self) -> float:
        """Median HU inside; NaN without a CT."""
        ...

    @property
    def axis(self) -> NDArray[Any]:
        """Unit vector from the wall into the lumen."""
        ...

    @property
    def diameter(self) -> float:
        """The largest width, mm."""
        ...

    @property
    def height(self) -> float:
        """Above a ring around it, mm."""
        ...

    @property
    def least_diameter(self) -> float:
        """The smallest width, mm."""
        ...

    @property
    def number(self) -> int:
        """From 1, by falling score."""
        ...

    @property
    def other(self) -> Optional[PolypInOtherPosition]:
        """In the other position; None unless it was sought."""
        ...

    @property
    def position(self) -> NDArray[Any]:
        """The middle of the head; LPS, mm."""
        ...

    @property
    def remark(self) -> str:
        """For example "the ileocaecal valve"; else empty."""
        ...

    @property
    def score(self) -> float:
        """0 to 1, of shape and tissue."""
        ...

    @property
    def segment(self) -> int:
        """1 rectum to 6 caecum; 0 unknown."""
        ...

    @property
    def shape_score(self) -> float:
        """0 to 1, of the shape alone."""
        ...

    @property
    def size(self) -> str:
        """For example "6-9 mm"."""
        ...

    @property
    def submerged_share(self) -> float:
        """Under tagged fluid, 0 to 1."""
        ...

    @property
    def tissue(self) -> str:
        """For example "soft tissue"."""
        ...

    @property
    def uv(self) -> NDArray[Any]:
        """On the flat map, mm; NaN where there is none."""
        ...

    @property
    def vertices(self) -> List[int]:
        """Of the wall, that the head is made of."""
        ...


class PolypInOtherPosition:
    """Where a candidate lies in the other position."""
    @property
    def candidate(self) -> int:
        """Its number; 0 for none."""
        ...

    @property
    def confidence(self) -> float:
        """Of the registration, 0 to 1."""
        ...

    @property
    def distance(self) -> float:
        """To the candidate there that is most alike, mm."""
        ...

    @property
    def is_excluded(self) -> bool:
        """Nothing can be said there."""
        ...

    @property
    def is_seen(self) -> bool:
        """A candidate there is alike."""
        ...

    @property
    def likeness(self) -> float:
        """0 to 1: of place, width and score."""
        ...

    @property
    def own_score(self) -> float:
        """The score before it was weighed; else NaN."""
        ...

    @property
    def point(self) -> NDArray[Any]:
        """On the other wall; LPS, mm."""
        ...


class Registration:
    """A map between the walls of two positions."""
    @property
    def confidence(self) -> float:
        """0 to 1; below 0.5 flagged."""
        ...

    @property
    def doubts(self) -> List[str]:
        """Why it is flagged; else none."""
        ...

    @property
    def flips(self) -> int:
        """Triangles that are turned over."""
        ...

    def map_points(self, points: ArrayLike, inverse: bool=...) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Takes places, k x 3 (LPS, mm), from the nearest points of the supine wall to the prone one, or back with `inverse`.

        Returns (places, k x 3, LPS mm; confidence, k, 0 to 1; excluded, k: nothing is to be seen in one of the positions).
        """
        ...

    @property
    def matches(self) -> List[MatchedFolds]:
        """MatchedFolds, in the order of supine folds."""
        ...

    @property
    def prone_to_supine(self) -> Mesh:
        """The other way."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of registration.json that ColonRegistration writes."""
        ...

    @property
    def supine_to_prone(self) -> Mesh:
        """The flat supine wall with point arrays mapped (LPS, mm, on the prone wall), mappedUv, displacement (mm), confidence (0 to 1), excluded."""
        ...

    @property
    def warnings(self) -> List[str]:
        """A line for each."""
        ...


class SeededHeat:
    """Labels from a few seeds: the steady state of heat that leaves the seeds of each label.

    image: intensities; float32 and C-contiguous ones are read in place.
    p: steepness, from 0; an edge insulates where the half gradient reaches 1 / p. None: chosen from noise and edges.
    window: (lower, upper) intensities that count as 0 and 1; None: the least and the greatest.
    least_weight: positive; what an edge that insulates still lets through.
    tolerance: greatest error of a probability, 1e-6 to 0.1.

    Draw strokes through all of each part, and of the background: a point is too little (`SeededLabels.warnings`).
    It keeps the last solution, from which the next one starts: 4 bytes for each voxel and label.
    """
    def __init__(self, image: Image, *, p: Optional[float]=..., window: Optional[Tuple[float, float]]=..., least_weight: float=..., tolerance: float=...) -> None: ...

    def segment(self, seeds: Image, *, probabilities: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> SeededLabels:
        """The label of each voxel.

        seeds: an image on the same grid, whole numbers from 0 to 65535; 0: no seed; two labels at least.
        probabilities: gives those of each label, too.
        progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
        """
        ...


class SeededLabels:
    """What `SeededHeat.segment` gives."""
    @property
    def iterations(self) -> int:
        """Of the solver; few after a small change of the seeds."""
        ...

    @property
    def labels(self) -> Image:
        """uint16: the label of greatest probability."""
        ...

    @property
    def probabilities(self) -> Dict[int, Image]:
        """Label to image, float32 in [0, 1], which sum to 1; empty unless they were asked for."""
        ...

    @property
    def uncertainty(self) -> Image:
        """float32: 1 minus the difference of the two greatest probabilities; 0 where one label is sure."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Labels that hardly leave their seeds, a line for each."""
        ...


class SegmentDistension:
    """How far a stretch of the colon is filled."""
    @property
    def begin(self) -> float:
        """mm along the centreline."""
        ...

    @property
    def collapsed_length(self) -> float:
        """Without lumen, mm."""
        ...

    @property
    def end(self) -> float:
        """mm along the centreline."""
        ...

    @property
    def mean_calibre(self) -> float:
        """Mean inner diameter, mm."""
        ...

    @property
    def name(self) -> str:
        """Of the segment."""
        ...

    @property
    def share(self) -> float:
        """Of its length with a calibre of at least 10 mm, 0 to 1."""
        ...


class ShapeComponent:
    """Voxels that are joined by edges of positive weight."""
    @property
    def closed(self) -> bool:
        """False where it reaches the border of the volume."""
        ...

    @property
    def converged_heat(self) -> float:
        """The heat that each voxel has in the end."""
        ...

    @property
    def index(self) -> Tuple[Any, ...]:
        """Its first voxel, [z, y, x]."""
        ...

    @property
    def normalized_heat(self) -> float:
        """Area / (6 volume^(2/3)): 1 for a cube."""
        ...

    @property
    def surface_area(self) -> float:
        """mm^2; 0 of an open one."""
        ...

    @property
    def volume(self) -> float:
        """mm^3."""
        ...

    @property
    def voxels(self) -> int:
        """How many."""
        ...


class ShapeNeighbour:
    """An entry and its distance."""
    @property
    def distance(self) -> float:
        """From 0; copies of one shape are about 1 apart."""
        ...

    @property
    def entry(self) -> int:
        """Its index."""
        ...


class ShapeRow:
    """A shape of a label map."""
    @property
    def component(self) -> int:
        """1 for the largest; 0 for the label as a whole."""
        ...

    @property
    def intensity_deviation(self) -> float:
        """Standard deviation."""
        ...

    @property
    def label(self) -> int:
        """From 1."""
        ...

    @property
    def mean_intensity(self) -> float:
        """Not part of the signature."""
        ...

    @property
    def name(self) -> str:
        """"7" or, for a component, "7.1"."""
        ...

    @property
    def signature(self) -> ShapeSignature:
        """A ShapeSignature."""
        ...

    @property
    def voxels(self) -> int:
        """How many."""
        ...


class ShapeSearchResult:
    """What `find_shape` gives."""
    @property
    def neighbours(self) -> List[ShapeNeighbour]:
        """The nearest first."""
        ...

    @property
    def probability(self) -> float:
        """That the nearest is of the same shape, on generated shapes."""
        ...

    @property
    def unknown(self) -> bool:
        """More likely than not it is none of them."""
        ...


class ShapeSignature:
    """What a shape is like, in numbers that neither place, rotation nor sampling change much."""
    @property
    def displacement(self) -> NDArray[Any]:
        """25 values, ascending: mean square of the way of heat that cannot leave, over r^2."""
        ...

    @property
    def elongation(self) -> float:
        """Longest over middle standard deviation; from 1."""
        ...

    @property
    def flatness(self) -> float:
        """Middle over shortest standard deviation; from 1."""
        ...

    @property
    def remaining_heat(self) -> NDArray[Any]:
        """25 values from 1 down: the share of heat that has not left the shape."""
        ...

    @property
    def spectrum(self) -> NDArray[Any]:
        """20 eigenvalues of the surface above 0, times its area; 8 pi is the first one of a sphere."""
        ...

    @property
    def surface(self) -> float:
        """mm^2."""
        ...

    @property
    def times(self) -> NDArray[Any]:
        """25 times t / r^2 of both curves; r is the radius of the ball of the same volume."""
        ...

    @property
    def volume(self) -> float:
        """mm^3."""
        ...


class ShapeTable:
    """What `describe_shapes` gives."""
    @property
    def rows(self) -> List[ShapeRow]:
        """By label, then component."""
        ...

    @property
    def warnings(self) -> List[str]:
        """What was left out, a line for each."""
        ...


class ShapetonResult:
    """What `diffuse_shapetons` gives."""
    @property
    def change(self) -> float:
        """Of the density in the last step (3.10)."""
        ...

    @property
    def coverage(self) -> float:
        """Share of the object voxels that were reached, 0 to 1."""
        ...

    @property
    def density(self) -> Image:
        """Visits over the greatest number of visits, in [0, 1]; float32, made when it is asked for."""
        ...

    @property
    def distance(self) -> float:
        """Length of a step, in units of the longest side."""
        ...

    @property
    def histogram(self) -> HeatHistogram:
        """A row for each of histogram_steps."""
        ...

    @property
    def reason_of_distance(self) -> str:
        """Why, where feature_size chose it; else empty."""
        ...

    @property
    def shapetons(self) -> int:
        """How many there were."""
        ...

    @property
    def steady(self) -> bool:
        """Whether the density has become steady."""
        ...

    @property
    def time_step(self) -> int:
        """The last step that was taken."""
        ...

    @property
    def trapped(self) -> int:
        """Shapetons in voxels that are cut off from all neighbours."""
        ...

    @property
    def visits(self) -> Image:
        """Of each voxel; uint32. They sum to shapetons x steps."""
        ...


class SurfaceHandle:
    """A place where a flattened surface has a handle."""
    @property
    def flat_place(self) -> NDArray[Any]:
        """On the map, mm."""
        ...

    @property
    def genus(self) -> int:
        """How many handles: more than 1 where they cannot be told apart."""
        ...

    @property
    def place(self) -> NDArray[Any]:
        """LPS, mm."""
        ...

    @property
    def radius(self) -> float:
        """mm."""
        ...

    @property
    def vertices(self) -> List[int]:
        """Of the surface that was flattened, ascending."""
        ...


class SurfaceSpectrum:
    """The smoothest eigenfunctions of a surface of n vertices."""
    def diffusion_distance(self, p: int, q: int, time: float) -> float:
        """The L2 distance of the heats that two vertices have sent out by `time` (mm^2); 1/mm."""
        ...

    def diffusion_distances(self, p: int, time: float) -> NDArray[Any]:
        """The distances from vertex p to all vertices, n values; 1/mm."""
        ...

    @property
    def eigenfunctions(self) -> NDArray[Any]:
        """n x k, in columns; 1/mm. A view."""
        ...

    @property
    def eigenvalues(self) -> NDArray[Any]:
        """k, ascending from 0; 1/mm^2."""
        ...

    def heat_kernel(self, p: int, q: int, time: float) -> float:
        """Heat at vertex q after `time` (mm^2) of a unit source at vertex p; 1/mm^2."""
        ...

    @property
    def residuals(self) -> NDArray[Any]:
        """k, relative to the largest eigenvalue."""
        ...

    def share_of_last_pair(self, time: float) -> float:
        """What the last pair has still at `time` (mm^2): the order of what is missing."""
        ...

    def signature(self, time: float) -> NDArray[Any]:
        """The heat kernel signature, n values: the heat that each vertex keeps of a unit source at it; 1/mm^2."""
        ...

    def signature_times(self, number: int=...) -> List[float]:
        """Times (mm^2) at which the signature is worth to be looked at, even in the logarithm."""
        ...


def build_colon(ct: Image, *, lumen: Optional[Image]=..., patient_position: str=..., seed_points: ArrayLike=..., faces: int=..., keep_pieces: bool=..., keep_partial: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonModel:
    """From a CT colonography in HU to lumen, cleansed CT, centreline, valve, distension and wall.

    lumen: a mask (uint8, not 0) on the grid of the CT in place of the automatic one. patient_position, seed_points: see
    `segment_lumen`. faces, keep_pieces: see `build_wall`. keep_partial: where the colon is not distended or tagged enough,
    goes on as far as that leads.

    A colon that cannot be used is no exception: `failure` tells why.
    """
    ...

def build_colon_of_lumen(lumen: Image, *, seed_points: ArrayLike=..., faces: int=..., keep_pieces: bool=..., keep_partial: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonModel:
    """From a mask of the lumen alone (uint8, not 0); parameters as those of `build_colon`."""
    ...

def build_wall(occupancy: Image, centreline: Union[Curves, NDArray[Any]], *, faces: int=..., bridge_radius: float=..., keep_pieces: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonWall:
    """The wall as surfaces, from the occupancy that `cleanse` gives.

    centreline: as `trace_centreline` gives it. faces: of the simplified wall; 0: a number that suits it.
    bridge_radius: of tubes through gaps, mm. keep_pieces: leaves the pieces of a broken lumen apart.
    """
    ...

def build_wall_of_mask(mask: Image, centreline: Union[Curves, NDArray[Any]], *, faces: int=..., bridge_radius: float=..., keep_pieces: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonWall:
    """The wall from a mask of the lumen (uint8, not 0); parameters as those of `build_wall`."""
    ...

def classify_heat(heat: Image, components: Sequence[ShapeComponent]=..., *, maximum_classes: int=..., background_heat: float=..., minimum_share: float=..., minimum_peak_to_valley: float=...) -> Tuple[Image, List[HeatClass]]:
    """The classes of a heat image: the lines of its histogram, cut at the valleys between them.

    heat: in [0, 1]. components: those of `HeatResult`, to count them by class. maximum_classes: besides the background.
    background_heat: lines whose peak lies below belong to the background. minimum_share: least share of the voxels above
    the background that makes a class. minimum_peak_to_valley: least ratio of the lower peak and the valley of neighbours.

    Returns (labels, classes): an image of uint8 and a list of HeatClass.
    """
    ...

def classify_visits(visits: Image) -> Tuple[Image, List[HeatClass]]:
    """The classes of a uint32 image of visits, as `classify_heat` finds those of heat: (labels, classes)."""
    ...

def cleanse(ct: Image, lumen: ColonLumen, *, progress: Optional[Callable[[float, str], object]]=...) -> CleansedColon:
    """Removes the tagged fluid of a colon from the CT that `lumen` was found in."""
    ...

def colon_phantom(*, seed: int=..., position: str=..., preset: str=..., size: Sequence[int]=..., spacing: Sequence[float]=..., truth_only: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonPhantom:
    """A synthetic patient for CT colonography.

    seed: fixes the patient. position: "supine", "prone", "leftDecubitus" or "rightDecubitus". preset: "standard", "hard" or
    "realistic". size: voxels along x, y, z. spacing: along x, y, z, mm; the patient needs about 358 x 358 x 336 mm.
    truth_only: leaves the CT out, which takes most of the time.
    """
    ...

def compare_graphs(a: Graph, b: Graph, seed: int=..., *, progress: Optional[Callable[[float, str], object]]=...) -> GraphComparison:
    """Decides whether two graphs are isomorphic, embeds both and tells what differs.

    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def complete_bipartite_graph(left: int, right: int) -> Graph:
    """Each left node with each right one."""
    ...

def complete_graph(nodes: int) -> Graph:
    """Each node joined with each other one."""
    ...

def conformal_map(mesh: Mesh, *, domain: str=..., outer_boundary: int=..., inner_boundary: int=..., corners: Sequence[int]=..., edge_lengths: Optional[ArrayLike]=..., progress: Optional[Callable[[float, str], object]]=...) -> ConformalMap:
    """Maps an open surface conformally to the plane.

    mesh: one manifold, oriented component with a boundary. domain: "rectangle", "annulus" or "slit".
    outer_boundary, inner_boundary: numbers from 1 by length; 0: the longest, and the longest one left.
    corners: four vertices of the only boundary of a rectangle. edge_lengths: another metric, by `surface_edges`.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def describe_shapes(image: Image, labels: Image, *, components: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ShapeTable:
    """The signature of each label, or of each connected component of each label.

    image: intensities, for mean_intensity alone. labels: whole numbers from 0 (background) to 65535, on the same grid.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.

    A shape takes half a second. What has fewer than 64 voxels or is too thin is left out with a warning.
    """
    ...

def diffuse_heat(image: Image, *, p: Optional[float]=..., window: Optional[Tuple[float, float]]=..., time_steps: int=..., time_step_length: float=..., tolerance: float=..., method: str=..., conductance: str=..., ignore_spacing: bool=..., until_steady: bool=..., histogram_steps: Sequence[int]=..., snapshot_steps: Sequence[int]=..., snapshot: Optional[Callable[[int, Image], object]]=..., components: bool=..., initial_heat: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> HeatResult:
    """Cumulative heat diffusion: describes each voxel by the heat it holds after diffusion from all voxels at once.

    image: intensities; float32 and C-contiguous ones are read in place. Any spacing.
    p: steepness, from 0; an edge insulates where the half gradient reaches 1 / p. None: chosen from noise and edges.
    window: (lower, upper) intensities that count as 0 and 1; None: the least and the greatest.
    time_steps: at least 1. Few show local shape, many whole objects.
    time_step_length: in (0, 1/12].
    tolerance: bound of the error of the heat, 1e-6 to 1.
    method: "chebyshev" or "explicit". conductance: "physical" or "published".
    ignore_spacing: treats voxels as cubes.
    until_steady: stops when the heat is steady.
    histogram_steps: ascending steps that become rows of the histogram, see `recorded_steps`.
    snapshot_steps, snapshot: snapshot(step, image) is called with the heat after each of these ascending steps.
    components: finds components and their converged heat. initial_heat: gives the heat at step 0, too.
    progress: called with (share, stage) ten times a second; False, or an exception such as that of Ctrl-C, aborts.

    The heat is the same bytes for any number of threads. Memory: about 8 float32 fields, 13 with a histogram.
    """
    ...

def diffuse_over_surface(mesh: Mesh, values: ArrayLike, time: float, *, progress: Optional[Callable[[float, str], object]]=...) -> NDArray[Any]:
    """Smooths values over a surface by heat flow of `time` mm^2, from 0; a new array of the shape of `values`.

    values: n, or n x k in columns. Time goes in two implicit steps: what has the eigenvalue x of the surface is multiplied by
    (1 + x time / 2)^-2, where the heat equation itself has exp(-x time). For that one use `spectrum`.

    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def diffuse_shapetons(image: Image, *, mask: Optional[Image]=..., p: float=..., window: Optional[Tuple[float, float]]=..., shapetons: Optional[int]=..., distance: float=..., feature_size: Optional[float]=..., time_steps: int=..., direction_sampling: str=..., path_rule: str=..., placement: str=..., seed: int=..., until_steady: bool=..., epsilon: Optional[float]=..., histogram_steps: Sequence[int]=..., progress: Optional[Callable[[float, str], object]]=...) -> ShapetonResult:
    """Shapeton diffusion: counts the visits of particles that move at random through a volume.

    image: intensities; float32 and C-contiguous ones are read in place. mask: shapetons start where it is not 0.
    p: steepness, from 0. window: (lower, upper) intensities that count as 0 and 1; None: the least and the greatest.
    shapetons: how many; None: 65000, or as many as feature_size asks for.
    distance: length of a step in (0, 1], in units of the longest side of the volume.
    feature_size: mm; chooses distance, and shapetons where they are None.
    time_steps: at least 1.
    direction_sampling: "solidAngle", "sectorArea" or "uniform". path_rule: "endpoint" or "traversal".
    placement: "uniform" or "initialHeat". seed: the same gives the same visits.
    until_steady: stops when the density changes by less than epsilon (3.10); None: chosen from the run.
    histogram_steps: ascending steps, from 1, that become rows of the histogram.
    progress: called with (share, stage) ten times a second; False, or an exception such as that of Ctrl-C, aborts.

    The visits are the same bytes for any number of threads.
    """
    ...

def edge_lengths(mesh: Mesh) -> NDArray[Any]:
    """The straight lengths of the edges in the order of `surface_edges`, e values; mm."""
    ...

def embed_graph(graph: Graph, *, genus: Optional[int]=..., rotation: Optional[Sequence[Sequence[int]]]=..., seed: int=..., augmentation: str=..., infinity: str=..., progress: Optional[Callable[[float, str], object]]=...) -> EmbeddingCertificate:
    """Embeds a graph without crossings by a circle packing, found by discrete Ricci flow.

    genus: of the surface: 0 sphere, 1 flat torus, from 2 hyperbolic; None: the smallest that is found.
    rotation: for each node the half-edges that leave it, counterclockwise, in place of a search.
    seed: of the search. augmentation: "ring" adds dummies where no packing exists, "none" does not.
    infinity: "circle" or "edgeNode", of the sphere.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def enclosed_volume(mesh: Mesh) -> float:
    """mm^3, of a closed oriented surface; negative where its faces look inwards."""
    ...

def find_candidates(wall: Mesh, lumen: Image, *, centreline: Optional[Union[Curves, NDArray[Any]]]=..., ct: Optional[Image]=..., flat: FlatColon=..., segments: Optional[Mesh]=..., catheter: Optional[Union[Curves, NDArray[Any]]]=..., preset: str=..., sensitivity: float=..., progress: Optional[Callable[[float, str], object]]=...) -> List[PolypCandidate]:
    """Polyp candidates on the wall of a colon, by falling score. For research use; a candidate is no finding.

    wall: of full resolution, without handles (`ColonWall.repaired`). lumen: uint8, not 0, on the grid of the CT.
    What else is known tells more about a candidate: centreline (with the valve), ct (HU, cleansed), flat (FlatColon),
    segments (`ColonLandmarks.segments`), catheter (`ColonLumen.catheter`).
    preset: "default" or "published". sensitivity: 0 to 1.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def find_folds(flat: FlatColon, *, scheme: str=..., minimum_length: float=..., minimum_area: float=..., minimum_elongation: float=..., minimum_angle: float=..., smoothing_time: float=..., smoothness: float=..., taeniae: Optional[Union[Curves, NDArray[Any]]]=..., progress: Optional[Callable[[float, str], object]]=...) -> HaustralFolds:
    """Haustral folds on the flat wall of a colon.

    scheme: "graphCut" or "published". minimum_length: mm; minimum_area: mm^2; minimum_elongation: long over short axis;
    minimum_angle: against the tube, degrees. smoothing_time: of the curvature, mm^2. smoothness: cost of outline.
    taeniae: Curves on the wall along which folds that have grown together are split.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def find_in_other_position(map: Mesh, candidates: Sequence[PolypCandidate], others: Sequence[PolypCandidate], *, confidence: Optional[float]=...) -> List[PolypCandidate]:
    """The candidates with `other` set, by a map of `Registration`.

    map: `Registration.supine_to_prone`, where the candidates are supine. others: the candidates of the other position.
    confidence: that of the registration, 0 to 1; where given, scores are weighed by what is seen there: a polyp stays where
    it is, most stool moves.
    """
    ...

def find_landmarks(flat: FlatColon, centreline: Union[Curves, NDArray[Any]], *, flexure_rule: str=..., taenia_rule: str=..., markers: ArrayLike=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonLandmarks:
    """Flexures, segments, folds on the surface and taeniae of a flat colon.

    flat: FlatColon. centreline: as `trace_centreline` gives it. flexure_rule: "ordered" or "published". taenia_rule: "joint"
    or "published". markers: k x 3, LPS mm: points on taeniae that a person has marked.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.

    A landmark that is not found is no exception: it is absent and `warnings` say why.
    """
    ...

def find_shape(signature: ShapeSignature, entries: Sequence[NamedShape], nearest: int=...) -> ShapeSearchResult:
    """Looks a signature up among entries, a list of NamedShape; `nearest` neighbours at most."""
    ...

def find_valve(labels: Image, centreline: Union[Curves, NDArray[Any]], ct: Optional[Image]=...) -> Tuple[Optional[IleocaecalValve], str]:
    """The ileocaecal valve: (IleocaecalValve or None, why it was not found).

    labels: the lumen, not 0. centreline: as `trace_centreline` gives it. ct: HU on the same grid; None: by shape alone.
    """
    ...

def flatten_tube(mesh: Mesh, centreline: Optional[Union[Curves, NDArray[Any]]]=..., *, metric: str=..., time: float=..., eigenpairs: int=..., remove_handles: bool=..., method: str=..., cut: Optional[Union[Curves, NDArray[Any]]]=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonFlattening:
    """Maps a tube, such as the wall of a colon, conformally to a rectangle.

    mesh: one manifold, oriented component with two boundary loops. centreline: from the rectum to the caecum; tells the
    rectum where the surface does not name it.
    metric: "heatDiffusion", "euclidean" or "truncatedHeatDiffusion". time: of diffusion, mm^2; 0: one that suits the mesh.
    eigenpairs: of truncatedHeatDiffusion. remove_handles: finds handles and cuts them out.
    method: "conjugate" or "published". cut: a curve near which the tube is cut, Curves or k x 3; None: a path is found.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def grid_graph(columns: int, rows: int) -> Graph:
    """Node (c, r) is r * columns + c."""
    ...

def heat_diffusion_metric(mesh: Mesh, time: Optional[float]=..., *, pairs: Optional[int]=..., progress: Optional[Callable[[float, str], object]]=...) -> HeatDiffusionMetric:
    """The heat diffusion distances of the ends of all edges, as new lengths of edges.

    mesh: one manifold component. time: of diffusion, mm^2; None: 8 times the square of the mean edge at 55,000 faces.
    pairs: takes so many eigenpairs alone, as published; None: all of them, without computing any.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def heat_histogram(heats: Sequence[Image], time_steps: Sequence[int]) -> HeatHistogram:
    """The histogram of heats that exist already, one row for each; time_steps ascend."""
    ...

def hypercube_graph(dimension: int) -> Graph:
    """2^dimension nodes; those that differ in one bit are joined."""
    ...

def implied_category(candidates: Sequence[PolypCandidate]) -> str:
    """What the sizes of the candidates alone would imply by C-RADS, in words."""
    ...

def inspect_surface(mesh: Mesh) -> Dict[str, Any]:
    """Topology, measures and defects of a surface, as a dictionary with the keys that SurfaceInspector writes.

    vertices, edges, faces, eulerCharacteristic, genus (None: not defined), manifold, closed, oriented, area (mm^2), volume
    (mm^3; None of an open one), extent, components, boundaryLoops, edgeLength, smallestAngle (degrees), defects, ...
    """
    ...

def list_series(path: Union[str, os.PathLike[str]], *, progress: Optional[Callable[[float, str], object]]=...) -> List[DicomSeries]:
    """The DICOM series in a folder, searched recursively, or in a file. Reads headers.

    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def measure_distension(centreline: Union[Curves, NDArray[Any]]) -> List[SegmentDistension]:
    """How far each segment is distended, by customary shares of the length."""
    ...

def read_certificate(path: Union[str, os.PathLike[str]]) -> EmbeddingCertificate:
    """Reads a certificate (JSON)."""
    ...

def read_curves(path: Union[str, os.PathLike[str]]) -> Curves:
    """Reads the lines and points of a VTP file, such as a centreline."""
    ...

def read_graph(path: Union[str, os.PathLike[str]]) -> Graph:
    """Reads GraphML, GML, DOT, edge lists, METIS, MATPOWER, PACE, graph6 or sparse6."""
    ...

def read_position(folder: Union[str, os.PathLike[str]], name: str) -> ColonPosition:
    """Reads a ColonPosition from a folder that VirtualColonoscopy has written."""
    ...

def read_shape_database(path: Union[str, os.PathLike[str]]) -> List[NamedShape]:
    """All shapes of an SQLite file of the tool ShapeSearch, in the order in which they were added."""
    ...

def read_shape_table(path: Union[str, os.PathLike[str]]) -> ShapeTable:
    """Reads what `write_shape_table` wrote."""
    ...

def read_surface(path: Union[str, os.PathLike[str]], *, part: str=..., component: int=..., unit: str=..., any_extent: bool=..., repair: bool=...) -> Mesh:
    """Reads VTP, STL, OBJ, PLY, OFF, glTF or GLB; LPS, mm.

    part: the name of a part of the file; "" for all. component: from 1, by number of faces; 0: there must be one; -1: all.
    unit: "m", "mm" or "um" in place of that of the format; then any extent is taken. any_extent: takes a surface that is not
    between 5 mm and 5 m wide, with a note. repair: mends what `repair_surface` mends.

    What was changed or doubtful is in the `notes` of the mesh.
    """
    ...

def read_volume(path: Union[str, os.PathLike[str]], *, series_uid: str=..., resample_gaps: bool=..., deshear: bool=..., drop_duplicates: bool=..., allow_single_slice: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> Image:
    """Reads a folder of DICOM slices, a DICOM file, or a NRRD, NIfTI or MetaImage file.

    An irregular series is refused with InputError that names the defect, unless its repair is allowed:

    series_uid: which series to take where the folder holds several (`DicomSeries.selector`).
    resample_gaps: fills gaps and uneven spacing by interpolation between slices.
    deshear: resamples a tilted volume onto perpendicular axes.
    drop_duplicates: keeps the first of several slices at one position.
    allow_single_slice: takes one slice as a volume.
    progress: of DICOM slices, called with (share, stage); False, or an exception such as that of Ctrl-C, aborts.

    The image holds float32, rescaled: Hounsfield units for CT. Its `facts` tell modality, patient_position, series_uid,
    identity, repairs, notes. A file of another format is read in one piece, which Ctrl-C waits for.
    """
    ...

def recorded_steps(last: int, number: int, spacing: str=...) -> List[int]:
    """At most `number` distinct time steps from 0 to `last`, for histogram_steps; spacing: "linear", as the tool records them, or "logarithmic"."""
    ...

def register_positions(supine: ColonPosition, prone: ColonPosition, *, map: str=..., matching: str=..., refine: bool=..., segment_wise: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> Registration:
    """A one-to-one map between the walls of a colon in two positions.

    map: "default" or "published". matching: of folds, "hungarian" or "dualDecomposition". refine: by the curvature of the
    wall itself. segment_wise: folds keep to their segment.
    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def remesh_surface(mesh: Mesh, edge_length: float, *, iterations: int=..., progress: Optional[Callable[[float, str], object]]=...) -> Mesh:
    """A surface of nearly equilateral triangles with edges of this length (mm). Its arrays are left out."""
    ...

def repair_surface(mesh: Mesh, *, merge_distance: float=..., merge_vertices: bool=..., orient: bool=..., split: bool=...) -> Tuple[Mesh, List[str]]:
    """A manifold, consistently oriented surface of the same faces: (mesh, what was done in words).

    merge_vertices: merges vertices nearer than merge_distance (mm; 0: at one position). orient: turns faces so that
    neighbours agree. split: cuts where the surface is not manifold.
    """
    ...

def seeds_of_classes(classes: Image, *, chosen: Sequence[int]=..., components: int=...) -> Image:
    """Seeds from classes, such as those of `classify_heat`; one voxel off the borders of each.

    classes: whole numbers. chosen: which ones; none: all but 0. components: 0: one label for each class; else so many of
    the largest components of each, of a label each. Labels count from 1 in the order of the classes.
    """
    ...

def segment_lumen(ct: Image, *, patient_position: str=..., seed_points: ArrayLike=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonLumen:
    """Finds gas and tagged fluid of the colon in a CT colonography, without seeds.

    ct: Hounsfield units; any axes, spacing about 0.5 to 3 mm. patient_position: "HFS", "HFP", ..., "supine", "prone",
    "leftDecubitus", "rightDecubitus"; "": gravity is inferred from fluid levels.
    seed_points: k x 3, LPS mm; the pieces of gas or fluid that hold them are colon.
    """
    ...

def set_threads(number: int) -> None:
    """Sets how many threads all functions of this process use; results do not depend on it."""
    ...

def signature_distance(a: ShapeSignature, b: ShapeSignature) -> float:
    """How much two signatures differ, from 0; copies of one shape are about 1 apart. Volume takes no part."""
    ...

def simplify_surface(mesh: Mesh, faces: int, *, smallest_angle: float=..., boundary_weight: float=..., progress: Optional[Callable[[float, str], object]]=...) -> Mesh:
    """A surface of at most so many faces with the same topology, by edge collapses. Its arrays are left out.

    smallest_angle: degrees, 0 to 30; no collapse makes a smaller one. boundary_weight: of boundary edges against faces.
    """
    ...

def spectrum(mesh: Mesh, pairs: int=..., *, progress: Optional[Callable[[float, str], object]]=...) -> SurfaceSpectrum:
    """The `pairs` smallest eigenpairs of the Laplacian of a surface that is one manifold component.

    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def split_colon(landmarks: ColonLandmarks, *, progress: Optional[Callable[[float, str], object]]=...) -> Tuple[List[ColonPiece], List[str]]:
    """Cuts the wall into its segments and maps each to a rectangle: (list of ColonPiece, warnings).

    progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.
    """
    ...

def surface_area(mesh: Mesh) -> float:
    """mm^2."""
    ...

def surface_edges(mesh: Mesh) -> NDArray[Any]:
    """The edges of a surface, e x 2, int32: the lesser vertex first, in their order."""
    ...

def threads() -> int:
    """How many threads the functions of this process use."""
    ...

def torus_grid(columns: int, rows: int, diagonals: bool=...) -> Tuple[Graph, List[List[int]]]:
    """The grid that closes in both directions, drawn on the torus: (Graph, rotation), see `embed_graph`."""
    ...

def trace_centreline(lumen: Image, *, start: Optional[ArrayLike]=..., seed_points: ArrayLike=..., exponent: int=..., minimum_volume: float=..., step: float=..., smoothing: float=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonCentreline:
    """The centreline of the colon from a mask of its lumen (uint8, not 0).

    start: where it begins in the rectum, LPS mm; None: found. seed_points: k x 3, LPS mm; pieces next to them are used.
    exponent: one mm of path costs 1 / (distance to the wall)^exponent. minimum_volume: of a piece of lumen, ml.
    step: between points of the line, mm. smoothing: standard deviation along the line, mm.
    """
    ...

def verify_embedding(certificate: EmbeddingCertificate) -> EmbeddingVerdict:
    """Proves from its numbers alone that no two edges of an embedding cross, or tells what fails."""
    ...

def visit_density(visits: Image) -> Image:
    """Visits over the greatest number of visits: float32 in [0, 1]."""
    ...

def write_certificate(certificate: EmbeddingCertificate, path: Union[str, os.PathLike[str]]) -> None:
    """Writes a certificate as JSON; numbers read back as they were."""
    ...

def write_curves(curves: Union[Curves, NDArray[Any]], path: Union[str, os.PathLike[str]]) -> None:
    """Writes curves as VTP with their arrays and facts; equal curves give equal bytes."""
    ...

def write_graph(graph: Graph, path: Union[str, os.PathLike[str]]) -> None:
    """Writes GraphML."""
    ...

def write_shape_table(table: ShapeTable, path: Union[str, os.PathLike[str]]) -> None:
    """Writes a CSV file, as the tool ShapeSignature does."""
    ...

def write_surface(mesh: Mesh, path: Union[str, os.PathLike[str]]) -> None:
    """Writes VTP (all arrays and facts), STL, PLY or OBJ by the extension; equal surfaces give equal bytes."""
    ...

def write_volume(image: Image, path: Union[str, os.PathLike[str]], metadata: Sequence[Tuple[str, str]]=...) -> None:
    """Writes NRRD (.nrrd), NIfTI (.nii, .nii.gz) or MetaImage (.mha), as the tools do.

    float32, int16, uint8, uint16 and uint32 are written as they are, bool as uint8, float64 as float32 where that rounds no
    voxel; ParameterError otherwise and for other types, so that a file always holds the values of the image. metadata: pairs
    of texts for the header of NRRD and MetaImage.
    """
    ...
