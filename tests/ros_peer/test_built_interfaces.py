"""test_msgs, built by `install_interfaces`: the same types, octets and messages as those of ROS's own build."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.conftest import Program, run_to_end
from tests.ros_peer.programs import idl_contents
from tools.ros_peer import RosPeer

from tfloom.rosidl import spec
from tfloom.rosidl.type_hash import type_hash
from tfloom.workspace.interface_package import Installed, install_interfaces
from tfloom.workspace.package_definitions import PackageDefinitions, read_manifest

from .conftest import OURS, THEIRS, vendors

pytestmark = pytest.mark.ros
PROGRAMS = Path(__file__).parent / "programs"
END = PROGRAMS / "every_field_end.py"
MESSAGES = 13


class Built(NamedTuple):
    """The package as ROS and as tfloom built it."""

    peer: RosPeer
    share: Path
    """Where the peer has packages."""
    installed: Installed
    prefix: Path

    def environment(self, vendor: str, domain_id: int = 0) -> dict[str, str]:
        """Return the environment of a process that has the package."""
        if vendor == THEIRS:
            return self.peer.environment(domain_id)
        path = {"PYTHONPATH": str(self.installed.python_folder), "AMENT_PREFIX_PATH": str(self.prefix)}
        return os.environ | path | {"ROS_DOMAIN_ID": str(domain_id)}

    def python(self, vendor: str) -> str | Path:
        """Return the Python of a vendor."""
        return self.peer.python if vendor == THEIRS else sys.executable

    def run(self, vendor: str, program: Path, *words: object, stdin: str = "") -> str:
        """Return what a program of that vendor prints."""
        done = run_to_end(
            [self.python(vendor), program, *map(str, words)],
            env=self.environment(vendor),
            input=stdin,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout


@pytest.fixture(scope="module")
def built(peer: RosPeer, tmp_path_factory: pytest.TempPathFactory) -> Built:
    """Build the package from the peer's definitions."""
    share = peer.python.parent.parent / "share"
    prefix = tmp_path_factory.mktemp("install") / "test_msgs"
    files = [place for place in marker(share, "test_msgs") if not place.endswith(".idl")]
    return Built(peer, share, install_interfaces(share / "test_msgs", "test_msgs", files, prefix), prefix)


def marker(share: Path, package: str) -> list[str]:
    return (share / "ament_index/resource_index/rosidl_interfaces" / package).read_text("utf-8").split()


def test_hashes_equal_those_of_ros(built: Built) -> None:
    recorded = {
        type_hash["type_name"]: type_hash["hash_string"]
        for path in (built.share / "test_msgs").glob("*/*.json")
        for type_hash in json.loads(path.read_text("utf-8"))["type_hashes"]
    }
    code = (
        "import json, sys; from tfloom.rosidl.registry import find_class\n"
        "print(json.dumps({name: find_class(name)._TYPE_HASH for name in json.load(sys.stdin)}))"
    )
    assert len(recorded) > 50
    assert json.loads(built.run(OURS, Path("-c"), code, stdin=json.dumps([*recorded]))) == recorded


def test_octets_equal_those_of_ros_but_for_padding(built: Built) -> None:
    """The real rclpy leaves padding as it was in memory, and reserves more than wide strings need."""
    ours, theirs = (json.loads(built.run(python, END, "serialize")) for python in (OURS, THEIRS))
    assert len(ours) > MESSAGES
    assert json.loads(built.run(OURS, END, "compare", stdin=json.dumps(theirs))) == dict.fromkeys(ours, 0)
    without_rest = {name: octets[: len(ours[name])] for name, octets in theirs.items()}
    assert {name for name in ours if len(theirs[name]) - len(ours[name]) > 6} <= {"WStrings"}
    assert json.loads(built.run(OURS, END, "deserialize", stdin=json.dumps(without_rest))) == [*ours]
    assert json.loads(built.run(THEIRS, END, "deserialize", stdin=json.dumps(ours))) == [*ours]


def test_messages_and_services_pass(
    built: Built,
    direction: str,
    domain_id: int,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    started = []
    for verb, vendor in zip(("publish", "receive"), vendors(direction), strict=True):
        environment = built.environment(vendor, domain_id)
        started.append(start_program(built.python(vendor), END, verb, env=environment))
    publisher, receiver = started
    receiver.wait(60.0)
    lines = [line for line in receiver.lines if line.startswith(("message", "response"))]
    assert len(lines) == MESSAGES + 3, receiver.output
    assert all(line.endswith("True") for line in lines), lines
    assert [line for line in publisher.lines if line.startswith("request")] == ["request True"] * 3


def test_a_command_prints_what_the_real_rclpy_publishes(
    built: Built, domain_id: int, start_program: Callable[..., Program], wait_until: Callable[..., None]
) -> None:
    publisher = start_program(built.python(THEIRS), END, "publish", env=built.environment(THEIRS, domain_id))
    wait_until(lambda: "ready" in publisher.lines, 60.0, "the publisher")
    quality = ("--qos-durability", "transient_local", "--qos-reliability", "reliable")
    environment = built.environment(OURS, domain_id)
    words = ("-m", "tfloom", "topic", "echo", "--once", *quality)
    topic = ("/topic_WStrings", "test_msgs/msg/WStrings")
    echo = start_program(sys.executable, *words, *topic, env=environment)
    assert echo.wait(60.0) == 0, echo.output
    assert "wstring_value: hällo ハ 93" in echo.lines, echo.output
    assert echo.lines[-1] == "---"


def test_idl_files_define_what_the_definitions_do(built: Built) -> None:
    """Each .idl file of the peer was generated from a definition by ROS's own adapter."""
    compared = 0
    for path in sorted(built.share.glob("*/*/*.idl")):
        package, kind, base = path.parent.parent.name, path.parent.name, path.stem
        definition = path.with_suffix(f".{kind}")
        if not definition.is_file():
            continue
        name = f"{package}/{kind}/{base}"
        idl, text = (
            PackageDefinitions(package, {name: source}, [built.share.parent]) for source in (path, definition)
        )
        whole = {
            f"{package}/{other.parent.name}/{other.stem}": other
            for other in (built.share / package).glob("*/*.*")
            if other.suffix == f".{other.parent.name}"
        }
        known = PackageDefinitions(package, whole, [built.share.parent])
        ours, theirs = idl.find_interface(name), text.find_interface(name)
        assert content(ours) == content(theirs)
        assert type_hash(ours, known.find_message) == type_hash(theirs, known.find_message)
        compared += 1
    assert compared > 150


def content(interface: spec.Interface) -> list[object]:
    """Return what the .idl file and the definition have in common; `char` is uint8 in both."""
    return [
        (
            message.name,
            [
                (field.name, str(field.type).replace("char", "uint8"), field.default)
                for field in message.fields
            ],
            [
                (constant.name, str(constant.type).replace("char", "uint8"), constant.value)
                for constant in message.constants
            ],
        )
        for message in spec.messages_of(interface)
    ]


def test_idl_contents_equal_the_references(built: Built) -> None:
    names = (
        "test_msgs/msg/Arrays",
        "test_msgs/msg/WStrings",
        "test_msgs/msg/Constants",
        "std_msgs/msg/Header",
    )
    files = [built.share / f"{name}.idl" for name in names]
    theirs = json.loads(built.run(THEIRS, PROGRAMS / "idl_contents.py", *files))
    assert json.loads(json.dumps({str(path): idl_contents.contents(path) for path in files})) == theirs


def test_run_dependencies_equal_the_references(built: Built) -> None:
    folder = built.share / "ament_index" / "resource_index" / "package_run_dependencies"
    packages = [path for path in folder.iterdir() if (built.share / path.name / "msg").is_dir()]
    assert len(packages) > 5
    for path in packages:
        manifest = read_manifest(built.share / path.name / "package.xml")
        assert list(manifest.run) == path.read_text("utf-8").split(";"), path.name
