"""Several bags that are played at a time, the order of their messages, and the progress that is shown."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.bag.test_player import Listener, numbers, player
from tests.bag.written_bags import CHATTER, START_NS, STEP_NS, begin_bag, push, text, topic
from tests.cli.transcript import run_here
from tests.terminals import on_a_terminal

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.opening import open_bags
from tfloom.bag.playing.played_topics import PlayedTopics
from tfloom.bag.playing.progress_bar import PlayStatus, ProgressBar
from tfloom.bag.playing.read_ahead import by_sent_time
from tfloom.bag.values import RawMessage
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.rosbag2_interfaces.msg import ReadSplitEvent
from tfloom.node.context.context import Context


@pytest.fixture
def listener(local_context: Context) -> Iterator[Listener]:
    listener = Listener(local_context)
    yield listener
    listener.executor.shutdown()


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    def write_one(name: str, *files: list[int]) -> Path:
        writer, channel = begin_bag(tmp_path / name)
        for place, numbers_ in enumerate(files):
            if place:
                writer.write_rest()
                writer.split()
            push(writer, channel, *numbers_)
        writer.close()
        return tmp_path / name

    return write_one


def test_messages_of_several_bags_are_merged_by_their_times(write: Any) -> None:
    paths = [write("a", [0, 4, 8], [20, 24]), write("b", [2, 4, 22]), write("c", [30])]
    with open_bags(paths) as bag:
        stamps = [(message.log_time_ns - START_NS) // STEP_NS for message in bag.messages()]
        assert stamps == [0, 2, 4, 4, 8, 20, 22, 24, 30]
        assert (bag.start_ns, bag.end_ns) == (START_NS, START_NS + 30 * STEP_NS)
        assert bag.message_count == bag.topics["/chatter"].message_count == 9
        assert [len(files) for files in bag.parts] == [2, 1, 1]


def test_one_bag_keeps_its_metadata(write: Any) -> None:
    with open_bags([write("a", [0])]) as bag:
        assert bag.metadata is not None


def test_bags_that_cannot_be_played_together(write: Any, tmp_path: Path) -> None:
    one = write("a", [0])
    other = BagWriter(tmp_path / "b")
    other.add_topic(topic("/chatter", "std_msgs/msg/Empty"))
    other.close()
    with pytest.raises(
        BagError, match=r"type of '/chatter' is std_msgs/msg/Empty, and in .*a it is std_msgs/msg/String"
    ):
        open_bags([one, tmp_path / "b"])
    with pytest.raises(BagError, match="no such file or folder"):
        open_bags([one, tmp_path / "none"])
    with pytest.raises(BagError, match="no recording was named"):
        open_bags([])


def test_splits_are_announced_within_each_bag(write: Any, listener: Listener, local_context: Context) -> None:
    events: list[tuple[str, str]] = []
    listener.node.create_subscription(
        ReadSplitEvent,
        "/events/read_split",
        lambda event: events.append((Path(event.closed_file).name, Path(event.opened_file).name)),
        10,
    )
    paths = [write("a", [0, 10], [20, 30], [40]), write("b", [5, 15], [25])]
    with open_bags(paths) as bag, player(bag, local_context) as node:
        listener.wait_until(node.ended.is_set)
        listener.wait_until(lambda: len(events) == 3)
    assert events == [("a_0.mcap", "a_1.mcap"), ("b_0.mcap", "b_1.mcap"), ("a_1.mcap", "a_2.mcap")]
    listener.expect([0, 5, 10, 15, 20, 25, 30, 40])


def message(received: int, sent: int) -> RawMessage:
    return RawMessage("/chatter", received, sent, str(sent).encode())


def test_order_of_sending_within_a_window() -> None:
    received = [message(1, 5), message(2, 3), message(3, 9), message(4, 7), message(5, 3)]
    assert [found.log_time_ns for found in by_sent_time(iter(received), 10)] == [3, 3, 5, 7, 9]
    assert [found.log_time_ns for found in by_sent_time(iter(received), 1)] == [3, 5, 7, 3, 9]
    assert [found.log_time_ns for found in by_sent_time(iter(received), 0)] == [3, 5, 7, 3, 9]
    assert list(by_sent_time(iter([]), 3)) == []


def test_messages_are_played_in_the_order_of_sending(
    tmp_path: Path, listener: Listener, local_context: Context
) -> None:
    """The clock of the sender is a day behind: nothing waits for that."""
    writer = BagWriter(tmp_path / "bag")
    channel = writer.add_topic(CHATTER)
    day_ns = 86_400_000_000_000
    for number, sent in enumerate([2, 0, 3, 1]):
        stamp_ns = START_NS + number * STEP_NS
        writer.push(channel, text(sent), stamp_ns, START_NS + sent * 10 * STEP_NS - day_ns)
    writer.close()
    for is_by_sent_time, expected in ((False, [2, 0, 3, 1]), (True, [0, 1, 2, 3])):
        listener.texts.clear()
        with (
            open_bag(tmp_path / "bag") as bag,
            player(bag, local_context, is_by_sent_time=is_by_sent_time) as node,
        ):
            listener.wait_until(node.ended.is_set)
        listener.expect(expected)


def test_progress_bar_stays_at_its_place() -> None:
    stream = io.StringIO()
    bar = ProgressBar(START_NS, 5 * 10**9, 2, stream)
    bar.end()
    assert stream.getvalue() == ""
    bar.show(START_NS + 1_250_000_000, PlayStatus.RUNNING)
    assert stream.getvalue() == (
        "\033[2K\n\033[2K\n\033[2K====== Playback Progress ======\n"
        "\033[2K[1700000001.250000000] Duration 1.25/5.00 [R]\n\033[4A"
    )
    bar.end()
    bar.end()
    assert stream.getvalue().endswith("\033[4A\n\n\n\n")


def test_progress_bar_whose_reader_is_gone() -> None:
    class Closed(io.StringIO):
        def write(self, _: str) -> int:
            raise BrokenPipeError

    bar = ProgressBar(0, 1, 0, Closed())
    bar.show(1, PlayStatus.PAUSED)
    bar.end()


PLAY = """
from tfloom.cli.main import main
import sys
sys.exit(main(["bag", "play", {path!r}, "--disable-keyboard-controls", *{options!r}]))
"""


def played(path: Path, *options: str, distribution: str = "jazzy") -> list[str]:
    """Return the states that `bag play` shows on a terminal."""
    program = PLAY.format(path=str(path), options=list(options))
    shown = on_a_terminal(program, ROS_DISTRO=distribution)
    return re.findall(r"\[\d+\.\d{9}\] Duration \S+/0\.30 \[(.)\]", shown)


def test_play_shows_its_progress(write: Any) -> None:
    path = write("a", [0, 100, 200, 300])
    assert played(path) == []
    assert played(path, "--progress-bar-update-rate", "0", distribution="kilted") == []
    assert played(path, "--progress-bar-update-rate", "-1") == ["R", "R", "R", "R", "S"]
    often = played(path, "--progress-bar-update-rate", "50", "--delay", "0.3", distribution="kilted")
    assert {"D", "R", "S"} == set(often)
    assert len(often) > 5


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "needs a bag: its path, or -i"),
        (["{bag}", "-i", "{bag}"], "by its path or by -i, not by both"),
        (["-i", "{bag}", "-i", "none"], "Bag path 'none' does not exist!"),
        (["-i", "{bag}", "odd"], "-i needs a path and a storage, sqlite3 or mcap, at most"),
        (["-i", "{bag}", "mcap", "mcap"], "-i needs a path and a storage"),
    ],
)
def test_arguments_that_cannot_be_used(arguments: list[str], said: str, write: Any) -> None:
    path = str(write("a", [0]))
    result = run_here("bag", "play", *(word.format(bag=path) for word in arguments))
    assert result.exit_code == 1
    assert said in result.text


@pytest.mark.parametrize(("order", "expected"), [("received", [5, 0, 3]), ("sent", [0, 3, 5])])
def test_bags_and_their_order_from_the_command_line(
    order: str, expected: list[int], tmp_path: Path, write: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = BagWriter(tmp_path / "late")
    writer.push(writer.add_topic(CHATTER), text(5), START_NS - STEP_NS, START_NS + 5 * STEP_NS)
    writer.close()
    played_: list[int] = []
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setattr(
        PlayedTopics, "publish", lambda _, found: played_.extend(numbers([_text(found.data)]))
    )
    result = run_here(
        *("bag", "play", "--disable-keyboard-controls", "--message-order", order),
        *("-i", str(tmp_path / "late"), "mcap", "-i", str(write("a", [0, 3]))),
    )
    assert (result.exit_code, played_) == (0, expected)


def _text(data: bytes) -> str:
    return data[8:].rstrip(b"\0").decode()
