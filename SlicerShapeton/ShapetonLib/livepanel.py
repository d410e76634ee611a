"""Widgets of a live session: start, steer, objects, save."""

import qt
import slicer

from ShapetonLib.livesession import LiveSession, presets


class LivePanel:
    """A timer polls the session, because Slicer's event loop blocks Python threads. A field that is changed steers the
    session; a change in the session is written into its field."""

    interval = 20  # ms

    def __init__(self, layout, volume, folder):
        """volume(): the chosen node; folder(): where the session reads and writes."""
        self.session = None
        self._volume, self._folder = volume, folder
        self._written = {}
        self._saved = ""  # shown until the next command
        self._makeStart(layout)
        self._makeSteering(layout)
        self._makeRegion(layout)
        self._makeObjects(layout)
        self.status = qt.QLabel()
        self.status.wordWrap = True
        layout.addRow(self.status)
        self._timer = qt.QTimer()
        self._timer.setInterval(self.interval)
        self._timer.connect("timeout()", self._poll)

    @property
    def isRunning(self):
        return self.session is not None

    def cleanup(self):
        """Ends the session."""
        self._timer.stop()
        session, self.session = self.session, None
        if session:
            session.end()
            self.status.text = "The session has ended"

    # ---- widgets ----
    def _makeStart(self, layout):
        self.preset = qt.QComboBox()
        self.preset.addItems(presets)
        self.preset.setToolTip("How window, p, smoothing and time are chosen: such that objects separate, as published, or "
                               "for surfaces.")
        layout.addRow("Preset:", self.preset)
        layout.addRow(self._button("Start", self.onStart), self._button("Stop", self.onStop))

    def _makeSteering(self, layout):
        self.fields = {}
        for name, title, field in (
            ("p", "p:", self._number(0.0, 1000.0, 2)),
            ("distance", "Distance:", self._number(0.000001, 1.0, 6)),
            ("shapetons", "Shapetons:", self._count(1, 100000000)),
        ):
            self.fields[name] = field
            signal = "valueChanged(int)" if name == "shapetons" else "valueChanged(double)"
            field.connect(signal, lambda value, name=name: self._onField(name, value))
            layout.addRow(title, field)
        layout.addRow(self._button("Pause or move", lambda: self._do(lambda session: session.toggleMoving())),
                      self._button("One step", lambda: self._do(lambda session: session.ask("step", steps=1))))
        self.heatSteps = self._count(1, 1000000000)
        self.heatSteps.value = 10000
        layout.addRow("Time of heat:", self.heatSteps)
        layout.addRow(self._button("Show heat", lambda: self._do(self._showHeat)),
                      self._button("Show density", lambda: self._do(lambda session: session.ask("density"))))

    def _makeRegion(self, layout):
        self.region = self._selector(["vtkMRMLMarkupsFiducialNode", "vtkMRMLMarkupsROINode"])
        layout.addRow("Start at points or ROI:", self.region)
        self.radius = self._number(0.1, 1000.0, 1)
        self.radius.value = 5.0
        self.radius.setToolTip("Radius around each point, in mm; in a region of interest, the largest ball in it is taken.")
        layout.addRow("Radius:", self.radius)
        layout.addRow(self._button("Start there", lambda: self._do(self._startThere)),
                      self._button("Start everywhere", lambda: self._do(lambda s: s.ask("start", region="everywhere"))))

    def _makeObjects(self, layout):
        layout.addRow(self._button("Find objects", lambda: self._do(lambda s: s.ask("objects", choose=True))),
                      self._button("Objects of this heat", lambda: self._do(lambda s: s.ask("objects", choose=False))))
        layout.addRow(self._button("Select in a slice", self.onPlace))
        layout.addRow(self._button("Not this", lambda: self._do(lambda s: s.ask("exclude", region="selected"))),
                      self._button("Undo", lambda: self._do(lambda session: session.ask("undo"))))
        layout.addRow(self._button("Larger", lambda: self._do(lambda session: session.selectLarger())),
                      self._button("Show all", lambda: self._do(lambda session: session.ask("select", object=0))))
        self.name = qt.QLineEdit()
        self.name.text = "session"
        layout.addRow("Name:", self.name)
        layout.addRow(self._button("Save", lambda: self._do(lambda s: s.save(self.name.text.strip(), self._onSaved))))

    # ---- actions ----
    def onStart(self):
        node = self._volume()
        if node is None or self.isRunning:
            return
        with slicer.util.tryWithErrorDisplay("The session could not start.", waitCursor=True):
            self.session = LiveSession(node, self._folder(), self.preset.currentText or presets[0])
            self._written = {}
            self.status.text = "Starting"
            self._timer.start()

    def onStop(self):
        if self.session:
            self.status.text = "Ending"
            self.session.stop()

    def onPlace(self):
        """The next click in a slice selects the object there."""
        node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLMarkupsFiducialNode", "Shapeton selection")
        event = slicer.vtkMRMLMarkupsNode.PointPositionDefinedEvent
        tag = node.AddObserver(event, lambda caller, event: self._onPlaced(node, tag))
        logic = slicer.modules.markups.logic()
        logic.SetActiveList(node)
        logic.StartPlaceMode(False)

    def _onPlaced(self, node, tag):
        point = [0.0, 0.0, 0.0]
        node.GetNthControlPointPositionWorld(0, point)
        node.RemoveObserver(tag)
        qt.QTimer.singleShot(0, lambda: slicer.mrmlScene.RemoveNode(node))  # not while it reports the event
        self._do(lambda session: session.selectAt(point))

    def _onField(self, name, value):
        if self.session and self.session.state and value != self._written.get(name):
            self._written[name] = value
            self._do(lambda session: session.ask("set", **{name: value}))

    def _showHeat(self, session):
        session.ask("heat", timeSteps=self.heatSteps.value)

    def _startThere(self, session):
        node = self.region.currentNode()
        session.startInBalls(ballsOf(node, self.radius.value) if node else [])

    def _onSaved(self, names):
        self._saved = "Saved " + ", ".join(names)
        self.status.text = self._saved

    def _do(self, action):
        self._saved = ""
        if self.session:
            with slicer.util.tryWithErrorDisplay("The session refused."):
                action(self.session)

    # ---- the session ----
    def _poll(self):
        session = self.session
        if session is None:  # ended while a message was shown
            return
        before = session.state
        try:
            with slicer.util.tryWithErrorDisplay("The session reports an error."):
                session.poll()
        finally:
            if session.isOver:
                self._timer.stop()
                self.session = None
                self.status.text = "The session has ended"
            elif session.state is not before:
                self._show(session.state)
            elif session.state is None:
                self.status.text = session.stage or "Starting"

    def _show(self, state):
        for name, field in self.fields.items():
            value = state["options"][name]
            if self._written.get(name) != value:  # otherwise it may be edited now
                self._written[name] = value
                field.value = value
        self.status.text = "; ".join(filter(None, (state["error"] or describe(state), self._saved)))

    # ---- helpers ----
    @staticmethod
    def _button(text, clicked):
        button = qt.QPushButton(text)
        button.connect("clicked()", clicked)
        return button

    @staticmethod
    def _number(least, most, decimals):
        field = qt.QDoubleSpinBox()
        field.decimals = decimals
        field.setRange(least, most)
        field.keyboardTracking = False
        return field

    @staticmethod
    def _count(least, most):
        field = qt.QSpinBox()
        field.setRange(least, most)
        field.keyboardTracking = False
        return field

    @staticmethod
    def _selector(kinds):
        selector = slicer.qMRMLNodeComboBox()
        selector.nodeTypes = kinds
        selector.noneEnabled = True
        selector.setMRMLScene(slicer.mrmlScene)
        return selector


def ballsOf(node, radius):
    """Balls at the points of a node; in a region of interest, the largest ball at its center."""
    center, size = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    if isinstance(node, slicer.vtkMRMLMarkupsROINode):
        node.GetCenterWorld(center)
        node.GetSizeWorld(size)
        return [(center, min(size) / 2.0)]
    balls = []
    for i in range(node.GetNumberOfControlPoints()):
        point = [0.0, 0.0, 0.0]
        node.GetNthControlPointPositionWorld(i, point)
        balls.append((point, radius))
    return balls


def describe(state):
    coarse = ", coarse" if state["quality"] == "coarse" else ""
    work = f", {state['stage']}: {100 * state['share']:.0f} %" if state["stage"] else ""
    if state["shown"] == "heat":
        objects = f", {state['objects']} objects" if state["objects"] is not None else ""
        selected = f", object {state['selected']} selected" if state["selected"] else ""
        return f"heat after {state['heatSteps']} steps{coarse}{work}{objects}{selected}; {state['lastChange']}"
    moving = f"{state['stepsPerSecond']:g} steps/s" if state["isMoving"] else "paused"
    return f"step {state['step']}, {moving}, coverage {100 * state['coverage']:.1f} %{coarse}{work}"
