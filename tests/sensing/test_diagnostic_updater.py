"""Diagnostics: the texts, the merging, what is published; and each name of the package."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import diagnostic_updater
import diagnostic_updater._diagnostic_status_wrapper as status_module
import diagnostic_updater._diagnostic_updater as updater_module
import diagnostic_updater._publisher as publisher_module
import diagnostic_updater._update_functions as functions_module
import pytest
from tests.sensing.spinning import spin_until

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.time import Time
from tfloom_sensing import update_functions
from tfloom_sensing.diagnosed_publisher import DiagnosedPublisher, HeaderlessTopicDiagnostic, TopicDiagnostic
from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatusWrapper
from tfloom_sensing.diagnostic_tasks import CompositeDiagnosticTask, DiagnosticTask, FunctionDiagnosticTask
from tfloom_sensing.diagnostic_updater import DiagnosticTaskVector, Updater
from tfloom_sensing.update_functions import (
    FrequencyStatus,
    FrequencyStatusParam,
    Heartbeat,
    TimeStampStatus,
    TimeStampStatusParam,
)

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR
LONG_S = 3600.0
"""A period in which no timer runs."""


class Watch:
    """A node's /diagnostics, as another node hears them."""

    def __init__(self, node: Node) -> None:
        self.arrays: list[DiagnosticArray] = []
        node.create_subscription(DiagnosticArray, "/diagnostics", self.arrays.append, 100)
        self._executor = SingleThreadedExecutor(context=node.context)
        self._executor.add_node(node)

    def next(self) -> list[DiagnosticStatus]:
        """Return the statuses of the next message."""
        spin_until(self._executor, lambda: self.arrays)
        return self.arrays.pop(0).status

    def close(self) -> None:
        self._executor.shutdown()


@pytest.fixture
def watch(make_node: Callable[..., Node]) -> Iterator[Watch]:
    watch = Watch(make_node("watch"))
    yield watch
    watch.close()


@pytest.fixture
def updater(node: Node, watch: Watch) -> Updater:
    return Updater(node, LONG_S)


class Clock:
    """The time that the tasks see."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now_s = 1000.0
        monkeypatch.setattr(update_functions, "_now", lambda: Time(nanoseconds=int(self.now_s * 1e9)))


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    return Clock(monkeypatch)


def fill(level: bytes, message: str) -> Callable[[DiagnosticStatusWrapper], DiagnosticStatusWrapper]:
    def run(stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        stat.summary(level, message)
        return stat

    return run


def values(stat: DiagnosticStatus) -> dict[str, str]:
    return {pair.key: pair.value for pair in stat.values}


def summary(stat: DiagnosticStatus) -> tuple[bytes, str]:
    return stat.level, stat.message


def test_a_status_is_filled() -> None:
    stat = DiagnosticStatusWrapper(name="motor")
    stat.summary(WARN, "warm")
    stat.add("temperature", "80.5")
    stat.add("fans", 2)
    assert (stat.name, stat.level, stat.message) == ("motor", WARN, "warm")
    assert values(stat) == {"temperature": "80.5", "fans": "2"}
    other = DiagnosticStatusWrapper()
    other.summary(stat)
    assert summary(other) == (WARN, "warm")
    stat.clearSummary()
    assert summary(stat) == (OK, "")
    stat.summary(2, "as a number")
    assert stat.level == ERROR
    assert isinstance(stat, DiagnosticStatus)


@pytest.mark.parametrize(
    ("first", "second", "merged"),
    [
        ((OK, "a"), (OK, "b"), (OK, "a; b")),
        ((OK, ""), (OK, "b"), (OK, "b")),
        ((OK, "a"), (WARN, "b"), (WARN, "b")),
        ((WARN, "a"), (OK, "b"), (WARN, "a")),
        ((WARN, "a"), (ERROR, "b"), (ERROR, "a; b")),
        ((ERROR, "a"), (WARN, "b"), (ERROR, "a; b")),
    ],
)
def test_summaries_are_merged(
    first: tuple[bytes, str], second: tuple[bytes, str], merged: tuple[bytes, str]
) -> None:
    stat = DiagnosticStatusWrapper()
    stat.summary(*first)
    stat.mergeSummary(*second)
    assert summary(stat) == merged
    stat.summary(*first)
    stat.mergeSummary(DiagnosticStatus(level=second[0], message=second[1]))
    assert summary(stat) == merged


@pytest.mark.parametrize("arguments", [(), ("text",), (OK,), (OK, "a", "b"), (b"\0\0", "a"), (256, "a")])
def test_what_is_no_summary(arguments: tuple[object, ...]) -> None:
    stat = DiagnosticStatusWrapper()
    for call in (stat.summary, stat.mergeSummary):
        with pytest.raises(TypeError, match="a summary is a DiagnosticStatus, or a level"):
            call(*arguments)


def test_tasks() -> None:
    task = DiagnosticTask("plain")
    stat = DiagnosticStatusWrapper()
    assert (task.getName(), task.run(stat)) == ("plain", stat)
    assert summary(FunctionDiagnosticTask("f", fill(WARN, "w")).run(stat)) == (WARN, "w")
    assert summary(Heartbeat().run(stat)) == (OK, "Alive")
    assert Heartbeat().getName() == "Heartbeat"


def test_a_composite_task_merges() -> None:
    composite = CompositeDiagnosticTask("both")
    composite.addTask(FunctionDiagnosticTask("low", fill(OK, "Lower-bound OK")))
    composite.addTask(FunctionDiagnosticTask("high", fill(ERROR, "Too high")))
    stat = DiagnosticStatusWrapper(level=WARN, message="given")
    assert summary(composite.run(stat)) == (ERROR, "Too high")
    seen: list[tuple[bytes, str]] = []
    composite.addTask(FunctionDiagnosticTask("see", lambda stat: seen.append(summary(stat)) or stat))
    stat.summary(WARN, "given")
    composite.run(stat)
    assert seen == [(WARN, "given")]


@pytest.mark.parametrize(
    ("ticks", "seconds", "bound", "expected"),
    [
        (0, 1, {"min": 1, "max": 2}, (ERROR, "No events recorded.")),
        (4, 2, {"min": 2, "max": 3}, (OK, "Desired frequency met")),
        (1, 2, {"min": 2, "max": 3}, (WARN, "Frequency too low.")),
        (8, 2, {"min": 2, "max": 3}, (WARN, "Frequency too high.")),
        (80, 2, {"min": 2}, (OK, "Desired frequency met")),
        (19, 10, {"min": 2, "max": 2}, (OK, "Desired frequency met")),  # within the tolerance
        (3, 0, {"min": 2}, (WARN, "Frequency too low.")),
    ],
)
def test_frequencies(
    ticks: int, seconds: float, bound: dict[str, float], expected: tuple[bytes, str], clock: Clock
) -> None:
    status = FrequencyStatus(FrequencyStatusParam(bound))
    assert status.getName() == "FrequencyStatus"
    for _ in range(ticks):
        status.tick()
    clock.now_s += seconds
    stat = status.run(DiagnosticStatusWrapper())
    assert summary(stat) == expected
    frequency = ticks / seconds if seconds else 0
    assert values(stat) == {
        "Events in window": str(ticks),
        "Events since startup": str(ticks),
        "Duration of window (s)": f"{seconds:f}",
        "Actual frequency (Hz)": f"{frequency:f}",
        **({"Target frequency (Hz)": "2.000000"} if bound.get("max") == bound["min"] else {}),
        "Minimum acceptable frequency (Hz)": f"{bound['min'] * 0.9:f}",
        **({"Maximum acceptable frequency (Hz)": f"{bound['max'] * 1.1:f}"} if "max" in bound else {}),
    }


def test_the_window_of_frequencies(clock: Clock) -> None:
    """The events of the last runs count, as many as the window has; bounds may change."""
    bound = {"min": 0.0}
    status = FrequencyStatus(FrequencyStatusParam(bound, 0.0, 2), "often")
    durations = []
    for ticks in (1, 2, 3):
        for _ in range(ticks):
            status.tick()
        clock.now_s += 1
        found = values(status.run(DiagnosticStatusWrapper()))
        durations.append((found["Events in window"], found["Duration of window (s)"]))
    assert durations == [("1", "1.000000"), ("3", "2.000000"), ("5", "2.000000")]
    assert "Minimum acceptable frequency (Hz)" not in found
    bound["min"] = 100
    clock.now_s += 1
    assert summary(status.run(DiagnosticStatusWrapper())) == (WARN, "Frequency too low.")
    status.clear()
    clock.now_s += 1
    assert summary(status.run(DiagnosticStatusWrapper())) == (ERROR, "No events recorded.")


@pytest.mark.parametrize(
    ("ages", "expected", "counts"),
    [
        ([], (WARN, "No data since last update."), "000"),
        ([0.5], (OK, "Timestamps are reasonable."), "000"),
        ([-2.0], (ERROR, "Timestamps too far in future seen."), "010"),
        ([6.0], (ERROR, "Timestamps too far in past seen."), "100"),
        ([6.0, -2.0], (ERROR, "Timestamps too far in past seen."), "110"),
        ([0.5, None], (ERROR, "Zero timestamp seen."), "001"),
        ([None], (WARN, "No data since last update."), "000"),
    ],
)
def test_time_stamps(
    ages: list[float | None], expected: tuple[bytes, str], counts: str, clock: Clock
) -> None:
    status = TimeStampStatus()
    assert status.getName() == "Timestamp Status"
    for age in ages:
        status.tick(0.0 if age is None else clock.now_s - age)
    stat = status.run(DiagnosticStatusWrapper())
    assert summary(stat) == expected
    known = [age for age in ages if age is not None] or [0]
    assert values(stat) == {
        "Earliest timestamp delay:": f"{min(known):f}",
        "Latest timestamp delay:": f"{max(known):f}",
        "Earliest acceptable timestamp delay:": "-1.000000",
        "Latest acceptable timestamp delay:": "5.000000",
        "Late diagnostic update count:": counts[0],
        "Early diagnostic update count:": counts[1],
        "Zero seen diagnostic update count:": counts[2],
    }
    assert summary(status.run(DiagnosticStatusWrapper())) == (WARN, "No data since last update.")


def test_stamps_of_each_kind(clock: Clock) -> None:
    status = TimeStampStatus(TimeStampStatusParam(0, 10))
    for stamp in (997.0, Time(seconds=996), TimeMessage(sec=995)):
        status.tick(stamp)
    found = values(status.run(DiagnosticStatusWrapper()))
    assert (found["Earliest timestamp delay:"], found["Latest timestamp delay:"]) == ("3.000000", "5.000000")


def test_without_a_clock_of_its_own() -> None:
    status = TimeStampStatus()
    status.tick(update_functions._now())
    assert summary(status.run(DiagnosticStatusWrapper())) == (OK, "Timestamps are reasonable.")


def test_what_an_updater_publishes(updater: Updater, watch: Watch) -> None:
    updater.setHardwareID("unit 7")
    updater.add("first", fill(WARN, "so so"))
    (status,) = watch.next()
    assert (status.name, *summary(status)) == ("under_test: first", OK, "Node starting up")
    updater.add(DiagnosticTask("second"))
    watch.next()
    updater.force_update()
    first, second = watch.next()
    assert (first.name, *summary(first)) == ("under_test: first", WARN, "so so")
    assert first.hardware_id == second.hardware_id == "unit 7"
    assert (second.name, *summary(second)) == ("under_test: second", ERROR, "No message was set")
    updater.broadcast(OK, "Doing important initialization stuff.")
    assert [summary(status) for status in watch.next()] == [(OK, "Doing important initialization stuff.")] * 2
    assert updater.removeByName("first")
    assert not updater.removeByName("first")
    updater.update()
    assert [status.name for status in watch.next()] == ["under_test: second"]


def test_a_status_is_published_as_it_was(updater: Updater, watch: Watch) -> None:
    stat = DiagnosticStatusWrapper(name="mine", level=WARN)
    stat.add("key", "value")
    for _ in range(2):
        updater.publish(stat)
        (status,) = watch.next()
        assert (status.name, values(status)) == ("under_test: mine", {"key": "value"})
    updater.publish([stat, stat])
    assert len(watch.next()) == 2
    assert stat.name == "mine"


def test_the_timer_updates(node: Node, watch: Watch) -> None:
    updater = Updater(node, LONG_S)
    updater.add(Heartbeat())
    watch.next()
    first = updater.timer
    updater.period = 0.01
    assert updater.period == 0.01
    assert updater.timer is not first
    assert list(node.timers) == [updater.timer]
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    executor.spin_once(timeout_sec=10)
    executor.shutdown()
    assert watch.next()[0].message == "Alive"


def test_parameters(make_node: Callable[..., Node]) -> None:
    given = [
        Parameter("diagnostic_updater.period", value=77.0),
        Parameter("diagnostic_updater.use_fqn", value=True),
    ]
    node = make_node("named", namespace="/robot", parameter_overrides=given)
    updater = Updater(node)
    assert (updater.period, updater.node_name) == (77.0, "/robot/named")
    assert Updater(node).period == 77.0  # a second one of the node takes the same
    plain = Updater(make_node("plain", namespace="/robot"))
    assert (plain.period, plain.node_name) == (1.0, "plain")


def test_warnings(updater: Updater, node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    logged: list[str] = []
    monkeypatch.setattr(type(node.get_logger()), "warn", lambda _self, text: logged.append(text))
    updater.add("fine", fill(OK, "fine"))
    updater.add("bad", fill(WARN, "bad"))
    updater.update()
    assert logged == []
    updater.verbose = True
    updater.update()
    assert logged == ["Non-zero diagnostic status. Name: bad, status b'\\x01': bad"]
    updater.removeByName("bad")
    logged.clear()
    for _ in range(2):
        updater.update()
    assert len(logged) == 1
    assert logged[0].startswith("diagnostic_updater: No HW_ID was set. This is probably a bug.")


def test_a_task_that_forgets_to_return_the_status(updater: Updater) -> None:
    updater.add("forgetful", lambda _stat: None)
    with pytest.raises(TypeError, match="the diagnostic task 'forgetful' returned None; it must return"):
        updater.update()


def test_a_task_may_change_the_list(updater: Updater) -> None:
    def once(stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        updater.removeByName("once")
        updater.add(Heartbeat())
        return stat

    updater.add("once", once)
    updater.update()
    assert [task.name for task in updater.tasks] == ["Heartbeat"]


@pytest.mark.parametrize("arguments", [(), ("name",), (1, 2), ("name", len, 3)])
def test_what_is_no_task(arguments: tuple[object, ...]) -> None:
    with pytest.raises(TypeError, match="add takes a DiagnosticTask, or a name and a function"):
        DiagnosticTaskVector().add(*arguments)


def test_a_vector_of_tasks() -> None:
    vector = DiagnosticTaskVector()
    vector.add(Heartbeat())
    (task,) = vector.tasks
    assert isinstance(task, DiagnosticTaskVector.DiagnosticTaskInternal)
    stat = task.run(DiagnosticStatusWrapper())
    assert (stat.name, stat.message) == ("Heartbeat", "Alive")


def test_topics_without_headers(updater: Updater, clock: Clock) -> None:
    topic = HeaderlessTopicDiagnostic("cmd_vel", updater, FrequencyStatusParam({"min": 1, "max": 3}))
    assert [task.name for task in updater.tasks] == ["cmd_vel topic status"]
    topic.tick()
    clock.now_s += 1
    assert summary(topic.run(DiagnosticStatusWrapper())) == (OK, "Desired frequency met")
    topic.tick()
    topic.clear_window()
    clock.now_s += 1
    assert summary(topic.run(DiagnosticStatusWrapper())) == (ERROR, "No events recorded.")


def test_topics_with_headers(updater: Updater, clock: Clock) -> None:
    topic = TopicDiagnostic("scan", updater, FrequencyStatusParam({"min": 10}), TimeStampStatusParam())
    topic.tick(clock.now_s - 100)
    clock.now_s += 1
    assert summary(topic.run(DiagnosticStatusWrapper())) == (
        ERROR,
        "Frequency too low.; Timestamps too far in past seen.",
    )


def test_a_diagnosed_publisher(updater: Updater, watch: Watch, node: Node) -> None:
    got: list[PointStamped] = []
    node.create_subscription(PointStamped, "point", got.append, 10)
    plain = node.create_publisher(PointStamped, "point", 10)
    publisher = DiagnosedPublisher(
        plain, updater, FrequencyStatusParam({"min": 0.0}), TimeStampStatusParam(-10, 10)
    )
    assert publisher.name == "/point topic status"
    message = PointStamped()
    message.header.stamp = node.get_clock().now().to_msg()
    publisher.publish(message)
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    spin_until(executor, lambda: got)
    executor.shutdown()
    watch.next()
    updater.update()
    (status,) = watch.next()
    assert summary(status) == (OK, "Desired frequency met; Timestamps are reasonable.")
    assert values(status)["Events since startup"] == "1"


def test_the_package_hands_on() -> None:
    ours = {
        DiagnosticStatusWrapper,
        DiagnosticTask,
        FunctionDiagnosticTask,
        CompositeDiagnosticTask,
        DiagnosticTaskVector,
        Updater,
        FrequencyStatusParam,
        FrequencyStatus,
        TimeStampStatusParam,
        TimeStampStatus,
        Heartbeat,
        HeaderlessTopicDiagnostic,
        TopicDiagnostic,
        DiagnosedPublisher,
    }
    for cls in ours:
        assert getattr(diagnostic_updater, cls.__name__) is cls
    assert status_module.DiagnosticStatusWrapper is DiagnosticStatusWrapper
    assert updater_module.Updater is Updater
    assert updater_module.CompositeDiagnosticTask is CompositeDiagnosticTask
    assert publisher_module.DiagnosedPublisher is DiagnosedPublisher
    assert functions_module.Heartbeat is Heartbeat
    for name in ("DiagnosticArray", "DiagnosticStatus", "KeyValue", "Time", "Clock", "ClockType"):
        assert hasattr(diagnostic_updater, name)
