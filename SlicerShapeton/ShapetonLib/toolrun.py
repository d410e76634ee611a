"""A tool of Shapeton as a process: progress, warnings, error message, cancel."""

import os
import re
import subprocess
from xml.sax.saxutils import unescape

import slicer

toolsFolderKey = "Shapeton/ToolsFolder"


def toolPath(name):
    """Returns the executable from the folder in the settings, else the command-line module of this extension."""
    folder = slicer.util.settingsValue(toolsFolderKey, "")
    if folder:
        path = os.path.join(folder, name)
    else:
        module = getattr(slicer.modules, name.lower(), None)
        path = module.path if module else name
    if not os.path.isfile(path):
        raise RuntimeError(f"The tool {name} was not found ({path}); set the folder of Shapeton's tools")
    return path


def toolEnvironment():
    """Removes Slicer's library search paths, because tools of another folder do not use Slicer's libraries."""
    return slicer.util.startupEnvironment() if slicer.util.settingsValue(toolsFolderKey, "") else None


class ToolRun:
    """Call poll() from a timer: Slicer's event loop blocks Python threads."""

    def __init__(self, name, arguments, onProgress=lambda share, stage: None):
        self.name = name
        self.share = 0.0
        self.stage = ""
        self.messages = []
        self.canceled = False
        self._onProgress = onProgress
        self._text = {}
        command = [toolPath(name)] + [str(argument) for argument in arguments]
        self._process = subprocess.Popen(
            command, env=toolEnvironment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        for stream in (self._process.stdout, self._process.stderr):
            os.set_blocking(stream.fileno(), False)
            self._text[stream] = b""

    def poll(self):
        """Reads the output of the tool. Returns True when it has finished."""
        isOver = self._process.poll() is not None  # polled before reading, to read all output
        self._readLines(self._process.stdout, self._takeLine)
        self._readLines(self._process.stderr, lambda line: None, keep=True)
        if isOver:
            self._process.stdout.close()
            self._process.stderr.close()
        return isOver

    def cancel(self):
        """Cancels the tool, which removes its temporary files and stops its child tools; poll() reports the end."""
        self.canceled = True
        self._process.terminate()

    def kill(self):
        """Ends a tool that does not react to cancel()."""
        self._process.kill()

    def requireSuccess(self):
        """Raises RuntimeError with the tool's message if the finished tool failed."""
        if self._process.returncode != 0:
            error = self._text[self._process.stderr].decode(errors="replace").strip()
            raise RuntimeError(error or f"{self.name} ended with status {self._process.returncode}")

    def _readLines(self, stream, take, keep=False):
        if stream.closed:
            return
        while True:
            try:
                piece = os.read(stream.fileno(), 1 << 16)
            except BlockingIOError:
                break
            if not piece:
                break
            self._text[stream] += piece
        if not keep:
            *lines, self._text[stream] = self._text[stream].split(b"\n")
            for line in lines:
                take(line.decode(errors="replace"))

    def _takeLine(self, line):
        element = re.fullmatch(r"<(filter-[a-z-]+)>(.*)</\1>", line)
        if not element:
            if line and not line.startswith("<"):
                self.messages.append(unescape(line))
        elif element[1] == "filter-progress":
            self.share = float(element[2])
            self._onProgress(self.share, self.stage)
        elif element[1] == "filter-comment":
            self.stage = unescape(element[2])


def exportVolume(node, path):
    """Writes the voxels of a volume node to a file; the storage node is unchanged."""
    if node.GetParentTransformNode():
        raise RuntimeError(f"{node.GetName()} is under a transform; harden the transform first")
    if not slicer.util.exportNode(node, path, {}):  # {}: exportNode would modify its mutable default argument
        raise RuntimeError(f"{node.GetName()} cannot be written to {path}")
