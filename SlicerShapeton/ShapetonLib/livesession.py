"""A session process (ShapetonSession) and the nodes that show it."""

import json
import os
import time

import numpy

from ShapetonLib.sessionnodes import SessionNodes, lpsOf
from ShapetonLib.toolrun import ToolRun, exportVolume
from ShapetonLib.websocket import ConnectionLost, WebSocket

presets = ("objects", "published", "surface")


class LiveSession:
    """Call poll() from a timer. Nothing waits, except end()."""

    secondsBetweenFrames = 0.2
    secondsToEnd = 5.0

    def __init__(self, volumeNode, folder, preset="objects", options=None):
        """options: of ShapetonSession, by name, such as {"p": 7}."""
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, "session-input.nrrd")
        exportVolume(volumeNode, path)
        arguments = [path, "--folder", folder, "--preset", preset]
        for name, value in (options or {}).items():
            arguments += [f"--{name}", value]
        self._run = ToolRun("ShapetonSession", arguments)
        self._socket = None
        self._lost = ""
        self._endTime = None
        self._waiting = {}  # functions that take the answers, by id
        self._number = 0
        self._isAsked = False  # for a frame
        self._nextFrame = 0.0
        self._errors = []
        self._grid = None
        self.nodes = SessionNodes()
        self.state = None  # as sent by the server
        self.objects = []
        self.isOver = False

    @property
    def stage(self):
        """What the process does before it is connected."""
        return self._run.stage

    def poll(self):
        """Raises RuntimeError for a rejected command, and at the end of a session that was not stopped; isOver is then
        true."""
        hasEnded = self._run.poll()
        try:
            self._transfer()
        except ConnectionLost as error:
            self._lost = self._lost or str(error)
            self.stop()
        if hasEnded:
            self._finish()
        elif self._endTime is not None and time.monotonic() > self._endTime:
            self._run.kill()
        errors, self._errors = self._errors, []
        if errors:
            raise RuntimeError("\n".join(errors))

    def stop(self):
        """Ends the process; poll() reports its end."""
        if self._endTime is None:
            self._endTime = time.monotonic() + self.secondsToEnd
            self._run.cancel()
        self._disconnect()

    def end(self):
        """Ends the process and waits for it."""
        self.stop()
        while not self._run.poll():
            if time.monotonic() > self._endTime:
                self._run.kill()
            time.sleep(0.01)
        self.isOver = True

    def ask(self, do, done=lambda answer: None, **values):
        """Sends a command; done(answer) is called if it is accepted."""
        if self._socket is None:
            raise RuntimeError("The session has not started yet" if not self.isOver else "The session has ended")
        self._number += 1
        self._waiting[self._number] = done
        self._socket.send(json.dumps({"do": do, "id": self._number, **values}))

    # ---- commands ----
    def toggleMoving(self):
        self.ask("pause" if self.state and self.state["isMoving"] else "resume")

    def startInBalls(self, balls):
        """balls: (center in RAS, radius in mm)"""
        if not balls:
            raise RuntimeError("Place a point or a region of interest first")
        self.ask("start", region="balls", balls=[lpsOf(center) + [radius] for center, radius in balls])

    def selectAt(self, ras):
        """Selects the smallest object at a point."""
        self.ask("select", point=lpsOf(ras))

    def selectLarger(self):
        selected = self.state["selected"] if self.state else 0
        parent = self.objects[selected - 1]["parent"] if 0 < selected <= len(self.objects) else 0
        if not parent:
            raise RuntimeError("No larger object contains the selected one" if selected else "Select an object first")
        self.ask("select", object=parent)

    def save(self, name, done):
        """done(names of the files)"""
        hasObjects = bool(self.state) and self.state["shown"] == "heat" and self.state["objects"] is not None
        self.ask("save", lambda answer: done(answer["files"]), name=name, labels=True, objects=hasObjects)

    # ---- messages ----
    def _transfer(self):
        if self._endTime is not None:
            return
        if self._socket is None:
            url = next((line for line in self._run.messages if line.startswith("http://")), None)
            if url is None:
                return
            self._socket = WebSocket(url + "live")
            self.ask("view", whole=True)
        if not self._isAsked and time.monotonic() >= self._nextFrame:
            self._isAsked = True
            self._socket.send('{"do": "ready"}')
        for message in self._socket.poll():
            if isinstance(message, str):
                self._takeAnswer(json.loads(message))
            else:
                self._takeFrame(message)

    def _takeAnswer(self, answer):
        done = self._waiting.pop(answer.get("id"), lambda answer: None)
        if answer["kind"] == "error":
            self._errors.append(answer["text"])
        else:
            done(answer)

    def _takeFrame(self, frame):
        length = int.from_bytes(frame[:4], "little")
        header = json.loads(frame[4 : 4 + length])
        at = 4 + length
        before, self.state = self.state, header["state"]
        if self.state["error"] and self.state["error"] != (before or {}).get("error"):
            self._errors.append(self.state["error"])
        if "volume" in header:
            self._grid = header["volume"]
            values, at = self._array(frame, at, "<f4")
            self.nodes.showValues("Heat" if self.state["shown"] == "heat" else "Density", self._grid, values)
        if "objects" in header:
            self.objects = header["objects"]
            labels, at = self._array(frame, at, "<u2")
            self.nodes.showObjects(self._grid, labels, self.objects)
        elif self.objects and self.state["objects"] is None:
            self.objects = []
            self.nodes.forgetObjects()
        if self.objects and ("objects" in header or self.state["selected"] != (before or {}).get("selected")):
            self.nodes.showSelected(self.objects, self.state["selected"])
        self._isAsked = False
        self._nextFrame = time.monotonic() + self.secondsBetweenFrames

    def _array(self, frame, at, kind):
        size = tuple(reversed(self._grid["size"]))
        count = int(numpy.prod(size))
        values = numpy.frombuffer(frame, kind, count, at).reshape(size)
        return values, at + values.nbytes

    # ---- end ----
    def _disconnect(self):
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def _finish(self):
        wasStopped = self._endTime is not None and not self._lost
        self._disconnect()
        if self._endTime is None:
            self._endTime = time.monotonic()
        if not self.isOver and not wasStopped:
            try:
                self._run.requireSuccess()
                self._errors.append(self._lost or "The session has ended")
            except RuntimeError as error:
                self._errors.append(str(error))
        self.isOver = True
