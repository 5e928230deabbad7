"""Many threads on one buffer and on its messages, with the GIL and without."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
import threading
from collections.abc import Callable, Iterator
from time import monotonic

import numpy as np
import pytest
from tests.tf2_ros.conftest import transform_stamped

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer

SECOND = 1_000_000_000
HAS_NO_GIL = bool(sysconfig.get_config_var("Py_GIL_DISABLED"))
WAIT_S = 20.0

needs_no_gil = pytest.mark.skipif(not HAS_NO_GIL, reason="this Python has a GIL: it's no free-threaded build")


def run_together(*works: Callable[[], None]) -> None:
    """Run each function on a thread, all started at once, and raise an exception of any of them."""
    barrier = threading.Barrier(len(works))
    raised: list[BaseException] = []

    def run(work: Callable[[], None]) -> None:
        barrier.wait(60)
        try:
            work()
        except BaseException as error:  # noqa: BLE001, it's raised below
            raised.append(error)

    threads = [threading.Thread(target=run, args=(work,)) for work in works]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if raised:
        raise raised[0]


def message(x: float, stamp: int) -> TransformStamped:
    return transform_stamped("a", "b", stamp, (x, 0.0, 0.0))


def test_lookups_while_others_insert() -> None:
    buffer = Buffer(None)
    steps = 500
    # Each link is constant over time, so any result has a known length.
    for link in range(3):
        buffer.set(f"f{link}", f"f{link + 1}", SECOND, (link + 1.0, 0, 0), (0, 0, 0, 1))

    def insert(parity: int) -> None:
        for step in range(parity, steps, 2):
            for link in range(3):
                place = f"f{link}", f"f{link + 1}", SECOND + step
                buffer.set(*place, (link + 1.0, 0, 0), (0, 0, 0, 1), static=link == 1 and step % 250 == 0)

    def look_up() -> None:
        for step in range(steps):
            if buffer.can("f0", "f3", stamp := SECOND + step % 7):
                poses = buffer.lookup_many("f0", "f3", [stamp] * 600, strict=False, workers=2)
                assert poses.positions[poses.known, 0] == pytest.approx(6)
            assert buffer.lookup("f0", "f1").translation[0] == 1.0

    run_together(lambda: insert(0), lambda: insert(1), look_up, look_up)


def test_latest_common_time_and_its_transform_belong_together() -> None:
    buffer = Buffer()
    is_over = threading.Event()

    def insert() -> None:
        for step in range(2, 8_000):
            for pair in (("a", "b"), ("b", "c")):
                buffer.set(*pair, step * 1000, (step, 0, 0), (0, 0, 0, 1))
        is_over.set()

    def look_up() -> None:
        newest = 0
        while not is_over.is_set():
            transform = buffer.lookup("a", "c")
            assert transform.stamp_ns >= newest
            newest = transform.stamp_ns
            assert transform.translation[0] == pytest.approx(newest / 500)

    for child in "bc":
        buffer.set("a" if child == "b" else "b", child, 1000, (1, 0, 0), (0, 0, 0, 1))
    run_together(insert, *[look_up] * 4)


def test_messages_that_change_while_they_are_read() -> None:
    buffer = Buffer(None)
    shared = TFMessage(transforms=[message(1.0, SECOND)])
    rounds = 1500

    def change() -> None:
        for step in range(rounds):
            # Nothing else references the former value, so it is freed at once.
            shared.transforms[0].transform.translation.x = float(step)
            shared.transforms[0].header = message(0.0, SECOND + step).header
            shared.transforms[0].child_frame_id = f"frame number {step}"
            shared.transforms = [message(float(step), SECOND + step)] * (1 + step % 3)

    def read() -> None:
        for _ in range(rounds):
            assert cdr.decode(TFMessage, cdr.encode(shared)).transforms
            assert buffer.set_message(shared.transforms[0], "me")

    run_together(change, read, read)


def test_first_message_on_many_threads() -> None:
    # In a separate process, where no plan has been compiled.
    program = """
import threading
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.values.time import Time
from tfloom.tf2.buffer import Buffer

buffer = Buffer()
buffer.set("a", "b", 1, (1, 2, 3), (0, 0, 0, 1))
barrier = threading.Barrier(8)
answers = []

def look_up():
    barrier.wait()
    answers.append(buffer.lookup_message("a", "b", Time()).transform.translation.y)

threads = [threading.Thread(target=look_up) for _ in range(8)]
for thread in threads: thread.start()
for thread in threads: thread.join()
assert answers == [2.0] * 8, answers
"""
    subprocess.run([sys.executable, "-c", program], check=True, timeout=120)


@pytest.fixture
def no_switching() -> Iterator[None]:
    """Set the GIL's switch interval to 60 s, so that another thread runs only when the GIL is released."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(60)
    yield
    sys.setswitchinterval(before)


def rows(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return np.arange(count) + SECOND, np.ones((count, 3)), np.tile([0.0, 0.0, 0.0, 1.0], (count, 1))


@pytest.fixture(scope="module")
def large() -> Buffer:
    buffer = Buffer(None)
    buffer.set_many("a", "b", *rows(1_000_000))
    for index in range(20_000):
        buffer.set("a", f"child {index}", SECOND, (1, 2, 3), (0, 0, 0, 1))
    return buffer


@pytest.mark.usefixtures("no_switching")
@pytest.mark.parametrize(
    "name",
    [
        "lookup_many",
        "set_many",
        "transform_points",
        "deskew",
        "samples",
        "frozen",
        "insert_cdr",
        "edges",
        "yaml",
    ],
)
def test_long_operations_release_the_gil(large: Buffer, name: str) -> None:
    stamps = np.arange(1_000_000) + SECOND
    points = np.ones((1_000_000, 3))
    batch = cdr.encode(TFMessage(transforms=[message(1.0, SECOND + 1)] * 50_000))
    table = rows(500_000)
    answers, known = np.empty((1_000_000, 7)), np.empty(1_000_000, np.uint8)
    identity = np.array([0.0, 0, 0, 0, 0, 0, 1])
    from tfloom import _native

    call = {
        "lookup_many": lambda: large.fill_many("a", "b", stamps, answers, known, True, 1),
        "set_many": lambda: Buffer(None).store_many("a", "b", *table, "me"),
        "transform_points": lambda: [
            _native.move_points_float64(identity, points, points) for _ in range(20)
        ],
        "deskew": lambda: large.deskew_float64("a", "b", identity, stamps, points, points, 1),
        "samples": lambda: large.samples("a", "b"),
        "frozen": large.frozen,
        "insert_cdr": lambda: Buffer(None).insert_cdr(batch),
        "edges": large.edges,
        "yaml": large.all_frames_as_yaml,
    }[name]

    started = threading.Lock()
    started.acquire()
    has_ended = other_ran = False

    def run() -> None:
        nonlocal has_ended
        started.release()
        give_up_at = monotonic() + WAIT_S
        while not other_ran and monotonic() < give_up_at:
            call()  # nothing else in this loop releases the GIL
        has_ended = True

    thread = threading.Thread(target=run)
    thread.start()
    started.acquire()
    ran_meanwhile = not has_ended
    other_ran = True
    thread.join()
    assert ran_meanwhile


@needs_no_gil
def test_import_keeps_the_gil_disabled() -> None:
    program = "import sys, tfloom.tf2.buffer, tfloom._native; sys.exit(sys._is_gil_enabled())"
    subprocess.run([sys.executable, "-W", "error", "-c", program], check=True, timeout=60)
