"""`topic echo` prints the messages of `topic pub`, process to process over DDS, as recorded."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from contextlib import ExitStack
from functools import partial

import pytest
import transcript
import yaml
from tests.conftest import Program

from tfloom.cli import main as cli
from tfloom.cli.shared.graph import joined_participant
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.rmw.base import NodeName, Sample
from tfloom.rmw.events import Count, Event
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

POSE = "{x: 5.544444561004639, y: 5.544444561004639}"
CAMERA = (
    "{transforms: [{header: {stamp: {sec: 1795257442, nanosec: 127281577}, frame_id: world}, child_frame_id: camera,"
    " transform: {translation: {x: 1.0, y: 2.0, z: 3.0},"
    " rotation: {z: 0.707106771713121, w: 0.707106790659974}}}]}"
)
LOG = (
    "{stamp: {sec: 1795257453, nanosec: 352914069}, level: 20, name: talker, msg: 'Publishing: \"Hello World: 10\"',"
    " file: <prefix>/lib/python3.11/site-packages/demo_nodes_py/topics/talker.py, function: timer_callback, line: 35}"
)
TRANSIENT = ("--qos-durability", "transient_local")


def publish_with(
    start_program: Callable[..., Program], topic: str, kind: str, values: str, *flags: str
) -> Program:
    """Publish values on a topic from a separate process, ten times a second."""
    program = start_program("tfloom", "topic", "pub", "-r", "10", *flags, topic, kind, values)
    program.wait_for("publishing #1")
    return program


@pytest.fixture
def publish(domain_id: int, start_program: Callable[..., Program]) -> Callable[..., Program]:
    """Publish on a separate domain: `publish(topic, kind, values, *flags)`."""
    return partial(publish_with, start_program)


@pytest.fixture(scope="module")
def pose(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Publish POSE during the test."""
    publish_with(start_module_program, "/turtle1/pose", "turtlesim/msg/Pose", POSE)


@pytest.fixture(scope="module")
def camera(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Publish CAMERA during the test, for late subscriptions too."""
    publish_with(start_module_program, "/tf_static", "tf2_msgs/msg/TFMessage", CAMERA, *TRANSIENT)


@pytest.fixture(scope="module")
def log(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Publish LOG during the test."""
    publish_with(start_module_program, "/rosout", "rcl_interfaces/msg/Log", LOG)


@pytest.mark.usefixtures("pose", "camera", "log")
@pytest.mark.parametrize(
    "name",
    [
        "topic_echo_once",
        "topic_echo_csv",
        "topic_echo_field",
        "topic_echo_flow",
        "topic_echo_tf_static",
        "topic_echo_noarr",
    ],
)
def test_messages_match_the_recording(name: str) -> None:
    transcript.check(name)


@pytest.mark.parametrize("name", ["topic_echo_bad", "topic_echo_badtype"])
def test_errors_begin_as_recorded(name: str, domain_id: int, deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-nearest-names" in deviations
    recorded = transcript.golden(name)
    answer = transcript.run_here(*recorded.command)
    assert answer.exit_code == recorded.exit_code
    assert answer.text.startswith(recorded.text)


def test_misspelt_topic_or_type_gives_the_nearest(pose: None) -> None:
    assert transcript.run_here("topic", "echo", "/turtle/pose").text.endswith("\ndid you mean /turtle1/pose?")
    assert "turtlesim/msg/Pose" in transcript.run_here("topic", "echo", "/x", "turtlesim/msg/Poze").text


def test_echo_with_a_type_waits_for_the_topic(
    domain_id: int, start_program: Callable[..., object], publish: Callable[..., object]
) -> None:
    echo = start_program("tfloom", "topic", "echo", "--once", "/tf_static", "tf2_msgs/msg/TFMessage")
    echo.wait_for("waiting for a publisher of /tf_static")
    publish(
        "/tf_static",
        "tf2_msgs/msg/TFMessage",
        CAMERA,
        *TRANSIENT,
        "--times",
        "1",
        "-w",
        "0",
        "--keep-alive",
        "30",
    )
    assert echo.wait() == 0
    assert "frame_id: world" in echo.output


def test_earlier_messages_of_all_transient_publishers_are_received(domain_id: int) -> None:
    qos = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)
    with ExitStack() as stack:
        for number in range(7):
            participant = stack.enter_context(joined_participant())
            writer = participant.create_writer(NodeName("/", f"node_{number}"), topic_of(Int32, "/late"), qos)
            writer.write(cdr.encode(Int32(data=number)))
        answer = transcript.run_here("topic", "echo", "--csv", "--timeout", "2", "/late")
    assert sorted(answer.text.splitlines()) == [str(number) for number in range(7)]


def test_filter_selects_messages(pose: None) -> None:
    words = ("topic", "echo", "/turtle1/pose")
    assert transcript.run_here(*words, "--once", "--csv", "--filter", "m.x > 5").exit_code == 0
    assert transcript.run_here(*words, "--timeout", "0.5", "--filter", "m.x < 5").text == ""
    mistaken = transcript.run_here(*words, "--filter", "m.q")
    assert (mistaken.exit_code, mistaken.text) == (
        1,
        (
            "--filter failed: AttributeError: 'Pose' object has no attribute 'q'\n"
            "there are: x, y, theta, linear_velocity, angular_velocity"
        ),
    )


def test_field_path_with_an_index_selects_an_element(camera: None) -> None:
    words = ("topic", "echo", "--once", "/tf_static", "--field")
    assert transcript.run_here(*words, "transforms[0].transform.translation.z").text == "3.0\n---"
    assert (
        transcript.run_here(*words, "transforms[0].header.stamp").text
        == "sec: 1795257442\nnanosec: 127281577\n---"
    )
    outside = transcript.run_here(*words, "transforms[1].header")
    assert outside.exit_code == 1
    assert outside.text.startswith("Invalid field 'transforms[1].header': ")
    wrong = transcript.run_here(*words, "transforms[0].header.q")
    assert wrong.text.endswith("there are: stamp, frame_id")


@pytest.mark.parametrize(
    "path", ["/", "transforms/header", "[0]", "[a]", "transforms[x]", "not a field", "-1"]
)
def test_a_field_path_of_another_form_is_a_field_that_no_message_has(path: str, camera: None) -> None:
    refused = transcript.run_here("topic", "echo", "--once", "/tf_static", f"--field={path}")
    assert (refused.exit_code, refused.text.splitlines()) == (
        1,
        [f"Invalid field '{path}': 'TFMessage' object has no attribute '{path}'", "there are: transforms"],
    )


@pytest.mark.parametrize("path", ["", ".", ".."])
def test_a_field_path_without_a_name_is_refused_at_once(path: str) -> None:
    refused = transcript.run_here("topic", "echo", "/nothing", "std_msgs/msg/String", "--field", path)
    assert refused.exit_code == 1
    assert refused.text.splitlines()[0] == f"Invalid field value '{path}'"


def test_points_around_a_field_path_are_no_part_of_it(camera: None) -> None:
    words = ("topic", "echo", "--once", "/tf_static", "--field", ".transforms[0]..header.stamp.")
    assert transcript.run_here(*words).text == "sec: 1795257442\nnanosec: 127281577\n---"


def test_csv_and_json_are_printed(camera: None) -> None:
    words = ("topic", "echo", "--once", "/tf_static")
    message = json.loads(transcript.run_here(*words, "--json").text)
    assert message["transforms"][0]["transform"]["translation"] == {"x": 1.0, "y": 2.0, "z": 3.0}
    assert transcript.run_here(*words, "--raw").text.startswith("b'\\x00\\x01\\x00\\x00\\x01\\x00\\x00\\x00")


def test_timeout_without_message_gives_an_error_message(domain_id: int) -> None:
    answer = transcript.run_here("topic", "echo", "--once", "--timeout", "0.5", "/x", "std_msgs/msg/Empty")
    assert answer.exit_code == 1
    assert answer.text.endswith("no message on /x within 0.5 s")


def test_arrays_and_strings_are_truncated_as_requested(publish: Callable[..., object]) -> None:
    values = f"{{data: {'x' * 200}}}"
    publish("/long", "std_msgs/msg/String", values)
    words = ("topic", "echo", "--once", "/long")
    assert transcript.run_here(*words).text == f"data: {'x' * 128}...\n---"
    assert transcript.run_here(*words, "--truncate-length", "5").text == "data: xxxxx...\n---"
    assert transcript.run_here(*words, "--full-length").text == f"data: {'x' * 200}\n---"
    assert transcript.run_here(*words, "--no-str").text == "data: '<string length: <200>>'\n---"


INFO = ["publication_sequence_number", "received_timestamp", "reception_sequence_number", "source_timestamp"]


def test_message_info_is_printed_before_the_message(pose: None) -> None:
    words = ("topic", "echo", "--once", "--include-message-info", "/turtle1/pose")
    info, message, _ = transcript.run_here(*words).text.split("---")
    assert list(yaml.safe_load(info)) == INFO
    assert yaml.safe_load(info)["received_timestamp"] >= yaml.safe_load(info)["source_timestamp"] > 1e18
    assert yaml.safe_load(message)["x"] == 5.544444561004639
    line = transcript.run_here(*words, "--csv").text
    numbers = r"\d+,0" if os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp" else "None,None"
    assert re.fullmatch(rf"\d{{19}},\d{{19}},{numbers},5.544444561004639,5.544444561004639,0.0,0.0,0.0", line)
    as_json = json.loads(transcript.run_here(*words, "--json").text)
    assert sorted(as_json["message_info"]) == INFO
    assert as_json["message"]["theta"] == 0.0


def test_several_fields_are_printed(camera: None, deviations: dict[str, dict[str, str]]) -> None:
    assert "echo-several-fields" in deviations
    words = ("topic", "echo", "--once", "/tf_static", "--field", "transforms[0].child_frame_id",
             "--field", "transforms[0].transform.translation")  # fmt: skip
    assert transcript.run_here(*words).text == (
        "transforms[0].child_frame_id: camera\n"
        "transforms[0].transform.translation:\n  x: 1.0\n  y: 2.0\n  z: 3.0\n---"
    )
    assert transcript.run_here(*words, "--csv").text == "camera,1.0,2.0,3.0"
    assert json.loads(transcript.run_here(*words, "--json").text) == {
        "transforms[0].child_frame_id": "camera",
        "transforms[0].transform.translation": {"x": 1.0, "y": 2.0, "z": 3.0},
    }


def test_filter_receives_the_selected_field(pose: None) -> None:
    words = ("topic", "echo", "/turtle1/pose", "--field", "x", "--filter")
    assert transcript.run_here(*words, "m > 5", "--once").text == "5.544444561004639\n---"
    assert transcript.run_here(*words, "m < 5", "--timeout", "0.5").text == ""


def test_raw_bytes_work_with_filter_and_json(pose: None) -> None:
    words = ("topic", "echo", "/turtle1/pose", "--raw")
    assert transcript.run_here(*words, "--filter", "m.x < 5", "--timeout", "0.5").text == ""
    raw = bytes.fromhex(json.loads(transcript.run_here(*words, "--once", "--json").text))
    assert cdr.decode(Pose, raw).x == 5.544444561004639
    part = transcript.run_here(*words, "--field", "x")
    assert (part.exit_code, part.text) == (
        1,
        "--raw prints the bytes of whole messages, and --field a part of them",
    )


def test_unknown_field_is_rejected(pose: None) -> None:
    answer = transcript.run_here("topic", "echo", "--once", "/turtle1/pose", "--field", "__class__")
    assert answer.exit_code == 1
    assert answer.text.endswith("there are: x, y, theta, linear_velocity, angular_velocity")


def test_timeout_ends_during_a_flood_of_messages(
    domain_id: int, start_program: Callable[..., object]
) -> None:
    flood = start_program("tfloom", "topic", "pub", "-r", "1e9", "-p", "0", "/x", "std_msgs/msg/Empty")
    flood.wait_for("beginning")
    assert transcript.run("topic", "echo", "--timeout", "0.5", "/x", timeout_s=20).exit_code == 0


class LossyReader:
    """A reader of two messages, before the second of which three were lost."""

    gid = bytes(16)

    def __init__(self) -> None:
        self.samples = [cdr.encode(Pose(x=1.0)), cdr.encode(Pose(x=2.0))]
        self.watched: set[Event] = set()

    def notify(self, queue: object, token: int = 0) -> None:
        queue.post(token)

    def notify_event(self, event: Event, queue: object, token: int = 0) -> None:
        self.watched.add(event)

    def take(self) -> Sample | None:
        return Sample(self.samples.pop(0), 1, 2, bytes(16)) if self.samples else None

    def take_event(self, event: Event) -> object:
        assert event in self.watched
        return Count(5, 3) if event is Event.MESSAGE_LOST and len(self.samples) == 0 else None

    def close(self) -> None:
        pass


@pytest.mark.parametrize("flags", [[], ["--no-lost-messages"]])
def test_lost_messages_are_reported(
    flags: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    deviations: dict[str, dict[str, str]],
) -> None:
    assert "echo-lost-messages" in deviations
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setattr("tfloom.rmw.local.wire.LocalParticipant.create_reader", lambda *_: LossyReader())
    words = ["topic", "echo", "/x", "turtlesim/msg/Pose", "--csv", "--timeout", "3", "--qos-depth", "5"]
    assert cli.main([*words, *flags]) == 0
    out, err = capsys.readouterr()
    assert out == "1.0,0.0,0.0,0.0,0.0\n2.0,0.0,0.0,0.0,0.0\n"
    told = "A message was lost!!!\n\ttotal count change:3\n\ttotal count: 5---\n"
    assert told in err if not flags else err == ""


def test_mismatched_type_is_reported(pose: None) -> None:
    answer = transcript.run_here("topic", "echo", "/turtle1/pose", "std_msgs/msg/Empty", "--timeout", "1")
    assert answer.text == (
        "WARNING: /turtle1/pose is published as turtlesim/msg/Pose, not as std_msgs/msg/Empty"
    )


def test_echo_subscribes_as_a_named_node_and_clears_a_terminal_alone(
    publish: Callable[..., Program], start_program: Callable[..., Program]
) -> None:
    publish("/pose", "turtlesim/msg/Pose", POSE)
    echo = start_program("tfloom", "topic", "echo", "--clear", "--node-name", "my_echo", "/pose")
    echo.wait_for("theta: ")
    assert "\x1b" not in echo.output
    assert "/my_echo" in transcript.run_here("node", "list").text.splitlines()
    wrong = transcript.run_here("topic", "echo", "--node-name", "1", "/pose")
    assert (wrong.exit_code, "node name" in wrong.text.lower()) == (1, True)
