"""Immediate response to Ctrl-C during a call, even if a step of the library cannot be interrupted.

Python handles signals in its main thread only. Long functions called in the main thread therefore run in a separate
thread; when the main thread stops waiting, this thread ends by itself, at the latest after its current step.
"""

from __future__ import annotations

import functools
import inspect
import threading
from queue import Empty, SimpleQueue
from types import ModuleType
from typing import Any, Callable, Dict, Tuple, get_type_hints

from . import _shapeton
from ._arguments import bound, check

_Function = Callable[..., Any]
_CALLBACKS = ("progress", "snapshot")


class _Call(threading.Thread):
    """A call in a separate thread; callbacks run in the waiting thread."""

    def __init__(self, function: _Function, arguments: Tuple[Any, ...], options: Dict[str, Any], stop: Any) -> None:
        super().__init__(name=function.__name__)
        options = {
            name: self._relayed(value) if name in _CALLBACKS and callable(value) else value
            for name, value in options.items()
        }
        self._work = functools.partial(function, *arguments, **options)
        self._stop_flag = stop
        self._questions: SimpleQueue[Any] = SimpleQueue()  # callbacks and their arguments; None marks the end
        self._answers: SimpleQueue[Any] = SimpleQueue()

    def _relayed(self, callback: _Function) -> _Function:
        def ask(*arguments: Any) -> Any:
            if self._stop_flag.is_set():
                raise SystemExit
            self._questions.put((callback, arguments))
            return self._answers.get()

        return ask

    def run(self) -> None:
        self._stop_flag.obey()
        try:
            self._outcome: Tuple[Any, Any] = (self._work(), None)
        except BaseException as error:
            self._outcome = (None, error)
        finally:
            del self._work  # refers to this thread
            self._questions.put(None)

    def _question(self) -> Any:
        while True:
            try:
                return self._questions.get(timeout=0.05)  # _thread.interrupt_main() does not end a wait
            except Empty:
                pass

    def outcome(self) -> Tuple[Any, Any]:
        """Returns the result and the exception; one of them is None."""
        try:
            self.start()
            for callback, arguments in iter(self._question, None):
                self._answers.put(callback(*arguments))
        except BaseException:  # from a signal or a callback
            self._stop_flag.set()
            self._answers.put(False)  # answers a pending question
            raise
        outcome = self._outcome
        del self._outcome  # an exception refers to this thread
        return outcome


def _interruptible(function: _Function, new_stop_flag: _Function) -> _Function:
    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        main = threading.main_thread()
        if threading.current_thread() is not main or not main.is_alive():  # false at interpreter shutdown
            return function(*arguments, **options)
        result, error = _Call(function, arguments, options, new_stop_flag()).outcome()
        try:
            if error is not None:
                raise error
            return result
        finally:
            del error  # refers to this frame

    call.__qualname__ = function.__name__  # the name of the compiled function cannot be pickled
    return call


def public(function: _Function) -> _Function:
    """A function of the package: its arguments are checked, and Ctrl-C ends it if it takes long."""
    signature = inspect.signature(function)
    is_long = "progress" in signature.parameters or function.__name__.startswith("read_")
    work = _interruptible(function, _shapeton._StopFlag) if is_long else function
    hints: Dict[str, Any] = {}  # evaluated at the first call, because modules import each other

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        given = bound(function, signature, arguments, options)
        hints.update({} if hints else get_type_hints(function))
        check(function, hints, given.arguments)
        return work(*given.args, **given.kwargs)

    return call


def make_interruptible(compiled: ModuleType) -> None:
    """The functions of the compiled module that report progress or read files."""
    for name, function in list(vars(compiled).items()):
        if inspect.isbuiltin(function):
            signature = (function.__doc__ or "").partition("\n")[0]
            if name.startswith("read_") or "progress: " in signature:
                setattr(compiled, name, _interruptible(function, compiled._StopFlag))
