"""rosbag2_py's Recorder and Player that are made with options: they record and play by several calls."""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
import rosbag2_py
from tests.bag.test_player import Listener, numbers
from tests.bag.written_bags import START_NS, STEP_NS, write_bag
from tests.conftest import wait_until

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused, Stop
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.node import Node


@pytest.fixture(autouse=True)
def own_domain(monkeypatch: pytest.MonkeyPatch, ros_domain: int) -> None:
    """Let contexts of their own meet `local_context`."""
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(ros_domain))


@pytest.fixture
def listener(local_context: Context) -> Iterator[Listener]:
    listener = Listener(local_context)
    yield listener
    listener.executor.shutdown()


@pytest.fixture
def storage(tmp_path: Path) -> rosbag2_py.StorageOptions:
    """Return a bag of 100 messages in 99 ms: texts of even numbers on /chatter, transforms on /tf."""
    write_bag(tmp_path / "bag")
    return rosbag2_py.StorageOptions(str(tmp_path / "bag"))


def play_options(**values: Any) -> rosbag2_py.PlayOptions:
    options = rosbag2_py.PlayOptions()
    options.topics_to_filter = ["/chatter"]
    for name, value in values.items():
        setattr(options, name, value)
    return options


@pytest.fixture
def make_recorder(tmp_path: Path) -> Callable[..., Any]:
    def make(**values: Any) -> rosbag2_py.Recorder:
        options = rosbag2_py.RecordOptions()
        options.topics = ["/words"]
        options.topic_polling_interval = timedelta(milliseconds=10)
        for name, value in values.items():
            setattr(options, name, value)
        return rosbag2_py.Recorder(rosbag2_py.StorageOptions(str(tmp_path / "new"), "mcap"), options)

    return make


def words(folder: Path) -> list[str]:
    with open_bag(folder) as bag:
        return [message.data for _, message in bag.read("/words")]


def test_recorder_records_pauses_and_records_again(
    make_recorder: Callable[..., Any], local_context: Context, tmp_path: Path
) -> None:
    publisher = Node("talker", context=local_context).create_publisher(String, "words", 10)
    recorder = make_recorder()
    assert not (tmp_path / "new").exists()  # it begins with `record`
    recorder.record()
    wait_until(lambda: publisher.get_subscription_count() == 1)
    publisher.publish(String(data="a"))
    recorder.pause()
    assert recorder.is_paused()
    publisher.publish(String(data="lost"))
    recorder.resume()
    assert not recorder.is_paused()
    publisher.publish(String(data="b"))
    with pytest.raises(RuntimeError, match="already recording"):
        recorder.record()
    recorder.stop()
    recorder.stop()
    assert words(tmp_path / "new") == ["a", "b"]
    with pytest.raises(BagError, match="exists already"):
        recorder.record()
    recorder.record(str(tmp_path / "second"))
    wait_until(lambda: publisher.get_subscription_count() == 1)
    recorder.resume()
    publisher.publish(String(data="c"))
    recorder.stop()
    assert words(tmp_path / "second") == ["c"]


def test_pause_before_the_recording_holds(
    make_recorder: Callable[..., Any], local_context: Context, tmp_path: Path
) -> None:
    publisher = Node("talker", context=local_context).create_publisher(String, "words", 10)
    recorder = make_recorder()
    recorder.pause()
    recorder.record()
    wait_until(lambda: publisher.get_subscription_count() == 1)
    publisher.publish(String(data="lost"))
    recorder.stop()
    with open_bag(tmp_path / "new") as bag:
        assert bag.message_count == 0


def test_services_are_answered_while_the_recorder_is_spun(
    make_recorder: Callable[..., Any], listener: Listener, tmp_path: Path
) -> None:
    recorder = make_recorder()
    client = listener.node.create_client(IsPaused, "/rosbag2_recorder/is_paused")
    stop = listener.node.create_client(Stop, "/rosbag2_recorder/stop")
    future = client.call_async(IsPaused.Request())
    listener.executor.spin_until_future_complete(future, 0.2)
    assert not future.done()
    for _ in range(2):
        recorder.start_spin()
        recorder.start_spin()
        listener.executor.spin_until_future_complete(future, 5.0)
        assert future.result() is not None
        recorder.stop_spin()
        recorder.stop_spin()
        future = client.call_async(IsPaused.Request())
        listener.executor.spin_until_future_complete(future, 0.1)
        assert not future.done()
    recorder.start_spin()
    recorder.record()
    stopped = stop.call_async(Stop.Request())
    listener.executor.spin_until_future_complete(stopped, 5.0)
    assert stopped.done()
    assert (tmp_path / "new" / "metadata.yaml").exists()


def test_a_recorder_that_is_freed_completes_its_bag(
    make_recorder: Callable[..., Any], local_context: Context, tmp_path: Path
) -> None:
    publisher = Node("talker", context=local_context).create_publisher(String, "words", 10)
    recorder = make_recorder()
    recorder.start_spin()
    recorder.record()
    wait_until(lambda: publisher.get_subscription_count() == 1)
    publisher.publish(String(data="a"))
    del recorder
    gc.collect()
    assert words(tmp_path / "new") == ["a"]
    assert publisher.get_subscription_count() == 0


def test_failure_of_a_recording_is_raised_by_stop(make_recorder: Callable[..., Any], tmp_path: Path) -> None:
    recorder = make_recorder()
    recorder.record()
    recorder._spun.node.fail(BagError(tmp_path, "the disk is full"))
    with pytest.raises(BagError, match="the disk is full"):
        recorder.stop()
    recorder.record(str(tmp_path / "second"))
    recorder.stop()
    assert (tmp_path / "second" / "metadata.yaml").exists()


def test_player_plays_to_the_end_and_again(storage: Any, listener: Listener) -> None:
    player = rosbag2_py.Player(storage, play_options(rate=1.0), "info", "rosbag2_player_test")
    assert not player.wait_for_playback_to_start(0.0)
    assert player.play()
    assert player.wait_for_playback_to_start(timedelta(seconds=5))
    assert not player.play()
    assert player.wait_for_playback_to_finish(5.0)
    listener.expect(list(range(0, 100, 2)))
    assert player.play()
    assert player.wait_for_playback_to_finish()
    listener.expect([*range(0, 100, 2), *range(0, 100, 2)])


def test_player_is_stepped_sought_and_resumed(storage: Any, listener: Listener) -> None:
    player = rosbag2_py.Player(storage, play_options(start_paused=True))
    assert not player.play_next()
    player.play()
    assert player.wait_for_playback_to_start(5.0)
    assert player.play_next()
    assert player.play_next()
    assert player.burst(2) == 2
    assert player.is_paused()
    assert not player.wait_for_playback_to_finish(0.05)
    listener.expect([0, 2, 4, 6])
    player.seek(0)  # before the bag's beginning
    player.resume()
    assert player.wait_for_playback_to_finish(5.0)
    assert not player.play_next()
    listener.expect([0, 2, 4, 6, *range(0, 100, 2)])


def test_player_that_is_stopped_plays_again(storage: Any, listener: Listener) -> None:
    player = rosbag2_py.Player(storage, play_options(rate=0.01))
    player.play()
    listener.expect([0])
    begin = time.monotonic()
    player.stop()
    player.stop()
    assert player.wait_for_playback_to_finish(1.0)
    assert time.monotonic() - begin < 2.0
    assert player.set_rate(1.0)
    assert player.play()
    assert player.wait_for_playback_to_finish(5.0)
    listener.expect([0, *range(0, 100, 2)])


def test_times_and_rates_of_a_player(storage: Any) -> None:
    player = rosbag2_py.Player(storage, play_options(start_offset=0.01, rate=2.0))
    assert player.get_starting_time() == START_NS + 10 * STEP_NS
    assert player.get_playback_duration() == 89 * STEP_NS
    assert player.get_rate() == 2.0
    assert not player.set_rate(-1.0)
    player.pause()
    assert player.is_paused()
    player.toggle_paused()
    assert not player.is_paused()


def test_a_player_that_is_freed_ends(storage: Any, local_context: Context) -> None:
    node = Node("counter", context=local_context)
    player = rosbag2_py.Player(storage, play_options(rate=0.001))
    player.play()
    wait_until(lambda: node.count_publishers("/chatter") == 1)
    del player
    gc.collect()
    assert node.count_publishers("/chatter") == 0


def test_failure_of_playing_is_raised_by_waiting(storage: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    player: Any = rosbag2_py.Player(storage, play_options())

    def fail() -> None:
        raise BagError("bag", "it is damaged")

    monkeypatch.setattr(player._spun.node.playback, "run", fail)
    player.play()
    with pytest.raises(BagError, match="it is damaged"):
        player.wait_for_playback_to_finish(5.0)
    monkeypatch.undo()
    assert player.play()
    assert player.wait_for_playback_to_finish(5.0)


def test_player_of_several_bags(storage: Any, listener: Listener, tmp_path: Path) -> None:
    write_bag(tmp_path / "second", count=3)
    both = [storage, rosbag2_py.StorageOptions(str(tmp_path / "second"))]
    player = rosbag2_py.Player(both, play_options())
    player.play()
    assert player.wait_for_playback_to_finish(5.0)
    listener.wait_until(lambda: len(listener.texts) == 52)
    assert sorted(numbers(listener.texts)) == [0, 0, 2, 2, *range(4, 100, 2)]


def test_calls_that_need_options_name_them(storage: Any) -> None:
    for call in (rosbag2_py.Player().pause, rosbag2_py.Recorder("debug").stop, rosbag2_py.Player().stop_spin):
        with pytest.raises(RuntimeError, match=r"needs the options at the construction: \w+\(StorageOptions"):
            call()
    with pytest.raises(TypeError, match="has no arguments"):
        rosbag2_py.Player(storage, play_options()).play(storage, play_options())
    with pytest.raises(ValueError, match="no log level 'loud'"):
        rosbag2_py.Player(storage, play_options(), "loud")


def test_options_that_cannot_be_used(storage: Any, tmp_path: Path) -> None:
    options = rosbag2_py.RecordOptions()
    options.input_serialization_format = "json"
    with pytest.raises(BagError, match="the serialization format is cdr, not 'json'"):
        rosbag2_py.Recorder(storage, options)
    assert not (tmp_path / "new").exists()
