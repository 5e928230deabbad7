"""tf2_monitor: its arithmetic, and its output over DDS against the reference's."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from typing import Any

import pytest
from tests.tf2_tools.test_programs import SPINNING, STATIC, golden

from tfloom.tf2_tools import monitor
from tfloom.tf2_tools.monitor import Delays, NetDelay, Statistics

QUICK_MONITOR = """
import sys
from functools import partialmethod
from tfloom.tf2_tools import monitor

monitor.Monitor.run = partialmethod(monitor.Monitor.run, round_s=0.1)
sys.exit(monitor.main(sys.argv[1:]))
"""
"""The monitor with results every 2.1 s instead of 10.5."""
TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
BROADCASTER = ("tfloom", "run", "turtle_tf2_py", "turtle_tf2_broadcaster")


def masked(text: str) -> str:
    return re.sub(r"\b\d+(\.\d+)?(e[-+]\d+)?\b", "N", text)


def test_delays_are_those_of_the_last_thousand() -> None:
    delays = Delays()
    for delay in [1000.0, *[0.25, 0.75] * 500]:
        delays.add(delay)
    assert (delays.average_s, delays.greatest_s) == (0.5, 0.75)
    delays = Delays()
    delays.add(-0.5)  # stamped by a clock that is ahead
    assert (delays.average_s, delays.greatest_s) == (-0.5, 0.0)


def test_the_net_delay_follows_slowly() -> None:
    net = NetDelay()
    for delay in (1.0, 2.0, 0.0):
        net.add(delay)
    assert net.average_s == pytest.approx(0.99 * 1.01)
    assert net.greatest_s == 2.0


def test_statistics_by_frame_and_in_all() -> None:
    statistics = Statistics()
    assert statistics.text() == "\nFrames:\n\nAll Broadcasters:"
    statistics.add([("b", 99.5), ("a", 99.0)], 100.0)
    statistics.add([("b", 100.0)], 100.5)
    statistics.add([], 101.0)
    assert statistics.text().splitlines() == [
        "",
        "Frames:",
        "Frame: a, published by <no authority available>, Average Delay: 1, Max Delay: 1",
        "Frame: b, published by <no authority available>, Average Delay: 0.5, Max Delay: 0.5",
        "",
        "All Broadcasters:",
        "Node: <no authority available> 3 Hz, Average Delay: 0.416667 Max Delay: 0.75",
    ]
    assert "Frame: a," not in statistics.text(["b", "c"])


def test_output_matches_the_reference(
    domain_id: int,
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
    deviations: dict[str, dict[str, str]],
) -> None:
    start_program(*STATIC, "--frame-id", "world", "--child-frame-id", "camera").wait_for(SPINNING)
    every = start_program("python", "-c", QUICK_MONITOR)
    pair = start_program("python", "-c", QUICK_MONITOR, "turtle1", "camera")
    start_program(*TURTLESIM)
    start_program(*BROADCASTER)
    wait_until(lambda: "Node: " in every.output and "Node: " in pair.output)
    for program in (every, pair):
        program.signal(signal.SIGINT)
        assert program.wait() == 0

    printed = masked(every.output)
    turtle = masked(
        "Frame: turtle1, published by <no authority available>, Average Delay: 1.5, Max Delay: 2\n"
    )
    assert turtle in printed
    assert printed.replace(turtle, "") == masked("\n".join(golden("tf2_monitor")))

    assert "tf2-monitor-pair" in deviations
    lines = pair.lines
    assert re.fullmatch("Waiting for transform chain .* turtle1 and camera [.]*", lines[0])
    assert lines[1:6] == [
        "Gathering data on turtle1 -> camera for 10 seconds...",
        *("", "", ""),
        "RESULTS: for turtle1 to camera",
    ]
    assert lines[6] == "Chain is: turtle1 -> camera"
    net = re.fullmatch(r"Net delay     avg = (\S+): max = (\S+)", lines[7])
    assert 0.0 < float(net[1]) <= float(net[2]) < 10.0
    assert masked("\n".join(lines[8:])) == masked(
        "\nFrames:\n"
        "Frame: camera, published by <no authority available>, Average Delay: 1.5, Max Delay: 2\n"
        "Frame: turtle1, published by <no authority available>, Average Delay: 1.5, Max Delay: 2\n"
        "\nAll Broadcasters:\n"
        "Node: <no authority available> 60.1 Hz, Average Delay: 1.5 Max Delay: 2"
    )
    rate = re.search(r"available> (\S+) Hz", lines[-1])
    assert 10.0 < float(rate[1]) < 80.0


@pytest.mark.parametrize("words", [["world"], ["world", "camera", "turtle1"]])
def test_usage_matches_the_reference(words: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    assert monitor.main(words) == 255
    printed = "".join(capfd.readouterr())
    assert printed.endswith("[tf2_monitor_main]: TF_Monitor: usage: tf2_monitor framea frameb\n")
