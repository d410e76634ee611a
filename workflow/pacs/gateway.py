#!/usr/bin/python3
"""gateway.py FOLDER: delivers all instances in the Orthanc of FOLDER to the PACS.

Storage commitment is requested for each instance first, and only instances missing in the PACS are sent. So no instance is
lost or sent twice after a kill: instances not marked as committed are queried again. waiting.tsv lists the waiting
instances with the reasons.
A committed instance is kept for a day, so its sender still finds it; an instance sent again is only queried, not forwarded
again."""

import base64
import json
import os
import sys
import time
import urllib.error
import urllib.request

COMMITTED = "1024"  # first user-defined metadata number of Orthanc
KEPT = 86400  # s
LONGEST_PAUSE = 60  # s
LONGEST_SILENCE = 3600  # s, until a PACS without a report is queried again
AT_ONCE = 200  # instances per request


class Refused(Exception):
    """An error reported by Orthanc."""


class Orthanc:
    """The REST interface of the Orthanc configured in a folder."""

    def __init__(self, folder):
        with open(f"{folder}/orthanc.json", encoding="utf-8") as file:
            settings = json.load(file)
        (user,) = settings["RegisteredUsers"].items()
        self.root = f"http://127.0.0.1:{settings['HttpPort']}"
        self.patience = 20 * settings["DicomScuTimeout"]
        self.heads = {"Authorization": "Basic " + base64.b64encode(":".join(user).encode()).decode()}

    def call(self, method, path, body=None):
        data = body.encode() if isinstance(body, str) else None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data, self.heads, method=method)
        try:
            with urllib.request.urlopen(request, timeout=self.patience) as answer:
                text = answer.read()
        except urllib.error.HTTPError as error:
            raise Refused(words_of(error.read())) from None
        return json.loads(text) if text else None

    def wait_until_it_answers(self):
        while True:
            try:
                return self.call("GET", "/system")
            except (urllib.error.URLError, Refused):  # another Orthanc uses the port; ours will report this and exit
                time.sleep(0.1)


def words_of(answer):
    """Returns an error of Orthanc as one line."""
    try:
        error = json.loads(answer)
    except ValueError:
        return answer.decode(errors="replace").strip()
    words = " ".join(f"{error.get('Message', '')}: {error.get('Details', '')}".split()).strip(": ")
    if words.endswith("to one of [ ]"):  # no transfer syntax accepted
        return "the PACS does not accept objects of this class: the presentation context was refused"
    return words + (": the PACS is out of resources, possibly its disk is full" if "DIMSE status 0xA7" in words else "")


class Queue:
    """The instances not committed by the PACS, each with the reason."""

    def __init__(self, folder, orthanc):
        self.list = f"{folder}/waiting.tsv"
        self.orthanc = orthanc
        self.last_change = 0
        self.waiting = {}  # instance: reason
        self.uids = {}  # instance: SOP Instance UID
        self.unasked = set()
        self.reports = {}  # storage commitment transaction: (instances, time)
        self.kept = []  # (time, instance) of committed instances, oldest first
        self.taken = 0  # number of instances accepted or committed by the PACS
        self.reported = None

    def take_new(self):
        """Returns whether new instances arrived since the last call; the first call includes all instances in Orthanc."""
        new, is_done = [], False
        while not is_done:
            changes = self.orthanc.call("GET", f"/changes?since={self.last_change}&limit=1000")
            self.last_change, is_done = changes["Last"], changes["Done"]
            new += [change["ID"] for change in changes["Changes"] if change["ChangeType"] == "NewInstance"]
        for content in self.orthanc.call("POST", "/tools/bulk-content", {"Resources": new, "Metadata": True}) if new else []:
            if COMMITTED in content["Metadata"]:
                self.kept.append((float(content["Metadata"][COMMITTED]), content["ID"]))
                continue
            self.uids[content["ID"]] = content["MainDicomTags"]["SOPInstanceUID"]
            self.waiting[content["ID"]] = "not queried yet"
            self.unasked.add(content["ID"])
        self.kept.sort()
        return bool(new)

    def ask(self):
        """Requests storage commitment for the new instances."""
        while self.unasked:
            some = sorted(self.unasked)[:AT_ONCE]
            answer = self.orthanc.call("POST", "/modalities/pacs/storage-commitment", {"Resources": some})
            self.reports[answer["ID"]] = (some, time.time())
            self.unasked.difference_update(some)

    def collect(self):
        """Marks committed instances; returns those missing in the PACS."""
        lacking = []
        for transaction, (asked, begin) in list(self.reports.items()):
            report = self.orthanc.call("GET", f"/storage-commitment/{transaction}")
            if report["Status"] == "Pending":
                self.waiting.update(dict.fromkeys(asked, "the PACS has not reported yet; check title and port of the gateway in its configuration"))
                if time.time() - begin < LONGEST_SILENCE:
                    continue
            del self.reports[transaction]
            committed = {entry["SOPInstanceUID"] for entry in report["Success"]}
            there = [instance for instance in asked if instance in self.waiting]
            self.unasked.update(there)
            for instance in there:
                if self.uids[instance] in committed:
                    self.mark(instance)
                elif report["Status"] != "Pending":
                    lacking.append(instance)
        return lacking

    def mark(self, instance):
        now = time.time()
        self.orthanc.call("PUT", f"/instances/{instance}/metadata/{COMMITTED}", str(now))
        self.kept.append((now, instance))
        self.forget([instance])
        self.taken += 1

    def send(self, lacking):
        """Sends each instance separately, so a rejected one does not block others and has a separate reason."""
        for instance in lacking:
            try:
                self.orthanc.call("POST", "/modalities/pacs/store", {"Resources": [instance]})
                self.waiting[instance] = "sent, not committed yet"
                self.taken += 1
            except Refused as error:
                self.waiting[instance] = str(error)
                self.orthanc.call("POST", "/modalities/pacs/echo", {})  # stops sending if the echo fails

    def forget(self, instances):
        for instance in instances:
            del self.waiting[instance], self.uids[instance]
        self.unasked.difference_update(instances)

    def forget_removed(self):
        """Handles instances deleted in Orthanc by a user."""
        self.forget(set(self.waiting).difference(self.orthanc.call("GET", "/instances")))

    def forget_old(self):
        while self.kept and self.kept[0][0] < time.time() - KEPT:
            self.orthanc.call("DELETE", f"/instances/{self.kept.pop(0)[1]}")

    def tell(self):
        """Writes the waiting instances; prints their number if it has changed."""
        lines = sorted(f"{self.uids[instance]}\t{reason}\n" for instance, reason in self.waiting.items())
        with open(self.list + ".part", "w", encoding="utf-8") as file:
            file.write("instance\treason\n" + "".join(lines))
        os.replace(self.list + ".part", self.list)
        reported = (len(lines), lines[0].split("\t")[1].strip() if lines else "")
        if reported != self.reported:
            print("waiting: {}{}".format(reported[0], f"; the first: {reported[1]}" if reported[1] else ""), flush=True)
        self.reported = reported

    def step(self):
        """Sends an instance; returns whether the PACS accepted it."""
        before = self.taken
        try:
            self.send(self.collect())
            self.ask()
            self.forget_old()
        except Refused as error:
            self.forget_removed()
            self.waiting.update(dict.fromkeys(self.unasked, str(error)))
        self.tell()
        return self.taken > before


def main():
    orthanc = Orthanc(sys.argv[1])
    orthanc.wait_until_it_answers()
    queue = Queue(sys.argv[1], orthanc)
    pause = 1
    while True:
        is_new = queue.take_new()
        pause = 1 if queue.step() or is_new else min(2 * pause, LONGEST_PAUSE)
        for _ in range(pause):
            time.sleep(1)
            if queue.take_new():
                break


if __name__ == "__main__":
    main()
