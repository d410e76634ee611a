"""prepare.py TABLE OUTPUT TOOLS MEMORY PACS SEND KEYS [OPTIONS...]: checks the table, and writes the input of
the Snakefile, OUTPUT/cohort.json. Empty arguments: no memory limit, no PACS, no sending, no
de-identification."""

import json
import os
import sys

from cohort.check import checked_subjects
from cohort.files import write_whole


def main():
    table, output, tools, memory, pacs, send, keys = sys.argv[1:8]
    subjects = checked_subjects(table, output, pacs, send, sys.argv[8:])
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
