"""Each kind of callback raises once: the exception reaches whom it concerns, and nobody else's work suffers."""

from __future__ import annotations

import threading
from collections.abc import Callable
from itertools import cycle

import pytest
from tests.conftest import wait_until
from tests.faults import application_rows, node_rows
from tests.faults.conftest import EXECUTORS, Fails, World
from tests.faults.covered import COVERED
from tests.faults.public_callables import public_callables
from tests.launch import test_raising_functions

from tfloom._native import ReadyQueue
from tfloom.node.context.context import Context
from tfloom.node.executing.entity import Entity
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node

MakeWorld = Callable[..., World]
ROWS = node_rows.ROWS | application_rows.ROWS
OFF_THE_WIRE = (
    *("timer", "waitable_", "jump_pre", "jump_post", "guard_condition", "task", "done_callback_of_a_future"),
    *("done_callback_of_an_", "resumption_", "callback_beside_asyncio", "on_configure", "on_activate"),
    *("on_deactivate", "on_cleanup", "on_shutdown", "on_error", "managed_entity", "qos_overriding"),
    *("pre_set_", "post_set_", "transform_future", "transformable_request", "transform_registration"),
    *(
        "filter_itself",
        "filter_aligner",
        "filter_cache",
        "filter_chain",
        "filter_time",
        "filter_approximate_time",
        "diagnostic_",
    ),
)
"""How the names of the rows begin whose callbacks are not called for anything that the wire brings."""
ON_DDS = [name for name in ROWS if not name.startswith(OFF_THE_WIRE)]


def run(world: World, name: str) -> None:
    expected = ROWS[name](world)
    if expected:
        wait_until(lambda: world.raised, what="the exception")
    if world.context.ok():
        world.check_others()
    world.check_locks()
    assert world.raised == expected
    assert world.reported == []


@pytest.mark.parametrize("executor", EXECUTORS)
@pytest.mark.parametrize("name", ROWS)
def test_callback_raises_once(name: str, executor: str, make_world: MakeWorld) -> None:
    run(make_world(executor), name)


@pytest.mark.parametrize(("name", "executor"), list(zip(ON_DDS, cycle(EXECUTORS))))
def test_callback_raises_once_on_dds(
    name: str, executor: str, domain_id: int, monkeypatch: pytest.MonkeyPatch, make_world: MakeWorld
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    run(make_world(executor), name)


class Response(Entity):
    """Has one response, as a client has; running it calls a function."""

    goes_by_group = False
    callback_group = None

    def __init__(self, run: Callable[[], None]) -> None:
        self._waiting: list[Callable[[], None]] = [run, run]
        self._queue: ReadyQueue | None = None

    def attach(self, queue: ReadyQueue, token: int) -> None:
        queue.post(token)

    def detach(self) -> None:
        """Do nothing."""

    def take(self) -> object:
        return self._waiting.pop() if self._waiting else None

    def run(self, taken: Callable[[], None]) -> None:
        taken()

    def destroy(self) -> None:
        """Do nothing."""


def test_responses_are_taken_after_one_whose_completion_raises(make_world: MakeWorld) -> None:
    """Feedback is delivered before the result is: its callback raises where responses are taken."""
    world = make_world()
    entered, gate = threading.Event(), threading.Event()
    world.executor.create_task(lambda: (entered.set(), gate.wait(30)))
    assert entered.wait(30)
    first, second = Fails(), Fails()
    second.calls.append(())
    world.executor.add_entities([Response(first), Response(second)])
    gate.set()
    wait_until(lambda: first.was_called(2) and second.was_called(3))
    assert world.raised == [first.error]


def test_coroutine_that_ends_the_program_frees_its_group(local_context: Context) -> None:
    node = Node("under_test", context=local_context)
    called: list[None] = []

    async def leave() -> None:
        raise SystemExit(3)

    leaving = node.create_timer(0.001, leave)
    with SingleThreadedExecutor(context=local_context) as executor:
        executor.add_node(node)
        with pytest.raises(SystemExit):
            executor.spin()
        leaving.cancel()
        node.create_timer(0.001, lambda: called.append(None))  # of the same group
        executor.spin_once(timeout_sec=30)
    assert called
    node.destroy_node()


def test_exceptions_that_no_spin_raises_are_printed(
    local_context: Context, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two callbacks raise at the same time: the spin raises one, and the program ends without another spin."""
    both = threading.Barrier(2)
    texts = iter(["one", "another"])

    def run() -> None:
        both.wait(30)
        raise ValueError(next(texts))

    with MultiThreadedExecutor(2, context=local_context) as executor:
        for _ in range(2):
            executor.create_task(run)
        with pytest.raises(ValueError, match=r"one|another") as raised:
            executor.spin()
        wait_until(lambda: not executor._busy)
    printed = capsys.readouterr().err
    assert "no spin has raised it" in printed
    assert ("another" if str(raised.value) == "one" else "one") in printed


def test_every_public_callable_has_a_row() -> None:
    """A parameter that takes a function needs a row, or a reason, in `covered.py`."""
    found = public_callables()
    assert found == set(COVERED), (
        "tests/faults/covered.py: each parameter of the public names that takes a function gets a row, or a reason"
    )
    rows = set(ROWS) | set(test_raising_functions.ROWS)
    assert {row for row in COVERED.values() if not row.startswith("-")} <= rows
