"""prepare.py TABLE OUTPUT TOOLS MEMORY PACS SEND KEYS [OPTIONS...]: checks everything before any work, and writes the
input of the Snakefile, OUTPUT/cohort.json. Empty arguments: no memory limit, no PACS, no sending, no
de-identification."""

import json
import os
import sys

from cohort.files import write_whole
from cohort.table import TableError, absent_sources, read_table


def main():
    table, output, tools, memory, pacs, send, keys = sys.argv[1:8]
    try:
        subjects = read_table(table)
    except TableError as error:
        sys.exit(str(error))
    absent = absent_sources(subjects, lambda subject: os.path.exists(f"{output}/{subject}/status.json"))
    if absent:
        sys.exit("\n".join(f"{table}, {line}" for line in absent))
    if not pacs and any(row.query for series in subjects.values() for row in series):
        sys.exit(f"{table}: contains queries to a PACS; describe it with --pacs FILE")
    if send and "--dicomResults" not in sys.argv[8:]:
        sys.exit("--send requires DICOM results; add: -- --dicomResults")
    for subject in subjects:
        os.makedirs(f"{output}/{subject}", exist_ok=True)  # Slurm does not start a job if the folder of its log is missing
    settings = {
        "table": os.path.abspath(table),
        "tools": os.path.abspath(tools),
        "memoryMB": int(memory) if memory else None,
        "pacs": os.path.abspath(pacs) if pacs else None,
        "send": os.path.abspath(send) if send else None,
        "keys": os.path.abspath(keys) if keys else None,
        "options": sys.argv[8:],
    }
    write_whole(f"{output}/cohort.json", json.dumps(settings, indent=1) + "\n")
    count = sum(len(series) for series in subjects.values())
    print(f"{len(subjects)} examinations, {count} series")


if __name__ == "__main__":
    main()
