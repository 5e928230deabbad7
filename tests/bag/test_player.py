"""Players on the wire inside the process: what they publish, when, and how they are steered."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from tests.bag.written_bags import START_NS, STEP_NS, begin_bag, push, text, topic, transforms, write_bag

from tfloom.bag import open_bag
from tfloom.bag.bag import Bag
from tfloom.bag.playing import play_clock
from tfloom.bag.playing.play_options import PlayOptions, parse_remaps
from tfloom.bag.playing.player import Player
from tfloom.bag.playing.read_ahead import ReadAhead
from tfloom.bag.playing.run import play
from tfloom.bag.qos_profiles import offered
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.values import RawMessage
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.rosbag2_interfaces.msg import ReadSplitEvent
from tfloom.interfaces.rosbag2_interfaces.srv import (
    Burst,
    GetRate,
    IsPaused,
    Play,
    PlayNext,
    Seek,
    SetRate,
    TogglePaused,
)
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.time import Time
from tfloom.rmw.qos import DurabilityPolicy as Durability
from tfloom.rmw.qos import QoS, ReliabilityPolicy


class Listener:
    """Receives what a player publishes, on a thread, with the time of each receipt [s]."""

    def __init__(self, context: Context) -> None:
        self.node = Node("listener", context=context)
        self.texts: list[str] = []
        self.times: list[float] = []
        self.clocks: list[int] = []
        self.executor = SingleThreadedExecutor(context=context)
        self.executor.add_node(self.node)
        self.node.create_subscription(String, "/chatter", self._on_text, 1000)
        self.node.create_subscription(Clock, "/clock", self._on_clock, 1000)

    def _on_text(self, message: String) -> None:
        self.texts.append(message.data)
        self.times.append(time.monotonic())

    def _on_clock(self, message: Clock) -> None:
        self.clocks.append(Time.from_msg(message.clock).nanoseconds)

    def wait_until(self, condition: Callable[[], bool]) -> None:
        end = time.monotonic() + 10.0
        while not condition():
            assert time.monotonic() < end, (self.texts[-3:], self.clocks[-3:])
            self.executor.spin_once(0.01)

    def expect(self, expected: list[int]) -> None:
        """Wait until the texts have these numbers."""
        self.wait_until(lambda: len(self.texts) >= len(expected))
        assert numbers(self.texts) == expected


@pytest.fixture
def listener(local_context: Context) -> Iterator[Listener]:
    listener = Listener(local_context)
    yield listener
    listener.executor.shutdown()


@pytest.fixture
def bag(tmp_path: Path) -> Iterator[Bag]:
    """Yield a bag of 100 messages in 99 ms: texts of even numbers on /chatter, transforms on /tf."""
    write_bag(tmp_path / "bag")
    with open_bag(tmp_path / "bag") as bag:
        yield bag


@contextmanager
def player(bag: Bag, context: Context, **options: Any) -> Iterator[Player]:
    node = Player(bag, PlayOptions(has_keyboard=False, **options), context=context)
    node.start()
    try:
        yield node
    finally:
        node.stop()
        node.destroy_node()


def numbers(texts: list[str]) -> list[int]:
    return [int(text.split()[1]) for text in texts]


def test_all_is_published_at_the_rate(bag: Bag, listener: Listener, local_context: Context) -> None:
    start = time.monotonic()
    with player(bag, local_context, rate=0.5) as node:
        listener.wait_until(node.ended.is_set)
    assert time.monotonic() - start > 0.19
    listener.expect(list(range(0, 100, 2)))
    assert listener.clocks == []


def test_rates_and_delays_of_any_size(bag: Bag, listener: Listener, local_context: Context) -> None:
    with player(bag, local_context, rate=1e-15, clock_hz=1e-15) as node:
        listener.expect([0])
        assert not node.set_rate(math.inf)
        assert node.set_rate(1e308)
        listener.expect(list(range(0, 100, 2)))
    assert node.failure is None
    with player(bag, local_context, delay_s=1e300) as node:
        assert not node.ended.wait(0.05)


def test_part_of_the_bag_is_published(bag: Bag, listener: Listener, local_context: Context) -> None:
    for options, first, last in (
        ({"start_offset_s": 0.05}, 50, 98),
        ({"duration_s": 0.02}, 0, 20),
        ({"until_ns": START_NS + 30 * STEP_NS}, 0, 30),
        ({"until_ns": START_NS + 30 * STEP_NS, "duration_s": 0.04}, 0, 40),
        ({"start_offset_s": 0.05, "duration_s": 0.01}, 50, 60),
    ):
        listener.texts.clear()
        with player(bag, local_context, rate=20.0, **options) as node:
            listener.wait_until(node.ended.is_set)
        listener.expect(list(range(first, last + 1, 2)))


def test_topics_are_chosen_and_renamed(bag: Bag, listener: Listener, local_context: Context) -> None:
    received: list[Any] = []
    listener.node.create_subscription(TFMessage, "/other", received.append, 1000)
    remaps = parse_remaps(["/tf:=other"])
    with player(bag, local_context, rate=20.0, choice=TopicChoice(["/tf"]), remaps=remaps) as node:
        listener.wait_until(node.ended.is_set)
    listener.wait_until(lambda: len(received) == 50)
    assert [message.transforms[0].header.stamp.sec for message in received] == list(range(1, 100, 2))
    assert listener.texts == []
    with pytest.raises(ValueError, match="'a' is not a remap: old_topic:=new_topic"):
        parse_remaps(["a"])


def test_steps_seeks_and_rates_by_keys(bag: Bag, listener: Listener, local_context: Context) -> None:
    with player(bag, local_context, is_start_paused=True) as node:
        assert node.playback.burst(3) == 3
        listener.wait_until(lambda: len(listener.texts) == 2)
        node.keys["right"]()  # a message of /tf
        assert node.keys["right"]() == 1
        listener.wait_until(lambda: numbers(listener.texts) == [0, 2, 4])
        assert node.playback.now_ns() == START_NS + 4 * STEP_NS
        assert node.playback.seek(START_NS + 90 * STEP_NS)
        assert not node.playback.seek(START_NS - 1)
        node.keys["right"]()
        listener.wait_until(lambda: numbers(listener.texts) == [0, 2, 4, 90])
        node.keys["left"]()
        node.keys["right"]()
        listener.wait_until(lambda: numbers(listener.texts) == [0, 2, 4, 90, 0])
        node.keys["up"]()
        assert node.playback.rate == pytest.approx(1.1)
        node.keys["down"]()
        assert node.playback.rate == pytest.approx(0.99)
        assert not node.set_rate(-1.0)
        node.keys[" "]()
        listener.wait_until(node.ended.is_set)
    listener.expect([0, 2, 4, 90, *range(0, 100, 2)])


def test_a_key_that_is_pressed_at_the_start_counts(
    bag: Bag, local_context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The line that playing begins is a sign to press keys, before the thread that plays is there."""
    node = Player(bag, PlayOptions(has_keyboard=True, is_start_paused=True), context=local_context)
    log = node.get_logger()
    info = log.info

    def press(text: str, **options: Any) -> bool:
        if text.startswith("Playback until"):
            node.keys[" "]()
        return info(text, **options)

    monkeypatch.setattr(log, "info", press)
    try:
        node.start()
        assert node.ended.wait(30)
    finally:
        node.stop()
        node.destroy_node()


def test_services_steer_it(bag: Bag, listener: Listener, local_context: Context) -> None:
    with player(bag, local_context, is_start_paused=True) as node:
        listener.executor.add_node(node)

        def call(kind: Any, name: str, **values: Any) -> Any:
            client = listener.node.create_client(kind, f"/rosbag2_player/{name}")
            assert client.wait_for_service(5.0)
            future = client.call_async(kind.Request(**values))
            listener.executor.spin_until_future_complete(future, 5.0)
            return future.result()

        assert call(IsPaused, "is_paused").paused
        node.playback.burst(1)
        assert call(PlayNext, "play_next").success
        assert call(Burst, "burst", num_messages=4).actually_burst == 4
        assert call(SetRate, "set_rate", rate=2.0).success
        assert not call(SetRate, "set_rate", rate=0.0).success
        assert call(GetRate, "get_rate").rate == 2.0
        assert call(Seek, "seek", time=Time(nanoseconds=START_NS + 96 * STEP_NS).to_msg()).success
        assert not call(Seek, "seek", time=Time(seconds=1).to_msg()).success
        assert not call(Seek, "seek", time=TimeMessage(sec=-1)).success
        assert not call(Play, "play", start_offset=TimeMessage(sec=-1)).success  # it is playing
        call(TogglePaused, "toggle_paused")
        listener.wait_until(node.ended.is_set)
        assert not call(PlayNext, "play_next").success
        listener.executor.remove_node(node)
    listener.expect([0, 2, 4, 96, 98])


def test_change_of_the_file_is_announced(tmp_path: Path, listener: Listener, local_context: Context) -> None:
    writer, channel = begin_bag(tmp_path / "bag")
    for number in range(3):
        push(writer, channel, number)
        writer.write_present()
        if number < 2:
            writer.split()
    writer.close()
    events: list[ReadSplitEvent] = []
    listener.node.create_subscription(ReadSplitEvent, "events/read_split", events.append, 10)
    with open_bag(tmp_path / "bag") as bag, player(bag, local_context):
        listener.wait_until(lambda: len(events) == 2)
    paths = [str(tmp_path / "bag" / f"bag_{number}.mcap") for number in range(3)]
    assert events == [
        ReadSplitEvent(closed_file=closed, opened_file=opened, node_name="/rosbag2_player")
        for closed, opened in pairwise(paths)
    ]


def test_clock_jumps_back_once_a_loop(bag: Bag, listener: Listener, local_context: Context) -> None:
    with player(bag, local_context, is_loop=True, clock_hz=1000.0) as node:
        listener.wait_until(lambda: listener.texts.count("message 0") == 3)
        node.playback.set_paused(True)
    backwards = [later for earlier, later in pairwise(listener.clocks) if later < earlier]
    assert backwards == [START_NS, START_NS]
    assert min(listener.clocks) == START_NS
    assert max(listener.clocks) <= START_NS + 99 * STEP_NS


def test_clock_has_the_times_of_messages(bag: Bag, listener: Listener, local_context: Context) -> None:
    for options, count in (({"clock_topics": ["/chatter"]}, 50), ({"is_clock_on_all": True}, 100)):
        listener.clocks.clear()
        with player(bag, local_context, rate=20.0, **options) as node:
            listener.wait_until(node.ended.is_set)
        listener.wait_until(lambda: len(listener.clocks) == count + 1)  # noqa: B023 - and one at the start
        stamps = [START_NS + number * STEP_NS for number in range(0, 100, 100 // count)]
        assert listener.clocks == [START_NS, *stamps]


def static_bag(folder: Path) -> None:
    """Write two messages of /tf_static at the start, by two publishers, and texts after them."""
    profile = topic("/tf_static", "tf2_msgs/msg/TFMessage").offered_qos.replace("depth: 7", "depth: 1")
    profile = profile.replace("volatile", "transient_local")
    writer = BagWriter(folder)
    static = writer.add_topic(topic("/tf_static", "tf2_msgs/msg/TFMessage", f"{profile}\n{profile}"))
    chatter = writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
    for number in range(2):
        writer.push(static, transforms(number), START_NS, START_NS)
    for number in range(20):
        writer.push(chatter, text(number), START_NS + number * STEP_NS, START_NS)
    writer.close()


def test_static_transforms_reach_late_subscriptions(
    listener: Listener, local_context: Context, tmp_path: Path, deviations: dict[str, dict[str, str]]
) -> None:
    assert {"bag-latched", "bag-keys", "bag-mixed-offers"} <= deviations.keys()
    static_bag(tmp_path / "bag")
    late = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    with open_bag(tmp_path / "bag") as bag:
        for options in ({}, {"start_offset_s": 0.01}):
            received: list[Any] = []
            with player(bag, local_context, is_start_paused=True, **options) as node:
                node.playback.burst(5)
                listener.wait_until(lambda: len(listener.texts) >= 3)
                subscription = listener.node.create_subscription(
                    TFMessage, "/tf_static", received.append, late
                )
                listener.wait_until(lambda: len(received) == 2)  # noqa: B023
                assert sorted(message.transforms[0].header.stamp.sec for message in received) == [0, 1]
                listener.node.destroy_subscription(subscription)
            listener.texts.clear()


def test_overridden_quality_is_offered(bag: Bag, local_context: Context) -> None:
    weak = {"/chatter": QoS(ReliabilityPolicy.BEST_EFFORT, depth=3)}
    with player(bag, local_context, is_start_paused=True, qos_overrides=weak) as node:
        (info,) = node.get_publishers_info_by_topic("/chatter")
        assert info.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
        (info,) = node.get_publishers_info_by_topic("/tf")
        assert info.qos_profile.reliability == ReliabilityPolicy.RELIABLE


def test_offered_quality_is_the_strongest_recorded_one(tmp_path: Path) -> None:
    weak = topic("/a", "std_msgs/msg/String").offered_qos.replace(
        "reliability: reliable", "reliability: best_effort"
    )
    strong = topic("/a", "std_msgs/msg/String").offered_qos.replace("volatile", "transient_local")
    assert offered(topic("/a", "std_msgs/msg/String", weak)).reliability == ReliabilityPolicy.BEST_EFFORT
    both = offered(topic("/a", "std_msgs/msg/String", f"{weak}\n{strong}"))
    assert (both.reliability, both.durability, both.depth) == (
        ReliabilityPolicy.RELIABLE,
        Durability.TRANSIENT_LOCAL,
        14,
    )
    assert offered(topic("/tf_static", "tf2_msgs/msg/TFMessage", "")).durability == Durability.TRANSIENT_LOCAL


def test_reading_ahead_is_bounded_by_number_and_size() -> None:
    taken = 0

    def messages(size: int) -> Iterator[RawMessage]:
        nonlocal taken
        for number in range(100_000):
            taken += 1
            yield RawMessage("/x", number, number, bytes(size))

    for size, most in ((10, 700), (1_000_000, 80)):
        taken = 0
        ahead = ReadAhead("bag", messages(size), 500)
        assert [next(ahead).log_time_ns for _ in range(10)] == list(range(10))
        ahead.close()
        assert taken <= most, size
    assert threading.active_count() < 10


def test_error_of_the_bag_is_raised_where_it_is_used() -> None:
    def messages() -> Iterator[RawMessage]:
        yield RawMessage("/x", 1, 1, b"")
        raise OSError("gone")

    ahead = ReadAhead("bag", messages(), 500)
    assert next(ahead).log_time_ns == 1
    with pytest.raises(OSError, match="gone"):
        next(ahead)
    ahead.close()


def test_names_that_the_bag_lacks_are_said(
    bag: Bag, listener: Listener, local_context: Context, capfd: pytest.CaptureFixture[str]
) -> None:
    choice = TopicChoice(["/nope", "/chatter"], services=["/add"])
    with player(bag, local_context, rate=20.0, choice=choice) as node:
        listener.wait_until(node.ended.is_set)
    said = capfd.readouterr().err
    for name in ("topic '/nope'", "service '/add'"):
        assert f"The bag has no {name}, which is not played. It has: /chatter, /silent, /tf" in said
    assert "'/chatter'" not in said
    with player(bag, local_context, choice=TopicChoice(regex="nope")) as node:
        listener.wait_until(node.ended.is_set)
    assert "No topic of the bag is to be played." in capfd.readouterr().err


def test_new_rate_counts_from_the_moment_it_is_set(monkeypatch: pytest.MonkeyPatch) -> None:
    """What has passed at the old rate is kept, and the new one applies to what follows only."""
    now = 0
    monkeypatch.setattr("time.monotonic_ns", lambda: now)
    clock = play_clock.PlayClock(1000, 1.0)
    clock.set_paused(False)
    now = 10
    clock.set_rate(5.0)
    assert clock.now_ns() == 1010
    now = 12
    assert clock.now_ns() == 1020
    clock.set_paused(True)
    now = 100
    clock.set_rate(0.5)
    assert clock.now_ns() == 1020
    clock.set_paused(False)
    now = 120
    assert clock.now_ns() == 1030


def test_bag_without_messages_is_played_to_its_end(
    tmp_path: Path, local_context: Context, capsys: pytest.CaptureFixture[str]
) -> None:
    BagWriter(tmp_path / "still").close()
    play([tmp_path / "still"], PlayOptions())
    assert capsys.readouterr().err == f"{tmp_path}/still: there are no messages in it\n"
