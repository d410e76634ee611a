"""Graphs of other packages."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping, Set
from typing import Any, List, Tuple

import numpy as np

from ._shapeton import Graph, InputError, ParameterError


def graph_of(graph: Any) -> Graph:
    """A graph from one of networkx, edges as pairs or an m x 2 array, or an adjacency matrix of numpy or scipy.

    Weights are left out, with a warning.
    """
    if isinstance(graph, Graph):
        return graph
    if hasattr(graph, "nodes") and hasattr(graph, "is_directed"):
        if graph.is_directed():
            raise InputError("the graph is directed; use graph.to_undirected()")
        if any(data.get("weight", 1) != 1 for _, _, data in graph.edges(data=True)):
            _warn_of_weights()
        return _of_named_edges(graph.nodes, graph.edges())
    if hasattr(graph, "tocoo"):
        return _of_matrix(graph.toarray())
    is_mapping = isinstance(graph, Mapping) and not isinstance(graph, Set)  # the edges of networkx are both
    if not isinstance(graph, Iterable) or is_mapping or isinstance(graph, (str, bytes)):
        raise TypeError(f"{type(graph).__name__} is not a graph of networkx, edges or an adjacency matrix")
    return _of_array(graph) if isinstance(graph, np.ndarray) else _of_rows(list(graph))


def _warn_of_weights() -> None:
    warnings.warn("the weights of the edges are left out: all edges count the same", stacklevel=2)


def _of_rows(rows: List[Any]) -> Graph:
    if len(rows) > 2 and all(isinstance(row, list) and len(row) == len(rows) for row in rows):
        return _of_matrix(np.asarray(rows))
    if not all(isinstance(row, (list, tuple, np.ndarray)) and len(row) == 2 for row in rows):
        raise ParameterError("each edge must be a pair of nodes; leave out weights and other data")
    whole = all(isinstance(end, (int, np.integer)) for row in rows for end in row)
    return _of_numbers(np.asarray(rows).reshape(-1, 2)) if whole else _of_named_edges((), rows)


def _of_array(array: Any) -> Graph:
    if array.ndim == 2 and array.shape[1] == 2:
        return _of_numbers(array)
    if array.ndim == 2 and array.shape[0] == array.shape[1]:
        return _of_matrix(array)
    raise ParameterError(f"an array of shape {array.shape} is neither m x 2 edges nor an adjacency matrix")


def _of_numbers(edges: Any) -> Graph:
    if edges.dtype.kind not in "iu" and edges.size > 0:
        raise ParameterError(f"edges must be pairs of whole numbers, not {edges.dtype}; names are given in a list of pairs")
    if edges.size > 0 and edges.max() >= np.iinfo(np.int32).max:
        raise ParameterError(f"the index {edges.max()} of a node is beyond 2^31 - 2; number the nodes from 0")
    return Graph(int(edges.max()) + 1 if len(edges) > 0 else 0, edges)


def _of_named_edges(nodes: Iterable[Any], edges: Iterable[Tuple[Any, Any]]) -> Graph:
    """Nodes are numbered in their order, then in the order of the edges."""
    numbers = {node: number for number, node in enumerate(nodes)}
    ends: List[Tuple[int, int]] = [(numbers.setdefault(a, len(numbers)), numbers.setdefault(b, len(numbers))) for a, b in edges]
    names = [str(node) for node in numbers]
    unique = len(set(names)) == len(names)  # 1 and "1" are two nodes
    return Graph(len(numbers), ends, names if unique else [repr(node) for node in numbers])


def _of_matrix(matrix: Any) -> Graph:
    """An edge for each nonzero entry on or above the diagonal."""
    if matrix.dtype.kind not in "buif" or not np.all(np.isfinite(matrix)):
        raise ParameterError("the adjacency matrix must have finite real numbers")
    if not np.array_equal(matrix, matrix.T):
        raise ParameterError("the adjacency matrix is not symmetric: the graph is directed")
    if np.any((matrix != 0) & (matrix != 1)):
        _warn_of_weights()
    return Graph(len(matrix), np.argwhere(np.triu(matrix)))
