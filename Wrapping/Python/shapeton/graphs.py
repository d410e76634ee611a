"""Graphs: crossing-free embeddings by circle packing, certificates that prove them crossing-free, and comparison."""

from ._shapeton import (
    EmbeddingCertificate,
    EmbeddingVerdict,
    Graph,
    GraphComparison,
    compare_graphs,
    complete_bipartite_graph,
    complete_graph,
    embed_graph,
    grid_graph,
    hypercube_graph,
    read_certificate,
    read_graph,
    torus_grid,
    verify_embedding,
    write_certificate,
    write_graph,
)

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
