"""tfloom's versions of the programs that ran during the recording: turtlesim, a talker, a static transform."""

from __future__ import annotations

import re
from collections.abc import Callable

import transcript

STATIC = (
    "--x",
    "1",
    "--y",
    "2",
    "--z",
    "3",
    "--yaw",
    "1.57",
    "--frame-id",
    "world",
    "--child-frame-id",
    "camera",
)


def masked(recorded: transcript.Transcript) -> tuple[str, int]:
    return re.sub(r"publisher_\w{16}", "publisher_NAME", recorded.text), recorded.exit_code


def test_lists_match_the_recording(domain_id: int, start_program: Callable[..., object]) -> None:
    start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless").wait_for(
        "Spawning turtle [turtle1]"
    )
    start_program("tfloom", "run", "demo_nodes_py", "talker").wait_for("Hello World: 0")
    start_program("tfloom", "run", "tf2_ros", "static_transform_publisher", *STATIC).wait_for(
        "Spinning until stopped"
    )
    names = ("node_list", "param_list", "service_list_t", "topic_list", "topic_list_hidden", "topic_list_t")
    for name in names:
        recorded = transcript.golden(name)
        assert masked(transcript.run_here(*recorded.command)) == masked(recorded)
