"""Immediate response to Ctrl-C during a call, even if a step of the library cannot be interrupted.

Python handles signals in its main thread only. Long functions called in the main thread therefore run in a separate
thread; when the main thread stops waiting, this thread ends by itself, at the latest after its current step.
"""

from __future__ import annotations

import errno
import functools
import inspect
import threading
from queue import Empty, SimpleQueue
from typing import Any, Callable, Dict, Tuple, TypeVar, cast, get_type_hints

from ._arguments import MissingFileError, adapted, as_mask, bound, check, lacks_file
from ._shapeton import InputError, _StopFlag

_Function = Callable[..., Any]
_AnyFunction = TypeVar("_AnyFunction", bound=_Function)
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


def _interruptible(function: _Function) -> _Function:
    def call(*arguments: Any, **options: Any) -> Any:
        main = threading.main_thread()
        if threading.current_thread() is not main or not main.is_alive():  # false at interpreter shutdown
            return function(*arguments, **options)
        result, error = _Call(function, arguments, options, _StopFlag()).outcome()
        try:
            if error is not None:
                raise error
            return result
        finally:
            del error  # refers to this frame

    return call


def public(function: _AnyFunction) -> _AnyFunction:
    """A function of the package: its arguments are checked, and Ctrl-C ends it if it reports progress or reads files.

    A method runs in the calling thread, because a callback must not wait for another call of the same object.
    """
    name = function.__qualname__.replace(".__init__", "")
    signature = inspect.signature(function)
    is_reader = function.__name__.startswith(("list_", "read_"))
    is_long = (is_reader or "progress" in signature.parameters) and function.__name__ == function.__qualname__
    work: _Function = _interruptible(function) if is_long else function
    hints: Dict[str, Any] = {}  # evaluated at the first call, because modules import each other

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        given = bound(name, signature, arguments, options)
        hints.update({} if hints else get_type_hints(function))
        for argument, value in given.arguments.items():
            given.arguments[argument] = as_mask(argument, adapted(hints.get(argument), value))
        check(name, hints, given.arguments)
        try:
            return work(*given.args, **given.kwargs)
        except InputError as error:
            if is_reader and lacks_file(hints, given.arguments):
                missing = MissingFileError(str(error))
                missing.errno = errno.ENOENT
                raise missing from None
            raise

    return cast(_AnyFunction, call)


def constructor(kind: type) -> Callable[[_Function], _Function]:
    """Decorates the signature of the constructor of a compiled class: its arguments are checked."""

    def replace(function: _Function) -> _Function:
        compiled, signature = kind.__init__, inspect.signature(function)  # type: ignore[misc]

        @functools.wraps(function)
        def initialize(*arguments: Any, **options: Any) -> None:
            given = signature.bind(*arguments, **options)
            given.apply_defaults()
            compiled(*given.args)

        initialize.__name__, initialize.__qualname__ = "__init__", f"{kind.__name__}.__init__"
        kind.__init__ = public(initialize)  # type: ignore[misc]
        return function

    return replace
