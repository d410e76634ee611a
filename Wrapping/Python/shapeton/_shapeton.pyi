"""Written by make_stub.py from the docstrings of the module; do not edit."""

import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike, NDArray

from .image import Image
from .mesh import Curves, Mesh

class Error(Exception):
    """Base class of all exceptions of Shapeton."""

class ParameterError(Error, ValueError):
    """A parameter is out of range or contradicts another one; also a ValueError."""

class InputError(Error, ValueError):
    """The input is missing, unreadable, malformed or unsuitable; also a ValueError."""

class OutputError(Error, OSError):
    """A result cannot be written; also an OSError."""

class Aborted(Error, RuntimeError):
    """A progress function returned False; also a RuntimeError."""

class CenterlineGap:
    """A section without lumen, bridged by the centerline."""
    @property
    def begin(self) -> float:
        """Start along the line, mm."""
        ...

    @property
    def distance(self) -> float:
        """Straight distance between the ends of the lumen, mm."""
        ...

    @property
    def end(self) -> float:
        """End along the line, mm."""
        ...

    @property
    def is_doubtful(self) -> bool:
        """Whether it is longer than known collapsed segments."""
        ...


class CleansedColon:
    """Result of `cleanse`."""
    @property
    def ct(self) -> Image:
        """float32, HU: the CT with fluid replaced by gas."""
        ...

    @property
    def occupancy(self) -> Image:
        """float32, 0 to 1, cropped: lumen fraction of each voxel; the wall is the 0.5 isosurface."""
        ...


class ColonCenterline:
    """The centerline of a colon from the rectum to the cecum."""
    @property
    def coverage(self) -> float:
        """Fraction of the lumen along the line, 0 to 1."""
        ...

    @property
    def curve(self) -> Curves:
        """One curve; point arrays arcLength (mm), radius (mm), gap (1 on a bridge)."""
        ...

    @property
    def gaps(self) -> List[CenterlineGap]:
        """Bridged gaps."""
        ...

    @property
    def length(self) -> float:
        """mm."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""
        ...


class ColonFlattening:
    """A flattened tube with its measurements."""
    @property
    def circumference(self) -> float:
        """Mean circumference, mm."""
        ...

    @property
    def flat(self) -> Mesh:
        """The tube cut open: points in space, the point arrays uv (mm: along, around) and sourcePointId, the field arrays circumference and length (mm)."""
        ...

    @property
    def genus_after(self) -> int:
        """Number of handles of the flattened surface."""
        ...

    @property
    def genus_before(self) -> int:
        """Number of handles of the input surface."""
        ...

    @property
    def handles(self) -> List[SurfaceHandle]:
        """Handles; most walls have none."""
        ...

    @property
    def length(self) -> float:
        """Length of the map, mm."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of the statistics of ColonFlattening: flips, dilatation, moduli, ..."""
        ...

    @property
    def surface(self) -> Mesh:
        """The flattened surface in space."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""
        ...


class ColonFlexure:
    """A major bend of the colon, found or not."""
    @property
    def arc_length(self) -> float:
        """mm along the centerline."""
        ...

    @property
    def confidence(self) -> float:
        """Probability, 0 to 1, that the true flexure is within 30 mm."""
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
        """Point on the centerline; LPS, mm."""
        ...

    @property
    def reason(self) -> str:
        """Reason why it was not found; otherwise empty."""
        ...


class ColonLandmarks:
    """Result of `find_landmarks`."""
    @property
    def flexure_loops(self) -> Curves:
        """A closed loop on the wall for each flexure found; cell arrays flexure, arcLength, confidence."""
        ...

    @property
    def flexures(self) -> List[ColonFlexure]:
        """Four flexures, starting at the rectum."""
        ...

    @property
    def fold_surface(self) -> Mesh:
        """The flat wall with the cell array fold and the point array meanCurvature (1/mm)."""
        ...

    @property
    def is_mirrored(self) -> bool:
        """Whether the colon is mirrored (situs inversus)."""
        ...

    @property
    def segments(self) -> Mesh:
        """The flat wall with the cell array segment: 1 rectum to 6 cecum, 0 unknown."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of landmarks.json of ColonLandmarks."""
        ...

    @property
    def taeniae(self) -> Curves:
        """Three curves on the wall, or none; point arrays arcLength (mm), uv (mm), confidence, cell array taenia."""
        ...

    @property
    def valve(self) -> Optional[IleocecalValve]:
        """The valve stored in the centerline, or None."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Missing landmarks, one per line."""
        ...


class ColonLumen:
    """Result of `segment_lumen`."""
    @property
    def catheter(self) -> Optional[Curves]:
        """Axis of a rectal catheter as Curves; None unless one was found with certainty."""
        ...

    @property
    def failure(self) -> str:
        """Reason why the colon is not usable; otherwise empty."""
        ...

    @property
    def gravity(self) -> NDArray[Any]:
        """Unit vector of gravity, LPS."""
        ...

    @property
    def is_tagged(self) -> bool:
        """Whether fluid brighter than tissue was found below the gas of the colon."""
        ...

    @property
    def labels(self) -> Image:
        """uint8: 1 gas, 2 fluid, 0 otherwise."""
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
        """Missing or doubtful results, one per line."""
        ...


class ColonModel:
    """A colon: lumen, centerline and wall."""
    @property
    def centerline(self) -> ColonCenterline:
        """ColonCenterline; its curve includes the valve."""
        ...

    @property
    def cleansed(self) -> Image:
        """float32, HU; None for a mask."""
        ...

    @property
    def distension(self) -> List[SegmentDistension]:
        """Distension of the segments."""
        ...

    @property
    def failure(self) -> str:
        """Reason why the colon is not usable; otherwise empty."""
        ...

    @property
    def lumen(self) -> ColonLumen:
        """ColonLumen."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of quality.json of ColonSegmentation."""
        ...

    @property
    def valve(self) -> Optional[IleocecalValve]:
        """IleocecalValve; None if it was not found."""
        ...

    @property
    def wall(self) -> ColonWall:
        """ColonWall."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Warnings of all stages, one per line."""
        ...


class ColonPhantom:
    """A synthetic patient for CT colonography, with ground truth."""
    @property
    def centerline(self) -> Curves:
        """The true centerline, from the anal verge to the cecum."""
        ...

    @property
    def ct(self) -> Image:
        """int16, HU; None if only the ground truth was requested."""
        ...

    @property
    def lumen(self) -> Image:
        """uint8: 1 gas, 2 fluid."""
        ...

    @property
    def segments(self) -> Image:
        """uint8: 1 rectum to 6 cecum."""
        ...


class ColonPiece:
    """A segment of the colon, cut open along a taenia and flattened."""
    @property
    def area(self) -> float:
        """mm^2."""
        ...

    @property
    def flat(self) -> Mesh:
        """Surface in space, with the point array uv (mm on the rectangle)."""
        ...

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle: an upper bound."""
        ...

    @property
    def modulus_v(self) -> float:
        """Height over width of the rectangle: a lower bound."""
        ...

    @property
    def name(self) -> str:
        """Name of the segment."""
        ...

    @property
    def segment(self) -> int:
        """1 rectum to 6 cecum."""
        ...


class ColonPosition:
    """The colon in one position, for registration.

    name: "supine" or "prone", for messages. landmarks: from `find_landmarks`. centerline: Curves.
    folds: from `find_folds`.
    """
    def __init__(self, name: str, landmarks: ColonLandmarks, centerline: Union[Curves, NDArray[Any]], folds: HaustralFolds) -> None: ...

    @property
    def name(self) -> str:
        """Name used in messages."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Missing inputs that the registration does not require."""
        ...


class ColonThresholds:
    """Intensities in HU, all estimated from the data."""
    @property
    def fluid(self) -> float:
        """Mode of tagged fluid; 0 without fluid."""
        ...

    @property
    def fluid_boundary(self) -> float:
        """Mean of tissue and fluid."""
        ...

    @property
    def gas(self) -> float:
        """Typical gas inside the body."""
        ...

    @property
    def gas_boundary(self) -> float:
        """Mean of gas and tissue: the boundary of the wall."""
        ...

    @property
    def tissue(self) -> float:
        """Typical soft tissue."""
        ...


class ColonWall:
    """The wall of a colon in three forms, each open at rectum and cecum."""
    @property
    def genus_after(self) -> int:
        """Number of handles of the repaired wall."""
        ...

    @property
    def genus_before(self) -> int:
        """Number of handles of the raw wall."""
        ...

    @property
    def raw(self) -> Mesh:
        """The extracted surface, with all handles."""
        ...

    @property
    def repaired(self) -> Mesh:
        """The surface without handles, smoothed."""
        ...

    @property
    def simplified(self) -> Mesh:
        """The repaired surface with fewer faces."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""
        ...


class ConformalMap:
    """A planar map of a surface, with quality measures."""
    @property
    def corners(self) -> List[int]:
        """Four corner vertices, for a rectangle with one boundary."""
        ...

    @property
    def dilatation(self) -> NDArray[Any]:
        """Dilatation of each face, at least 1 (conformal)."""
        ...

    @property
    def flat(self) -> Mesh:
        """The cut surface in space with the point array uv (mm in the plane)."""
        ...

    @property
    def flips(self) -> int:
        """Number of flipped faces."""
        ...

    @property
    def genus(self) -> int:
        """Genus; 0 without handles."""
        ...

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle, or 2 pi / ln(R / r)."""
        ...

    @property
    def modulus_v(self) -> float:
        """The modulus from the conjugate; the gap is the error bar."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of the statistics of ConformalMap."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""
        ...


class DicomDefect:
    """A defect or peculiarity of a DICOM series."""
    @property
    def advice(self) -> str:
        """Possible remedy."""
        ...

    @property
    def files(self) -> List[str]:
        """The affected files."""
        ...

    @property
    def message(self) -> str:
        """The defect as a sentence."""
        ...

    @property
    def name(self) -> str:
        """For example "gap"."""
        ...

    @property
    def slices(self) -> List[int]:
        """The affected slices, counted from 1 along the normal."""
        ...


class DicomSeries:
    """A DICOM series of a folder; see `list_series`."""
    @property
    def defects(self) -> List[DicomDefect]:
        """Defects that prevent reading the series without repair."""
        ...

    @property
    def description(self) -> str:
        """Series Description."""
        ...

    @property
    def is_usable(self) -> bool:
        """Whether a volume can be read without repair."""
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
        """Reason why this is not a volume, if no defect explains it; otherwise empty."""
        ...

    @property
    def remarks(self) -> List[DicomDefect]:
        """Peculiarities that do not prevent reading."""
        ...

    @property
    def selector(self) -> str:
        """The series_uid for `read_volume`: the UID, with "#part" if needed."""
        ...

    @property
    def size(self) -> Tuple[Any, ...]:
        """Columns, rows, slices: the extents along x, y, z."""
        ...

    @property
    def spacing(self) -> Tuple[Any, ...]:
        """Spacing of columns, rows, slices; mm, 0 if unknown."""
        ...

    @property
    def uid(self) -> str:
        """Series Instance UID."""
        ...


class EmbeddingCertificate:
    """A graph embedded on a surface with its circle packing.

    Positions are unit vectors on the sphere (radius: the angle of a cap), otherwise (x, y) in the plane or in the Poincare
    disk (radius: a length; in the disk, hyperbolic). Half-edge 2e leaves the first end of edge e, 2e + 1 the second.
    """
    @property
    def face_positions(self) -> NDArray[Any]:
        """One row per face of the packed graph; a view."""
        ...

    @property
    def face_radii(self) -> NDArray[Any]:
        """Radii of the circles of the faces; a view."""
        ...

    @property
    def genus(self) -> int:
        """Genus of the surface."""
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
        """One row per packed node, starting with the graph's nodes; a view."""
        ...

    @property
    def node_radii(self) -> NDArray[Any]:
        """Radii of the circles of the packed nodes; a view."""
        ...

    @property
    def packed(self) -> Graph:
        """The 3-connected graph, including dummy nodes."""
        ...

    @property
    def periods(self) -> NDArray[Any]:
        """Periods of the torus: x1, y1, x2, y2; empty on other surfaces."""
        ...

    @property
    def rotation(self) -> List[int]:
        """Outgoing half-edges of all nodes, counterclockwise, in one list."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """Measurements by name."""
        ...

    @property
    def subdivided(self) -> List[List[int]]:
        """Edges subdivided into paths of the packed graph, as half-edges."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""
        ...


class EmbeddingVerdict:
    """Result of `verify_embedding`."""
    @property
    def is_valid(self) -> bool:
        """Whether the absence of crossings is proven."""
        ...

    @property
    def measures(self) -> Dict[str, Any]:
        """Measurements by name."""
        ...

    @property
    def refusal(self) -> str:
        """The first failed condition; otherwise empty."""
        ...


class FlatColon:
    """The flat wall of a colon with a grid of square pixels.

    surface: from `flatten_tube`. pixel_size: mm on the map, used for folds and landmarks.
    """
    def __init__(self, surface: Mesh, pixel_size: float=...) -> None: ...

    @property
    def circumference(self) -> float:
        """Mean circumference, mm."""
        ...

    def coordinates(self) -> NDArray[Any]:
        """Rows x columns x 3, float32: point in space of each pixel, LPS mm; NaN in holes."""
        ...

    def curvature(self) -> NDArray[Any]:
        """Rows x columns, float64: mean curvature, 1/mm; positive where the wall bulges into the lumen, NaN in holes."""
        ...

    def faces(self) -> NDArray[Any]:
        """Rows x columns, int32: the face at each pixel; -1 in holes."""
        ...

    def find(self, points: ArrayLike) -> Tuple[NDArray[Any], NDArray[Any]]:
        """uv on the map (k x 2) of points in space (k x 3, LPS, mm), and their distances from the wall (k); mm."""
        ...

    @property
    def length(self) -> float:
        """Length of the map, mm."""
        ...

    @property
    def pixel_size(self) -> float:
        """mm on the map."""
        ...

    def pixels(self, uv: ArrayLike) -> NDArray[Any]:
        """Pixels [row, column] (k x 2, int32) of points on the map (k x 2, mm). Rows may run against v."""
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

    nodes: their number. edges: m x 2, indices of nodes. names: none, or one per node.
    """
    def __init__(self, nodes: int, edges: ArrayLike, names: Sequence[str]=...) -> None: ...

    @property
    def edges(self) -> NDArray[Any]:
        """m x 2, int32: the ends of each edge; a view."""
        ...

    @property
    def names(self) -> List[str]:
        """None, or one per node."""
        ...

    @property
    def nodes(self) -> int:
        """Number of nodes."""
        ...


class GraphComparison:
    """Comparison of two graphs."""
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
        """Corresponding node of `b.graph` for each node of `a.graph`, or -1."""
        ...

    @property
    def correspondence_by(self) -> str:
        """"isomorphism", "names", "neighborhoods" or "none"."""
        ...

    @property
    def differences(self) -> List[str]:
        """Differences as sentences; empty for isomorphic graphs."""
        ...

    @property
    def isomorphic(self) -> bool:
        """Whether the graphs are isomorphic."""
        ...


class HaustralFold:
    """A haustral fold."""
    @property
    def angle(self) -> float:
        """Angle between the long axis and the tube, degrees; 90 is circumferential."""
        ...

    @property
    def arc_length(self) -> float:
        """mm along the centerline; NaN if unknown."""
        ...

    @property
    def area(self) -> float:
        """mm^2."""
        ...

    @property
    def center(self) -> NDArray[Any]:
        """LPS, mm."""
        ...

    @property
    def center_uv(self) -> NDArray[Any]:
        """Center on the map, mm."""
        ...

    @property
    def crosses_cut(self) -> bool:
        """Whether the fold extends across the cut."""
        ...

    @property
    def elongation(self) -> float:
        """Ratio of long to short axis."""
        ...

    @property
    def ends(self) -> NDArray[Any]:
        """2 x 3; LPS, mm."""
        ...

    @property
    def height(self) -> float:
        """Height of the crest above the wall, mm; NaN if not visible."""
        ...

    @property
    def label(self) -> int:
        """Label value, from 1."""
        ...

    @property
    def length(self) -> float:
        """Length along the crest, mm."""
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
    """Result of `find_folds`."""
    @property
    def folds(self) -> List[HaustralFold]:
        """List of HaustralFold, in label order."""
        ...

    @property
    def labels(self) -> NDArray[Any]:
        """Rows x columns, uint16: 0 wall, otherwise the label of a fold."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Warnings, one per line."""
        ...


class HeatClass:
    """A class of voxels with similar heat: a line of the heat histogram."""
    @property
    def border_share(self) -> float:
        """Fraction of the voxels at the border of the volume, 0 to 1."""
        ...

    @property
    def components(self) -> int:
        """Converged closed components in the class."""
        ...

    @property
    def label(self) -> int:
        """0 is the background, 1 the class of lowest heat."""
        ...

    @property
    def lower_heat(self) -> float:
        """The class contains lower_heat <= heat < upper_heat."""
        ...

    @property
    def mean_heat(self) -> float:
        """Mean heat, in [0, 1]."""
        ...

    @property
    def normalized_heat(self) -> float:
        """Scale-invariant heat of closed components; 0 without any."""
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
        """Number of voxels."""
        ...


class HeatDiffusionMetric:
    """Heat diffusion distances along all edges."""
    @property
    def drowned_edges(self) -> int:
        """Edges with a length below rounding error, for example at the tip of a needle; set to the shortest possible length."""
        ...

    @property
    def edge_lengths(self) -> NDArray[Any]:
        """Edge lengths in the order of `surface_edges`; 1/mm."""
        ...

    @property
    def eigenpairs(self) -> int:
        """Number of eigenpairs; 0 for all."""
        ...

    @property
    def time(self) -> float:
        """mm^2."""
        ...


class HeatHistogram:
    """Counts of voxels by heat, one row per recorded time step."""
    @property
    def counts(self) -> NDArray[Any]:
        """Rows x 4097, uint32: voxels in each bin; a view."""
        ...

    @property
    def edges(self) -> NDArray[Any]:
        """4098 heat values: bin b contains edges[b] <= heat < edges[b + 1]. Bin 0 is the background, the others are 256 per factor of two."""
        ...

    def equalization(self) -> List[float]:
        """4098 numbers from 0 to 1, ascending: the fraction of the counts, without bin 0, below the lower edge of each bin, averaged over the rows."""
        ...

    @property
    def time_steps(self) -> List[int]:
        """Time steps of the rows, ascending."""
        ...


class HeatResult:
    """Result of `diffuse_heat`."""
    @property
    def cold(self) -> bool:
        """Whether the volume has no edges; the heat is then 0 everywhere."""
        ...

    @property
    def components(self) -> List[ShapeComponent]:
        """Largest first; empty unless requested."""
        ...

    @property
    def heat(self) -> Image:
        """Heat after the last step, in [0, 1]; float32, on the grid of the input."""
        ...

    @property
    def histogram(self) -> HeatHistogram:
        """One row per step of histogram_steps reached."""
        ...

    @property
    def initial_heat(self) -> Image:
        """Heat at step 0; None unless requested."""
        ...

    @property
    def p(self) -> float:
        """The p used."""
        ...

    @property
    def reason_of_p(self) -> str:
        """Reason for an automatic p; otherwise empty."""
        ...

    @property
    def steady(self) -> bool:
        """Whether the steady state was reached."""
        ...

    @property
    def time_step(self) -> int:
        """The last step computed."""
        ...

    @property
    def time_step_length(self) -> float:
        """dt, at most 1/12."""
        ...

    @property
    def window(self) -> Tuple[Any, ...]:
        """The intensities mapped to 0 and 1."""
        ...


class IleocecalValve:
    """The opening of the terminal ileum into the colon."""
    @property
    def arc_length(self) -> float:
        """mm along the centerline."""
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
        """Greatest width, mm."""
        ...

    @property
    def position(self) -> NDArray[Any]:
        """LPS, mm."""
        ...

    @property
    def width(self) -> float:
        """Least width, mm."""
        ...


class MatchedFolds:
    """A pair of corresponding folds."""
    @property
    def prone_fold(self) -> int:
        """Label of the prone fold."""
        ...

    @property
    def prone_point(self) -> NDArray[Any]:
        """Center of the prone fold; LPS, mm."""
        ...

    @property
    def residual(self) -> float:
        """Distance between the mapped supine fold and the prone fold, mm."""
        ...

    @property
    def segment(self) -> str:
        """Segment in the supine position; "" if unknown."""
        ...

    @property
    def supine_fold(self) -> int:
        """Label of the supine fold."""
        ...

    @property
    def supine_point(self) -> NDArray[Any]:
        """Center of the supine fold; LPS, mm."""
        ...

    @property
    def weight(self) -> float:
        """Weight of the pair in the map, 0 to 1; pairs below 0.5 are ignored."""
        ...


class NamedShape:
    """A signature with a name, not necessarily unique."""
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
    """A polyp-like location on the wall; not a clinical finding."""
    @property
    def apex(self) -> NDArray[Any]:
        """Most protruding point; LPS, mm."""
        ...

    @property
    def arc_length(self) -> float:
        """mm along the centerline; NaN if unknown."""
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
        """Largest width, mm."""
        ...

    @property
    def height(self) -> float:
        """Height above the surrounding ring, mm."""
        ...

    @property
    def least_diameter(self) -> float:
        """Smallest width, mm."""
        ...

    @property
    def number(self) -> int:
        """Rank by descending score, from 1."""
        ...

    @property
    def other(self) -> Optional[PolypInOtherPosition]:
        """Result in the other position; None if it was not searched."""
        ...

    @property
    def position(self) -> NDArray[Any]:
        """Center of the head; LPS, mm."""
        ...

    @property
    def remark(self) -> str:
        """For example "the ileocecal valve"; otherwise empty."""
        ...

    @property
    def score(self) -> float:
        """Score of shape and tissue, 0 to 1."""
        ...

    @property
    def segment(self) -> int:
        """1 rectum to 6 cecum; 0 unknown."""
        ...

    @property
    def shape_score(self) -> float:
        """Score of the shape only, 0 to 1."""
        ...

    @property
    def size(self) -> str:
        """For example "6-9 mm"."""
        ...

    @property
    def submerged_share(self) -> float:
        """Fraction covered by tagged fluid, 0 to 1."""
        ...

    @property
    def tissue(self) -> str:
        """For example "soft tissue"."""
        ...

    @property
    def uv(self) -> NDArray[Any]:
        """Position on the flat map, mm; NaN without one."""
        ...

    @property
    def vertices(self) -> List[int]:
        """Wall vertices of the head."""
        ...


class PolypInOtherPosition:
    """Position of a candidate in the other position of the patient."""
    @property
    def candidate(self) -> int:
        """Number of the most similar candidate; 0 for none."""
        ...

    @property
    def confidence(self) -> float:
        """Confidence of the registration, 0 to 1."""
        ...

    @property
    def distance(self) -> float:
        """Distance to the most similar candidate in the other position, mm."""
        ...

    @property
    def is_excluded(self) -> bool:
        """Whether the corresponding wall cannot be assessed."""
        ...

    @property
    def is_seen(self) -> bool:
        """Whether a similar candidate was found."""
        ...

    @property
    def likeness(self) -> float:
        """Similarity of location, width and score, 0 to 1."""
        ...

    @property
    def own_score(self) -> float:
        """Score before weighting; otherwise NaN."""
        ...

    @property
    def point(self) -> NDArray[Any]:
        """Point on the other wall; LPS, mm."""
        ...


class Registration:
    """A map between the walls of two positions."""
    @property
    def confidence(self) -> float:
        """0 to 1; flagged below 0.5."""
        ...

    @property
    def doubts(self) -> List[str]:
        """Reasons for a flag; otherwise empty."""
        ...

    @property
    def flips(self) -> int:
        """Number of flipped triangles."""
        ...

    def map_points(self, points: ArrayLike, inverse: bool=...) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Maps the wall points nearest to k x 3 points (LPS, mm) from supine to prone, or back with `inverse`.

        Returns (points, k x 3, LPS mm; confidence, k, 0 to 1; excluded, k: wall not visible in one of the positions).
        """
        ...

    @property
    def matches(self) -> List[MatchedFolds]:
        """List of MatchedFolds, in the order of supine folds."""
        ...

    @property
    def prone_to_supine(self) -> Mesh:
        """The inverse map."""
        ...

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of registration.json of ColonRegistration."""
        ...

    @property
    def supine_to_prone(self) -> Mesh:
        """The flat supine wall with point arrays mapped (LPS, mm, on the prone wall), mappedUv, displacement (mm), confidence (0 to 1), excluded."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Warnings, one per line."""
        ...


class SeededHeat:
    """Labels from a few seeds: the steady state of heat that leaves the seeds of each label.

    image: intensities; not copied if float32 and C-contiguous.
    p: steepness, from 0; an edge insulates if the half gradient reaches 1 / p. None: chosen from noise and edges.
    window: (lower, upper) intensities mapped to 0 and 1; None: minimum and maximum.
    least_weight: positive; the weight of an edge that just insulates.
    tolerance: maximum error of a probability, 1e-6 to 0.1.

    Draw strokes through each part and through the background: points are not enough (`SeededLabels.warnings`).
    The last solution is kept as the start of the next one: 4 bytes per voxel and label.
    """
    def __init__(self, image: Image, *, p: Optional[float]=..., window: Optional[Tuple[float, float]]=..., least_weight: float=..., tolerance: float=...) -> None: ...

    def segment(self, seeds: Image, *, probabilities: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> SeededLabels:
        """The label of each voxel.

        seeds: an image on the same grid, integers from 0 to 65535; 0: no seed; at least two labels.
        probabilities: also returns the probability of each label.
        progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
        """
        ...


class SeededLabels:
    """Result of `SeededHeat.segment`."""
    @property
    def iterations(self) -> int:
        """Number of solver iterations; few after a small change of the seeds."""
        ...

    @property
    def labels(self) -> Image:
        """uint16: the label of highest probability."""
        ...

    @property
    def probabilities(self) -> Dict[int, Image]:
        """One image per label, float32 in [0, 1]; the images sum to 1. Empty unless requested."""
        ...

    @property
    def uncertainty(self) -> Image:
        """float32: 1 minus the difference of the two greatest probabilities; 0 if one label is certain."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Labels that hardly extend beyond their seeds, one per line."""
        ...


class SegmentDistension:
    """Distension of a segment of the colon."""
    @property
    def begin(self) -> float:
        """Start along the centerline, mm."""
        ...

    @property
    def collapsed_length(self) -> float:
        """Length without lumen, mm."""
        ...

    @property
    def end(self) -> float:
        """End along the centerline, mm."""
        ...

    @property
    def mean_caliber(self) -> float:
        """Mean inner diameter, mm."""
        ...

    @property
    def name(self) -> str:
        """Name of the segment."""
        ...

    @property
    def share(self) -> float:
        """Fraction of its length with a diameter of at least 10 mm, 0 to 1."""
        ...


class ShapeComponent:
    """Voxels connected by edges of positive weight."""
    @property
    def closed(self) -> bool:
        """False if the component reaches the border of the volume."""
        ...

    @property
    def converged_heat(self) -> float:
        """Steady-state heat of each voxel."""
        ...

    @property
    def index(self) -> Tuple[Any, ...]:
        """First voxel, [z, y, x]."""
        ...

    @property
    def normalized_heat(self) -> float:
        """Area / (6 volume^(2/3)): 1 for a cube."""
        ...

    @property
    def surface_area(self) -> float:
        """mm^2; 0 for an open component."""
        ...

    @property
    def volume(self) -> float:
        """mm^3."""
        ...

    @property
    def voxels(self) -> int:
        """Number of voxels."""
        ...


class ShapeNeighbor:
    """An entry and its distance."""
    @property
    def distance(self) -> float:
        """At least 0; copies of one shape are about 1 apart."""
        ...

    @property
    def entry(self) -> int:
        """Index of the entry."""
        ...


class ShapeRow:
    """A shape of a label map."""
    @property
    def component(self) -> int:
        """1 for the largest; 0 for the whole label."""
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
        """Number of voxels."""
        ...


class ShapeSearchResult:
    """Result of `find_shape`."""
    @property
    def neighbors(self) -> List[ShapeNeighbor]:
        """Nearest first."""
        ...

    @property
    def probability(self) -> float:
        """Probability that the nearest entry is the same shape, fitted to generated shapes."""
        ...

    @property
    def unknown(self) -> bool:
        """Whether the shape is probably none of the entries."""
        ...


class ShapeSignature:
    """Shape descriptors that are nearly invariant to position, rotation and sampling."""
    @property
    def displacement(self) -> NDArray[Any]:
        """25 values, ascending: mean squared displacement of heat in the insulated shape, divided by r^2."""
        ...

    @property
    def elongation(self) -> float:
        """Ratio of longest to middle standard deviation; at least 1."""
        ...

    @property
    def flatness(self) -> float:
        """Ratio of middle to shortest standard deviation; at least 1."""
        ...

    @property
    def remaining_heat(self) -> NDArray[Any]:
        """25 values, descending from 1: fraction of the heat remaining in the shape."""
        ...

    @property
    def spectrum(self) -> NDArray[Any]:
        """20 nonzero eigenvalues of the surface, times its area; the first one of a sphere is 8 pi."""
        ...

    @property
    def surface(self) -> float:
        """mm^2."""
        ...

    @property
    def times(self) -> NDArray[Any]:
        """25 values of t / r^2 for both curves, with r the radius of the ball of equal volume."""
        ...

    @property
    def volume(self) -> float:
        """mm^3."""
        ...


class ShapeTable:
    """Result of `describe_shapes`."""
    @property
    def rows(self) -> List[ShapeRow]:
        """Rows by label, then component."""
        ...

    @property
    def warnings(self) -> List[str]:
        """Skipped shapes, one per line."""
        ...


class ShapetonResult:
    """Result of `diffuse_shapetons`."""
    @property
    def change(self) -> float:
        """Change of the density in the last step (3.10)."""
        ...

    @property
    def coverage(self) -> float:
        """Fraction of the object voxels reached, 0 to 1."""
        ...

    @property
    def density(self) -> Image:
        """Visits divided by their maximum, in [0, 1]; float32, computed on access."""
        ...

    @property
    def distance(self) -> float:
        """Step length, in units of the longest side."""
        ...

    @property
    def histogram(self) -> HeatHistogram:
        """One row per step of histogram_steps."""
        ...

    @property
    def reason_of_distance(self) -> str:
        """Reason for the distance, if chosen by feature_size; otherwise empty."""
        ...

    @property
    def shapetons(self) -> int:
        """Number of shapetons."""
        ...

    @property
    def steady(self) -> bool:
        """Whether the steady state was reached."""
        ...

    @property
    def time_step(self) -> int:
        """The last step computed."""
        ...

    @property
    def trapped(self) -> int:
        """Shapetons in voxels disconnected from all neighbors."""
        ...

    @property
    def visits(self) -> Image:
        """Number of visits of each voxel; uint32. The sum is shapetons x steps."""
        ...


class SurfaceHandle:
    """A handle of a flattened surface."""
    @property
    def flat_place(self) -> NDArray[Any]:
        """Position on the map, mm."""
        ...

    @property
    def genus(self) -> int:
        """Number of handles: more than 1 if they cannot be separated."""
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
        """Vertices of the flattened surface, ascending."""
        ...


class SurfaceSpectrum:
    """The smoothest eigenfunctions of a surface of n vertices."""
    def diffusion_distance(self, p: int, q: int, time: float) -> float:
        """The diffusion distance: L2 distance at `time` (mm^2) of the heat of unit sources at two vertices; 1/mm."""
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
        """Heat at vertex q at `time` (mm^2) from a unit source at vertex p; 1/mm^2."""
        ...

    @property
    def residuals(self) -> NDArray[Any]:
        """k, relative to the largest eigenvalue."""
        ...

    def share_of_last_pair(self, time: float) -> float:
        """Remaining fraction of the last pair at `time` (mm^2): order of magnitude of the truncation error."""
        ...

    def signature(self, time: float) -> NDArray[Any]:
        """The heat kernel signature, n values: the remaining heat of a unit source at each vertex; 1/mm^2."""
        ...

    def signature_times(self, number: int=...) -> List[float]:
        """Suggested times (mm^2) for the signature, logarithmically spaced."""
        ...


def build_colon(ct: Image, *, lumen: Optional[Image]=..., patient_position: str=..., seed_points: ArrayLike=..., faces: int=..., keep_pieces: bool=..., keep_partial: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonModel:
    """Computes lumen, cleansed CT, centerline, valve, distension and wall from a CT colonography in HU.

    lumen: a mask (uint8, nonzero) on the grid of the CT that replaces the automatic one. patient_position, seed_points:
    see `segment_lumen`. faces, keep_pieces: see `build_wall`. keep_partial: if the colon is not distended or tagged enough,
    continues as far as possible.

    An unusable colon does not raise an exception: see `failure`.
    """
    ...

def build_colon_of_lumen(lumen: Image, *, seed_points: ArrayLike=..., faces: int=..., keep_pieces: bool=..., keep_partial: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonModel:
    """Computes the model from a mask of the lumen only (uint8, nonzero); parameters as in `build_colon`."""
    ...

def build_wall(occupancy: Image, centerline: Union[Curves, NDArray[Any]], *, faces: int=..., bridge_radius: float=..., keep_pieces: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonWall:
    """The wall as surfaces, from the occupancy computed by `cleanse`.

    centerline: from `trace_centerline`. faces: of the simplified wall; 0: chosen automatically.
    bridge_radius: radius of the tubes through gaps, mm. keep_pieces: keeps the pieces of a broken lumen separate.
    """
    ...

def build_wall_of_mask(mask: Image, centerline: Union[Curves, NDArray[Any]], *, faces: int=..., bridge_radius: float=..., keep_pieces: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonWall:
    """The wall from a mask of the lumen (uint8, nonzero); parameters as in `build_wall`."""
    ...

def classify_heat(heat: Image, components: Sequence[ShapeComponent]=..., *, maximum_classes: int=..., background_heat: float=..., minimum_share: float=..., minimum_peak_to_valley: float=...) -> Tuple[Image, List[HeatClass]]:
    """The classes of a heat image: the lines of its histogram, separated at the valleys.

    heat: in [0, 1]. components: from `HeatResult`, to count them per class. maximum_classes: without the background.
    background_heat: lines with a peak below this heat are background. minimum_share: minimum fraction of the voxels above
    the background in a class. minimum_peak_to_valley: minimum ratio of the lower peak to the valley between neighbors.

    Returns (labels, classes): an image of uint8 and a list of HeatClass.
    """
    ...

def classify_visits(visits: Image) -> Tuple[Image, List[HeatClass]]:
    """The classes of a uint32 image of visits, analogous to `classify_heat`: (labels, classes)."""
    ...

def cleanse(ct: Image, lumen: ColonLumen, *, progress: Optional[Callable[[float, str], object]]=...) -> CleansedColon:
    """Removes the tagged fluid of a colon from the CT from which `lumen` was segmented."""
    ...

def colon_phantom(*, seed: int=..., position: str=..., preset: str=..., size: Sequence[int]=..., spacing: Sequence[float]=..., truth_only: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonPhantom:
    """A synthetic patient for CT colonography.

    seed: fixes the patient. position: "supine", "prone", "leftDecubitus" or "rightDecubitus". preset: "standard", "hard" or
    "realistic". size: voxels along x, y, z. spacing: along x, y, z, mm; the patient needs about 358 x 358 x 336 mm.
    truth_only: omits the CT, which takes most of the time.
    """
    ...

def compare_graphs(a: Graph, b: Graph, seed: int=..., *, progress: Optional[Callable[[float, str], object]]=...) -> GraphComparison:
    """Determines whether two graphs are isomorphic, embeds both and reports the differences.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def complete_bipartite_graph(left: int, right: int) -> Graph:
    """The complete bipartite graph."""
    ...

def complete_graph(nodes: int) -> Graph:
    """The complete graph."""
    ...

def conformal_map(mesh: Mesh, *, domain: str=..., outer_boundary: int=..., inner_boundary: int=..., corners: Sequence[int]=..., edge_lengths: Optional[ArrayLike]=..., progress: Optional[Callable[[float, str], object]]=...) -> ConformalMap:
    """Maps an open surface conformally to the plane.

    mesh: one manifold, oriented component with a boundary. domain: "rectangle", "annulus" or "slit".
    outer_boundary, inner_boundary: numbers from 1 by length; 0: the longest, and the longest of the others.
    corners: four vertices of the only boundary of a rectangle. edge_lengths: another metric, in the order of
    `surface_edges`.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def describe_shapes(image: Image, labels: Image, *, components: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> ShapeTable:
    """The signature of each label, or of each connected component of each label.

    image: intensities, used for mean_intensity only. labels: integers from 0 (background) to 65535, on the same grid.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    A shape takes half a second. Shapes of fewer than 64 voxels, or too thin, are skipped with a warning.
    """
    ...

def diffuse_heat(image: Image, *, p: Optional[float]=..., window: Optional[Tuple[float, float]]=..., time_steps: int=..., time_step_length: float=..., tolerance: float=..., method: str=..., conductance: str=..., ignore_spacing: bool=..., until_steady: bool=..., histogram_steps: Sequence[int]=..., snapshot_steps: Sequence[int]=..., snapshot: Optional[Callable[[int, Image], object]]=..., components: bool=..., initial_heat: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> HeatResult:
    """Cumulative heat diffusion: a shape descriptor of each voxel, its heat after diffusion from all voxels at once.

    image: intensities; not copied if float32 and C-contiguous. Any spacing.
    p: steepness, from 0; an edge insulates if the half gradient reaches 1 / p. None: chosen from noise and edges.
    window: (lower, upper) intensities mapped to 0 and 1; None: minimum and maximum.
    time_steps: at least 1. Few steps show local shape, many show whole objects.
    time_step_length: in (0, 1/12].
    tolerance: bound of the error of the heat, 1e-6 to 1.
    method: "chebyshev" or "explicit". conductance: "physical" or "published".
    ignore_spacing: treats voxels as cubes.
    until_steady: stops when the heat is steady.
    histogram_steps: ascending steps that become rows of the histogram, see `recorded_steps`.
    snapshot_steps, snapshot: snapshot(step, image) is called with the heat after each of these ascending steps.
    components: finds components and their converged heat. initial_heat: also returns the heat at step 0.
    progress: called with (share, stage) ten times a second; returning False, an exception or Ctrl-C aborts.

    The heat is byte-identical for any number of threads. Memory: about 8 float32 fields, 13 with a histogram.
    """
    ...

def diffuse_over_surface(mesh: Mesh, values: ArrayLike, time: float, *, progress: Optional[Callable[[float, str], object]]=...) -> NDArray[Any]:
    """Smooths values over a surface by heat flow for `time` mm^2, from 0; a new array of the shape of `values`.

    values: n, or n x k in columns. Two implicit time steps: the component of eigenvalue x is multiplied by
    (1 + x time / 2)^-2, where the exact factor is exp(-x time). For the exact one use `spectrum`.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def diffuse_shapetons(image: Image, *, mask: Optional[Image]=..., p: float=..., window: Optional[Tuple[float, float]]=..., shapetons: Optional[int]=..., distance: float=..., feature_size: Optional[float]=..., time_steps: int=..., direction_sampling: str=..., path_rule: str=..., placement: str=..., seed: int=..., until_steady: bool=..., epsilon: Optional[float]=..., histogram_steps: Sequence[int]=..., progress: Optional[Callable[[float, str], object]]=...) -> ShapetonResult:
    """Shapeton diffusion: counts the visits of particles that perform a random walk through a volume.

    image: intensities; not copied if float32 and C-contiguous. mask: shapetons start where it is nonzero.
    p: steepness, from 0. window: (lower, upper) intensities mapped to 0 and 1; None: minimum and maximum.
    shapetons: their number; None: 65000, or chosen from feature_size.
    distance: step length in (0, 1], in units of the longest side of the volume.
    feature_size: mm; sets distance, and shapetons, if these are None.
    time_steps: at least 1.
    direction_sampling: "solidAngle", "sectorArea" or "uniform". path_rule: "endpoint" or "traversal".
    placement: "uniform" or "initialHeat". seed: the same seed gives the same visits.
    until_steady: stops when the density changes by less than epsilon (3.10); None: chosen from the run.
    histogram_steps: ascending steps, from 1, that become rows of the histogram.
    progress: called with (share, stage) ten times a second; returning False, an exception or Ctrl-C aborts.

    The visits are byte-identical for any number of threads.
    """
    ...

def edge_lengths(mesh: Mesh) -> NDArray[Any]:
    """Euclidean edge lengths in the order of `surface_edges`, e values; mm."""
    ...

def embed_graph(graph: Graph, *, genus: Optional[int]=..., rotation: Optional[Sequence[Sequence[int]]]=..., seed: int=..., augmentation: str=..., infinity: str=..., progress: Optional[Callable[[float, str], object]]=...) -> EmbeddingCertificate:
    """Embeds a graph without crossings by a circle packing computed with discrete Ricci flow.

    genus: of the surface: 0 sphere, 1 flat torus, from 2 hyperbolic; None: the smallest found.
    rotation: for each node the half-edges that leave it, counterclockwise; replaces the search.
    seed: of the search. augmentation: "ring" adds dummy nodes if no packing exists, "none" does not.
    infinity: "circle" or "edgeNode", on the sphere.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def enclosed_volume(mesh: Mesh) -> float:
    """mm^3, of a closed oriented surface; negative if its faces are oriented inwards."""
    ...

def find_candidates(wall: Mesh, lumen: Image, *, centerline: Optional[Union[Curves, NDArray[Any]]]=..., ct: Optional[Image]=..., flat: FlatColon=..., segments: Optional[Mesh]=..., catheter: Optional[Union[Curves, NDArray[Any]]]=..., preset: str=..., sensitivity: float=..., progress: Optional[Callable[[float, str], object]]=...) -> List[PolypCandidate]:
    """Polyp candidates on the wall of a colon, by descending score. For research use; not clinical findings.

    wall: full resolution, without handles (`ColonWall.repaired`). lumen: uint8, nonzero, on the grid of the CT.
    Optional inputs add information to a candidate: centerline (with the valve), ct (HU, cleansed), flat (FlatColon),
    segments (`ColonLandmarks.segments`), catheter (`ColonLumen.catheter`).
    preset: "default" or "published". sensitivity: 0 to 1.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def find_folds(flat: FlatColon, *, scheme: str=..., minimum_length: float=..., minimum_area: float=..., minimum_elongation: float=..., minimum_angle: float=..., smoothing_time: float=..., smoothness: float=..., taeniae: Optional[Union[Curves, NDArray[Any]]]=..., progress: Optional[Callable[[float, str], object]]=...) -> HaustralFolds:
    """Haustral folds on the flat wall of a colon.

    scheme: "graphCut" or "published". minimum_length: mm; minimum_area: mm^2; minimum_elongation: long over short axis;
    minimum_angle: against the tube, degrees. smoothing_time: of the curvature, mm^2. smoothness: cost of the outline.
    taeniae: Curves on the wall along which merged folds are split.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def find_in_other_position(map: Mesh, candidates: Sequence[PolypCandidate], others: Sequence[PolypCandidate], *, confidence: Optional[float]=...) -> List[PolypCandidate]:
    """The candidates with `other` set, from a map of `Registration`.

    map: `Registration.supine_to_prone` if the candidates are supine. others: the candidates of the other position.
    confidence: of the registration, 0 to 1. If given, scores are weighted by the other position: polyps stay in
    place, most stool moves.
    """
    ...

def find_landmarks(flat: FlatColon, centerline: Union[Curves, NDArray[Any]], *, flexure_rule: str=..., taenia_rule: str=..., markers: ArrayLike=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonLandmarks:
    """Flexures, segments, folds on the surface and taeniae of a flat colon.

    flat: FlatColon. centerline: from `trace_centerline`. flexure_rule: "ordered" or "published". taenia_rule: "joint" or
    "published". markers: k x 3, LPS mm: points on taeniae placed by a person.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    A landmark that is not found does not raise an exception: it is absent, and `warnings` give the reason.
    """
    ...

def find_shape(signature: ShapeSignature, entries: Sequence[NamedShape], nearest: int=...) -> ShapeSearchResult:
    """Searches a signature in a list of NamedShape; returns at most `nearest` neighbors."""
    ...

def find_valve(labels: Image, centerline: Union[Curves, NDArray[Any]], ct: Optional[Image]=...) -> Tuple[Optional[IleocecalValve], str]:
    """The ileocecal valve: (IleocecalValve or None, reason why it was not found).

    labels: nonzero in the lumen. centerline: from `trace_centerline`. ct: HU on the same grid; None: shape only.
    """
    ...

def flatten_tube(mesh: Mesh, centerline: Optional[Union[Curves, NDArray[Any]]]=..., *, metric: str=..., time: float=..., eigenpairs: int=..., remove_handles: bool=..., method: str=..., cut: Optional[Union[Curves, NDArray[Any]]]=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonFlattening:
    """Maps a tube, such as the wall of a colon, conformally to a rectangle.

    mesh: one manifold, oriented component with two boundary loops. centerline: from the rectum to the cecum; locates the
    rectum if the surface does not name it.
    metric: "heatDiffusion", "euclidean" or "truncatedHeatDiffusion". time: diffusion time, mm^2; 0: chosen for the mesh.
    eigenpairs: for truncatedHeatDiffusion. remove_handles: finds and cuts handles.
    method: "conjugate" or "published". cut: a curve near which the tube is cut, Curves or k x 3; None: computed.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def grid_graph(columns: int, rows: int) -> Graph:
    """Node (c, r) is r * columns + c."""
    ...

def heat_diffusion_metric(mesh: Mesh, time: Optional[float]=..., *, pairs: Optional[int]=..., progress: Optional[Callable[[float, str], object]]=...) -> HeatDiffusionMetric:
    """The heat diffusion distances along all edges, as new edge lengths.

    mesh: one manifold component. time: diffusion time, mm^2; None: 8 times the squared mean edge length at 55,000 faces.
    pairs: uses only this number of eigenpairs, as published; None: exact distances, without eigenpairs.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def heat_histogram(heats: Sequence[Image], time_steps: Sequence[int]) -> HeatHistogram:
    """The histogram of given heat images, one row each; time_steps must be ascending."""
    ...

def hypercube_graph(dimension: int) -> Graph:
    """The hypercube graph with 2^dimension nodes; nodes that differ in one bit are adjacent."""
    ...

def implied_category(candidates: Sequence[PolypCandidate]) -> str:
    """C-RADS category implied by the candidate sizes only, as text."""
    ...

def inspect_surface(mesh: Mesh) -> Dict[str, Any]:
    """Topology, measures and defects of a surface, as a dictionary with the keys of SurfaceInspector.

    vertices, edges, faces, eulerCharacteristic, genus (None: not defined), manifold, closed, oriented, area (mm^2), volume
    (mm^3; None if open), extent, components, boundaryLoops, edgeLength, smallestAngle (degrees), defects, ...
    """
    ...

def list_series(path: Union[str, os.PathLike[str]], *, progress: Optional[Callable[[float, str], object]]=...) -> List[DicomSeries]:
    """The DICOM series in a folder, searched recursively, or in a file. Reads headers.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def measure_distension(centerline: Union[Curves, NDArray[Any]]) -> List[SegmentDistension]:
    """Distension of each segment, with segments delimited by standard fractions of the length."""
    ...

def read_certificate(path: Union[str, os.PathLike[str]]) -> EmbeddingCertificate:
    """Reads a certificate (JSON)."""
    ...

def read_curves(path: Union[str, os.PathLike[str]]) -> Curves:
    """Reads the lines and points of a VTP file, such as a centerline."""
    ...

def read_graph(path: Union[str, os.PathLike[str]]) -> Graph:
    """Reads GraphML, GML, DOT, edge lists, METIS, MATPOWER, PACE, graph6 or sparse6."""
    ...

def read_position(folder: Union[str, os.PathLike[str]], name: str) -> ColonPosition:
    """Reads a ColonPosition from a folder written by VirtualColonoscopy."""
    ...

def read_shape_database(path: Union[str, os.PathLike[str]]) -> List[NamedShape]:
    """All shapes of an SQLite file of the tool ShapeSearch, in insertion order."""
    ...

def read_shape_table(path: Union[str, os.PathLike[str]]) -> ShapeTable:
    """Reads a table written by `write_shape_table`."""
    ...

def read_surface(path: Union[str, os.PathLike[str]], *, part: str=..., component: int=..., unit: str=..., any_extent: bool=..., repair: bool=...) -> Mesh:
    """Reads VTP, STL, OBJ, PLY, OFF, glTF or GLB; LPS, mm.

    part: name of a part of the file; "" for all. component: from 1, by number of faces; 0: the only one; -1: all.
    unit: "m", "mm" or "um", replaces the unit of the format; accepts any extent. any_extent: accepts a surface that is not
    between 5 mm and 5 m wide, with a note. repair: repairs as `repair_surface` does.

    Repairs and doubts are in the `notes` of the mesh.
    """
    ...

def read_volume(path: Union[str, os.PathLike[str]], *, series_uid: str=..., resample_gaps: bool=..., deshear: bool=..., drop_duplicates: bool=..., allow_single_slice: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> Image:
    """Reads a folder of DICOM slices, a DICOM file, or a NRRD, NIfTI or MetaImage file.

    An irregular series raises InputError with the name of the defect, unless its repair is allowed:

    series_uid: selects a series if the folder contains several (`DicomSeries.selector`).
    resample_gaps: fills gaps and uneven spacing by interpolation between slices.
    deshear: resamples a tilted volume onto perpendicular axes.
    drop_duplicates: keeps the first of several slices at one position.
    allow_single_slice: accepts a single slice as a volume.
    progress: for DICOM slices, called with (share, stage); returning False, an exception or Ctrl-C aborts.

    The image holds float32, rescaled: Hounsfield units for CT. Its `facts` hold modality, patient_position, series_uid,
    identity, repairs, notes. Files of other formats are read in one piece, for which Ctrl-C waits.
    """
    ...

def recorded_steps(last: int, number: int, spacing: str=...) -> List[int]:
    """At most `number` distinct time steps from 0 to `last`, for histogram_steps; spacing: "linear", as the tool records them, or "logarithmic"."""
    ...

def register_positions(supine: ColonPosition, prone: ColonPosition, *, map: str=..., matching: str=..., refine: bool=..., segment_wise: bool=..., progress: Optional[Callable[[float, str], object]]=...) -> Registration:
    """A one-to-one map between the walls of a colon in two positions.

    map: "default" or "published". matching: of folds, "hungarian" or "dualDecomposition". refine: by the wall curvature.
    segment_wise: folds stay within their segment.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def remesh_surface(mesh: Mesh, edge_length: float, *, iterations: int=..., progress: Optional[Callable[[float, str], object]]=...) -> Mesh:
    """A surface of nearly equilateral triangles with this edge length (mm). Its arrays are dropped."""
    ...

def repair_surface(mesh: Mesh, *, merge_distance: float=..., merge_vertices: bool=..., orient: bool=..., split: bool=...) -> Tuple[Mesh, List[str]]:
    """A manifold, consistently oriented surface of the same faces: (mesh, repairs in words).

    merge_vertices: merges vertices closer than merge_distance (mm; 0: coincident). orient: flips faces so that neighbors
    agree. split: cuts the surface where it is not manifold.
    """
    ...

def seeds_of_classes(classes: Image, *, chosen: Sequence[int]=..., components: int=...) -> Image:
    """Seeds from classes, such as those of `classify_heat`, eroded by one voxel.

    classes: integers. chosen: the classes to use; none: all but 0. components: 0: one label per class; otherwise one label
    for each of this number of largest components per class. Labels count from 1 in the order of the classes.
    """
    ...

def segment_lumen(ct: Image, *, patient_position: str=..., seed_points: ArrayLike=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonLumen:
    """Segments gas and tagged fluid of the colon in a CT colonography, without seeds.

    ct: Hounsfield units; any axes, spacing about 0.5 to 3 mm. patient_position: "HFS", "HFP", ..., "supine", "prone",
    "leftDecubitus", "rightDecubitus"; "": gravity is inferred from fluid levels.
    seed_points: k x 3, LPS mm; the pieces of gas or fluid that contain them are colon.
    """
    ...

def set_threads(number: int) -> None:
    """Sets the number of threads of all functions of this process; results do not depend on it."""
    ...

def signature_distance(a: ShapeSignature, b: ShapeSignature) -> float:
    """Distance of two signatures, at least 0; copies of one shape are about 1 apart. The volume is ignored."""
    ...

def simplify_surface(mesh: Mesh, faces: int, *, smallest_angle: float=..., boundary_weight: float=..., progress: Optional[Callable[[float, str], object]]=...) -> Mesh:
    """A surface with at most this number of faces and the same topology, by edge collapses. Arrays are dropped.

    smallest_angle: degrees, 0 to 30; no angle becomes smaller. boundary_weight: of boundary edges against faces.
    """
    ...

def spectrum(mesh: Mesh, pairs: int=..., *, progress: Optional[Callable[[float, str], object]]=...) -> SurfaceSpectrum:
    """The `pairs` smallest eigenpairs of the Laplacian of a surface with one manifold component.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def split_colon(landmarks: ColonLandmarks, *, progress: Optional[Callable[[float, str], object]]=...) -> Tuple[List[ColonPiece], List[str]]:
    """Cuts the wall into its segments and maps each to a rectangle: (list of ColonPiece, warnings).

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    ...

def surface_area(mesh: Mesh) -> float:
    """mm^2."""
    ...

def surface_edges(mesh: Mesh) -> NDArray[Any]:
    """The edges of a surface, e x 2, int32: the smaller vertex first, sorted."""
    ...

def threads() -> int:
    """The number of threads of all functions of this process."""
    ...

def torus_grid(columns: int, rows: int, diagonals: bool=...) -> Tuple[Graph, List[List[int]]]:
    """The grid with periodic boundaries, embedded on the torus: (Graph, rotation), see `embed_graph`."""
    ...

def trace_centerline(lumen: Image, *, start: Optional[ArrayLike]=..., seed_points: ArrayLike=..., exponent: int=..., minimum_volume: float=..., step: float=..., smoothing: float=..., progress: Optional[Callable[[float, str], object]]=...) -> ColonCenterline:
    """The centerline of the colon from a mask of its lumen (uint8, nonzero).

    start: start point in the rectum, LPS mm; None: detected. seed_points: k x 3, LPS mm; pieces next to them are used.
    exponent: one mm of path costs 1 / (distance to the wall)^exponent. minimum_volume: of a piece of lumen, ml.
    step: spacing of the points, mm. smoothing: standard deviation along the line, mm.
    """
    ...

def verify_embedding(certificate: EmbeddingCertificate) -> EmbeddingVerdict:
    """Proves from the numbers of an embedding that no edges cross, or reports the failed condition."""
    ...

def visit_density(visits: Image) -> Image:
    """Visits divided by their maximum: float32 in [0, 1]."""
    ...

def write_certificate(certificate: EmbeddingCertificate, path: Union[str, os.PathLike[str]]) -> None:
    """Writes a certificate as JSON without loss of precision."""
    ...

def write_curves(curves: Union[Curves, NDArray[Any]], path: Union[str, os.PathLike[str]]) -> None:
    """Writes curves as VTP with their arrays and facts; equal curves give byte-identical files."""
    ...

def write_graph(graph: Graph, path: Union[str, os.PathLike[str]]) -> None:
    """Writes GraphML."""
    ...

def write_shape_table(table: ShapeTable, path: Union[str, os.PathLike[str]]) -> None:
    """Writes a CSV file as the tool ShapeSignature does."""
    ...

def write_surface(mesh: Mesh, path: Union[str, os.PathLike[str]]) -> None:
    """Writes VTP (all arrays and facts), STL, PLY or OBJ by extension; equal surfaces give byte-identical files."""
    ...

def write_volume(image: Image, path: Union[str, os.PathLike[str]], metadata: Sequence[Tuple[str, str]]=...) -> None:
    """Writes NRRD (.nrrd), NIfTI (.nii, .nii.gz) or MetaImage (.mha), as the tools do.

    float32, int16, uint8, uint16 and uint32 are written unchanged, bool as uint8, float64 as float32 if that rounds no
    voxel; otherwise, and for other types, ParameterError is raised, so that a file always holds the values of the image.
    metadata: pairs of texts for the header of NRRD and MetaImage.
    """
    ...
