#!/usr/bin/python3
"""gateway.py FOLDER: sees to it that all that the Orthanc of FOLDER holds comes to the PACS.

Each instance is asked for first (storage commitment), and is sent only when the PACS answers that it lacks it. So nothing is lost
or sent twice, whatever is killed: what is not marked as committed is asked for again. What waits, and why, is in waiting.tsv.
A committed instance is kept for a day, so that its sender still finds it; the next one is asked for, too, and not sent."""

import base64
import json
import os
import sys
import time
import urllib.error
import urllib.request

COMMITTED = "1024"  # Orthanc's number of the first metadata that users may define
KEPT = 86400  # s
LONGEST_PAUSE = 60  # s
LONGEST_SILENCE = 3600  # s, until a PACS that has not reported is asked again
AT_ONCE = 200  # instances in a request


class Refused(Exception):
    """What Orthanc could not do, in its words."""


class Orthanc:
    """The REST interface of the Orthanc that is configured in a folder."""

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
            except (urllib.error.URLError, Refused):  # refused by another one that has the port; ours will say so and end
                time.sleep(0.1)


def words_of(answer):
    """An error of Orthanc as one line."""
    try:
        error = json.loads(answer)
    except ValueError:
        return answer.decode(errors="replace").strip()
    words = " ".join(f"{error.get('Message', '')}: {error.get('Details', '')}".split()).strip(": ")
    if words.endswith("to one of [ ]"):  # no transfer syntax was accepted
        return "the PACS takes no objects of this class: the presentation context was refused"
    return words + (": it is out of resources, perhaps its disk is full" if "DIMSE status 0xA7" in words else "")


class Queue:
    """The instances that the PACS has not committed to: each with the reason why it waits."""

    def __init__(self, folder, orthanc):
        self.list = f"{folder}/waiting.tsv"
        self.orthanc = orthanc
        self.last_change = 0
        self.waiting = {}  # instance: reason
        self.uids = {}  # instance: SOP Instance UID
        self.unasked = set()
        self.reports = {}  # storage commitment transaction: (instances, time)
        self.kept = []  # (time, instance) of those that are committed, the oldest first
        self.taken = 0  # how often the PACS took an instance or committed to one
        self.told = None

    def take_new(self):
        """Whether instances came since the last call; at first these are all that Orthanc holds."""
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
            self.waiting[content["ID"]] = "not asked for yet"
            self.unasked.add(content["ID"])
        self.kept.sort()
        return bool(new)

    def ask(self):
        """Asks whether the PACS commits to the instances that were not asked for."""
        while self.unasked:
            some = sorted(self.unasked)[:AT_ONCE]
            answer = self.orthanc.call("POST", "/modalities/pacs/storage-commitment", {"Resources": some})
            self.reports[answer["ID"]] = (some, time.time())
            self.unasked.difference_update(some)

    def collect(self):
        """Marks what the PACS has committed to; returns what it lacks."""
        lacking = []
        for transaction, (asked, begin) in list(self.reports.items()):
            report = self.orthanc.call("GET", f"/storage-commitment/{transaction}")
            if report["Status"] == "Pending":
                self.waiting.update(dict.fromkeys(asked, "the PACS has not reported yet; does it know title and port of the gateway?"))
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
        """Each by itself, so that one that is refused keeps no other back and has a reason of its own."""
        for instance in lacking:
            try:
                self.orthanc.call("POST", "/modalities/pacs/store", {"Resources": [instance]})
                self.waiting[instance] = "sent, not committed yet"
                self.taken += 1
            except Refused as error:
                self.waiting[instance] = str(error)
                self.orthanc.call("POST", "/modalities/pacs/echo", {})  # there is no use in sending more where it fails

    def forget(self, instances):
        for instance in instances:
            del self.waiting[instance], self.uids[instance]
        self.unasked.difference_update(instances)

    def forget_removed(self):
        """Somebody may give an instance up, and delete it in Orthanc."""
        self.forget(set(self.waiting).difference(self.orthanc.call("GET", "/instances")))

    def forget_old(self):
        while self.kept and self.kept[0][0] < time.time() - KEPT:
            self.orthanc.call("DELETE", f"/instances/{self.kept.pop(0)[1]}")

    def tell(self):
        """Writes what waits; on stdout how many, where it has changed."""
        lines = sorted(f"{self.uids[instance]}\t{reason}\n" for instance, reason in self.waiting.items())
        with open(self.list + ".part", "w", encoding="utf-8") as file:
            file.write("instance\treason\n" + "".join(lines))
        os.replace(self.list + ".part", self.list)
        told = (len(lines), lines[0].split("\t")[1].strip() if lines else "")
        if told != self.told:
            print("waiting: {}{}".format(told[0], f"; the first: {told[1]}" if told[1] else ""), flush=True)
        self.told = told

    def step(self):
        """Whether the PACS took something."""
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
