"""Transforms from publishers of both kinds, through the drop-in listener of a real rclpy node."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.drop_in.conftest import PROGRAMS, Peer

pytestmark = pytest.mark.ros

TOPICS = ("/tf", "/tf_static")
WITHOUT_TRANSPORT = "<CycloneDDS><Domain><General><Transport>none</Transport></General></Domain></CycloneDDS>"
"""A configuration of tfloom's reader by which it discovers nobody; Fast DDS does not read it."""


class Listener:
    """A drop-in listener in a process of the real rclpy, which answers queries."""

    def __init__(
        self, real_ros: Peer, domain_id: int, raw: str = "", *arguments: str, init: str = "", **options: Any
    ) -> None:
        self.program = real_ros.start(
            "listen", raw, init, *arguments, domain_id=domain_id, PYTHONFAULTHANDLER="1", **options
        )
        self._asked = 0

    def ready(self, why_raw: str = "''") -> None:
        self.program.wait_for("ready: ", 60.0)
        assert any(f"ready: {why_raw}" in line for line in self.program.lines), self.program.output

    def answers(self) -> list[Any]:
        return [json.loads(line) for line in self.program.lines if line.startswith("{")]

    def query(self, target: str, source: str, timeout_s: float = 60.0) -> Any:
        self.program.process.stdin.write(json.dumps([target, source, timeout_s]) + "\n")
        self.program.process.stdin.flush()
        self._asked += 1
        end = time.monotonic() + timeout_s + 30.0
        while len(self.answers()) < self._asked:
            assert time.monotonic() < end, self.program.output
            assert self.program.process.poll() is None, self.program.output
            time.sleep(0.005)
        return self.answers()[-1]

    def end(self) -> None:
        self.program.process.stdin.close()
        assert self.program.wait() == 0, self.program.output
        assert "ended" in self.program.lines


@pytest.fixture
def listen(real_ros: Peer, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Listener]:
    started = real_ros._start

    def start(*words: Any, **options: Any) -> Any:
        return started(*words, **{"stdin": subprocess.PIPE, **options})

    monkeypatch.setattr(real_ros, "_start", start)
    return lambda *words, **options: Listener(real_ros, *words, **options)


def publish(
    publisher: str,
    real_ros: Peer,
    start: Callable[..., Any],
    domain_id: int,
    topics: tuple[str, str] = TOPICS,
) -> Any:
    if publisher == "rclpy":
        program = real_ros.start("publish", *topics, domain_id=domain_id)
    else:
        program = start(sys.executable, PROGRAMS / "publish.py", *topics)
    program.wait_for("ready", 60.0)
    return program


@pytest.mark.parametrize("publisher", ["tfloom", "rclpy"])
@pytest.mark.parametrize(("raw", "why"), [("reader", "''"), ("raw", "'it was requested'")])
def test_transforms_of_both_kinds_of_publishers_arrive(
    publisher: str, raw: str, why: str, listen: Any, real_ros: Peer, domain_id: int, start_program: Any
) -> None:
    publish(publisher, real_ros, start_program, domain_id)  # before: /tf_static is for a late joiner
    listener = listen(domain_id, raw)
    listener.ready(why)
    assert listener.query("world", "camera")["x"] == 11.5
    first = listener.query("world", "turtle")
    assert first["x"] == 1.5
    assert abs(first["stamp_ns"] / 1e9 - time.time()) < 30.0
    while listener.query("world", "turtle")["stamp_ns"] == first["stamp_ns"]:
        time.sleep(0.01)
    assert listener.query("world", "camera")["why_raw"] == why.strip("'")
    listener.end()


@pytest.mark.parametrize("raw", ["reader", "raw"])
def test_topics_are_remapped_by_the_rules_of_the_node(
    raw: str, listen: Any, real_ros: Peer, domain_id: int, start_program: Any
) -> None:
    publish("tfloom", real_ros, start_program, domain_id, ("/robot/tf", "/robot/tf_static"))
    rules = ["--ros-args", "-r", "/tf:=tf", "-r", "/tf_static:=tf_static"]
    listener = listen(domain_id, raw, *rules)
    assert listener.query("world", "camera")["x"] == 11.5
    listener.end()


def test_domain_is_that_of_the_context(
    listen: Any, real_ros: Peer, domain_id: int, start_program: Any
) -> None:
    publish("tfloom", real_ros, start_program, domain_id)
    listener = listen(0, "reader", init=str(domain_id))
    assert listener.query("world", "camera")["x"] == 11.5
    listener.end()


def test_without_the_dds_library_it_is_a_raw_subscription(
    listen: Any, real_ros: Peer, domain_id: int, start_program: Any, site_without_dds: Path, tmp_path: Path
) -> None:
    publish("rclpy", real_ros, start_program, domain_id)
    # The system may have its own library.
    hidden = (
        "from tfloom.rmw.cyclone import library as cyclone_library\ncyclone_library._SYSTEM_FOLDERS = ()\n"
    )
    (tmp_path / "sitecustomize.py").write_text(hidden)
    listener = listen(domain_id, paths=[tmp_path, site_without_dds])
    listener.ready('"there is no DDS: install one with')
    assert listener.query("world", "camera")["x"] == 11.5
    listener.end()


def test_listener_becomes_a_raw_subscription_if_the_reader_misses_publishers(
    listen: Any, real_ros: Peer, domain_id: int, start_program: Any
) -> None:
    publish("rclpy", real_ros, start_program, domain_id)
    listener = listen(domain_id, CYCLONEDDS_URI=WITHOUT_TRANSPORT)
    listener.ready()
    answer = listener.query("world", "camera")
    assert answer["x"] == 11.5
    assert (
        answer["why_raw"] == "the own reader has not discovered /publisher on /tf, /publisher on /tf_static"
    )
    assert "From now on a raw subscription of this node takes its place" in listener.program.output
    listener.end()


def test_requested_reader_that_misses_publishers_warns(
    listen: Any, real_ros: Peer, domain_id: int, start_program: Any
) -> None:
    publish("rclpy", real_ros, start_program, domain_id)
    listener = listen(domain_id, TFLOOM_DROP_IN="reader", CYCLONEDDS_URI=WITHOUT_TRANSPORT)
    listener.program.wait_for("has not discovered publishers that this node knows: /publisher on /tf", 60.0)
    assert listener.query("world", "camera", 0.1) == {
        "error": 'LookupException: "world" passed to lookupTransform argument target_frame does not exist. ',
        "why_raw": "",
    }
    listener.end()


@pytest.mark.skipif(sys.platform != "linux", reason="network namespaces are Linux's")
@pytest.mark.parametrize("first", ["publisher", "listener"])
def test_stock_settings_on_one_host(
    first: str, real_ros: Peer, domain_id: int, start_program: Any, tmp_path: Path
) -> None:
    """Without a variable of discovery, Fast DDS searches the subnet by multicast, and tfloom this machine.

    It runs in a network namespace that has a loopback interface alone. The second program starts when the first one has
    printed a line.
    """
    if shutil.which("ip") is None or subprocess.run(["unshare", "-rn", "true"], check=False).returncode != 0:
        pytest.skip("a user may not create network namespaces here, or there is no ip command")
    programs = (PROGRAMS / f"{name}.py" for name in ("publish", "listen"))
    publish, listen = (shlex.join([str(real_ros.peer.python), str(program)]) for program in programs)
    publish, listen = f"{publish} /tf /tf_static", f"{listen} '' ''"
    ends = {
        "publisher": f"exec 3<&0; {publish} | (read line; {listen} <&3)",
        "listener": f"mkfifo ready; (read line; {publish}) <ready & {listen} | tee ready",
    }
    network = "ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 1"
    environment = real_ros.peer.environment(domain_id, PYTHONPATH=os.pathsep.join(map(str, real_ros.sites)))
    del environment[real_ros.peer.release.profile_variable]
    program = start_program(
        *("unshare", "-rn", "sh", "-c", f"{network}\n{ends[first]}"),
        env=environment,
        stdin=subprocess.PIPE,
        cwd=tmp_path,
    )
    program.process.stdin.write('["world", "camera", 60.0]\n["world", "turtle", 60.0]\n')
    program.process.stdin.flush()
    program.wait_for('{"x": 1.5', 120.0)
    answers = [json.loads(line) for line in program.lines if line.startswith("{")]
    assert [(answer["x"], answer["why_raw"]) for answer in answers] == [(11.5, ""), (1.5, "")], program.output


def test_program_with_a_listener_ends_at_ctrl_c(real_ros: Peer, domain_id: int, start_program: Any) -> None:
    publish("tfloom", real_ros, start_program, domain_id)
    program = real_ros.start("spin", domain_id=domain_id)
    program.wait_for("found", 60.0)
    program.signal(signal.SIGINT)
    assert program.wait() == 0, program.output
    assert "ended" in program.lines
    assert "Traceback" not in program.output
