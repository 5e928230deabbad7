"""A node that looks at what a launch has started, and the end of the launch."""

from __future__ import annotations

import signal
from collections.abc import Callable

from tests.conftest import Program, run_to_end

from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener


class User:
    """A node that looks at what a launch has started."""

    def __init__(self) -> None:
        init(args=[])
        self.node = Node("user")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self.node)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self.node)

    def sees(self, condition: Callable[[], object]) -> Callable[[], object]:
        """Return a condition that is evaluated after waiting messages were received."""

        def look() -> object:
            self._executor.spin_once(timeout_sec=0.01)
            return condition()

        return look

    def nodes(self) -> set[str]:
        named = self.node.get_node_names_and_namespaces()
        return {f"{namespace.rstrip('/')}/{name}" for name, namespace in named} - {"/user"}

    def position(self, target: str, source: str) -> tuple[float, float] | None:
        """Return where a frame is in another one [m]; None while it isn't known."""
        try:
            there = self.buffer.lookup_transform(target, source, Time()).transform.translation
        except TransformException:
            return None
        return float(there.x), float(there.y)

    def end(self) -> None:
        self._executor.shutdown()
        self.node.destroy_node()
        try_shutdown()


def pids_of(program: Program) -> list[int]:
    """Return the ids of the processes that a launch has started, in order."""
    return [
        int(line.split("[")[-1].rstrip("]")) for line in program.lines if "process started with pid" in line
    ]


def expect_clean_end(program: Program, number: int = signal.SIGINT) -> None:
    """End a launch, and check that all of its processes end without an error."""
    program.signal(number)
    program.wait(60.0)
    assert "Traceback" not in program.output, program.output
    assert "escalating" not in program.output
    started = [line for line in program.lines if "process started with pid" in line]
    ended = [line for line in program.lines if "process has finished cleanly" in line]
    assert len(started) == len(ended), program.output


def is_running(pid: int) -> bool:
    """Return whether a process runs; one that has ended and that its parent has not asked about does not."""
    done = run_to_end(["ps", "-o", "stat=", "-p", str(pid)])
    return bool(done.stdout.strip()) and not done.stdout.startswith("Z")
