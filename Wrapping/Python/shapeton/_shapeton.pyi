"""Written by make_stub.py from the docstrings of the classes; do not edit."""

from typing import Any, Dict, List, Optional, Sequence, Tuple

from numpy.typing import ArrayLike, NDArray

from ._arguments import Lines, Pairs
from .image import Image
from .mesh import Curves, Mesh

def __getattr__(name: str) -> Any: ...  # the functions, which only the package calls

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

    @property
    def distance(self) -> float:
        """Straight distance between the ends of the lumen, mm."""

    @property
    def end(self) -> float:
        """End along the line, mm."""

    @property
    def is_doubtful(self) -> bool:
        """Whether it is longer than known collapsed segments."""


class CleansedColon:
    """Result of `cleanse`."""
    @property
    def ct(self) -> Image:
        """float32, HU: the CT with fluid replaced by gas."""

    @property
    def occupancy(self) -> Image:
        """float32, 0 to 1, cropped: lumen fraction of each voxel; the wall is the 0.5 isosurface."""


class ColonCenterline:
    """The centerline of a colon from the rectum to the cecum."""
    @property
    def coverage(self) -> float:
        """Fraction of the lumen along the line, 0 to 1."""

    @property
    def curve(self) -> Curves:
        """One curve; point arrays arcLength (mm), radius (mm), gap (1 on a bridge)."""

    @property
    def gaps(self) -> List[CenterlineGap]:
        """Bridged gaps."""

    @property
    def length(self) -> float:
        """mm."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class ColonDistension:
    """Distension of a stretch of the colon."""
    @property
    def begin(self) -> float:
        """Start along the centerline, mm."""

    @property
    def collapsed_length(self) -> float:
        """Length without lumen, mm."""

    @property
    def end(self) -> float:
        """End along the centerline, mm."""

    @property
    def mean_caliber(self) -> float:
        """Mean inner diameter, mm."""

    @property
    def share(self) -> float:
        """Fraction of its length with a diameter of at least 10 mm, 0 to 1."""


class ColonFlattening:
    """A flattened tube with its measurements."""
    @property
    def circumference(self) -> float:
        """Mean circumference, mm."""

    @property
    def flat(self) -> Mesh:
        """The tube cut open: points in space, the point arrays uv (mm: along, around) and sourcePointId, the field arrays circumference and length (mm)."""

    @property
    def genus_after(self) -> int:
        """Number of handles of the flattened surface."""

    @property
    def genus_before(self) -> int:
        """Number of handles of the input surface."""

    @property
    def handles(self) -> List[SurfaceHandle]:
        """Handles; most walls have none."""

    @property
    def length(self) -> float:
        """Length of the map, mm."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of the statistics of ColonFlattening: flips, dilatation, moduli, ..."""

    @property
    def surface(self) -> Mesh:
        """The flattened surface in space."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class ColonFlexure:
    """A major bend of the colon, found or not."""
    @property
    def arc_length(self) -> float:
        """mm along the centerline."""

    @property
    def confidence(self) -> float:
        """Probability, 0 to 1, that the true flexure is within 30 mm."""

    @property
    def is_found(self) -> bool:
        """Whether it was found."""

    @property
    def name(self) -> str:
        """For example "splenic"."""

    @property
    def number(self) -> int:
        """1 rectosigmoid, 2 descending-sigmoid, 3 splenic, 4 hepatic."""

    @property
    def point(self) -> NDArray[Any]:
        """Point on the centerline; LPS, mm."""

    @property
    def reason(self) -> str:
        """Reason why it was not found; otherwise empty."""


class ColonLandmarks:
    """Result of `find_landmarks`."""
    @property
    def flexure_loops(self) -> Curves:
        """A closed loop on the wall for each flexure found; cell arrays flexure, arcLength, confidence."""

    @property
    def flexures(self) -> List[ColonFlexure]:
        """Four flexures, starting at the rectum."""

    @property
    def fold_surface(self) -> Mesh:
        """The flat wall with the cell array fold and the point array meanCurvature (1/mm)."""

    @property
    def is_mirrored(self) -> bool:
        """Whether the colon is mirrored (situs inversus)."""

    @property
    def segments(self) -> Mesh:
        """The flat wall with the cell array segment: 1 rectum to 6 cecum, 0 unknown."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of landmarks.json of ColonLandmarks."""

    @property
    def taeniae(self) -> Curves:
        """Three curves on the wall, or none; point arrays arcLength (mm), uv (mm), confidence, cell array taenia."""

    @property
    def valve(self) -> Optional[IleocecalValve]:
        """The valve stored in the centerline, or None."""

    @property
    def warnings(self) -> List[str]:
        """Missing landmarks, one per line."""


class ColonLumen:
    """Result of `segment_lumen`."""
    @property
    def catheter(self) -> Optional[Curves]:
        """Axis of a rectal catheter as Curves; None unless one was found with certainty."""

    @property
    def failure(self) -> str:
        """Reason why the colon is not usable; otherwise empty."""

    @property
    def gravity(self) -> NDArray[Any]:
        """Unit vector of gravity, LPS."""

    @property
    def is_tagged(self) -> bool:
        """Whether fluid brighter than tissue was found below the gas of the colon."""

    @property
    def labels(self) -> Image:
        """uint8: 1 gas, 2 fluid, 0 otherwise."""

    @property
    def noise(self) -> float:
        """Standard deviation in soft tissue, HU."""

    @property
    def thresholds(self) -> ColonThresholds:
        """HU."""

    @property
    def warnings(self) -> List[str]:
        """Missing or doubtful results, one per line."""


class ColonModel:
    """A colon: lumen, centerline and wall."""
    @property
    def centerline(self) -> ColonCenterline:
        """ColonCenterline; its curve includes the valve."""

    @property
    def cleansed(self) -> Image:
        """float32, HU; None for a mask."""

    @property
    def distension(self) -> ColonDistension:
        """Distension of the whole colon."""

    @property
    def failure(self) -> str:
        """Reason why the colon is not usable; otherwise empty."""

    @property
    def lumen(self) -> ColonLumen:
        """ColonLumen."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of quality.json of ColonSegmentation."""

    @property
    def valve(self) -> Optional[IleocecalValve]:
        """IleocecalValve; None if it was not found."""

    @property
    def wall(self) -> ColonWall:
        """ColonWall."""

    @property
    def warnings(self) -> List[str]:
        """Warnings of all stages, one per line."""


class ColonPhantom:
    """A synthetic patient for CT colonography, with ground truth."""
    @property
    def centerline(self) -> Curves:
        """The true centerline, from the anal verge to the cecum."""

    @property
    def ct(self) -> Image:
        """int16, HU; None if only the ground truth was requested."""

    @property
    def lumen(self) -> Image:
        """uint8: 1 gas, 2 fluid."""

    @property
    def segments(self) -> Image:
        """uint8: 1 rectum to 6 cecum."""


class ColonPiece:
    """A segment of the colon, cut open along a taenia and flattened."""
    @property
    def area(self) -> float:
        """mm^2."""

    @property
    def flat(self) -> Mesh:
        """Surface in space, with the point array uv (mm on the rectangle)."""

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle: an upper bound."""

    @property
    def modulus_v(self) -> float:
        """Height over width of the rectangle: a lower bound."""

    @property
    def name(self) -> str:
        """Name of the segment."""

    @property
    def segment(self) -> int:
        """1 rectum to 6 cecum."""


class ColonPosition:
    """The colon in one position, for registration."""
    def __init__(self: ColonPosition, name: str, landmarks: ColonLandmarks, centerline: Lines, folds: HaustralFolds) -> None:
        """name: "supine" or "prone", for messages.
            landmarks: from `find_landmarks`.
            centerline: from `trace_centerline`.
            folds: from `find_folds`.
        """

    @property
    def name(self) -> str:
        """Name used in messages."""

    @property
    def warnings(self) -> List[str]:
        """Missing inputs that the registration does not require."""


class ColonThresholds:
    """Intensities in HU, all estimated from the data."""
    @property
    def fluid(self) -> float:
        """Mode of tagged fluid; 0 without fluid."""

    @property
    def fluid_boundary(self) -> float:
        """Mean of tissue and fluid."""

    @property
    def gas(self) -> float:
        """Typical gas inside the body."""

    @property
    def gas_boundary(self) -> float:
        """Mean of gas and tissue: the boundary of the wall."""

    @property
    def tissue(self) -> float:
        """Typical soft tissue."""


class ColonWall:
    """The wall of a colon in three forms, each open at rectum and cecum."""
    @property
    def genus_after(self) -> int:
        """Number of handles of the repaired wall."""

    @property
    def genus_before(self) -> int:
        """Number of handles of the raw wall."""

    @property
    def raw(self) -> Mesh:
        """The extracted surface, with all handles."""

    @property
    def repaired(self) -> Mesh:
        """The surface without handles, smoothed."""

    @property
    def simplified(self) -> Mesh:
        """The repaired surface with fewer faces."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class ConformalMap:
    """A planar map of a surface, with quality measures."""
    @property
    def corners(self) -> List[int]:
        """Four corner vertices, for a rectangle with one boundary."""

    @property
    def dilatation(self) -> NDArray[Any]:
        """Dilatation of each face, at least 1 (conformal)."""

    @property
    def flat(self) -> Mesh:
        """The cut surface in space with the point array uv (mm in the plane)."""

    @property
    def flips(self) -> int:
        """Number of flipped faces."""

    @property
    def genus(self) -> int:
        """Genus; 0 without handles."""

    @property
    def modulus_u(self) -> float:
        """Height over width of the rectangle, or 2 pi / ln(R / r)."""

    @property
    def modulus_v(self) -> float:
        """The modulus from the conjugate; the gap is the error bar."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of the statistics of ConformalMap."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class ConformalTypeResult:
    """Balls of growing radius, their packings, and the verdict."""
    @property
    def limit_radius(self) -> Tuple[Any, ...]:
        """Extrapolated hyperbolic radius of the circle of the root, two values; 0 if parabolic, NaN if not decided."""

    @property
    def moduli(self) -> NDArray[Any]:
        """-log tanh(r / 2) of the root radii."""

    @property
    def nodes(self) -> NDArray[Any]:
        """Nodes of each ball."""

    @property
    def packing(self) -> Dict[str, Any]:
        """Growth of the moduli: type, decay, limit, far_limit."""

    @property
    def radii(self) -> NDArray[Any]:
        """Radius of each ball, edges."""

    @property
    def resistance(self) -> Dict[str, Any]:
        """Growth of the resistances: type, decay, limit, far_limit."""

    @property
    def resistances(self) -> NDArray[Any]:
        """Effective resistance from the root to the boundary of each ball."""

    @property
    def root(self) -> int:
        """Node at the center of the balls."""

    @property
    def root_radii(self) -> NDArray[Any]:
        """Hyperbolic radius of the circle of the root in each ball."""

    @property
    def type(self) -> str:
        """"parabolic", "hyperbolic" or "not decided"."""


class DeviceError(Error, RuntimeError):
    """A requested GPU is not available or failed; also a RuntimeError."""

class DicomDefect:
    """A defect or peculiarity of a DICOM series."""
    @property
    def advice(self) -> str:
        """Possible remedy."""

    @property
    def files(self) -> List[str]:
        """The affected files."""

    @property
    def message(self) -> str:
        """The defect as a sentence."""

    @property
    def name(self) -> str:
        """For example "gap"."""

    @property
    def slices(self) -> List[int]:
        """The affected slices, counted from 1 along the normal."""


class DicomSeries:
    """A DICOM series of a folder; see `list_series`."""
    @property
    def defects(self) -> List[DicomDefect]:
        """Defects that prevent reading the series without repair."""

    @property
    def description(self) -> str:
        """Series Description."""

    @property
    def is_usable(self) -> bool:
        """Whether a volume can be read without repair."""

    @property
    def modality(self) -> str:
        """For example "CT"."""

    @property
    def number(self) -> int:
        """Series Number."""

    @property
    def patient_position(self) -> str:
        """For example "HFS"."""

    @property
    def refusal(self) -> str:
        """Reason why this is not a volume, if no defect explains it; otherwise empty."""

    @property
    def remarks(self) -> List[DicomDefect]:
        """Peculiarities that do not prevent reading."""

    @property
    def selector(self) -> str:
        """The series_uid for `read_volume`: the UID, with "#part" if needed."""

    @property
    def size(self) -> Tuple[Any, ...]:
        """Columns, rows, slices: the extents along x, y, z."""

    @property
    def spacing(self) -> Tuple[Any, ...]:
        """Spacing of columns, rows, slices; mm, 0 if unknown."""

    @property
    def uid(self) -> str:
        """Series Instance UID."""


class EmbeddingCertificate:
    """A graph embedded on a surface with its circle packing.

    Positions are unit vectors on the sphere (radius: the angle of a cap), otherwise (x, y) in the plane or in the Poincare
    disk (radius: a length; in the disk, hyperbolic). Half-edge 2e leaves the first end of edge e, 2e + 1 the second.
    """
    @property
    def face_positions(self) -> NDArray[Any]:
        """One row per face of the packed graph; a view."""

    @property
    def face_radii(self) -> NDArray[Any]:
        """Radii of the circles of the faces; a view."""

    @property
    def genus(self) -> int:
        """Genus of the surface."""

    @property
    def geometry(self) -> str:
        """"spherical" (genus 0), "euclidean" (1) or "hyperbolic"."""

    @property
    def graph(self) -> Graph:
        """Graph."""

    @property
    def node_positions(self) -> NDArray[Any]:
        """One row per packed node, starting with the graph's nodes; a view."""

    @property
    def node_radii(self) -> NDArray[Any]:
        """Radii of the circles of the packed nodes; a view."""

    @property
    def packed(self) -> Graph:
        """The 3-connected graph, including dummy nodes."""

    @property
    def periods(self) -> NDArray[Any]:
        """Periods of the torus: x1, y1, x2, y2; empty on other surfaces."""

    @property
    def rotation(self) -> List[int]:
        """Outgoing half-edges of all nodes, counterclockwise, in one list."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """Measurements by name."""

    @property
    def subdivided(self) -> List[List[int]]:
        """Edges subdivided into paths of the packed graph, as half-edges."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class EmbeddingVerdict:
    """Result of `verify_embedding`."""
    @property
    def is_valid(self) -> bool:
        """Whether the absence of crossings is proven."""

    @property
    def measures(self) -> Dict[str, Any]:
        """Measurements by name."""

    @property
    def refusal(self) -> str:
        """The first failed condition; otherwise empty."""


class FlatColon:
    """The flat wall of a colon with a grid of square pixels."""
    def __init__(self: FlatColon, surface: Mesh, pixel_size: float = 1.0) -> None:
        """surface: from `flattening.flatten_tube`.
            pixel_size: Pixel size of the flat colon at the mean circumference, rounded so that it divides the
                circumference. In mm, 0.05 to 20.
        """

    @property
    def circumference(self) -> float:
        """Mean circumference, mm."""

    def coordinates(self) -> NDArray[Any]:
        """Rows x columns x 3, float32: point in space of each pixel, LPS mm; NaN in holes."""

    def curvature(self) -> NDArray[Any]:
        """Rows x columns, float64: mean curvature, 1/mm; positive where the wall bulges into the lumen, NaN in holes."""

    def faces(self) -> NDArray[Any]:
        """Rows x columns, int32: the face at each pixel; -1 in holes."""

    def find(self, points: ArrayLike) -> Tuple[NDArray[Any], NDArray[Any]]:
        """uv on the map (k x 2) of points in space (k x 3, LPS, mm), and their distances from the wall (k); mm."""

    @property
    def length(self) -> float:
        """Length of the map, mm."""

    @property
    def pixel_size(self) -> float:
        """mm on the map."""

    def pixels(self, uv: ArrayLike) -> NDArray[Any]:
        """Pixels [row, column] (k x 2, int32) of points on the map (k x 2, mm). Rows may run against v."""

    @property
    def shape(self) -> Tuple[Any, ...]:
        """Rows (around the tube) and columns (along it) of the grid."""

    @property
    def surface(self) -> Mesh:
        """The flat surface."""


class Graph:
    """An undirected graph; loops and multiple edges are allowed."""
    def __init__(self: Graph, nodes: int, edges: Pairs = (), names: Sequence[str] = ()) -> None:
        """nodes: their number.
            edges: m x 2, indices of nodes.
            names: none, or one per node.
        """

    @property
    def edges(self) -> NDArray[Any]:
        """m x 2, int32: the ends of each edge; a read-only view."""

    @property
    def names(self) -> List[str]:
        """None, or one per node."""

    @property
    def nodes(self) -> int:
        """Number of nodes."""


class GraphComparison:
    """Comparison of two graphs."""
    @property
    def a(self) -> EmbeddingCertificate:
        """Certificate of the first graph in canonical order."""

    @property
    def b(self) -> EmbeddingCertificate:
        """Certificate of the second graph in canonical order."""

    @property
    def correspondence(self) -> List[int]:
        """Corresponding node of `b.graph` for each node of `a.graph`, or -1."""

    @property
    def correspondence_by(self) -> str:
        """"isomorphism", "names", "neighborhoods" or "none"."""

    @property
    def differences(self) -> List[str]:
        """Differences as sentences; empty for isomorphic graphs."""

    @property
    def isomorphic(self) -> bool:
        """Whether the graphs are isomorphic."""


class GraphCurvature:
    """Discrete Ricci curvature of a graph; no unit."""
    @property
    def denominators(self) -> NDArray[Any]:
        """Denominators of the exact curvatures, int64; 0 for loops."""

    @property
    def edges(self) -> NDArray[Any]:
        """One per edge; NaN for loops."""

    @property
    def node_means(self) -> NDArray[Any]:
        """Mean over the edges of each node; NaN without edges; a view."""

    @property
    def node_sums(self) -> NDArray[Any]:
        """Sum over the edges of each node; a view."""

    @property
    def numerators(self) -> NDArray[Any]:
        """Numerators of the exact curvatures of edges, int64."""

    @property
    def triangles(self) -> NDArray[Any]:
        """Common neighbors of the ends of each edge."""


class HaustralFold:
    """A haustral fold."""
    @property
    def angle(self) -> float:
        """Angle between the long axis and the tube, degrees; 90 is circumferential."""

    @property
    def arc_length(self) -> float:
        """mm along the centerline; NaN if unknown."""

    @property
    def area(self) -> float:
        """mm^2."""

    @property
    def center(self) -> NDArray[Any]:
        """LPS, mm."""

    @property
    def center_uv(self) -> NDArray[Any]:
        """Center on the map, mm."""

    @property
    def crosses_cut(self) -> bool:
        """Whether the fold extends across the cut."""

    @property
    def elongation(self) -> float:
        """Ratio of long to short axis."""

    @property
    def ends(self) -> NDArray[Any]:
        """2 x 3; LPS, mm."""

    @property
    def height(self) -> float:
        """Height of the crest above the wall, mm; NaN if not visible."""

    @property
    def label(self) -> int:
        """Label value, from 1."""

    @property
    def length(self) -> float:
        """Length along the crest, mm."""

    @property
    def mean_curvature(self) -> float:
        """1/mm."""

    @property
    def reliability(self) -> float:
        """0 to 1."""


class HaustralFolds:
    """Result of `find_folds`."""
    @property
    def folds(self) -> List[HaustralFold]:
        """List of HaustralFold, in label order."""

    @property
    def labels(self) -> NDArray[Any]:
        """Rows x columns, uint16: 0 wall, otherwise the label of a fold."""

    @property
    def warnings(self) -> List[str]:
        """Warnings, one per line."""


class HeatClass:
    """A class of voxels with similar heat: a line of the heat histogram."""
    @property
    def border_share(self) -> float:
        """Fraction of the voxels at the border of the volume, 0 to 1."""

    @property
    def coherence(self) -> Optional[float]:
        """Near 1 for a region bounded by edges, near 0 for speckle; None if not measured."""

    @property
    def components(self) -> int:
        """Converged closed components in the class."""

    @property
    def label(self) -> int:
        """0 is the background, 1 the class of lowest heat."""

    @property
    def lower_heat(self) -> float:
        """The class contains lower_heat <= heat < upper_heat."""

    @property
    def mean_heat(self) -> float:
        """Mean heat, in [0, 1]."""

    @property
    def normalized_heat(self) -> float:
        """Scale-invariant heat of closed components; 0 without any."""

    @property
    def upper_heat(self) -> float:
        """See lower_heat."""

    @property
    def volume(self) -> float:
        """mm^3."""

    @property
    def voxels(self) -> int:
        """Number of voxels."""


class HeatDiffusionMetric:
    """Heat diffusion distances along all edges."""
    @property
    def drowned_edges(self) -> int:
        """Edges with a length below rounding error, for example at the tip of a needle; set to the shortest possible length."""

    @property
    def edge_lengths(self) -> NDArray[Any]:
        """Edge lengths in the order of `surface_edges`; 1/mm."""

    @property
    def eigenpairs(self) -> int:
        """Number of eigenpairs; 0 for all."""

    @property
    def time(self) -> float:
        """mm^2."""


class HeatHistogram:
    """Counts of voxels by heat, one row per recorded time step."""
    @property
    def counts(self) -> NDArray[Any]:
        """Rows x 4097, uint32: voxels in each bin; a view."""

    @property
    def edges(self) -> NDArray[Any]:
        """4098 heat values: bin b contains edges[b] <= heat < edges[b + 1]. Bin 0 is the background, the others are 256 per factor of two."""

    def equalization(self) -> List[float]:
        """4098 numbers from 0 to 1, ascending: the fraction of the counts, without bin 0, below the lower edge of each bin, averaged over the rows."""

    @property
    def time_steps(self) -> List[int]:
        """Time steps of the rows, ascending."""


class HeatObject:
    """A region of heat with a border: a part that a person sees."""
    @property
    def center(self) -> NDArray[Any]:
        """Mean position of its voxels, LPS, mm."""

    @property
    def compactness(self) -> float:
        """36 pi volume^2 / surface^3: 1 for a ball."""

    @property
    def contrast(self) -> float:
        """Mean over its border of the absolute log ratio of the heat on both sides."""

    @property
    def cut(self) -> float:
        """Share of its border at the border of the volume."""

    @property
    def mean_heat(self) -> float:
        """Mean of its voxels."""

    @property
    def parent(self) -> int:
        """Number of the smallest object, from 1, that contains this one; 0 for none."""

    @property
    def probability(self) -> float:
        """Probability that it is one whole object, 0 to 1."""

    @property
    def range(self) -> float:
        """Range of border strengths over which its volume changes by less than a factor of 2, as a natural logarithm."""

    @property
    def score(self) -> float:
        """Of two objects of which one contains the other, a person more probably means the one with the greater score."""

    @property
    def volume(self) -> float:
        """mm^3."""

    @property
    def voxels(self) -> int:
        """Number of voxels, with those of objects in it."""


class HeatObjects:
    """Result of `find_objects`."""
    @property
    def labels(self) -> Image:
        """uint16: the number of the smallest object at each voxel; 0 for none."""

    def mask(self, number: int) -> Image:
        """uint8: 1 in an object, with those in it, otherwise 0."""

    @property
    def objects(self) -> List[HeatObject]:
        """By descending volume; the number of the first one is 1."""

    @property
    def warnings(self) -> List[str]:
        """What to do if no object was found."""


class HeatResult:
    """Result of `diffuse_heat`."""
    @property
    def classes(self) -> List[HeatClass]:
        """With coherence; empty unless components are requested."""

    @property
    def cold(self) -> bool:
        """Whether the volume has no edges; the heat is then 0 everywhere."""

    @property
    def components(self) -> List[ShapeComponent]:
        """Largest first; empty unless requested."""

    @property
    def heat(self) -> Image:
        """Heat after the last step, in [0, 1]; float32, on the grid of the input."""

    @property
    def histogram(self) -> HeatHistogram:
        """One row per step of histogram_steps reached."""

    @property
    def initial_heat(self) -> Optional[Image]:
        """Heat at step 0; None unless requested."""

    @property
    def p(self) -> float:
        """The p used."""

    @property
    def reasons(self) -> Dict[str, str]:
        """Reasons for the parameters chosen from the data; empty for given ones."""

    @property
    def smoothing(self) -> float:
        """Standard deviation of the smoothing, mm."""

    @property
    def steady(self) -> bool:
        """Whether the steady state was reached."""

    @property
    def time_step(self) -> int:
        """The last step computed."""

    @property
    def time_step_length(self) -> float:
        """dt, at most 1/12."""

    @property
    def window(self) -> Tuple[Any, ...]:
        """The intensities mapped to 0 and 1."""


class IleocecalValve:
    """The opening of the terminal ileum into the colon."""
    @property
    def arc_length(self) -> float:
        """mm along the centerline."""

    @property
    def attenuation(self) -> float:
        """Median HU inside; NaN without a CT."""

    @property
    def confidence(self) -> float:
        """0 to 1."""

    @property
    def length(self) -> float:
        """Greatest width, mm."""

    @property
    def position(self) -> NDArray[Any]:
        """LPS, mm."""

    @property
    def width(self) -> float:
        """Least width, mm."""


class MatchedFolds:
    """A pair of corresponding folds."""
    @property
    def prone_fold(self) -> int:
        """Label of the prone fold."""

    @property
    def prone_point(self) -> NDArray[Any]:
        """Center of the prone fold; LPS, mm."""

    @property
    def residual(self) -> float:
        """Distance between the mapped supine fold and the prone fold, mm."""

    @property
    def segment(self) -> str:
        """Segment in the supine position; "" if unknown."""

    @property
    def supine_fold(self) -> int:
        """Label of the supine fold."""

    @property
    def supine_point(self) -> NDArray[Any]:
        """Center of the supine fold; LPS, mm."""

    @property
    def weight(self) -> float:
        """Weight of the pair in the map, 0 to 1; pairs below 0.5 are ignored."""


class NamedShape:
    """A signature with a name, not necessarily unique."""
    def __init__(self: NamedShape, name: str, signature: ShapeSignature) -> None:
        """name: any text, not necessarily unique."""

    @property
    def name(self) -> str:
        """Any text."""

    @property
    def signature(self) -> ShapeSignature:
        """A ShapeSignature."""


class PolypCandidate:
    """A polyp-like location on the wall; not a clinical finding."""
    @property
    def apex(self) -> NDArray[Any]:
        """Most protruding point; LPS, mm."""

    @property
    def arc_length(self) -> float:
        """mm along the centerline; NaN if unknown."""

    @property
    def attenuation(self) -> float:
        """Median HU inside; NaN without a CT."""

    @property
    def axis(self) -> NDArray[Any]:
        """Unit vector from the wall into the lumen."""

    @property
    def diameter(self) -> float:
        """Largest width, mm."""

    @property
    def film_share(self) -> float:
        """Fraction of the surface coated with contrast, 0 to 1."""

    @property
    def height(self) -> float:
        """Height above the surrounding ring, mm."""

    @property
    def least_diameter(self) -> float:
        """Smallest width, mm."""

    @property
    def number(self) -> int:
        """Rank by descending score, from 1."""

    @property
    def other(self) -> Optional[PolypInOtherPosition]:
        """Result in the other position; None if it was not searched."""

    @property
    def position(self) -> NDArray[Any]:
        """Center of the head; LPS, mm."""

    @property
    def remark(self) -> str:
        """For example "the ileocecal valve"; otherwise empty."""

    @property
    def score(self) -> float:
        """Score of shape and tissue, 0 to 1."""

    @property
    def segment(self) -> int:
        """1 rectum to 6 cecum; 0 unknown."""

    @property
    def shape_score(self) -> float:
        """Score of the shape only, 0 to 1."""

    @property
    def size(self) -> str:
        """For example "6-9 mm"."""

    @property
    def submerged_share(self) -> float:
        """Fraction covered by tagged fluid, 0 to 1."""

    @property
    def tissue(self) -> str:
        """For example "soft tissue"."""

    @property
    def uv(self) -> NDArray[Any]:
        """Position on the flat map, mm; NaN without one."""

    @property
    def vertices(self) -> List[int]:
        """Wall vertices of the head."""


class PolypInOtherPosition:
    """Position of a candidate in the other position of the patient."""
    @property
    def candidate(self) -> int:
        """Number of the most similar candidate; 0 for none."""

    @property
    def confidence(self) -> float:
        """Confidence of the registration, 0 to 1."""

    @property
    def distance(self) -> float:
        """Distance to the most similar candidate in the other position, mm."""

    @property
    def is_excluded(self) -> bool:
        """Whether the corresponding wall cannot be assessed."""

    @property
    def is_seen(self) -> bool:
        """Whether a similar candidate was found."""

    @property
    def likeness(self) -> float:
        """Similarity of location, width and score, 0 to 1."""

    @property
    def own_score(self) -> float:
        """Score before weighting; otherwise NaN."""

    @property
    def point(self) -> NDArray[Any]:
        """Point on the other wall; LPS, mm."""


class Registration:
    """A map between the walls of two positions."""
    @property
    def confidence(self) -> float:
        """0 to 1; flagged below 0.5."""

    @property
    def doubts(self) -> List[str]:
        """Reasons for a flag; otherwise empty."""

    @property
    def flips(self) -> int:
        """Number of flipped triangles."""

    def map_points(self, points: ArrayLike, inverse: bool=False) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Maps the wall points nearest to k x 3 points (LPS, mm) from supine to prone, or back with `inverse`.

        Returns (points, k x 3, LPS mm; confidence, k, 0 to 1; excluded, k: wall not visible in one of the positions).
        """

    @property
    def matches(self) -> List[MatchedFolds]:
        """List of MatchedFolds, in the order of supine folds."""

    @property
    def prone_to_supine(self) -> Mesh:
        """The inverse map."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of registration.json of ColonRegistration."""

    @property
    def supine_to_prone(self) -> Mesh:
        """The flat supine wall with point arrays mapped (LPS, mm, on the prone wall), mappedUv, displacement (mm), confidence (0 to 1), excluded."""

    @property
    def warnings(self) -> List[str]:
        """Warnings, one per line."""


class SeededLabels:
    """Result of `SeededHeat.segment`."""
    @property
    def iterations(self) -> int:
        """Number of solver iterations; few after a small change of the seeds."""

    @property
    def labels(self) -> Image:
        """uint16: the label of highest probability."""

    @property
    def probabilities(self) -> Dict[int, Image]:
        """By label, an image: float32 in [0, 1]; the images sum to 1. Empty unless requested."""

    @property
    def uncertainty(self) -> Image:
        """float32: 1 minus the difference of the two greatest probabilities; 0 if one label is certain."""

    @property
    def warnings(self) -> List[str]:
        """Labels that hardly extend beyond their seeds, one per line."""


class ShapeComponent:
    """Voxels connected by edges of positive weight."""
    @property
    def closed(self) -> bool:
        """False if the component reaches the border of the volume."""

    @property
    def converged_heat(self) -> float:
        """Steady-state heat of each voxel."""

    @property
    def index(self) -> Tuple[Any, ...]:
        """First voxel, [z, y, x]."""

    @property
    def normalized_heat(self) -> float:
        """Area / (6 volume^(2/3)): 1 for a cube."""

    @property
    def surface_area(self) -> float:
        """mm^2; 0 for an open component."""

    @property
    def volume(self) -> float:
        """mm^3."""

    @property
    def voxels(self) -> int:
        """Number of voxels."""


class ShapeNeighbor:
    """An entry and its distance."""
    @property
    def distance(self) -> float:
        """At least 0; copies of one shape are about 1 apart."""

    @property
    def entry(self) -> int:
        """Index of the entry."""


class ShapeRow:
    """A shape of a label map."""
    @property
    def component(self) -> int:
        """1 for the largest; 0 for the whole label."""

    @property
    def intensity_deviation(self) -> float:
        """Standard deviation."""

    @property
    def label(self) -> int:
        """From 1."""

    @property
    def mean_intensity(self) -> float:
        """Not part of the signature."""

    @property
    def name(self) -> str:
        """"7" or, for a component, "7.1"."""

    @property
    def signature(self) -> ShapeSignature:
        """A ShapeSignature."""

    @property
    def voxels(self) -> int:
        """Number of voxels."""


class ShapeSearchResult:
    """Result of `find_shape`."""
    @property
    def neighbors(self) -> List[ShapeNeighbor]:
        """Nearest first."""

    @property
    def probability(self) -> float:
        """Probability that the nearest entry is the same shape, fitted to generated shapes."""

    @property
    def unknown(self) -> bool:
        """Whether the shape is probably none of the entries."""


class ShapeSignature:
    """Shape descriptors that are nearly invariant to position, rotation and sampling."""
    @property
    def displacement(self) -> NDArray[Any]:
        """25 values, ascending: mean squared displacement of heat in the insulated shape, divided by r^2."""

    @property
    def elongation(self) -> float:
        """Ratio of longest to middle standard deviation; at least 1."""

    @property
    def flatness(self) -> float:
        """Ratio of middle to shortest standard deviation; at least 1."""

    @property
    def remaining_heat(self) -> NDArray[Any]:
        """25 values, descending from 1: fraction of the heat remaining in the shape."""

    @property
    def spectrum(self) -> NDArray[Any]:
        """20 nonzero eigenvalues of the surface, times its area; the first one of a sphere is 8 pi."""

    @property
    def surface(self) -> float:
        """mm^2."""

    @property
    def times(self) -> NDArray[Any]:
        """25 values of t / r^2 for both curves, with r the radius of the ball of equal volume."""

    @property
    def volume(self) -> float:
        """mm^3."""


class ShapeTable:
    """Result of `describe_shapes`."""
    @property
    def rows(self) -> List[ShapeRow]:
        """Rows by label, then component."""

    @property
    def warnings(self) -> List[str]:
        """Skipped shapes, one per line."""


class ShapetonResult:
    """Result of `diffuse_shapetons`."""
    @property
    def change(self) -> float:
        """Change of the density in the last step (3.10)."""

    @property
    def coverage(self) -> float:
        """Fraction of the object voxels reached, 0 to 1."""

    @property
    def density(self) -> Image:
        """Visits divided by their maximum, in [0, 1]; float32, computed on access."""

    @property
    def distance(self) -> float:
        """Step length, in units of the longest side."""

    @property
    def histogram(self) -> HeatHistogram:
        """One row per step of histogram_steps."""

    @property
    def p(self) -> float:
        """The p used."""

    @property
    def reason_of_distance(self) -> str:
        """Reason for the distance, if chosen by feature_size; otherwise empty."""

    @property
    def shapetons(self) -> int:
        """Number of shapetons."""

    @property
    def smoothing(self) -> float:
        """Standard deviation of the smoothing, mm."""

    @property
    def steady(self) -> bool:
        """Whether the steady state was reached."""

    @property
    def time_step(self) -> int:
        """The last step computed."""

    @property
    def trapped(self) -> int:
        """Shapetons in voxels disconnected from all neighbors."""

    @property
    def visits(self) -> Image:
        """Number of visits of each voxel; uint32. The sum is shapetons x steps."""


class SurfaceHandle:
    """A handle of a flattened surface."""
    @property
    def flat_place(self) -> NDArray[Any]:
        """Position on the map, mm."""

    @property
    def genus(self) -> int:
        """Number of handles: more than 1 if they cannot be separated."""

    @property
    def place(self) -> NDArray[Any]:
        """LPS, mm."""

    @property
    def radius(self) -> float:
        """mm."""

    @property
    def vertices(self) -> List[int]:
        """Vertices of the flattened surface, ascending."""


class SurfaceRicciFlow:
    """A surface with a metric of prescribed curvature."""
    @property
    def curvatures(self) -> NDArray[Any]:
        """Curvature of each vertex, radians."""

    @property
    def edge_lengths(self) -> NDArray[Any]:
        """Geodesic length in place of each edge, in the order of surfaces.surface_edges."""

    @property
    def flat(self) -> Mesh:
        """The cut surface in space with the point array uv (mm, or in the unit disk) or sphere."""

    @property
    def flips(self) -> int:
        """Number of flips during the flow."""

    @property
    def genus(self) -> int:
        """Number of handles."""

    @property
    def log_scales(self) -> NDArray[Any]:
        """Logarithm of the length scale at each vertex."""

    @property
    def modulus(self) -> float:
        """Circumference over length of a flat tube; 0 for others."""

    @property
    def residual(self) -> float:
        """Largest curvature error, radians."""

    @property
    def sides(self) -> NDArray[Any]:
        """Side lengths of these faces, from each corner to the next."""

    @property
    def statistics(self) -> Dict[str, Any]:
        """A dictionary with the keys of the statistics of SurfaceRicciFlow."""

    @property
    def steps(self) -> int:
        """Number of Newton steps."""

    @property
    def tau(self) -> complex:
        """Quotient of the periods of a flat torus; 0 for others."""

    @property
    def triangles(self) -> NDArray[Any]:
        """Faces of the final triangulation."""

    @property
    def warnings(self) -> List[str]:
        """Doubtful results, one per line."""


class SurfaceSpectrum:
    """The smoothest eigenfunctions of a surface of n vertices."""
    def diffusion_distance(self, p: int, q: int, time: float) -> float:
        """The diffusion distance: L2 distance at `time` (mm^2) of the heat of unit sources at two vertices; 1/mm."""

    def diffusion_distances(self, p: int, time: float) -> NDArray[Any]:
        """The distances from vertex p to all vertices, n values; 1/mm."""

    @property
    def eigenfunctions(self) -> NDArray[Any]:
        """n x k, in columns; 1/mm. A view."""

    @property
    def eigenvalues(self) -> NDArray[Any]:
        """k, ascending from 0; 1/mm^2."""

    def heat_kernel(self, p: int, q: int, time: float) -> float:
        """Heat at vertex q at `time` (mm^2) from a unit source at vertex p; 1/mm^2."""

    @property
    def residuals(self) -> NDArray[Any]:
        """k, relative to the largest eigenvalue."""

    def share_of_last_pair(self, time: float) -> float:
        """Remaining fraction of the last pair at `time` (mm^2): order of magnitude of the truncation error."""

    def signature(self, time: float) -> NDArray[Any]:
        """The heat kernel signature, n values: the remaining heat of a unit source at each vertex; 1/mm^2."""

    def signature_times(self, number: int=4) -> List[float]:
        """Suggested times (mm^2) for the signature, logarithmically spaced."""

