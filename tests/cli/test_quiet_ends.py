"""Every verb ends without traceback when its pipe is closed (`| head -1`), and long-running ones on Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
import transcript
from test_json import ASKED, BAG, POSE, ROTATE
from test_usage import VERBS

from tfloom.cli import main as cli

pytestmark = [
    pytest.mark.skipif(os.name != "posix", reason="a pipe breaks differently elsewhere"),
]

AT_A_TIME = 4
PRINTING = {
    **ASKED,
    "action send_goal": (ROTATE, "turtlesim/action/RotateAbsolute", "{theta: 0.1}"),
    "daemon start": (),
    "bag info": (BAG,),
    "bag list": ("storage",),
    "daemon status": (),
    "daemon stop": (),
    "demo": ("--seconds", "0"),
    "interface proto": ("geometry_msgs/msg/Twist",),
    "interface show": ("geometry_msgs/msg/Twist",),
    "lifecycle set": ("/a_node", "configure"),
    "param list": ("/turtlesim",),
    "param load": ("/turtlesim", "parameters.yaml"),
    "param set": ("/turtlesim", "background_r", "70"),
    "pkg create": ("my_pkg",),
    "pkg prefix": ("turtlesim",),
    "run": ("tf2_ros", "tf2_echo"),
    "service call": ("/clear", "std_srvs/srv/Empty"),
    "tf diff": (BAG, "live"),
    "tf doctor": ("--seconds", "0.2"),
    "tf explain": ("turtle1", "turtle2", "--wait", "0.2"),
    "tf save": ("statics.yaml", "--bag", BAG),
    "topic bw": (POSE,),
    "topic echo": (POSE,),
    "topic hz": (POSE,),
    "topic pub": ("/x", "std_msgs/msg/Empty"),
    "view": ("--no-open", "--port", "0"),
}
"""A command line of each verb that prints on stdout."""
OFTEN = (
    *(
        "interface show",
        "param get",
        "pkg list",
        "run",
        "service call",
        "tf doctor",
        "topic echo",
        "topic hz",
    ),
    "topic list",
)
"""Verbs that are often before a pipe, one of each way to print."""
SILENT = {
    "bag burst": "prints on stderr",
    "bag convert": "prints on stderr",
    "bag play": "prints on stderr",
    "bag record": "prints on stderr",
    "bag reindex": "prints on stderr",
    "action echo": "nobody calls turtlesim's action",
    **dict.fromkeys(["component load", "component unload"], "there is no container, as it prints on stderr"),
    "component list": "there is no container",
    **dict.fromkeys(["component standalone", "component types"], "prints on stderr"),
    "interface stubs": "no workspace with definitions is sourced, as it prints on stderr",
    "param delete": "turtlesim's parameters can't be deleted, as it prints on stderr",
    "launch": "prints on stderr",
    "security": "prints on stderr",
    "pkg xml": "our own packages have no package.xml",
    "service echo": "turtlesim publishes no events",
    "tf plot": "there are no transforms, as it prints on stderr",
    "tf publish": "prints on stderr",
    "topic delay": "no topic of turtlesim has a header",
    "multicast receive": "has its own test",
    "multicast send": "has its own test",
    "zenoh router": "has its own test",
}
"""Verbs that print nothing on stdout here, each with its reason."""
START = "import sys; from tfloom.cli import main; sys.stdin.read(1); sys.exit(main.main())"
"""Waits for a byte of the input, so that the pipe is closed before the first line."""


@pytest.fixture(scope="module", autouse=True)
def nodes(module_domain_id: int, start_module_program: Callable[..., Any]) -> None:
    start_module_program("python", Path(__file__).with_name("a_lifecycle_node.py")).wait_for("ready")
    start_module_program("tfloom", "run", "turtlesim", "turtlesim_node").wait_for("Spawning turtle [turtle1]")


def test_each_verb_has_a_command_line_or_a_stated_reason() -> None:
    assert {*PRINTING, *SILENT} >= set(VERBS)


@pytest.mark.parametrize(
    "verbs", [OFTEN, pytest.param([*PRINTING], marks=pytest.mark.slow)], ids=["often", "all"]
)
def test_closed_pipe_ends_the_verb(tmp_path: Path, verbs: Sequence[str]) -> None:
    (tmp_path / "parameters.yaml").write_text("/turtlesim:\n  ros__parameters:\n    background_g: 3\n")

    def end_of(verb: str) -> tuple[int, str]:
        words = PRINTING[verb]
        process = subprocess.Popen(
            [sys.executable, "-c", START, *verb.split(), *words],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=tmp_path,
        )
        process.stdout.close()
        _, errors = process.communicate(b"x", timeout=60)
        return process.returncode, transcript.without_waiting(errors.decode())

    with ThreadPoolExecutor(AT_A_TIME) as pool:  # most of a verb's time is a wait for the graph
        ends = dict(zip(verbs, pool.map(end_of, verbs), strict=True))
    assert ends == dict.fromkeys(verbs, (cli.PIPE_CLOSED, ""))


LONG = {
    "topic echo": ((POSE,), "x: "),
    "topic hz": ((POSE,), "average rate"),
    "topic pub": (("/x", "std_msgs/msg/Empty"), "publishing #1"),
    "service call": (("/nobodys", "std_srvs/srv/Empty"), "waiting for service"),
    "service echo": (("/clear",), "no publisher of"),
    "action echo": (
        (ROTATE,),
        "no publisher yet of GOAL_SERVICE, CANCEL_SERVICE, RESULT_SERVICE (services are",
    ),
    "action send_goal": (("/nobodys", "turtlesim/action/RotateAbsolute"), "Waiting for an action server"),
    "run": (("turtlesim", "turtlesim_node", "--ros-args", "-r", "__node:=other"), "Spawning"),
}
"""What runs until Ctrl-C, and what it prints once it runs; `topic bw` and `delay` listen as `hz` does."""


@pytest.mark.parametrize("verb", LONG)
def test_ctrl_c_ends_the_verb(verb: str, start_program: Callable[..., Any]) -> None:
    words, printed = LONG[verb]
    program = start_program("tfloom", *verb.split(), *words)
    program.wait_for(printed)
    told = list(program.lines)
    program.signal(signal.SIGINT)
    assert program.wait() == (0 if verb == "run" else cli.INTERRUPTED)
    assert "Traceback" not in program.output
    assert not [line for line in program.lines[len(told) :] if "nterrupt" in line or "Error" in line]


def test_ctrl_c_at_any_time_ends_without_traceback() -> None:
    """The command may be importing its verb, joining, receiving or leaving."""
    start = "import sys; from tfloom.cli import main; print('main', flush=True); sys.exit(main.main())"
    for step in range(6):
        process = subprocess.Popen(
            [sys.executable, "-c", start, "topic", "list"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert process.stdout.readline() == "main\n"
        with suppress(subprocess.TimeoutExpired):
            process.wait(0.003 + 0.06 * step)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=30)
        if errors.splitlines()[1:] == ['  File "<string>", line 1, in <module>', "KeyboardInterrupt"]:
            continue  # it came before the command was called
        assert errors == "", step
        assert process.returncode in {0, cli.INTERRUPTED}
