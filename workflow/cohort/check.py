"""check.py TABLE OUTPUT PACS SEND [OPTIONS...]: checks the table and the options; prints all errors, and writes nothing."""

import os
import sys

from cohort.table import TableError, read_table


def checked_subjects(table, output, pacs, send, options):
    """Returns the subjects of the table, or ends the program with all errors."""
    try:
        subjects = read_table(table, lambda subject: os.path.exists(f"{output}/{subject}/status.json"))
    except TableError as error:
        sys.exit(str(error))
    if not pacs and any(row.query for series in subjects.values() for row in series):
        sys.exit(f"{table}: contains queries to a PACS; describe it with --pacs FILE")
    if send and "--dicomResults" not in options:
        sys.exit("--send requires DICOM results; add: -- --dicomResults")
    return subjects


if __name__ == "__main__":
    checked_subjects(*sys.argv[1:5], sys.argv[5:])
