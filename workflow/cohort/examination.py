"""examination.py SUBJECT ATTEMPT MEGABYTES COMMAND...: runs COMMAND SUBJECT/exam ... and records the outcome.

SUBJECT/status.json is written if no retry is needed: done (status 0), unsuitable (2: wrong usage; 3: the input).
Everything else (status 1, killed, out of memory) is a failure of this program, and Snakemake decides on a retry.
SUBJECT/attempt.json describes the last attempt; the end is missing if the attempt was killed with its job."""

import datetime
import fcntl
import json
import os
import resource
import signal
import socket
import subprocess
import sys

from cohort.files import write_whole

OUTCOMES = {0: "done", 2: "unsuitable", 3: "unsuitable"}


def alone(path):
    """Waits for processes left by a killed workflow. The file is open in this process and all its children, so the
    next attempt waits for all of them."""
    lock = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
    os.set_inheritable(lock, True)
    fcntl.flock(lock, fcntl.LOCK_EX)


def run(command, log_path):
    """Runs a command; returns its exit status as in a shell, and the last line of the log."""
    with open(log_path, "w", encoding="utf-8") as log:
        status = subprocess.run(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL, close_fds=False).returncode
    with open(log_path, encoding="utf-8", errors="replace") as log:
        lines = [line.strip() for line in log if line.strip()]
    return (status if status >= 0 else 128 - status), (lines[-1] if lines else "")


def message_of(status, last_line):
    """Returns the reason of a failure as one line; a killed tool prints none."""
    if status == 0:
        return ""
    if status > 128:
        return f"killed by {signal.Signals(status - 128).name}" + (", possibly out of memory" if status == 137 else "")
    return last_line or f"the tool exited with status {status} without a message"


def main():
    subject, attempt, megabytes = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    alone(f"{subject}/.lock")
    record = {"attempt": attempt, "askedMB": megabytes, "host": socket.gethostname(), "job": os.environ.get("SLURM_JOB_ID", "")}
    begin = datetime.datetime.now(datetime.timezone.utc)
    record["begin"] = begin.isoformat(timespec="seconds")
    write_whole(f"{subject}/attempt.json", json.dumps(record, indent=1))
    status, last_line = run(sys.argv[4:], f"{subject}/log.txt")
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    record["seconds"] = round((datetime.datetime.now(datetime.timezone.utc) - begin).total_seconds(), 1)
    record["processorSeconds"] = round(usage.ru_utime + usage.ru_stime, 1)
    record["memoryMB"] = usage.ru_maxrss // 1024  # peak of the largest process; the stages run one after another
    end = {"exitStatus": status, "message": message_of(status, last_line)}
    write_whole(f"{subject}/attempt.json", json.dumps({**record, **end}, indent=1))
    if status not in OUTCOMES:
        sys.exit(f"{subject}: attempt {attempt}: {end['message']}")
    write_whole(f"{subject}/status.json", json.dumps({"outcome": OUTCOMES[status], **end}, indent=1))


if __name__ == "__main__":
    main()
