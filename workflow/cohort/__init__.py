"""What the workflow of cohorts is made of, by the standard library alone. See ../README.md."""
