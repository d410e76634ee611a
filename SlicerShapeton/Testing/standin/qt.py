"""Dummy widgets to run widget code. They do not verify the calls to Qt."""


class Widget:
    def __init__(self, *arguments):
        self._connected = {}

    def connect(self, signal, slot):
        self._connected[signal] = slot

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *arguments: Widget()


class QPixmap(Widget):
    def width(self):
        return 100

    height = width

    def scaled(self, width, height):
        return self


class QTableWidget(Widget):
    def __init__(self, rows, columns):
        Widget.__init__(self)
        self.rowCount, self._items = rows, {}

    def setRowCount(self, rows):
        self.rowCount = rows

    def setItem(self, row, column, item):
        self._items[row, column] = item

    def item(self, row, column):
        return self._items[row, column]


class QTableWidgetItem:
    def __init__(self, text=""):
        self._text, self._state = text, None

    def text(self):
        return self._text

    def setCheckState(self, state):
        self._state = state

    def checkState(self):
        return self._state


class QObject:
    pass


class QTimer(Widget):
    @staticmethod
    def singleShot(milliseconds, slot):
        slot()


class QSettings:
    def setValue(self, key, value):
        import slicer

        slicer.util._settings[key] = value


class QSizePolicy:
    Ignored, Fixed = 13, 0


class Qt:
    Unchecked, Checked = 0, 2


class QEvent:
    MouseButtonPress = 2


QLabel = QComboBox = QFormLayout = QVBoxLayout = QProgressBar = QPushButton = QScrollArea = Widget
QSpinBox = QDoubleSpinBox = QLineEdit = QPainter = QPen = QColor = Widget
