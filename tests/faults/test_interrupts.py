"""Ctrl-C at each call while a node is made: the program gets its KeyboardInterrupt, and no other error."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from inspect import CO_GENERATOR
from pathlib import Path
from types import FrameType

import pytest

import tfloom.node
from tfloom.node.context.context import Context
from tfloom.node.node import Node

FOLDER = str(Path(tfloom.node.__file__).parent)


class Interrupt:
    """Raises KeyboardInterrupt at the call with a number, of those of functions in `FOLDER`.

    Python runs handlers of signals there. A trace of lines would raise at places where no handler runs, as between the
    block of a `with` and its `__exit__`, and leave locks locked.
    """

    def __init__(self, number: int) -> None:
        self.left = number
        self.place = ""

    def trace(self, frame: FrameType, event: str, _argument: object) -> None:
        """Trace a frame; see sys.settrace."""
        if (
            frame.f_code.co_flags & CO_GENERATOR
        ):  # its end is a call, too, whose exception is printed and dropped
            return
        if event == "call" and frame.f_code.co_filename.startswith(FOLDER):
            self.left -= 1
            if self.left == 0:
                sys.settrace(None)
                self.place = f"{frame.f_code.co_filename}:{frame.f_lineno}"
                raise KeyboardInterrupt


@pytest.fixture
def _garbage_is_kept() -> Iterator[None]:
    """Keep the nodes of failed constructors until the end, because an interrupt in __del__ would be lost."""
    gc.disable()
    yield
    gc.enable()
    gc.collect()


@pytest.mark.usefixtures("_garbage_is_kept")
def test_ctrl_c_at_each_call_of_a_new_node(local_context: Context) -> None:
    Node("warm_up", context=local_context).destroy_node()
    wrong = []
    number = 0
    while True:
        number += 1
        interrupt = Interrupt(number)
        before = sys.gettrace()
        sys.settrace(interrupt.trace)
        node = None
        try:
            node = Node("interrupted", context=local_context)
        except KeyboardInterrupt as error:
            if error.__context__ is not None:
                wrong.append(f"{interrupt.place}: {error.__context__!r}")
        except Exception as error:  # noqa: BLE001 - each is one too many
            wrong.append(f"{interrupt.place}: {error!r}")
        finally:
            sys.settrace(before)
        if node is not None:
            node.destroy_node()
            break
    assert not wrong, "\n".join(wrong)
    assert number > 50
