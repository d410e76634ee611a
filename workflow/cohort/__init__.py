"""The cohort workflow; uses the standard library only. See ../README.md."""
