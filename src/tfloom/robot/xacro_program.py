"""xacro: write the XML that a file with macros describes, by the library of this name, within limits.

A file of a few lines can stand for any amount of XML: macros that call others twice, or `${9**9**9}`. So the library
runs in a separate process, which has the limits; this one ends it where it doesn't end itself.
"""

from __future__ import annotations

import contextlib
import math
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NoReturn

from tfloom.common.terminal import report
from tfloom.common.xml import guard_minidom
from tfloom.workspace.packages_around import packages_around, packages_of_clones

__all__ = ["main"]

MISSING = "xacro is not installed: pip install 'tfloom[robot]'"
MAX_ELEMENTS = 50_000
"""Number of elements that are evaluated, those of macros each time that they are called."""
MAX_TEXT = 1_000_000
"""Length of a text that an attribute, a property or an element may have [characters]."""
MAX_S = 60.0
"""How long an expansion may take [s]."""
MAX_BYTES = 2 * 1024**3
"""How much memory it may have, where the system can limit it [bytes]."""
GRACE_S = 5.0
"""How long it may take to say that it took too long, until it is ended [s]."""
PARENT_S = 0.2
"""Period at which the process of the library looks whether the one that started it is there [s]."""
PR_SET_PDEATHSIG = 1
"""Of Linux's prctl: the signal that a process gets when its parent ends."""
FAILED = 2
"""Exit code of the library for what is wrong with a file."""


def main(args: list[str] | None = None, near: Path | None = None) -> int:
    """Expand a file; return 0, or 1 without the library. Raise SystemExit for errors, which were printed.

    Args:
        args: The command line; None: `sys.argv`.
        near: A folder around which `$(find PACKAGE)` looks first; None: in workspaces that are sourced, then around the
            file.
    """
    if find_spec("xacro") is None:
        report(f"xacro: {MISSING}")
        return 1
    words = sys.argv[1:] if args is None else args
    limits = [f"{MAX_ELEMENTS}", f"{MAX_S}", f"{MAX_BYTES}", f"{os.getpid()}", f"{near or ''}"]
    with subprocess.Popen([sys.executable, "-m", "tfloom.robot.xacro_program", *limits, *words]) as child:
        try:
            with _ended_by_signal():
                code = child.wait(MAX_S + GRACE_S)
        except subprocess.TimeoutExpired:
            report(f"error: {_too_long(MAX_S)}")
            code = FAILED
        finally:
            child.kill()
    if code < 0:
        name = signal.Signals(-code).name if -code in {*signal.Signals} else f"signal {-code}"
        report(f"error: the expansion was ended by {name}")
        code = FAILED
    if code:
        raise SystemExit(code)
    return 0


@contextlib.contextmanager
def _ended_by_signal() -> Iterator[None]:
    """Raise SystemExit in the block for SIGTERM, so that the child is ended, too."""

    def end(number: int, _: object) -> NoReturn:
        raise SystemExit(128 + number)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def _too_long(limit_s: float) -> str:
    return f"the expansion takes more than {limit_s:g} s, which is the limit: does a macro call others again and again?"


def _expand(limits: list[str], args: list[str]) -> int:
    """Expand a file in this process; return the exit code. The library raises SystemExit for errors."""
    import xml.parsers.expat  # noqa: F401  # the library uses it, and imports it too late for its errors

    import tfloom

    max_elements, max_s, max_bytes, parent = int(limits[0]), float(limits[1]), int(limits[2]), int(limits[3])
    _end_with(parent)
    _limit_time(max_s + GRACE_S)
    tfloom.use_ros_names()  # it finds packages by ament_index_python
    import xacro

    guard_minidom()  # by which it reads
    xacro.eval_all = _counted(xacro, max_elements, max_s)
    xacro.eval_extension = _explained(xacro)
    xacro.eval_text = _measured(xacro)
    xacro.process_file = _with_memory(xacro, max_bytes)
    _find_around(xacro, Path(limits[4]) if limits[4] else None)
    sys.argv = ["xacro", *args]
    try:
        xacro.main()
    except BrokenPipeError:
        sys.stdout = None  # there is nobody to write to when Python ends
        return 1
    except MemoryError:  # from writing the XML
        report(f"error: {_too_large(max_bytes)}")
        return FAILED
    return 0


def _end_with(parent: int) -> None:
    """Let this process end when the one that waits for it does, by SIGKILL too.

    On Linux, the kernel ends it; elsewhere a thread does, unless one operation holds the GIL: then `_limit_time`. On
    Windows, a parent that has ended can't be told from one that hasn't.
    """
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    elif os.name == "posix":
        threading.Thread(
            target=_wait_for_end, args=(parent,), name="tfloom_xacro_parent", daemon=True
        ).start()
    if os.name == "posix" and os.getppid() != parent:  # it has ended before
        os._exit(FAILED)


def _wait_for_end(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(PARENT_S)
    os._exit(FAILED)


def _limit_time(max_s: float) -> None:
    """Limit the time on the processor, where the system can: one operation may take for ever, as `9**9**9`."""
    if sys.platform != "win32":
        import resource

        with contextlib.suppress(OSError, ValueError):  # a lower limit of the user's
            most = resource.getrlimit(resource.RLIMIT_CPU)[1]
            resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(max_s), most))


def _counted(xacro: Any, max_elements: int, max_s: float) -> Callable[[Any, Any, Any], None]:
    """Return the library's function that evaluates an element, with a limit for their number and the time."""
    evaluate: Callable[[Any, Any, Any], None] = xacro.eval_all
    end_s = time.monotonic() + max_s
    count = 0

    def evaluate_within_limits(node: Any, macros: Any, symbols: Any) -> None:
        nonlocal count
        count += 1
        if count > max_elements:
            raise xacro.XacroException(
                f"the expansion has more than {max_elements} elements, which is the limit: does a macro call others "
                "again and again?"
            )
        if time.monotonic() > end_s:
            raise xacro.XacroException(_too_long(max_s))
        evaluate(node, macros, symbols)

    return evaluate_within_limits


def _explained(xacro: Any) -> Callable[[str], Any]:
    """Return the library's function that evaluates `$(…)`, with errors that say once what is wrong, and what to do."""
    from xacro import substitution_args

    evaluate: Callable[[str], Any] = xacro.eval_extension

    def evaluate_and_explain(text: str) -> Any:
        try:
            return evaluate(text)
        except xacro.XacroException as error:
            if isinstance(error.exc, substitution_args.ArgException):
                error.suffix = f"(add {error.exc}:=VALUE)"
            elif isinstance(error.exc, LookupError | xacro.XacroException):
                raise xacro.XacroException(str(error.exc)) from None  # once, and without its class
            raise

    return evaluate_and_explain


def _measured(xacro: Any) -> Callable[[Any, Any], Any]:
    """Return the library's function that evaluates a text, with a limit for what it yields."""
    evaluate: Callable[[Any, Any], Any] = xacro.eval_text

    def evaluate_within_limits(text: Any, symbols: Any) -> Any:
        value = evaluate(text, symbols)
        if isinstance(value, str) and len(value) > MAX_TEXT:
            raise xacro.XacroException(
                f"a text has {len(value)} characters, and {MAX_TEXT} are the limit: does a property have others again "
                "and again?"
            )
        return value

    return evaluate_within_limits


def _with_memory(xacro: Any, max_bytes: int) -> Callable[..., Any]:
    """Return the library's function that expands a file, with a limit for the memory, where the system has one."""
    process: Callable[..., Any] = xacro.process_file
    if sys.platform != "win32":
        import resource

        with contextlib.suppress(OSError, ValueError):  # a lower limit of the user's
            resource.setrlimit(resource.RLIMIT_AS, (max_bytes, resource.getrlimit(resource.RLIMIT_AS)[1]))

    def process_within_limits(*args: Any, **options: Any) -> Any:
        try:
            return process(*args, **options)
        except Exception as error:
            cause: BaseException | None = error
            while cause is not None and not isinstance(cause, MemoryError):
                cause = cause.__context__
            if cause is None:
                raise
        raise xacro.XacroException(_too_large(max_bytes))

    return process_within_limits


def _find_around(xacro: Any, near: Path | None) -> None:
    """Let the library find packages around a folder before those of workspaces; None: around the file after them."""
    from xacro import XacroException, substitution_args

    names = vars(substitution_args)
    find: Callable[[str], str] = names["_eval_find"]
    process: Callable[..., Any] = xacro.process_file
    folder = near or Path.cwd()

    def process_and_remember(path: str | None, *args: Any, **options: Any) -> Any:
        nonlocal folder
        if near is None and path:  # without one it reads its standard input
            folder = Path(path).absolute().parent
        return process(path, *args, **options)

    def find_around(package: str) -> str:
        around = packages_around(folder, package)
        if near is not None and around:
            return str(around[0])
        try:
            return find(package)
        except LookupError:
            if places := (*around, *packages_of_clones(folder, package)):
                return str(places[0])
            if near is None:
                raise
            raise XacroException(f"there is no package '{package}', and none around {near}") from None

    xacro.process_file = process_and_remember
    names["_eval_find"] = find_around


def _too_large(max_bytes: int) -> str:
    return f"the expansion needs more than {max_bytes // 1024**2} MiB of memory, which is the limit"


if __name__ == "__main__":
    sys.exit(_expand(sys.argv[1:6], sys.argv[6:]))
