"""Each public call that waits, creates or spins leaves nothing behind, though a program makes it again and again."""

from __future__ import annotations

import gc
import inspect
import re
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import psutil
import pytest
from tests.faults.public_callables import functions_of, own_names, public_modules
from tests.faults.round_rows import COVERED, OFF, ROWS, World
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.node.context.context import Context

WIRES = ["tfloom_local", "rmw_cyclonedds_cpp", pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH)]
ENDS_S = 30.0
"""Longest wait for what ends by itself, on other threads."""
WARM_UP = 5
"""Rounds before the first look: of what is imported, cached and kept for reuse."""
OBJECTS_OF_THE_PEER = 80
"""Most by which the number of objects differs between two moments of the peer's work."""
KB = 1024
MAX_KB = {"tfloom_local": 10, "rmw_cyclonedds_cpp": 20, "rmw_zenoh_cpp": 400}
"""Most memory that a round may leave [KiB]; on Zenoh, the library keeps some of each endpoint (docs/zenoh.md)."""
PACKAGES = ("tfloom.ros_names.rclpy", "tfloom.ros_names.tf2_ros", "tfloom.ros_names.message_filters")
CALLS = re.compile(
    r"create_|wait_|spin|call(_async)?$|send_goal|get_result|cancel_goal|sleep|lookup_transform|can_transform|init$"
)
ENDS = ("destroy", "shutdown", "unregister", "close")
"""Methods that end what a constructor has begun."""


class Usage(NamedTuple):
    descriptors: int
    threads: int
    objects: int
    memory: int
    thread_names: tuple[str, ...]
    """Of the threads, where the system tells them; they say of which one was left behind."""

    @classmethod
    def now(cls) -> Usage:
        process = psutil.Process()
        for _ in range(2):  # what finalizers have let go of, too
            gc.collect()
        descriptors = process.num_fds() if hasattr(process, "num_fds") else 0
        names = sorted(path.read_text("utf-8").strip() for path in Path("/proc/self/task").glob("*/comm"))
        threads, objects, memory = process.num_threads(), len(gc.get_objects()), process.memory_info().rss
        return cls(descriptors, threads, objects, memory, tuple(names))

    def exceeds(self, before: Usage) -> bool:
        """Return whether something has been left behind, but for memory; the peer works meanwhile."""
        return (
            self.descriptors > before.descriptors + 1
            or self.threads > before.threads + 1
            or self.objects > before.objects + OBJECTS_OF_THE_PEER
        )


@pytest.fixture(scope="module", params=WIRES)
def world(
    request: pytest.FixtureRequest, module_domain_id: int, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[World]:
    with pytest.MonkeyPatch.context() as patch, use_port_of(module_domain_id):
        patch.setenv("RMW_IMPLEMENTATION", request.param)
        context = Context()
        context.init(["program"])
        world = World(context, tmp_path_factory.mktemp("world"))
        yield world
        world.close()


def run(world: World, name: str, rounds: int) -> tuple[Usage, Usage]:
    """Run a row, and return what was in use before and after it, once what ends by itself has ended."""
    for _ in range(WARM_UP):
        ROWS[name](world)
    before = Usage.now()
    for _ in range(rounds):
        ROWS[name](world)
    end = time.monotonic() + ENDS_S
    while (after := Usage.now()).exceeds(before) and time.monotonic() < end:
        time.sleep(0.05)
    return before, after


def check(world: World, name: str, rounds: int) -> tuple[Usage, Usage]:
    before, after = run(world, name, rounds)
    assert not after.exceeds(before), (before, after)
    return before, after


@pytest.mark.parametrize("name", ROWS)
def test_some_rounds_leave_nothing_behind(world: World, name: str) -> None:
    check(world, name, 20)


@pytest.mark.slow
@pytest.mark.parametrize("name", ROWS)
def test_many_rounds_leave_nothing_behind(world: World, name: str, request: pytest.FixtureRequest) -> None:
    rounds = 200
    most = MAX_KB[request.node.callspec.params["world"]] * KB * rounds
    usages = [check(world, name, rounds)]
    if grown_by(usages[0]) >= most:  # the allocators keep some of the first rounds' memory for reuse
        usages.append(check(world, name, rounds))
    assert min(map(grown_by, usages)) < most, usages


def grown_by(usages: tuple[Usage, Usage]) -> int:
    before, after = usages
    return after.memory - before.memory


def is_call(function: Any) -> bool:
    """Return whether a function waits, creates or spins, by its name or by what it returns."""
    returned = str(inspect.signature(function).return_annotation)
    return CALLS.match(function.__name__) is not None or returned.startswith("Future[")


def public_calls() -> set[str]:
    """Return `Class.method` or `module.function` for what the public names have, and `Class.__init__` of what ends."""
    found: set[str] = set()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of modules that are deprecated
        values = [v for package in PACKAGES for module in public_modules(package) for v in own_names(module)]
    for value in values:
        if inspect.isclass(value) and any(hasattr(value, end) for end in ENDS):
            found.add(f"{value.__qualname__}.__init__")
        for function in functions_of(value):
            if is_call(function) and "." in function.__qualname__:
                found.add(function.__qualname__)
            elif is_call(function):
                found.add(f"{function.__module__.rpartition('.')[2]}.{function.__qualname__}")
    return found


def test_every_public_call_has_a_row() -> None:
    """A new call that waits, creates or spins needs a row in `round_rows.py`, or a reason in its `OFF`."""
    assert public_calls() - set(COVERED) - set(OFF) == set(), (
        "tests/faults/round_rows.py: a public call that waits, creates or spins gets a row, or a reason in its OFF"
    )
    assert set(OFF) <= public_calls()
    assert public_calls() & set(OFF) & set(COVERED) == set()
