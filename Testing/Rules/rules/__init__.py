"""Rules of the repository. A rule is a function that takes a Tree and yields its faults."""
