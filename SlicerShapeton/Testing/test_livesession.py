"""The live session with a real process: the nodes are compared with the files that it saves."""

import gzip
import os
import signal
import subprocess
import time
import unittest
from unittest import mock

import numpy
from case import Case, hangingSeconds, numberOfWaits, slicer, tools, waitFor
from ShapetonHeat import ShapetonHeatWidget

from ShapetonLib.livesession import LiveSession
from ShapetonLib.sessionnodes import ijkToRAS, lpsOf

QUICK = {"shapetons": 5000, "timeSteps": 40, "p": 7}


def parts(path):
    """The header's fields and the data of a NRRD file."""
    with open(path, "rb") as file:
        header, data = file.read().split(b"\n\n", 1)
    return dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line), data


def readVolume(path):
    """Voxels [z, y, x] of a NRRD file."""
    fields, data = parts(path)
    kinds = {"float": "<f4", "unsigned int": "<u4", "unsigned short": "<u2", "unsigned char": "u1"}
    data = gzip.decompress(data) if fields["encoding"] == "gzip" else data
    return numpy.frombuffer(data, kinds[fields["type"]]).reshape([int(size) for size in fields["sizes"].split()][::-1])


def matrixOf(path):
    """From the header: index to RAS."""
    fields, _ = parts(path)
    assert fields["space"] == "left-posterior-superior"
    vector = lambda text: [float(part) for part in text.strip("()").split(",")]  # noqa: E731
    matrix = numpy.eye(4)
    matrix[:3, :3] = numpy.array([vector(part) for part in fields["space directions"].split()]).T
    matrix[:3, 3] = vector(fields["space origin"])
    return numpy.diag((-1.0, -1.0, 1.0, 1.0)) @ matrix


def valuesOf(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


class SessionCase(Case):
    def setUp(self):
        Case.setUp(self)
        self.results = os.path.join(self.folder, "results")
        patience = mock.patch.object(LiveSession, "secondsToEnd", hangingSeconds)  # a busy process is not killed
        patience.start()
        self.addCleanup(patience.stop)

    def obliquePhantom(self):
        """An oblique grid of 36 x 40 x 44 voxels of 0.7 x 1.1 x 1.9 mm: a ball of 1000 and a box of 600."""
        cosine, sine = numpy.cos(0.4), numpy.sin(0.4)
        rotation = numpy.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]]) @ numpy.array(
            [[1, 0, 0], [0, cosine, sine], [0, -sine, cosine]]
        )
        directions = rotation * numpy.array((0.7, 1.1, 1.9))
        z, y, x = numpy.mgrid[0:44, 0:40, 0:36]
        values = numpy.random.default_rng(1).normal(0, 3, z.shape)
        values[(x - 10) ** 2 + (y - 12) ** 2 + (z - 12) ** 2 < 49] += 1000
        values[(x >= 20) & (x < 31) & (y >= 22) & (y < 34) & (z >= 24) & (z < 38)] += 600
        path = os.path.join(self.folder, "oblique.nrrd")
        columns = " ".join("({})".format(",".join(f"{part:.17g}" for part in column)) for column in directions.T)
        header = (
            "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 36 40 44\n"
            f"space directions: {columns}\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
            "space origin: (-12.5,31,7.25)\n\n"
        )
        with open(path, "wb") as file:
            file.write(header.encode() + values.astype("<f4").tobytes())
        return path

    def start(self, path=None, preset="published", options=QUICK):
        node = slicer.Node("vtkMRMLScalarVolumeNode", path or self.obliquePhantom())
        session = LiveSession(node, self.results, preset, options)
        self.addCleanup(session.end)
        return session

    def until(self, session, condition):
        waitFor(condition, session.poll, lambda: session.state)

    def ask(self, session, action):
        """Runs an action that takes a function for its answer."""
        answers = []
        action(answers.append)
        self.until(session, lambda: answers)
        return answers[0]

    def save(self, session, name):
        return self.ask(session, lambda done: session.save(name, done))

    def settled(self, session):
        self.until(session, lambda: session.state and session.state["step"] == 40 and not session.state["isMoving"])

    def path(self, name):
        return os.path.join(self.results, name)

    def processId(self, session):
        return session._run._process.pid


class LiveSessionTest(SessionCase):
    def testDensityIsThatOfTheFileInTheSamePlace(self):
        path = self.obliquePhantom()
        session = self.start(path)
        self.settled(session)
        self.assertEqual(self.save(session, "a"), ["a-density.nrrd", "a-labels.nrrd", "a.sh"])
        node = session.nodes.find("Density")
        visits = readVolume(self.path("a-density.nrrd"))
        self.assertEqual((visits.max() > 0, node._array.shape), (True, (44, 40, 36)))
        numpy.testing.assert_allclose(node._array, visits / visits.max(), atol=1e-6)
        for file in (path, self.path("a-density.nrrd")):
            numpy.testing.assert_allclose(valuesOf(node._matrix), matrixOf(file), atol=1e-6)

    def testUpdatesReplaceTheVoxelsOfTheSameNode(self):
        session = self.start()
        self.settled(session)
        node = session.nodes.find("Density")
        updates, before = node._updates, node._array
        session.ask("set", p=20, distance=0.05, shapetons=3000)
        self.until(session, lambda: session.state["options"]["p"] == 20)
        self.settled(session)
        self.until(session, lambda: node._updates > updates and not numpy.array_equal(node._array, before))
        self.assertEqual(session.state["options"]["shapetons"], 3000)
        self.assertIs(session.nodes.find("Density"), node)
        slicer.mrmlScene.RemoveNode(node)
        session.ask("set", p=21)
        self.until(session, lambda: session.nodes.find("Density") not in (None, node))  # is made again

    def testHeatIsItsOwnNode(self):
        session = self.start()
        self.settled(session)
        density = session.nodes.find("Density")._array
        session.ask("heat", timeSteps=500)
        self.until(session, lambda: session.state["shown"] == "heat" and session.state["quality"] == "exact")
        self.save(session, "h")
        numpy.testing.assert_array_equal(session.nodes.find("Heat")._array, readVolume(self.path("h-heat.nrrd")))
        numpy.testing.assert_array_equal(session.nodes.find("Density")._array, density)

    def testPauseAndStep(self):
        session = self.start(options={**QUICK, "timeSteps": 1000000})
        self.until(session, lambda: session.state and session.state["step"] > 0)
        session.toggleMoving()
        self.until(session, lambda: not session.state["isMoving"])
        step = session.state["step"]
        session.ask("step", steps=3)
        self.until(session, lambda: session.state["step"] == step + 3 and not session.state["isMoving"])
        session.toggleMoving()
        self.until(session, lambda: session.state["step"] > step + 3)

    def testShapetonsStartInABallGivenInRAS(self):
        path = self.obliquePhantom()
        session = self.start(path)
        self.settled(session)
        center = matrixOf(path) @ (10, 12, 14, 1)
        session.startInBalls([(list(center[:3]), 3.0)])
        self.until(session, lambda: session.state["region"] == "balls")
        self.settled(session)
        self.save(session, "b")
        places = numpy.argwhere(readVolume(self.path("start-1.nrrd")) > 0)[:, ::-1]  # x, y, z
        distances = numpy.linalg.norm((matrixOf(path)[:3, :3] @ (places - (10, 12, 14)).T), axis=0)
        self.assertLessEqual(distances.max(), 3.0)
        self.assertAlmostEqual(len(places), 36 * numpy.pi / (0.7 * 1.1 * 1.9), delta=15)
        with self.assertRaisesRegex(RuntimeError, "Place a point"):
            session.startInBalls([])

    def testTheGeometryIsThatOfAnyGrid(self):
        grid = {"origin": [1, 2, 3], "spacing": [2, 3, 4], "axes": [[0, 1, 0], [0, 0, -1], [1, 0, 0]]}
        place = ijkToRAS(grid) @ (1, 1, 1, 1)
        numpy.testing.assert_array_equal(place[:3], (-(1 + 4), -(2 + 2), 3 - 3))


class ObjectsTest(SessionCase):
    """Objects of the ball and the box, found once."""

    def setUp(self):
        SessionCase.setUp(self)
        self.volume = self.obliquePhantom()
        self.session = self.start(self.volume, "objects", {"shapetons": 5000, "timeSteps": 40})
        self.until(self.session, lambda: self.session.state)
        self.session.ask("objects", choose=True)
        self.until(self.session, lambda: self.session.objects)

    def testAClickSelectsAndLargerClimbs(self):
        session, nodes = self.session, self.session.nodes
        self.save(session, "o")
        labels = readVolume(self.path("o-objects.nrrd"))
        numpy.testing.assert_array_equal(nodes.find("Objects")._array, labels)
        numpy.testing.assert_allclose(valuesOf(nodes.find("Objects")._matrix), matrixOf(self.volume), atol=1e-6)

        inBall = matrixOf(self.volume) @ (10, 12, 12, 1)
        session.selectAt(list(inBall[:3]))
        self.until(session, lambda: session.state["selected"])
        ball = session.state["selected"]
        self.assertEqual(ball, labels[12, 12, 10])
        colors = nodes.find("Object colors")._colors
        self.assertEqual(colors[0][4], 0.0)
        for entry in session.objects:
            self.assertEqual(colors[entry["number"]][4], float(nodes._isIn(entry, ball, session.objects)))
        self.assertRegex(colors[ball][0], rf"^object {ball}, \d+ mm3, \d+ %$")
        hexOf = "#" + bytes(round(255 * channel) for channel in colors[ball][1:4]).hex()
        self.assertEqual(hexOf, session.objects[ball - 1]["color"])
        for _ in range(len(session.objects)):  # climbs to the outermost object and no further
            parent = session.objects[session.state["selected"] - 1]["parent"]
            if not parent:
                break
            session.selectLarger()
            self.until(session, lambda parent=parent: session.state["selected"] == parent)
        with self.assertRaisesRegex(RuntimeError, "No larger object"):
            session.selectLarger()
        session.ask("select", object=0)
        self.until(session, lambda: not session.state["selected"])
        self.assertTrue(all(color[4] == 1.0 for color in nodes.find("Object colors")._colors[1:]))
        with self.assertRaisesRegex(RuntimeError, "Select an object first"):
            session.selectLarger()

    def testTheTableIsThatOfTheFile(self):
        session = self.session
        self.save(session, "o")
        columns = session.nodes.find("Object table")._columns
        table = numpy.genfromtxt(self.path("o-objects.csv"), delimiter=",", names=True, dtype=None, encoding=None, ndmin=1)
        self.assertGreaterEqual(len(table), 2)
        for name, column in (("object", "object"), ("voxels", "voxels"), ("volume_mm3", "volume")):
            numpy.testing.assert_allclose(columns[name], table[column], rtol=1e-4)
        numpy.testing.assert_allclose(columns["probability"], table["probability"], atol=1e-3)
        numpy.testing.assert_allclose(columns["R"], -table["x"], atol=1e-2)
        numpy.testing.assert_allclose(columns["S"], table["z"], atol=1e-2)

    def testTheScriptWritesTheSameBytes(self):
        names = self.save(self.session, "o")
        self.assertIn("o-objects.csv", names)
        again = os.path.join(self.folder, "again")
        os.mkdir(again)
        environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}
        subprocess.run(["sh", self.path("o.sh"), again], env=environment, check=True, stdout=subprocess.DEVNULL)
        for name in names[:-1]:
            with open(self.path(name), "rb") as first, open(os.path.join(again, name), "rb") as second:
                self.assertEqual(first.read(), second.read(), name)

    def testAChangeForgetsTheObjects(self):
        session = self.session
        labels = session.nodes.find("Objects")
        session.ask("set", p=3)
        self.until(session, lambda: not session.objects)
        self.assertIs(session.nodes.find("Objects"), labels)
        self.assertEqual(labels._array.max(), 0)
        self.assertEqual(len(session.nodes.find("Object table")._columns["object"]), 0)


class EndsTest(SessionCase):
    def assertEnded(self, session, message):
        with self.assertRaisesRegex(RuntimeError, message):
            self.until(session, lambda: session.isOver)
        self.assertTrue(session.isOver)
        with self.assertRaisesRegex(RuntimeError, "has ended"):
            session.ask("density")
        self.assertFalse(os.path.exists(f"/proc/{self.processId(session)}"))

    def testARejectedCommandIsAnErrorAndTheSessionGoesOn(self):
        session = self.start()
        self.settled(session)
        session.ask("set", p=-1)
        with self.assertRaisesRegex(RuntimeError, "p"):
            self.until(session, lambda: False)
        session.selectAt([0, 0, 0])
        with self.assertRaisesRegex(RuntimeError, "find them first"):
            self.until(session, lambda: False)
        session.ask("set", p=3)
        self.until(session, lambda: session.state["options"]["p"] == 3)
        self.assertFalse(session.isOver)

    def testAWrongOptionIsTheLineOfTheTool(self):
        session = self.start(options={"distance": -1})
        self.assertEnded(session, "^[^\n]*--distance[^\n]*$")

    def testAKilledProcessIsReported(self):
        session = self.start()
        self.settled(session)
        os.kill(self.processId(session), signal.SIGKILL)
        self.assertEnded(session, "ended with status -9")

    def testAProcessThatAnotherEndsIsReported(self):
        session = self.start()
        self.settled(session)
        os.kill(self.processId(session), signal.SIGTERM)
        self.assertEnded(session, "has ended|was closed|lost")

    def testALostConnectionEndsTheProcess(self):
        session = self.start()
        self.settled(session)
        session._socket._socket.shutdown(2)
        self.assertEnded(session, "connection")

    def testAHangingProcessDoesNotBlockAndIsEnded(self):
        session = self.start()
        self.settled(session)
        os.kill(self.processId(session), signal.SIGSTOP)
        session._socket.secondsOfSilence = 0.5
        session.secondsToEnd = 0.5
        session.ask("set", p=4)
        with self.assertRaisesRegex(RuntimeError, "status -9"):
            while not session.isOver:
                time.sleep(0.01)
                waits = numberOfWaits()
                session.poll()
                self.assertEqual(numberOfWaits(), waits)
        self.assertEqual(numberOfWaits(), waits)

    def testStopEndsItWithoutAnError(self):
        session = self.start()
        self.settled(session)
        session.stop()
        self.until(session, lambda: session.isOver)
        self.assertEqual(session._run._process.returncode, 0)

    def testStopDuringTheStart(self):
        session = self.start(preset="objects", options={})
        session.stop()
        self.until(session, lambda: session.isOver)

    def testAVolumeUnderATransformIsRefused(self):
        node = slicer.Node("vtkMRMLScalarVolumeNode", self.obliquePhantom())
        node.GetParentTransformNode = lambda: object()
        with self.assertRaisesRegex(RuntimeError, "harden the transform"):
            LiveSession(node, self.results)


class PanelTest(SessionCase):
    """The widget code on dummy widgets."""

    def setUp(self):
        SessionCase.setUp(self)
        self.widget = ShapetonHeatWidget()
        self.widget.setup()
        self.addCleanup(self.widget.cleanup)
        self.live = self.widget.live
        self.path_ = self.obliquePhantom()
        self.widget.volume._node = slicer.Node("vtkMRMLScalarVolumeNode", self.path_)
        self.widget.panel.outputFolder.currentPath = self.results
        self.live.preset.currentText = "published"

    def begin(self):
        self.live.onStart()
        self.wait(lambda: self.live.session.state)
        return self.live.session

    def wait(self, condition):
        waitFor(condition, self.live._poll)

    def testStartSteerSelectSaveStop(self):
        self.widget.volume._node, node = None, self.widget.volume._node
        self.live.onStart()
        self.assertFalse(self.live.isRunning)
        self.widget.volume._node = node
        session = self.begin()
        self.assertEqual(self.live.fields["p"].value, session.state["options"]["p"])
        self.live.fields["shapetons"]._connected["valueChanged(int)"](2000)
        self.wait(lambda: session.state["options"]["shapetons"] == 2000)
        roi = slicer.vtkMRMLMarkupsROINode((0.0, -40.0, 30.0), (9.0, 30.0, 40.0))
        center = matrixOf(self.path_) @ (18, 20, 22, 1)
        roi._center = tuple(center[:3])
        self.live.region._node = roi
        self.live._do(self.live._startThere)
        self.wait(lambda: session.state["region"] == "balls")

        session.ask("objects", choose=True)
        self.wait(lambda: session.objects)
        self.live.onPlace()
        points = slicer.modules.markups.logic()._active
        self.assertFalse(slicer.modules.markups.logic()._isPersistent)
        points._place(list((matrixOf(self.path_) @ (10, 12, 12, 1))[:3]))
        self.assertFalse(slicer.mrmlScene.IsNodePresent(points))  # only the selection remains
        self.wait(lambda: session.state["selected"])
        self.assertIn("selected", self.live.status.text)
        session.save("panel", self.live._onSaved)
        self.wait(lambda: "panel-objects.csv" in self.live.status.text)
        session.ask("select", object=0)
        self.wait(lambda: not session.state["selected"])
        self.assertIn("panel-objects.csv", self.live.status.text)
        self.live._do(lambda session: session.ask("select", object=1))
        self.wait(lambda: session.state["selected"])
        self.assertNotIn("panel-objects.csv", self.live.status.text)
        self.live.onStop()
        self.wait(lambda: not self.live.isRunning)
        self.assertIn("ended", self.live.status.text)

    def testClosingTheSceneOrTheModuleEndsTheProcess(self):
        for close in (lambda: slicer.mrmlScene._observers[-1](None, None), self.widget.cleanup):
            session = self.begin()
            close()
            self.assertFalse(self.live.isRunning)
            self.assertEqual(session._run._process.returncode, 0)
            self.assertFalse(os.path.exists(f"/proc/{self.processId(session)}"))

    def testErrorsAreShownAndAKilledSessionCanBeStartedAgain(self):
        session = self.begin()
        self.live.fields["p"]._connected["valueChanged(double)"](-3.0)
        with self.assertRaisesRegex(RuntimeError, "p"):
            self.wait(lambda: False)
        self.assertTrue(self.live.isRunning)
        os.kill(self.processId(session), signal.SIGKILL)
        with self.assertRaisesRegex(RuntimeError, "status -9"):
            self.wait(lambda: False)
        self.assertFalse(self.live.isRunning)
        self.begin()


if __name__ == "__main__":
    unittest.main()
