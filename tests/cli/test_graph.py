"""The wait for complete discovery."""

from __future__ import annotations

import threading
import time
from types import SimpleNamespace

import pytest

from tfloom._native import ReadyQueue
from tfloom.cli.shared import graph


class FakeGraph:
    """A graph that changes at given times after `notify`."""

    def __init__(self, *changes_s: float) -> None:
        self.count = 0
        self.changed_at: list[float] = []
        self.whole_from = 0
        self.late = 0
        self.listener: ReadyQueue | None = None
        self.timers = [threading.Timer(when, self.change) for when in changes_s]

    def change(self) -> None:
        self.count += 1
        if self.listener is not None:
            self.changed_at.append(time.monotonic())
            self.listener.post(0)

    def changes(self) -> int:
        return self.count

    def is_whole(self) -> bool:
        return self.count >= self.whole_from

    def late_count(self) -> int:
        return 0 if self.is_whole() else self.late

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        self.listener = queue
        if queue is not None:
            for timer in self.timers:
                timer.start()


def waited(
    changes_s: list[float], most_s: float, whole_from: int = 0, late: int = 0
) -> tuple[float, list[float]]:
    """Return how long the wait took, and when the graph changed during it [s]."""
    fake = FakeGraph(*changes_s)
    fake.whole_from = whole_from
    fake.late = late
    start = time.monotonic()
    graph.wait_until_quiet(fake, most_s)
    duration = time.monotonic() - start
    assert fake.listener is None
    for timer in fake.timers:
        timer.join()
    return duration, [changed_at - start for changed_at in fake.changed_at]


@pytest.mark.timing
@pytest.mark.parametrize(
    ("changes_s", "most_s"),
    [
        ([], 5.0),
        ([0.01], 5.0),
        ([0.1], 5.0),
        ([0.1, 0.2, 0.3], 5.0),
        ([0.05 * i for i in range(1, 40)], 0.5),
    ],
    ids=["nothing", "at once", "one", "a chain", "no end"],
)
def test_wait_lasts_until_nothing_new_arrives(changes_s: list[float], most_s: float) -> None:
    duration, changed_s = waited(changes_s, most_s)
    # What comes in the last moments may come when the wait has looked for the last time.
    seen_s = [when for when in changed_s if when < duration - 0.05]
    at_least_s = min(most_s, max(graph.MIN_WAIT_S, *(when + graph.QUIET_S for when in [0.0, *seen_s])))
    # On a busy machine the changes come late, and it may wait longer on purpose.
    assert at_least_s <= duration < at_least_s + 0.4 + graph.MAX_LATE_S


@pytest.mark.timing
@pytest.mark.parametrize(
    ("changes_s", "most_s", "at_least_s"),
    [([0.6], 5.0, 0.6), ([], 5.0, graph.MIN_WAIT_S + graph.PATIENCE_S), ([], 0.4, 0.4)],
    ids=["it comes", "it never comes", "for so long at most"],
)
def test_wait_lasts_while_announced_entities_are_missing_and_tells_if_they_never_come(
    changes_s: list[float], most_s: float, at_least_s: float, capsys: pytest.CaptureFixture[str]
) -> None:
    duration, _ = waited(changes_s, most_s, whole_from=1)
    assert at_least_s <= duration < at_least_s + 0.6 + graph.MAX_LATE_S
    assert capsys.readouterr().err == ("" if changes_s else f"{graph.MISSING}\n")


def test_who_looks_further_is_not_told(capsys: pytest.CaptureFixture[str]) -> None:
    fake = FakeGraph()
    fake.whole_from = 1
    graph.wait_until_quiet(fake, 0.0, goes_on=True)
    assert capsys.readouterr().err == ""
    graph.wait_until_quiet(fake, 0.0)
    assert capsys.readouterr().err == f"{graph.MISSING}\n"


WAITING = "waiting for the nodes of 1 participant of Fast DDS, which lists them up to 3 s late\n"
MISSING = "nodes may be missing: 2 participants of Fast DDS did not list them\n"


@pytest.mark.timing
@pytest.mark.parametrize(
    ("changes_s", "most_s", "late", "at_least_s", "told"),
    [
        ([1.6], 5.0, 1, 1.6, WAITING),
        ([0.1], 5.0, 1, 0.1 + graph.QUIET_S, ""),
        ([], 0.8, 2, 0.8, WAITING.replace("1 participant", "2 participants") + MISSING),
        ([], 0.3, 2, 0.3, MISSING),
    ],
    ids=["late", "soon", "not within --spin-time", "a short --spin-time"],
)
def test_wait_for_fast_dds_is_longer_and_told(
    changes_s: list[float],
    most_s: float,
    late: int,
    at_least_s: float,
    told: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    duration, _ = waited(changes_s, most_s, whole_from=1, late=late)
    assert at_least_s <= duration < at_least_s + 0.6 + graph.MAX_LATE_S
    assert capsys.readouterr().err == told


def test_wait_is_not_told_to_who_completes_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("_ARGCOMPLETE", "1")
    waited([], 0.3, whole_from=1, late=1)
    assert capsys.readouterr().err == ""


def test_wait_is_longer_on_a_busy_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    class LateQueue:
        def wait(self, _: int) -> None:
            time.sleep(0.15)

        def post(self, _: int) -> None:
            pass

    monkeypatch.setattr(graph, "ReadyQueue", LateQueue)
    assert waited([], 5.0)[0] >= graph.MIN_WAIT_S + 2 * 0.1


@pytest.mark.parametrize(
    ("name", "hidden"),
    [("/a/b", False), ("/_a", True), ("/a/_action/status", True), ("/a_b", False), ("/", False)],
)
def test_names_with_a_leading_underscore_are_hidden(name: str, hidden: bool) -> None:
    assert graph.is_hidden(name) is hidden


def test_topic_types_are_sorted_and_unique() -> None:
    ends = [
        SimpleNamespace(topic=SimpleNamespace(name=name, type_name=kind))
        for name, kind in [("/b", "p/msg/Z"), ("/a", "p/msg/T"), ("/b", "p/msg/A"), ("/b", "p/msg/Z")]
    ]
    types = graph.topic_types(ends)
    assert list(types.items()) == [("/a", ["p/msg/T"]), ("/b", ["p/msg/A", "p/msg/Z"])]
