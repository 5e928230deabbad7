"""`topic hz`, `bw` and `delay` of a publisher in another process."""

from __future__ import annotations

import re
import time
from collections.abc import Callable

import pytest
import transcript
from tests.conftest import Program

from tfloom.cli.shared.graph import joined_participant
from tfloom.cli.topic import bw, rates
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import QoS
from tfloom.rosidl.message import Message

QUICK = {"tfloom.cli.topic.rates.REPORT_S": 0.4, "tfloom.cli.shared.sim_time.PATIENCE_S": 0.4}


def test_report_period_has_its_default() -> None:
    assert rates.REPORT_S == 1.0


@pytest.fixture
def listen(publish: Callable[..., None], start_program: Callable[..., Program]) -> Callable[..., Program]:
    """Publish on /x at 50 Hz and start a verb on it."""

    def start(verb: str, *flags: str, make: Callable[[], Message] = Header) -> Program:
        publish("/x", make)
        return start_program("python", *transcript.python_words("topic", verb, *flags, "/x", constants=QUICK))

    return start


def stamped_now() -> PointStamped:
    sec, nanosec = divmod(time.time_ns(), 10**9)
    return PointStamped(header=Header(stamp=Time(sec=sec, nanosec=nanosec)))


@pytest.mark.timing
def test_hz_output_matches_the_recording(listen: Callable[..., object]) -> None:
    sent: list[float] = []

    def make() -> Header:
        sent.append(time.monotonic())
        return Header()

    program = listen("hz", make=make)
    recorded = transcript.golden("topic_hz").text.splitlines()[:2]
    program.wait_for("window: ")
    assert [transcript.mask(line) for line in program.lines[:2]] == [
        transcript.mask(line) for line in recorded
    ]
    rate_hz = (len(sent) - 1) / (sent[-1] - sent[0])  # 50, and less on a busy machine
    assert rate_hz / 1.5 < float(program.lines[0].split()[-1]) < 1.5 * rate_hz


def test_hz_counts_filtered_messages(listen: Callable[..., object]) -> None:
    listen("hz", "--filter", "m.frame_id == 'none'").wait_for("no new messages")


def test_bw_output_matches_the_recording(listen: Callable[..., object]) -> None:
    program = listen("bw", make=Pose)
    recorded = transcript.golden("topic_bw").text.splitlines()
    # Before that, a busy machine may have sent less than 1 KB a second, which is printed in bytes.
    last = program.lines.index(program.wait_for("KB max: "))
    assert program.lines[0] == "Subscribed to [/x]"
    assert [transcript.mask(line) for line in program.lines[last - 1 : last + 1]] == [
        transcript.mask(line) for line in recorded[1:3]
    ]
    size = re.search(r"mean: ([\d.]+) KB", program.output)
    assert size
    assert float(size[1]) == 0.02


def test_delay_is_measured_from_the_header_stamp(listen: Callable[..., object]) -> None:
    program = listen("delay", make=stamped_now)
    program.wait_for("window: ")
    assert 0 <= float(program.lines[0].removeprefix("average delay: ")) < 0.5


def test_delay_needs_a_header(domain_id: int, listen: Callable[..., object]) -> None:
    recorded = transcript.golden("topic_delay")
    program = listen("delay", make=Pose)
    assert program.wait() == recorded.exit_code
    assert program.output == recorded.text


def test_verb_waits_for_a_missing_topic(
    publish: Callable[..., None], start_program: Callable[..., Program]
) -> None:
    program = start_program("python", *transcript.python_words("topic", "hz", "/late", constants=QUICK))
    program.wait_for("WARNING: topic [/late] does not appear to be published yet")
    publish("/late", Header)
    program.wait_for("average rate: ")


@pytest.mark.parametrize(
    ("sizes", "duration_s", "first"),
    [
        ([24.0] * 100, 1.6, "1.50 KB/s from 100 messages"),
        ([1.0, 3.0], 1.0, "4 B/s from 2 messages"),
        ([1e6, 3e6], 2.0, "2.00 MB/s from 2 messages"),
    ],
)
def test_unit_depends_on_the_rate(sizes: list[float], duration_s: float, first: str) -> None:
    assert bw.bandwidth_text(sizes, duration_s).splitlines()[0] == first


def test_bytes_have_no_decimals() -> None:
    assert bw.bandwidth_text([1.0, 3.0], 1.0).splitlines()[1] == "\tMessage size mean: 2 B min: 1 B max: 3 B"


def test_spread_of_values() -> None:
    assert rates.spread([1.0, 3.0]) == (2.0, 1.0, 3.0, 1.0)


@pytest.fixture
def simulated_time(publish: Callable[..., None]) -> int:
    """Publish the constant time 5000 s on /clock."""
    publish("/clock", lambda: Clock(clock=Time(sec=5000)))
    return 5000


def test_pub_stamps_with_simulated_time(simulated_time: int, start_program: Callable[..., object]) -> None:
    kind = "geometry_msgs/msg/PointStamped"
    values = "{header: auto}"
    program = start_program("tfloom", "topic", "pub", "-s", "-1", "-w", "0", "/x", kind, values)
    assert program.wait() == 0
    assert f"sec={simulated_time}, nanosec=0" in program.output


def test_delay_measures_by_simulated_time(simulated_time: int, listen: Callable[..., object]) -> None:
    program = listen("delay", "-s", make=lambda: PointStamped(header=Header(stamp=Time(sec=4990))))
    program.wait_for("window: ")
    assert program.lines[0] == "average delay: 10.000"


def test_hz_uses_simulated_time_unless_wall_time_is_requested(
    simulated_time: int, listen: Callable[..., object]
) -> None:
    listen("hz", "-s").wait_for("average rate: inf")
    wall = listen("hz", "-s", "--wall-time")
    wall.wait_for("average rate: ")
    assert "inf" not in wall.lines[0]


def test_verb_waits_for_missing_simulated_time(
    domain_id: int, start_program: Callable[..., object], listen: Callable[..., object]
) -> None:
    listen("hz", "-s").wait_for("waiting for the time on /clock")


@pytest.mark.parametrize("words", [("/x", "/y", "/nobodys"), ("--all",)])
def test_hz_of_several_topics_is_a_table(
    words: tuple[str, ...], publish: Callable[..., None], start_program: Callable[..., Program]
) -> None:
    publish("/x", Header)
    program = start_program("python", *transcript.python_words("topic", "hz", *words, constants=QUICK))
    program.wait_for("/x ")
    publish("/y", Header, 20.0)  # which begins later
    program.wait_for("/y ")
    program.wait_for("topic ")
    output = program.output
    assert ("WARNING: topic [/nobodys] does not appear to be published yet" in output) == (
        "/nobodys" in words
    )
    *_, title, rule, x = [line for line in output[: output.rindex("/y ")].splitlines() if line]
    assert title.split() == ["topic", "rate", "min_delta", "max_delta", "std_dev", "window"]
    assert {*rule} == {"="}
    assert x.split()[0] == "/x"
    assert 10 < float(x.split()[1]) < 60


def test_bw_of_several_topics_is_a_table(
    publish: Callable[..., None], start_program: Callable[..., Program]
) -> None:
    publish("/x", Pose)
    publish("/y", lambda: Header(frame_id="a" * 1000))
    program = start_program("python", *transcript.python_words("topic", "bw", "/x", "/y", constants=QUICK))
    row = program.wait_for("/y ").split()
    assert row[2] == "KB/s"
    assert row[4:] == ["1.02", "KB"] * 3
    assert any(line.split()[:1] == ["/x"] for line in program.lines)


def test_a_topic_whose_type_nobody_has_stops_no_other(
    publish: Callable[..., None],
    start_program: Callable[..., Program],
    domain_id: int,
) -> None:
    publish("/x", Header)
    with joined_participant() as participant:
        unknown = Topic("/z", "nobodys_msgs/msg/Thing", f"RIHS01_{0:064}")
        writer = participant.create_writer(NodeName("/", "other"), unknown, QoS())
        program = start_program("python", *transcript.python_words("topic", "hz", "-a", constants=QUICK))
        program.wait_for("/x ")
        assert "/z: " in program.output
        writer.close()


@pytest.mark.parametrize("words", [(), ("--all", "/x")])
def test_topics_are_named_or_all(words: tuple[str, ...], domain_id: int) -> None:
    for verb in ("hz", "bw"):
        answer = transcript.run_here("topic", verb, *words)
        assert answer.exit_code == 1
        assert answer.text.startswith("name the topics, or give --all")


@pytest.mark.parametrize("words", [("/x",), ("/x", "/y")])
def test_rates_are_measured_with_the_requested_quality(
    words: tuple[str, ...], publish: Callable[..., None], start_program: Callable[..., Program]
) -> None:
    publish("/x", Header)
    asked = ("--qos-durability", "transient_local", "--qos-reliability", "reliable")
    program = start_program(
        "python", *transcript.python_words("topic", "hz", *words, *asked, constants=QUICK)
    )
    program.wait_for("offered DURABILITY VOLATILE, requested DURABILITY TRANSIENT_LOCAL")
