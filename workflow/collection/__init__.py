"""Benchmarks on public collections of CT colonography; see ../README.md."""
