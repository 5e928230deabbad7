"""Completion: by argcomplete's protocol, and in real shells in a pseudo-terminal."""

from __future__ import annotations

import json
import math
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

import pytest
import transcript
from test_usage import VERBS
from tests.conftest import python_with
from tests.each import for_each

from tfloom.cli.completion import find_offer
from tfloom.cli.shared.interfaces import action_class, fill_message, message_class, parse_yaml, service_class
from tfloom.cli.shared.message_text import prototype
from tfloom.interfaces.geometry_msgs.msg import Vector3
from tfloom.interfaces.std_msgs.msg import String
from tfloom.rosidl.message import Message
from tfloom.workspace.interfaces import known_interfaces

pytestmark = pytest.mark.skipif(os.name != "posix", reason="completion is a shell's")


PATIENT = {"tfloom.cli.completion.MAX_WAIT_S": 10.0}


EACH = """
import json, os
import argcomplete
from tfloom.cli import completion, launch_api, main, tab_key
from tfloom.cli.shared import graph
from tfloom.cli.shared import interfaces
from tfloom.cli.shared import message_text
from tfloom.common import yaml as user_yaml
folder, lines = sys.argv[1:]
for number, line in enumerate(json.loads(lines)):
    if not os.fork():
        os.environ.update(COMP_LINE=line, COMP_POINT=str(len(line)))
        os.environ["_ARGCOMPLETE_STDOUT_FILENAME"] = f"{folder}/answer{number}"
        main.main(prog="ros2")
        os._exit(1)
    os.wait()
"""
"""Answers each command line in a separate process, which has imported the command already."""


def complete_each(lines: Iterable[str], tmp_path: Path) -> dict[str, list[str]]:
    """Return the completions at the end of each command line, with patience for a busy machine."""
    lines = list(lines)
    environment = os.environ | {"_ARGCOMPLETE": "1", "_ARGCOMPLETE_IFS": "\n", "COMP_TYPE": "9"}
    command = [sys.executable, *python_with(PATIENT, EACH, tmp_path, json.dumps(lines))]
    subprocess.run(command, env=environment, timeout=60, check=True, stdin=subprocess.DEVNULL)
    answers = [(tmp_path / f"answer{number}").read_text() for number in range(len(lines))]
    return {
        line: [word.strip() for word in answer.split("\n") if word.strip()]
        for line, answer in zip(lines, answers, strict=True)
    }


OFFERS = {
    "tfloom to": {"topic"},
    "tfloom topic i": {"info"},
    "tfloom topic list --show": {"--show-types"},
    "tfloom topic echo --qos-reliability bes": {"best_effort", "best_available"},
    "tfloom run turtlesim turtlesim": {"turtlesim_node"},
    "tfloom run turtles": {"turtlesim"},
    "tfloom pkg prefix tf2_r": {"tf2_ros", "tf2_ros_py"},
    "tfloom interface package geo": {"geographic_msgs", "geometry_msgs"},
    "tfloom service find std_srvs/srv/Em": {"std_srvs/srv/Empty"},
    "tfloom action send_goal /nobodys turtlesim/action/Rot": {"turtlesim/action/RotateAbsolute"},
}
SEVERAL = (
    "tfloom interface show geometry_msgs/msg/TwistW",
    "tfloom topic pub /nobodys geometry_msgs/msg/Twist",
)
"""Lines whose last word begins several types."""


def test_verbs_and_names_are_completed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    found = complete_each([*OFFERS, *SEVERAL], tmp_path)
    for line in SEVERAL:
        types = found.pop(line)
        assert len(types) > 1, line
        assert all(name.startswith(line.split()[-1]) for name in types), line
    assert {line: set(words) for line, words in found.items()} == OFFERS


@pytest.fixture
def launch_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a folder with a launch file the current one."""
    (tmp_path / "here" / "deeper").mkdir(parents=True)
    (tmp_path / "here" / "a.launch.xml").write_text(
        '<launch><arg name="mode" default="a"><choice value="a"/><choice value="b"/></arg><arg name="more"/></launch>'
    )
    (tmp_path / "here" / "a.txt").touch()
    monkeypatch.chdir(tmp_path / "here")
    return tmp_path


LAUNCH_OFFERS: dict[str, set[str]] = {
    "tfloom launch turtle_tf2_p": {"turtle_tf2_py"},
    "tfloom launch a.": {"a.launch.xml"},
    "tfloom launch ./": {"./a.launch.xml", "./deeper/"},
    "tfloom launch a.launch.xml m": {"mode:=", "more:="},
    "tfloom launch -d a.launch.xml mode:=a m": {"more:="},
    "tfloom launch a.launch.xml mode:=": {"mode:=a", "mode:=b"},
    "tfloom launch a.launch.xml more:=": set(),
    "tfloom launch missing.launch.xml m": set(),
    "tfloom launch --show": {"--show-args", "--show-arguments", "--show-all-subprocesses-output"},
}


def test_launch_files_and_their_arguments_are_completed(launch_folder: Path) -> None:
    found = complete_each(LAUNCH_OFFERS, launch_folder)
    assert {line: set(words) for line, words in found.items()} == LAUNCH_OFFERS


TWIST = "{linear: {x: 0.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 0.0}}"
PUB_TWIST = "tfloom topic pub -1 /nobodys geometry_msgs/msg/Twist "


MESSAGES: dict[str, list[str]] = {
    PUB_TWIST: [f"'{TWIST}'"],
    f"{PUB_TWIST}'": [TWIST],
    f"{PUB_TWIST}'{{lin": [TWIST],
    f"{PUB_TWIST}{{lin": [f"'{TWIST}'"],
    f"{PUB_TWIST}{{ang": [],
    'tfloom topic pub /x std_msgs/msg/String "': [r"{data: \"\"}"],
    "tfloom topic pub /x std_msgs/msg/Nope ": [],
    "tfloom topic pub /x std_msgs/msg/Empty ": ["'{}'"],
    "tfloom service call /s turtlesim/srv/Spawn ": ["""'{x: 0.0, y: 0.0, theta: 0.0, name: ""}'"""],
    "tfloom service call /s turtlesim/srv/Nope ": [],
    "tfloom action send_goal /a turtlesim/action/RotateAbsolute ": ["'{theta: 0.0}'"],
    "tfloom action send_goal -f /a turtlesim/action/Nope ": [],
}


def test_a_message_to_edit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert complete_each(MESSAGES, tmp_path) == MESSAGES


SENT: dict[str, Callable[[str], type[Message]]] = {
    "msg": message_class,
    "srv": lambda name: service_class(name).Request,
    "action": lambda name: action_class(name).Goal,
}
"""The class of what is sent, by the kind of its interface."""


@pytest.mark.parametrize("kind", SENT)
def test_each_message_is_read_back_as_its_defaults(kind: str) -> None:
    for name in known_interfaces(kind):
        cls = SENT[kind](name)
        message = cls()
        text = prototype(message)
        assert "\n" not in text
        filled = cls()
        fill_message(filled, parse_yaml(text))
        assert filled == message, name


def test_values_that_yaml_writes_its_own_way() -> None:
    odd = Vector3(x=math.inf, y=-math.inf, z=1e-9)
    filled = Vector3()
    fill_message(filled, parse_yaml(prototype(odd)))
    assert filled == odd
    fill_message(filled, parse_yaml(prototype(Vector3(x=math.nan))))
    assert math.isnan(filled.x)
    text = String(data='it\'s \\ "two"\nlines: ü')
    filled = String()
    fill_message(filled, parse_yaml(prototype(text)))
    assert filled == text


def test_programs_of_a_workspace_are_completed(prefix: Path) -> None:
    program = prefix / "lib" / "my_pkg" / "my_program"
    program.parent.mkdir(parents=True)
    program.touch(mode=0o755)
    offers = {"tfloom run my_p": ["my_pkg"], "tfloom run my_pkg my": ["my_program"]}
    assert complete_each(offers, prefix) == offers


FREE = {
    "plugin_name",
    "path",
    "bag_path",
    "value",
    "further",
    "argv",
    "arguments",
    "parameter_file",
    "folder",
    "file",
    "before",
    "after",
    "launch_file_name",
    "launch_arguments",
    "words",
}


@for_each(VERBS)
def test_each_argument_has_completions_or_is_free_text(verb: str) -> None:
    for action in VERBS[verb]._actions:
        if (
            not action.option_strings
            and not action.choices
            and verb != "pkg create"
            and action.dest not in FREE
        ):
            assert find_offer(verb.split(), action.dest), action.dest


def test_containers_and_their_components_are_completed(
    domain_id: int, tmp_path: Path, start_program: Callable[..., object]
) -> None:
    start_program("python", Path(__file__).with_name("a_container.py")).wait_for("ready")
    containers, components = "tfloom component list /", "tfloom component unload /a_container "
    empty = {containers: ["/a_container"], components: []}
    assert complete_each(empty, tmp_path) == empty
    loaded = transcript.run_here(
        "component", "load", "-q", "/a_container", "composition", "composition::Talker"
    )
    assert complete_each([components], tmp_path) == {components: [loaded.text.split()[0]]}


def test_lifecycle_nodes_and_their_transitions_are_completed(
    domain_id: int, tmp_path: Path, start_program: Callable[..., object]
) -> None:
    start_program("python", Path(__file__).with_name("a_lifecycle_node.py")).wait_for("ready")
    offers = {"tfloom lifecycle get /": ["/a_node"], "tfloom lifecycle set /a_node con": ["configure"]}
    assert complete_each(offers, tmp_path) == offers


def test_frames_of_a_graph_and_of_a_file_are_completed(
    domain_id: int,
    tmp_path: Path,
    start_program: Callable[..., object],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.yaml").write_text(
        "static_transforms: [{frame_id: base, child_frame_id: laser}, {frame_id: base, child_frame_id: lamp}]"
    )
    start_program("tfloom", "tf", "publish", tmp_path / "robot.yaml").wait_for("until Ctrl-C")
    offers = {
        "tfloom tf explain ba": ["base"],
        "tfloom tf explain base la": ["lamp", "laser"],
        "tfloom tf plot --bag robot.yaml base las": ["laser"],
    }
    assert complete_each(offers, tmp_path) == offers


def test_live_topics_nodes_and_types_are_completed(
    domain_id: int, tmp_path: Path, start_program: Callable[..., object]
) -> None:
    start_program("tfloom", "topic", "pub", "-n", "my_node", "/my_topic", "geometry_msgs/msg/Twist").wait_for(
        "#1"
    )
    offers = {
        "tfloom topic echo /my": ["/my_topic"],
        "tfloom topic echo my": ["my_topic"],
        "tfloom topic hz /my": ["/my_topic"],
        "tfloom topic pub /my_topic ": ["geometry_msgs/msg/Twist"],
    }
    assert complete_each(offers, tmp_path) == offers


def test_live_services_actions_and_parameters_are_completed(
    domain_id: int, tmp_path: Path, start_program: Callable[..., object]
) -> None:
    start_program("tfloom", "run", "turtlesim", "turtlesim_node").wait_for("Spawning")
    goals = "tfloom action send_goal /none "
    offers = {
        "tfloom service call /sp": ["/spawn"],
        "tfloom service call /spawn ": ["turtlesim/srv/Spawn"],
        "tfloom param get /turtles": ["/turtlesim"],
        "tfloom param get /turtlesim background_r": ["background_r"],
        "tfloom param describe /turtlesim back": ["background_b", "background_g", "background_r"],
    }
    answers = complete_each([*offers, goals], tmp_path)
    assert "example_interfaces/action/Fibonacci" in answers.pop(goals)
    assert answers == offers


INTERACTIVE = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], "PS1="),
    "zsh": (["zsh", "-f", "-i"], "PS1=; autoload -U compinit && compinit -u -D"),
}
"""How to start each shell with no files of the user's, and what completion needs there."""


@pytest.mark.parametrize("name", INTERACTIVE)
def test_completion_works_in_bash_and_zsh(
    name: str,
    domain_id: int,
    tmp_path: Path,
    start_program: Callable[..., object],
    wait_until: Callable[..., None],
) -> None:
    if not shutil.which(name):
        pytest.skip(f"needs {name}")
    start_program("tfloom", "topic", "pub", "/my_topic", "std_msgs/msg/Empty").wait_for("#1")
    ros2 = tmp_path / "ros2"  # As the distribution tfloom-ros2 installs it.
    ros2.write_text(
        f"#!/bin/sh\nexec '{sys.executable}' -c 'from tfloom.cli.main import main; main(prog=\"ros2\")' \"$@\"\n"
    )
    ros2.chmod(0o755)
    command, setting_up = INTERACTIVE[name]
    shell = start_program("python", "-c", f"import pty; pty.spawn({command})", stdin=subprocess.PIPE)
    folder = transcript.PROGRAM.parent

    def type_keys(keys: str) -> None:
        shell.process.stdin.write(keys)
        shell.process.stdin.flush()

    type_keys(
        f"PATH={shlex.quote(str(tmp_path))}:{shlex.quote(str(folder))}:$PATH; {setting_up}; "
        'eval "$(register-python-argcomplete tfloom ros2)"; echo is re""ady\n'
    )
    shell.wait_for("is ready")

    def is_completed(line: str, whole: str) -> bool:
        """Press Tab, repeatedly, because on a busy machine discovery may take longer than a second."""
        printed = shell.output.count("it is ")
        # Control-A moves to the beginning of the line: the completed line is printed, not run.
        type_keys(f"{line}\t\x01echo 'it is' \x05\n")
        wait_until(lambda: shell.output.count("it is ") > printed)
        return f"it is {whole}" in shell.output

    for line, whole in (
        ("tfloom run turtlesim turtlesim_n", "tfloom run turtlesim turtlesim_node"),
        ("ros2 topic pub /my_topic ", "ros2 topic pub /my_topic std_msgs/msg/Empty"),
        ("ros2 topic pub /x std_msgs/msg/String '", """ros2 topic pub /x std_msgs/msg/String {data: ""}"""),
        ("ros2 topic pub /x std_msgs/msg/String ", """ros2 topic pub /x std_msgs/msg/String {data: ""}"""),
    ):
        wait_until(partial(is_completed, line, whole))
    type_keys("exit\n")


@pytest.mark.skipif(not shutil.which("fish"), reason="needs fish")
@pytest.mark.parametrize(
    ("line", "offers"),
    [
        ("tfloom run turtlesim turtlesim_n", ["turtlesim_node"]),
        ("tfloom topic pub /x std_msgs/msg/String ", ['{data: ""}']),
        ('tfloom topic pub /x std_msgs/msg/String "', ['{data: ""}']),
        ("tfloom topic pub /x std_msgs/msg/String {da", []),
    ],
)
def test_completion_works_in_fish(line: str, offers: list[str]) -> None:
    folder = transcript.PROGRAM.parent
    code = (
        f"set -x PATH '{folder}' $PATH; register-python-argcomplete --shell fish tfloom ros2 | source; "
        f"complete -C '{line}'"
    )
    done = subprocess.run(
        ["fish", "--no-config", "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert [offer.strip() for offer in done.stdout.splitlines()] == offers
