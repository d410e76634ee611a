"""The queue in front of a PACS, with fakes of its Orthanc and of the PACS."""

import json
import os
import random
import sys
import unittest
from unittest import mock

from case import WORKFLOW, Case

sys.path.insert(0, os.path.join(WORKFLOW, "pacs"))
import gateway


class StandIn:
    """An Orthanc with its REST interface, and the PACS behind it."""

    def __init__(self):
        self.held, self.changes, self.marks, self.reports = {}, [], {}, {}
        self.kept, self.sent, self.unwanted = set(), [], set()  # instances of the PACS
        self.is_away = self.is_silent = False

    def receive(self, *instances):
        for instance in instances:
            self.held[instance] = f"uid-{instance}"
            self.changes.append({"ID": instance, "ChangeType": "NewInstance"})

    def call(self, method, path, body=None):
        parts = path.strip("/").split("/")
        if parts[0].startswith("changes"):
            since = int(parts[0].split("=")[1].split("&")[0])
            return {"Changes": self.changes[since:], "Last": len(self.changes), "Done": True}
        if path == "/tools/bulk-content":
            return [self.content_of(instance) for instance in body["Resources"] if instance in self.held]
        if parts[0] == "modalities":
            return self.talk_to_pacs(parts[2], body)
        if parts[0] == "storage-commitment":
            return self.reports[parts[1]]
        return self.change(method, parts, body)

    def content_of(self, instance):
        marks = {gateway.COMMITTED: self.marks[instance]} if instance in self.marks else {}
        return {"ID": instance, "MainDicomTags": {"SOPInstanceUID": self.held[instance]}, "Metadata": marks}

    def change(self, method, parts, body):
        if method == "GET":
            return list(self.held)
        if method == "PUT":
            self.marks[parts[1]] = body
        else:
            del self.held[parts[1]]
        return None

    def talk_to_pacs(self, service, body):
        wanted = body.get("Resources", [])
        if self.is_away or not set(wanted) <= set(self.held):
            raise gateway.Refused("the PACS is away" if self.is_away else "unknown resource")
        if service == "store":
            if wanted[0] in self.unwanted:
                raise gateway.Refused("not taken")
            self.sent += wanted
            self.kept.update(wanted)
        if service != "storage-commitment":
            return {}
        transaction = str(len(self.reports))
        self.reports[transaction] = {
            "Status": "Pending" if self.is_silent else "Success" if set(wanted) <= self.kept else "Failure",
            "Success": [] if self.is_silent else [{"SOPInstanceUID": self.held[one]} for one in wanted if one in self.kept],
        }
        return {"ID": transaction}


class Gateway(Case):
    def setUp(self):
        super().setUp()
        self.orthanc = StandIn()
        self.queue = gateway.Queue(self.folder, self.orthanc)
        patch = mock.patch("builtins.print")
        patch.start()
        self.addCleanup(patch.stop)

    def steps(self, count=4):
        for _ in range(count):
            self.queue.take_new()
            self.queue.step()

    def waiting(self):
        with open(f"{self.folder}/waiting.tsv", encoding="utf-8") as file:
            return dict(line.rstrip("\n").split("\t") for line in list(file)[1:])

    def test_what_the_pacs_lacks_is_sent_once(self):
        self.orthanc.kept.add("b")
        self.orthanc.receive("a", "b", "c")
        self.steps()
        self.assertEqual(sorted(self.orthanc.sent), ["a", "c"])
        self.assertEqual(self.waiting(), {})
        self.assertEqual(sorted(self.orthanc.marks), ["a", "b", "c"])
        asked = len(self.orthanc.reports)
        self.queue = gateway.Queue(self.folder, self.orthanc)
        self.steps()
        self.assertEqual(len(self.orthanc.reports), asked)

    def test_one_that_is_refused_keeps_no_other_back(self):
        self.orthanc.unwanted.add("a")
        self.orthanc.receive("a", "b")
        self.steps()
        self.assertEqual(self.orthanc.sent, ["b"])
        self.assertEqual(self.waiting(), {"uid-a": "not taken"})

    def test_one_that_is_deleted_is_given_up(self):
        self.orthanc.unwanted.add("a")
        self.orthanc.receive("a")
        self.steps()
        del self.orthanc.held["a"]
        self.orthanc.receive("b")
        self.steps(6)
        self.assertEqual(self.orthanc.sent, ["b"])
        self.assertEqual(self.waiting(), {})

    def test_a_pacs_that_is_away(self):
        self.orthanc.is_away = True
        self.orthanc.receive("a")
        self.steps()
        self.assertEqual(self.waiting(), {"uid-a": "the PACS is away"})
        self.orthanc.is_away = False
        self.steps()
        self.assertEqual((self.orthanc.sent, self.waiting()), (["a"], {}))

    def test_a_pacs_that_does_not_report_gets_nothing_and_is_asked_again(self):
        self.orthanc.is_silent = True
        self.orthanc.kept.add("a")
        self.orthanc.receive("a")
        self.steps()
        self.assertEqual((self.orthanc.sent, len(self.orthanc.reports)), ([], 1))
        self.assertIn("has not reported yet", self.waiting()["uid-a"])
        self.orthanc.is_silent = False
        with mock.patch("gateway.LONGEST_SILENCE", 0):
            self.steps()
        self.assertEqual((self.orthanc.sent, self.waiting()), ([], {}))

    def test_what_is_committed_is_kept_for_a_day(self):
        self.orthanc.receive("a")
        self.steps()
        self.assertIn("a", self.orthanc.held)
        with mock.patch("gateway.KEPT", -1):
            self.steps(1)
        self.assertEqual(self.orthanc.held, {})

    def test_a_queue_that_forgets_at_any_time(self):
        rng = random.Random(1)
        for turn in range(200):
            if rng.random() < 0.2:
                self.orthanc.receive(f"{turn}")
            if rng.random() < 0.3:
                self.queue = gateway.Queue(self.folder, self.orthanc)  # its state is lost, Orthanc's is not
            self.orthanc.is_away = rng.random() < 0.3
            self.steps(1)
        self.orthanc.is_away = False
        self.steps()
        self.assertEqual(sorted(self.orthanc.sent), sorted(self.orthanc.held))
        self.assertEqual(self.waiting(), {})


class Words(unittest.TestCase):
    def test_of_an_error(self):
        for message, details, wanted in [
            ("Bad", " a  b ", "Bad: a b"),
            ("Bad", "", "Bad"),
            ("No", "Cannot transcode from 1.2 to one of [ ]", "the PACS does not accept objects of this class"),
            ("E", "DIMSE status 0xA700", "its disk is full"),
        ]:
            self.assertIn(wanted, gateway.words_of(json.dumps({"Message": message, "Details": details}).encode()))
        self.assertEqual(gateway.words_of(b"no JSON"), "no JSON")


if __name__ == "__main__":
    unittest.main()
