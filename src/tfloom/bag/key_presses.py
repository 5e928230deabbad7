"""Keys that are pressed while a bag is recorded or played."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager

from tfloom.common.keyboard import Keyboard, NoTerminalError, without_repetitions
from tfloom.common.terminal import report
from tfloom.node.values.callback_errors import report_exception

__all__ = ["handled_keys"]

_POLL_S = 0.1


@contextmanager
def handled_keys(actions: Mapping[str, Callable[[], object]], *, enabled: bool = True) -> Iterator[None]:
    """Call an action for each key that is pressed during the block, on a thread.

    If standard input is not a terminal, a line on stderr says so. To be entered in the main thread.

    Args:
        actions: By key: ` `, `up`, `down`, `right`, …
        enabled: Whether keys are read at all.
    """
    if not enabled:
        yield
        return
    with ExitStack() as stack:
        try:
            keyboard = stack.enter_context(Keyboard())
        except NoTerminalError:
            report("stdin is not a terminal device. Keyboard handling disabled.")
            yield
            return
        ended = threading.Event()
        thread = threading.Thread(target=_read, args=(keyboard, actions, ended), daemon=True)
        try:
            thread.start()
        except RuntimeError as error:
            report(f"Keyboard handling disabled: {error}.")
            yield
            return
        try:
            yield
        finally:
            ended.set()
            thread.join()


def _read(keyboard: Keyboard, actions: Mapping[str, Callable[[], object]], ended: threading.Event) -> None:
    while not ended.is_set():
        try:
            keys = keyboard.read(_POLL_S)
        except EOFError:
            return
        for key in without_repetitions(keys):
            if key in actions:
                _call(actions[key])


def _call(action: Callable[[], object]) -> None:
    try:
        action()
    except Exception:  # of one key; the next must work
        report_exception()
