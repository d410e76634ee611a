"""Graphs of other packages."""

from __future__ import annotations

from typing import Any, Iterable, List, Tuple

import numpy as np

from ._shapeton import Graph, InputError, ParameterError


def graph_of(graph: Any) -> Graph:
    """A graph from one of networkx, a list or m x 2 array of edges, or an adjacency matrix of numpy or scipy."""
    if isinstance(graph, Graph):
        return graph
    if hasattr(graph, "nodes") and hasattr(graph, "is_directed"):
        if graph.is_directed():
            raise InputError("the graph is directed; use graph.to_undirected()")
        return _of_named_edges(graph.nodes, graph.edges())
    if hasattr(graph, "tocoo"):
        graph = graph.toarray()
    if isinstance(graph, np.ndarray) and graph.ndim == 2:
        if graph.shape[1] == 2:
            return _of_numbers(graph)
        if graph.shape[0] == graph.shape[1]:
            return _of_matrix(graph)
    if isinstance(graph, (list, tuple)) and all(isinstance(edge, (list, tuple)) and len(edge) == 2 for edge in graph):
        whole = all(isinstance(end, (int, np.integer)) for edge in graph for end in edge)
        return _of_numbers(np.asarray(graph).reshape(-1, 2)) if whole else _of_named_edges((), graph)
    raise TypeError(f"{type(graph).__name__} is not a graph of networkx, a list of edges or an adjacency matrix")


def _of_numbers(edges: Any) -> Graph:
    return Graph(int(edges.max()) + 1 if len(edges) > 0 else 0, edges)


def _of_named_edges(nodes: Iterable[Any], edges: Iterable[Tuple[Any, Any]]) -> Graph:
    """Nodes are numbered in their order, then in the order of the edges."""
    numbers = {node: number for number, node in enumerate(nodes)}
    ends: List[Tuple[int, int]] = [(numbers.setdefault(a, len(numbers)), numbers.setdefault(b, len(numbers))) for a, b in edges]
    return Graph(len(numbers), ends, [str(node) for node in numbers])


def _of_matrix(matrix: Any) -> Graph:
    """An edge for each nonzero entry on or above the diagonal."""
    if not np.array_equal(matrix, matrix.T):
        raise ParameterError("the adjacency matrix is not symmetric: the graph is directed")
    return Graph(len(matrix), np.argwhere(np.triu(matrix)))
