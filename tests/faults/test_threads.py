"""Each thread of the library can't be started, starts late or ends early: one clear error, or all goes on."""

from __future__ import annotations

import _thread
import ast
import asyncio
import errno
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import urllib.request
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.bag.written_bags import START_NS, STEP_NS, text, topic
from tests.conftest import run_to_end, wait_until
from typing_extensions import Self

import tfloom
from tfloom.bag import key_presses, open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.player import Player
from tfloom.bag.playing.read_ahead import ReadAhead
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.cli.shared import child
from tfloom.demos import processes
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.launch.logs.background_writing import BackgroundWriting
from tfloom.launch.ros.ros_adapters import ROSAdapter
from tfloom.launch.testing.ros.topics import MessagePump
from tfloom.node.context.context import Context
from tfloom.node.executing import signals
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.rmw import services
from tfloom.rmw.base import RequestId
from tfloom.rmw.postponed_interrupt import postponed
from tfloom.rmw.zenoh.announced import AnnouncedTokens
from tfloom.tf2_ros import deadlines
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.viewer import page_server
from tfloom.viewer.inline_page import InlinePage
from tfloom.viewer.page_server import PageServer, ServerError
from tfloom.viewer.published_joints import published_joints

SOURCE = Path(tfloom.__path__[-1])
NO_THREAD = "can't start new thread"
STARTS = {"Thread", "Timer", "ThreadPoolExecutor", "start_new_thread"}
TOLD = "its program ends with the error of the start"
PLACES = {
    "bag/key_presses.py": ["keys"],
    "bag/playing/player.py": ["player"],
    "bag/playing/read_ahead.py": ["read_ahead"],
    "bag/recording/discovery.py": ["recorder"],
    "bag/recording/recorder.py": ["recorder"],
    "bag/rosbag2_names/nodes.py": ["spinning"],
    "cli/shared/child.py": ["child"],
    "demos/child.py": [TOLD],
    "demos/demo_nodes_py/use_logger_service.py": [TOLD],
    "demos/processes.py": ["demo_process"],
    "demos/threads.py": [TOLD],
    "launch/logs/background_writing.py": ["launch_output"],
    "launch/ros/actions/lifecycle_node.py": ["raised in the event handler, which ends the launch"],
    "launch/ros/ros_adapters.py": ["ros_adapter"],
    "launch/testing/ros/topics.py": ["message_pump", "raised to the test that waits"],
    "launch/testing/test_runner.py": [TOLD],
    "node/async_node.py": [
        "refused: tests/node/test_async_node.py, where the node runs when there is room again"
    ],
    "node/context/context.py": ["shutdown_hooks"],
    "node/endpoints/arrivals.py": [
        "refused: tests/node/test_later_releases.py, where messages are taken as before"
    ],
    "node/executing/executors.py": ["pool"],
    "node/executing/signals.py": ["postponed_interrupt"],
    "rmw/cyclone/threads.py": ["participant"],
    "rmw/services.py": ["held_requests", "late_response"],
    "rmw/zenoh/announced.py": ["announced_tokens"],
    "rmw/zenoh/events.py": ["refused: tests/rmw/test_zenoh_wire.py, where the endpoint is not opened then"],
    "rmw/zenoh/feeder.py": ["refused: tests/rmw/test_zenoh_wire.py, where the reader isn't fed then"],
    "rmw/zenoh/meeting_point.py": ["refused: tests/rmw/test_zenoh_session.py, which closes the session then"],
    "rmw/zenoh/session.py": [
        "refused: tests/rmw/test_zenoh_session.py, which closes the session nevertheless"
    ],
    "robot/xacro_program.py": [TOLD],
    "tf2_ros/deadlines.py": ["deadline"],
    "tf2_ros/listener_base.py": ["listener"],
    "turtlesim/teleop_key.py": [TOLD],
    "foxglove/bridge.py": [
        "stopped by the caller: tests/foxglove/test_stuck_clients.py, which refuses the thread"
    ],
    "foxglove/relay.py": ["the bridge doesn't start: tests/foxglove/test_relay.py, which refuses the thread"],
    "foxglove/own_client.py": ["a warning: tests/foxglove/test_own_client.py, which refuses the thread"],
    "viewer/driving/link.py": [
        "refused: tests/viewer/test_driving.py, where a page hears it, and drives later"
    ]
    * 2,
    "viewer/driving/process.py": ["its viewer is told, and starts it again: tests/viewer/test_driving.py"],
    "viewer/forms/sending.py": [TOLD],
    "viewer/inline_page.py": ["inline_page"],
    "viewer/page_server.py": ["page_server"],
    "viewer/parameters.py": [TOLD],
    "viewer/published_joints.py": ["published_joints"],
}
"""By file, one entry for each place that starts threads: the row that refuses it one, or why there is none."""


@contextmanager
def no_threads() -> Iterator[None]:
    """Let the system refuse all new threads."""

    def refuse(*_: Any, **__: Any) -> None:
        raise RuntimeError(NO_THREAD)

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(threading.Thread, "start", refuse)
        patched.setattr(_thread, "start_new_thread", refuse)
        yield


@contextmanager
def late_threads() -> Iterator[Callable[[], None]]:
    """Let each new thread wait before it does anything, until the function that this yields is called."""
    gate = threading.Event()
    run = threading.Thread.run

    def wait_and_run(thread: threading.Thread) -> None:
        assert gate.wait(30)
        run(thread)

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(threading.Thread, "run", wait_and_run)
        yield gate.set
        gate.set()


@pytest.fixture(autouse=True)
def _threads_end() -> Iterator[None]:
    """Check that no thread is left."""
    before = set(threading.enumerate())
    yield
    wait_until(
        lambda: not {thread.name for thread in set(threading.enumerate()) - before} - {"tf2_deadlines"}
    )


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    writer = BagWriter(tmp_path / "bag", WriterSettings())
    channel = writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
    for number in range(10):
        writer.push(channel, text(number), START_NS + number * STEP_NS, START_NS + number * STEP_NS)
    writer.close()
    return tmp_path / "bag"


def test_every_place_that_starts_threads_has_a_row() -> None:
    found: Counter[str] = Counter()
    for path in sorted(SOURCE.rglob("*.py")):
        source = path.read_text("utf-8")
        if not any(name in source for name in STARTS):
            continue  # because it takes long to parse all files
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.Call):
                function = node.func
                name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
                if name in STARTS and not (name == "Timer" and isinstance(function, ast.Name)):
                    found[path.relative_to(SOURCE).as_posix()] += 1
    assert dict(found) == {path: len(rows) for path, rows in PLACES.items()}, (
        "PLACES of tests/faults/test_threads.py: each call that starts a thread gets a row"
    )
    tests = {name.removeprefix("test_").removesuffix("_without_a_thread") for name in globals()}
    assert {row for rows in PLACES.values() for row in rows if row.isidentifier()} <= tests


# Executors


def test_pool_without_a_thread(local_context: Context) -> None:
    """The spin says that it has no thread; the callback is not lost, and runs when there is one."""
    called: list[int] = []
    with MultiThreadedExecutor(2, context=local_context) as executor:
        executor.create_task(lambda: called.append(1))
        with no_threads():
            for _ in range(3):
                with pytest.raises(
                    RuntimeError, match=f"{NO_THREAD}. Spin again when there are fewer threads"
                ):
                    executor.spin_once(timeout_sec=1)
        assert called == []
        executor.spin_once(timeout_sec=0.01)
        wait_until(lambda: called == [1])


def test_pool_with_one_thread_of_two(local_context: Context) -> None:
    """If one thread could be started, the callbacks run on it, and nothing is reported."""
    called: list[int] = []
    with MultiThreadedExecutor(2, context=local_context) as executor:
        first = executor.create_task(lambda: called.append(0))
        executor.spin_until_future_complete(first, 30)
        with no_threads():
            tasks = [
                executor.create_task(lambda number=number: called.append(number)) for number in (1, 2, 3)
            ]
            for task in tasks:
                executor.spin_until_future_complete(task, 30)
    assert called == [0, 1, 2, 3]


def test_pool_whose_threads_are_late(local_context: Context, make_node: Callable[..., Node]) -> None:
    node = make_node("under_test")
    arrived: list[int] = []
    publisher = node.create_publisher(Int32, "numbers", 10)
    node.create_subscription(Int32, "numbers", lambda message: arrived.append(message.data), 10)
    with late_threads() as begin, MultiThreadedExecutor(2, context=local_context) as executor:
        executor.add_node(node)
        for number in range(3):
            publisher.publish(Int32(data=number))
        executor.spin_once(timeout_sec=1)
        assert arrived == []
        begin()
        while len(arrived) < 3:
            executor.spin_once(timeout_sec=0.1)
    assert arrived == [0, 1, 2]


def test_executor_that_is_shut_down_before_its_thread_has_begun(local_context: Context) -> None:
    with late_threads() as begin:
        executor = MultiThreadedExecutor(2, context=local_context)
        executor.create_task(lambda: None)
        executor.spin_once(timeout_sec=1)
        assert executor.shutdown(timeout_sec=0.05)  # nothing runs
        begin()


# Signals


def test_shutdown_hooks_without_a_thread(local_context: Context) -> None:
    """A signal arrives when there is no thread for the hooks: they run when the program ends the context."""
    called: list[None] = []
    local_context.on_shutdown(lambda: called.append(None))
    with no_threads():
        local_context.interrupt()
    assert (local_context.ok(), called) == (False, [])
    local_context.try_shutdown()
    assert called == [None]


def test_postponed_interrupt_without_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """The KeyboardInterrupt stays postponed, for the next spin, and the handler raises nothing else."""
    monkeypatch.setattr(signals, "_may_interrupt", lambda _: False)
    postponed.set(float("inf"))
    with no_threads():
        signals._interrupt_main_thread(sys._getframe())
    assert isinstance(signals.shutdown_exception(), KeyboardInterrupt)
    assert signal.getsignal(signal.SIGINT) is not None


# Transforms


def test_deadline_without_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """No request is left in the buffer, and no call for later."""
    monkeypatch.setattr(deadlines, "_thread", None)
    buffer = Buffer()
    before = len(deadlines._functions)
    with no_threads(), pytest.raises(RuntimeError, match=NO_THREAD):
        buffer.wait_for_transform_async("map", "base", Time(seconds=1), Duration(seconds=1))
    assert len(deadlines._functions) == before
    assert not buffer.cancel_request(1)


def test_deadline_whose_thread_is_late(monkeypatch: pytest.MonkeyPatch) -> None:
    called = threading.Event()
    own = threading.Condition()
    for name, value in (("_thread", None), ("_changed", own), ("_waiting", []), ("_functions", {})):
        monkeypatch.setattr(deadlines, name, value)
    with late_threads() as begin:
        deadlines.call_after(0.0, called.set)
        assert not called.wait(0.05)
        begin()
        assert called.wait(30)


@pytest.mark.parametrize("owns_node", [False, True])
def test_listener_without_a_thread(owns_node: bool, node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """No subscription is left, and the node goes on in the executor that it was in."""
    made: list[Node] = []

    def hidden() -> Node:
        made.append(Node("hidden", context=node.context))
        return made[0]

    monkeypatch.setattr("tfloom.tf2_ros.transform_listener._hidden_node", hidden)
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        before = len(list(node.subscriptions))
        with no_threads(), pytest.raises(RuntimeError, match=f"needs a thread: {NO_THREAD}"):
            TransformListener(Buffer(), None if owns_node else node, spin_thread=True)
        assert len(list(node.subscriptions)) == before
        assert node.executor is executor
        assert node.get_node_names() == ["under_test"]


def test_listener_whose_thread_is_late(node: Node) -> None:
    with late_threads() as begin:
        listener = TransformListener(Buffer(), node, spin_thread=True)
        assert listener.executor is not None
        listener.executor.shutdown()
        begin()
    assert listener.dedicated_listener_thread is not None
    listener.dedicated_listener_thread.join(30)
    assert not listener.dedicated_listener_thread.is_alive()
    listener.unregister()


# Participants

ROOMS = (0, 5, 8, 12)
"""Numbers of threads, of which the last is enough."""
PRELOADED = Path(__file__).parents[1] / "native" / "few_threads.c"


@pytest.mark.skipif(sys.platform != "linux" or shutil.which("cc") is None, reason="builds a library with cc")
def test_participant_without_a_thread(domain_id: int, tmp_path: Path) -> None:
    """A system has room for few more threads, or none: one sentence says so, or all works; and later all does."""
    library = tmp_path / "few_threads.so"
    subprocess.run(["cc", "-shared", "-fPIC", PRELOADED, "-o", library, "-ldl"], check=True)
    answers = []
    for room in ROOMS:
        done = run_to_end(
            [sys.executable, Path(__file__).with_name("few_threads.py"), str(room)],
            env={
                **os.environ,
                "LD_PRELOAD": f"{os.environ.get('LD_PRELOAD', '')} {library}",
                "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
            },
        )
        assert done.returncode == 0, (room, done.stdout + done.stderr)
        first, refused, second = done.stdout.splitlines()
        assert second == "worked"
        assert (first == "worked") or refused != "0", room
        answers.append(first)
    assert answers[0] == (
        f"WireError: cannot join DDS domain {domain_id}, which takes 8 threads: can't start new thread. End some "
        "program, or raise the limit of processes (ulimit -u)"
    )
    assert answers[-1] == "worked"
    assert {answer.split(":")[0] for answer in answers} <= {"WireError", "RuntimeError", "worked"}


# Pages


def test_announced_tokens_without_a_thread() -> None:
    """A listing may lack something then; the router is asked when there is a thread."""
    zenoh = pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed")
    asked = threading.Event()

    def open_client() -> Any:
        asked.set()
        raise zenoh.ZError("no router")

    tokens = AnnouncedTokens(open_client, "@ros2_lv/**")
    with no_threads():
        for _ in range(3):
            assert not tokens.are_here(lambda _: False)
    tokens.are_here(lambda _: False)
    assert asked.wait(30)
    tokens.close()
    asked.clear()
    assert not tokens.are_here(lambda _: False)
    assert not asked.is_set()


def test_page_server_without_a_thread() -> None:
    """One sentence says so, and the port is free again."""
    server = PageServer(SimpleNamespace(), lambda *_: None, lambda _: None)  # type: ignore[arg-type]
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
    with no_threads(), pytest.raises(ServerError, match=f"serving pages needs a thread: {NO_THREAD}"):
        server.start("127.0.0.1", port)
    server.stop()
    with socket.socket() as other:
        other.bind(("127.0.0.1", port))


@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (OSError(errno.EADDRINUSE, "Address already in use"), "Address already in use"),
        (RuntimeError("no loop"), "no loop"),
    ],
    ids=["system", "library"],
)
def test_page_server_that_fails_at_its_start(
    monkeypatch: pytest.MonkeyPatch, error: Exception, reason: str
) -> None:
    """The start raises rather than waits; the port and the thread are given back, and a later start works."""

    async def fail(*_: object, **__: object) -> None:
        raise error

    server = PageServer(SimpleNamespace(), lambda *_: None, lambda _: None)  # type: ignore[arg-type]
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
    with monkeypatch.context() as patch:
        patch.setattr(page_server, "serve", fail)
        with pytest.raises(ServerError, match=f"can't serve pages at 127.0.0.1:{port}: {reason}"):
            _within(lambda: server.start("127.0.0.1", port))
    assert "tfloom_view_pages" not in {thread.name for thread in threading.enumerate()}
    server.stop()
    _serves_then_stops(server, port)


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere two sockets can't share a port so")
def test_page_server_whose_port_is_taken_while_it_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another program that listens between the bind and the listen makes an error of the system."""
    real_serve = page_server.serve
    server = PageServer(SimpleNamespace(), lambda *_: None, lambda _: None)  # type: ignore[arg-type]
    with socket.socket() as other:
        other.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]

        async def serve_late(*arguments: Any, **options: Any) -> Any:
            other.listen()
            return await real_serve(*arguments, **options)

        monkeypatch.setattr(page_server, "serve", serve_late)
        with pytest.raises(ServerError, match=f"can't serve pages at 127.0.0.1:{port}: "):
            _within(lambda: server.start("127.0.0.1", port))
    monkeypatch.undo()
    _serves_then_stops(server, port)


def test_page_server_starts_after_a_start_without_a_thread() -> None:
    server = PageServer(SimpleNamespace(), lambda *_: None, lambda _: None)  # type: ignore[arg-type]
    with no_threads(), pytest.raises(ServerError, match=NO_THREAD):
        server.start("127.0.0.1", 0)
    _serves_then_stops(server, 0)


def test_page_server_whose_address_is_taken_leaves_nothing_open(monkeypatch: pytest.MonkeyPatch) -> None:
    loops: list[asyncio.AbstractEventLoop] = []
    real_new_event_loop = asyncio.new_event_loop

    def new_event_loop() -> asyncio.AbstractEventLoop:
        loops.append(real_new_event_loop())
        return loops[-1]

    monkeypatch.setattr(asyncio, "new_event_loop", new_event_loop)
    server = PageServer(SimpleNamespace(), lambda *_: None, lambda _: None)  # type: ignore[arg-type]
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(ServerError, match=f"can't listen at 127.0.0.1:{port}"):
            server.start("127.0.0.1", port)
    server.stop()
    assert len(loops) == 1
    assert loops[0].is_closed()


def _within(call: Callable[[], None], timeout_s: float = 20.0) -> None:
    """Call on another thread, and raise its `ServerError`; fail when it does not return."""
    raised: list[ServerError] = []

    def run() -> None:
        try:
            call()
        except ServerError as error:
            raised.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(timeout_s)
    assert not thread.is_alive(), "the call does not return"
    if raised:
        raise raised[0]


def _serves_then_stops(server: PageServer, port: int) -> None:
    _within(lambda: server.start("127.0.0.1", port))
    with urllib.request.urlopen(server.address, timeout=20.0) as response:
        assert response.status == 200
    server.stop()
    assert "tfloom_view_pages" not in {thread.name for thread in threading.enumerate()}


def test_inline_page_without_a_thread() -> None:
    """One error says so; what was not served is closed."""
    page = InlinePage(lambda *_: None, 600)
    with no_threads(), pytest.raises(RuntimeError, match=f"showing a page needs a thread: {NO_THREAD}"):
        page.start()
    assert not page.is_open
    page.close()


# Services with peers that take few requests


class Endpoint:
    """What a requester needs of its ends on the wire; it notes what is written."""

    gid = bytes(16)

    def __init__(self) -> None:
        self.written: list[bytes] = []

    def write(self, data: bytes) -> None:
        self.written.append(data)

    def try_write(self, data: bytes) -> bool:
        self.written.append(data)
        return True

    def close(self) -> None:
        """Do nothing."""


def test_held_requests_without_a_thread() -> None:
    """The request that is held is sent when the first one is answered."""
    servers: Any = SimpleNamespace(
        incompatibility=str, synchronise=lambda: None, most_in_flight=lambda: 1, is_ready=lambda: True
    )
    requests: Any = Endpoint()
    responses: Any = Endpoint()
    requester = services.HeaderRequester(requests, responses, servers, bytes(8))
    with no_threads():
        first = requester.send(bytes(8))
        requester.send(bytes(8))
        assert len(requests.written) == 1
        requester._in_flight.answered(requester, first)
    assert len(requests.written) == 2
    requester.close()


def test_late_response_without_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """The response to a client that is matched late is sent by the thread that has it."""
    monkeypatch.setattr(services, "CLIENT_WAIT_S", 0.0)
    looks = iter([False, False, False])
    clients: Any = SimpleNamespace(
        is_matched=lambda *_: next(looks, True), may_be_late=lambda _: True, synchronise=lambda: None
    )
    requests: Any = Endpoint()
    responses: Any = Endpoint()
    responder = services.HeaderResponder(requests, responses, clients)
    responder._remember(bytes(8), b"writer")
    with no_threads():
        responder.send(RequestId(bytes(16), 1), bytes(8))
    assert len(responses.written) == 1
    responder.close()


# Recordings


def recorder_of(folder: Path, context: Context) -> Recorder:
    options = RecordOptions(TopicChoice(["/late"]), polling_interval_s=0.01, has_keyboard=False)
    return Recorder(folder, WriterSettings(), options, context=context)


@pytest.mark.parametrize("started", [0, 1])
def test_recorder_without_a_thread(
    started: int, tmp_path: Path, local_context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    """None of its two threads, or the second alone: it says so, and leaves a bag that can be read."""
    start, count = threading.Thread.start, iter(range(10))

    def refuse_later(thread: threading.Thread) -> None:
        if next(count) >= started:
            raise RuntimeError(NO_THREAD)
        start(thread)

    recorder = recorder_of(tmp_path / "bag", local_context)
    channel = recorder.writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
    recorder.writer.queue.push(channel, text(1), START_NS, START_NS)
    with monkeypatch.context() as patched:
        patched.setattr(threading.Thread, "start", refuse_later)
        with pytest.raises(BagError, match=f"recording needs two threads: {NO_THREAD}"):
            recorder.start()
    recorder.stop()
    recorder.destroy_node()
    with open_bag(tmp_path / "bag") as recorded:
        assert recorded.message_count == 1


def test_recorder_whose_threads_are_late(tmp_path: Path, local_context: Context) -> None:
    """What arrives before its threads begin is written, also where it is stopped before."""
    recorder = recorder_of(tmp_path / "bag", local_context)
    with late_threads() as begin:
        recorder.start()
        channel = recorder.writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
        recorder.writer.queue.push(channel, text(1), START_NS, START_NS)
        recorder._ended.set()
        begin()
    recorder._ended.clear()
    recorder.stop()
    recorder.destroy_node()
    with open_bag(tmp_path / "bag") as recorded:
        assert recorded.message_count == 1


def test_spinning_without_a_thread(tmp_path: Path, ros_domain: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A recorder of rosbag2_py says so, and can be spun later."""
    import rosbag2_py

    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(ros_domain))
    recorder = rosbag2_py.Recorder(
        rosbag2_py.StorageOptions(str(tmp_path / "bag")), rosbag2_py.RecordOptions()
    )
    with no_threads(), pytest.raises(RuntimeError, match=NO_THREAD):
        recorder.start_spin()
    recorder.start_spin()
    recorder.stop_spin()


def test_player_without_a_thread(bag: Path, local_context: Context) -> None:
    with open_bag(bag) as opened:
        player = Player(opened, PlayOptions(clock_hz=10.0), context=local_context)
        with no_threads(), pytest.raises(BagError, match=f"can't be played: {NO_THREAD}"):
            player.start()
        player.start()
        wait_until(player.ended.is_set)
        with no_threads():
            assert not player.play_again(opened.start_ns, opened.end_ns)
        assert player.ended.is_set()  # else whoever waits for it would wait for ever
        player.stop()
        player.destroy_node()


def test_player_whose_threads_are_late(bag: Path, local_context: Context) -> None:
    with open_bag(bag) as opened:
        player = Player(opened, PlayOptions(rate=100.0), context=local_context)
        with late_threads() as begin:
            player.start()
            assert not player.ended.is_set()
            begin()
            wait_until(player.ended.is_set)
        player.stop()
        player.destroy_node()


def test_player_whose_thread_ends_early(
    bag: Path, local_context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Any exception of its thread is its failure; the end alone would look like that of the bag."""
    with open_bag(bag) as opened:
        player = Player(opened, PlayOptions(), context=local_context)

        def fail() -> None:
            raise KeyError("inside")

        monkeypatch.setattr(player.playback, "run", fail)
        player.start()
        wait_until(player.ended.is_set)
        player.stop()
        assert "playing has ended: KeyError: 'inside'" in str(player.failure)
        player.destroy_node()


def test_read_ahead_without_a_thread(bag: Path, local_context: Context) -> None:
    """Where the thread that reads can't be started, the player fails."""
    with no_threads(), pytest.raises(BagError, match=f"bag: it can't be read ahead: {NO_THREAD}"):
        ReadAhead("bag", iter(()), 100)
    start = threading.Thread.start
    with open_bag(bag) as opened:
        player = Player(opened, PlayOptions(), context=local_context)

        def refuse(thread: threading.Thread) -> None:
            if getattr(thread, "_target", None).__name__ == "_read":
                raise RuntimeError(NO_THREAD)
            start(thread)

        with pytest.MonkeyPatch.context() as patched:
            patched.setattr(threading.Thread, "start", refuse)
            player.start()
            wait_until(player.ended.is_set)
        player.stop()
        assert NO_THREAD in str(player.failure)
        player.destroy_node()


class Keys:
    """A terminal on which the same key is pressed until `close`."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Do nothing."""

    def read(self, _: float) -> list[str]:
        threading.Event().wait(0.001)
        return ["up"]


def test_keys_without_a_thread(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(key_presses, "Keyboard", Keys)
    with no_threads(), key_presses.handled_keys({"up": print}):
        pass
    assert f"Keyboard handling disabled: {NO_THREAD}." in capsys.readouterr().err


def test_keys_go_on_after_an_action_that_raises(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(key_presses, "Keyboard", Keys)
    monkeypatch.setattr(key_presses, "without_repetitions", lambda keys: keys)
    reported: list[BaseException | None] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: reported.append(args.exc_value))
    pressed: list[None] = []

    def act() -> None:
        pressed.append(None)
        if len(pressed) == 1:
            raise ValueError("of the first key")

    with key_presses.handled_keys({"up": act}):
        wait_until(lambda: len(pressed) > 2)
    assert [str(error) for error in reported] == ["of the first key"]


# Launches, tests and demos


@pytest.fixture
def _local(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


@pytest.mark.usefixtures("_local")
def test_ros_adapter_without_a_thread() -> None:
    """No node is left, and it can be started later."""
    adapter = ROSAdapter(argv=[], autostart=False)
    with no_threads(), pytest.raises(RuntimeError, match=f"the launch's node has no thread: {NO_THREAD}"):
        adapter.start()
    assert (adapter.ros_node, adapter.ros_context, adapter.ros_executor) == (None, None, None)
    adapter.start()
    adapter.shutdown()


@pytest.mark.usefixtures("_local")
def test_ros_adapter_that_is_shut_down_before_its_thread_has_begun() -> None:
    adapter = ROSAdapter(argv=[], autostart=False)
    with late_threads() as begin:
        adapter.start()
        assert adapter._executor is not None
        adapter._executor.shutdown()
        begin()
    adapter.shutdown()


@pytest.mark.usefixtures("_local")
def test_published_joints_without_a_thread() -> None:
    """No node is left, and they can be published later."""
    robot = '<robot name="robot"><link name="base"/></robot>'
    with (
        no_threads(),
        pytest.raises(RuntimeError, match=f"the joints have no thread: {NO_THREAD}"),
        published_joints(robot, pytest.fail),
    ):
        pytest.fail("it has a thread")
    with published_joints(robot, pytest.fail) as joints:
        assert joints.rows() == []
        assert joints._publisher.count_publishers("/joint_states") == 1  # none of the first


def test_launch_output_without_a_thread() -> None:
    """What a launch prints is then written by the caller."""
    writing = BackgroundWriting()

    async def write() -> None:
        async with writing.running(lambda *_: None):
            with no_threads():
                assert writing.writer("screen") is None
            assert writing.writer("screen") is not None

    asyncio.run(write())


def test_message_pump_without_a_thread(node: Node) -> None:
    pump = MessagePump(node)
    with no_threads(), pytest.raises(RuntimeError, match=NO_THREAD):
        pump.start()
    pump.stop()


def test_message_pump_goes_on_after_a_callback_that_raises(
    node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    reported: list[BaseException | None] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: reported.append(args.exc_value))
    ticks: list[None] = []

    def tick() -> None:
        ticks.append(None)
        if len(ticks) == 1:
            raise ValueError("of the first tick")

    node.create_timer(0.001, tick)
    pump = MessagePump(node)
    pump.start()
    wait_until(lambda: len(ticks) > 2)
    pump.stop()
    assert [str(error) for error in reported] == ["of the first tick"]


def test_demo_process_without_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """The process that was started, whose output nobody would read, is ended."""
    started: list[Any] = []
    popen = processes.subprocess.Popen

    def note(*args: Any, **options: Any) -> Any:
        started.append(popen(*args, **options))
        return started[-1]

    with monkeypatch.context() as patched, no_threads():
        patched.setattr(processes.subprocess, "Popen", note)
        with pytest.raises(RuntimeError, match=NO_THREAD):
            processes.ProcessProgram(["time:sleep", "600"], {})
    assert started[0].poll() is not None
    started[0].stdout.close()
    started[0].stdin.close()


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_child_without_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """A signal is passed on at once."""
    code = "import os, signal; os.kill(os.getppid(), signal.SIGTERM); signal.pause()"
    monkeypatch.setattr(child, "_child_setup", lambda _: None)
    with no_threads():
        assert child.run_child([sys.executable, "-c", code]) == -signal.SIGTERM
