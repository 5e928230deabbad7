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
    """Raises KeyboardInterrupt at the call with a number, from 1, of those of functions in `FOLDER`; 0 is none.

    Python runs handlers of signals there. A trace of lines would raise at places where no handler runs, as between the
    block of a `with` and its `__exit__`, and leave locks locked.
    """

    def __init__(self, number: int = 0) -> None:
        self.number = number
        self.places: list[tuple[object, ...]] = []
        """Which function is called, and where, of each call so far."""

    def trace(self, frame: FrameType, event: str, _argument: object) -> None:
        """Trace a frame; see sys.settrace."""
        if (
            frame.f_code.co_flags & CO_GENERATOR
        ):  # its end is a call, too, whose exception is printed and dropped
            return
        if event == "call" and frame.f_code.co_filename.startswith(FOLDER):
            caller = frame.f_back
            assert caller is not None
            self.places.append((frame.f_code, caller.f_code, caller.f_lineno))
            if len(self.places) == self.number:
                sys.settrace(None)
                raise KeyboardInterrupt


def interrupted(interrupt: Interrupt, context: Context) -> str:
    """Make a node; return what was wrong with the end of that, or nothing."""
    before = sys.gettrace()
    sys.settrace(interrupt.trace)
    try:
        node = Node("interrupted", context=context)
    except KeyboardInterrupt as error:
        return f"{interrupt.places[-1]}: {error.__context__!r}" if error.__context__ is not None else ""
    except Exception as error:  # noqa: BLE001 - each is one too many
        return f"{interrupt.places[-1]}: {error!r}"
    finally:
        sys.settrace(before)
    node.destroy_node()
    return "it was not interrupted" if interrupt.number else ""


@pytest.fixture
def _garbage_is_kept() -> Iterator[None]:
    """Keep the nodes of failed constructors until the end, because an interrupt in __del__ would be lost."""
    gc.disable()
    yield
    gc.enable()
    gc.collect()


@pytest.mark.usefixtures("_garbage_is_kept")
def test_ctrl_c_at_each_call_of_a_new_node(local_context: Context) -> None:
    """A call that is made again at the same place, as for each service, is interrupted the first and the last time."""
    Node("warm_up", context=local_context).destroy_node()
    undisturbed = Interrupt()
    assert not interrupted(undisturbed, local_context)
    numbers = list(range(1, len(undisturbed.places) + 1))
    last = dict(zip(undisturbed.places, numbers, strict=True))
    first = dict(zip(reversed(undisturbed.places), reversed(numbers), strict=True))
    wrong = [interrupted(Interrupt(number), local_context) for number in (*first.values(), *last.values())]
    assert not any(wrong), "\n".join(filter(None, wrong))
    assert len(wrong) > 50
