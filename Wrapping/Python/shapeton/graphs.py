"""Graphs: crossing-free embeddings by circle packing, certificates that prove them crossing-free, and comparison."""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

from . import _shapeton
from ._arguments import Pairs, Path, Progress
from ._calls import constructor, public
from ._shapeton import EmbeddingCertificate, EmbeddingVerdict, Graph, GraphComparison

__all__ = [
    "EmbeddingCertificate",
    "EmbeddingVerdict",
    "Graph",
    "GraphComparison",
    "compare_graphs",
    "complete_bipartite_graph",
    "complete_graph",
    "embed_graph",
    "grid_graph",
    "hypercube_graph",
    "read_certificate",
    "read_graph",
    "torus_grid",
    "verify_embedding",
    "write_certificate",
    "write_graph",
]


@constructor(Graph)
def _graph(self: Graph, nodes: int, edges: Pairs, names: Sequence[str] = ()) -> None:
    """nodes: their number.
    edges: m x 2, indices of nodes.
    names: none, or one per node.
    """


@public
def read_graph(path: Path) -> Graph:
    """Reads GraphML, GML, DOT, edge lists, METIS, MATPOWER, PACE, graph6 or sparse6."""
    return _shapeton.read_graph(path)


@public
def write_graph(graph: Graph, path: Path) -> None:
    """Writes GraphML."""
    _shapeton.write_graph(graph, path)


@public
def complete_graph(nodes: int) -> Graph:
    """The complete graph."""
    return _shapeton.complete_graph(nodes)


@public
def complete_bipartite_graph(left: int, right: int) -> Graph:
    """The complete bipartite graph."""
    return _shapeton.complete_bipartite_graph(left, right)


@public
def grid_graph(columns: int, rows: int) -> Graph:
    """Node (c, r) is r * columns + c."""
    return _shapeton.grid_graph(columns, rows)


@public
def hypercube_graph(dimension: int) -> Graph:
    """The hypercube graph with 2^dimension nodes; nodes that differ in one bit are adjacent."""
    return _shapeton.hypercube_graph(dimension)


@public
def torus_grid(columns: int, rows: int, diagonals: bool = False) -> Tuple[Graph, List[List[int]]]:
    """The grid with periodic boundaries, embedded on the torus: (Graph, rotation), see `embed_graph`."""
    return _shapeton.torus_grid(columns, rows, diagonals)


@public
def read_certificate(path: Path) -> EmbeddingCertificate:
    """Reads a certificate (JSON)."""
    return _shapeton.read_certificate(path)


@public
def write_certificate(certificate: EmbeddingCertificate, path: Path) -> None:
    """Writes a certificate as JSON without loss of precision."""
    _shapeton.write_certificate(certificate, path)


@public
def embed_graph(
    graph: Graph,
    *,
    genus: Optional[int] = None,
    rotation: Optional[Sequence[Sequence[int]]] = None,
    seed: int = 1,
    augmentation: str = "ring",
    infinity: str = "circle",
    progress: Optional[Progress] = None,
) -> EmbeddingCertificate:
    """Embeds a graph without crossings by a circle packing computed with discrete Ricci flow.

    genus: of the surface: 0 sphere, 1 flat torus, from 2 hyperbolic; None: the smallest found.
    rotation: for each node the half-edges that leave it, counterclockwise; replaces the search.
    seed: of the search.
    augmentation: "ring" adds dummy nodes if no packing exists, "none" does not.
    infinity: "circle" or "edgeNode", on the sphere.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.embed_graph(graph, genus, rotation, seed, augmentation, infinity, progress)


@public
def verify_embedding(certificate: EmbeddingCertificate) -> EmbeddingVerdict:
    """Proves from the numbers of an embedding that no edges cross, or reports the failed condition."""
    return _shapeton.verify_embedding(certificate)


@public
def compare_graphs(a: Graph, b: Graph, seed: int = 1, *, progress: Optional[Progress] = None) -> GraphComparison:
    """Determines whether two graphs are isomorphic, embeds both and reports the differences.

    seed: of the search for embeddings.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.compare_graphs(a, b, seed, progress)
