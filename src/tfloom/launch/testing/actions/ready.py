"""The report of a test description that its tests can begin."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.event import Event
from tfloom.launch.launch_context import LaunchContext

__all__ = ["ReadyToTest", "TestsCanBegin"]


class TestsCanBegin(Event):
    """The launch has come to its ReadyToTest action."""

    __test__ = False  # for pytest
    name = "tfloom.launch.testing.TestsCanBegin"


class ReadyToTest(Action):
    """Lets the tests of a launch begin; by itself, or where a handler of events has it, once that event has come."""

    def describe(self) -> str:
        """Return the class name."""
        return "ReadyToTest()"

    def execute(self, context: LaunchContext) -> None:
        """Emit the event that starts the tests; in a launch without tests nothing handles it."""
        event = TestsCanBegin()
        if context.would_handle_event(event):
            context.emit_event_sync(event)
