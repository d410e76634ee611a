"""examination.py SUBJECT ATTEMPT MEGABYTES COMMAND...: runs COMMAND SUBJECT/exam ..., and writes how it ended.

SUBJECT/status.json is written where another attempt is of no use: done (status 0), unsuitable (2: wrong use; 3: the input).
All else (status 1, killed, no memory) is a failure of this program, and Snakemake decides whether it is tried again.
SUBJECT/attempt.json tells about the last attempt; what was killed with its job has no end in it."""

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
    """Waits for what a killed workflow has left behind. The file stays open here and in all that is started from here, so the
    next one waits for the last of these processes, whoever of them was killed."""
    lock = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
    os.set_inheritable(lock, True)
    fcntl.flock(lock, fcntl.LOCK_EX)


def run(command, log_path):
    """Exit status as a shell has it, and the last line of the log."""
    with open(log_path, "w", encoding="utf-8") as log:
        status = subprocess.run(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL, close_fds=False).returncode
    with open(log_path, encoding="utf-8", errors="replace") as log:
        lines = [line.strip() for line in log if line.strip()]
    return (status if status >= 0 else 128 - status), (lines[-1] if lines else "")


def message_of(status, last_line):
    """One line that says why; a killed tool has said nothing."""
    if status == 0:
        return ""
    if status > 128:
        return f"killed by {signal.Signals(status - 128).name}" + (", perhaps for want of memory" if status == 137 else "")
    return last_line or f"the tool ended with status {status} and said nothing"


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
    record["memoryMB"] = usage.ru_maxrss // 1024  # of the largest process; the stages run one after another
    end = {"exitStatus": status, "message": message_of(status, last_line)}
    write_whole(f"{subject}/attempt.json", json.dumps({**record, **end}, indent=1))
    if status not in OUTCOMES:
        sys.exit(f"{subject}: attempt {attempt}: {end['message']}")
    write_whole(f"{subject}/status.json", json.dumps({"outcome": OUTCOMES[status], **end}, indent=1))


if __name__ == "__main__":
    main()
