"""Messages are allocated and freed by the native part: no leaks, no early frees, Python's rules."""

from __future__ import annotations

import gc
import os
import platform
import struct
import sys
import threading
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.interfaces.geometry_msgs.msg import Transform, TransformStamped, Twist, Vector3
from tfloom.interfaces.std_msgs.msg import Empty, String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class


def test_references_to_the_class_are_released() -> None:
    data = cdr.encode(TFMessage(transforms=[TransformStamped() for _ in range(50)]))
    classes = (TFMessage, TransformStamped, Transform, Vector3, Empty)

    def work() -> list[int]:
        for _ in range(20):
            cdr.decode(TFMessage, data)
            cdr.decode(Empty, cdr.encode(Empty()))
            [Vector3() for _ in range(1000)]
        gc.collect()
        return [sys.getrefcount(cls) for cls in classes]

    work()  # what the first use of a class keeps
    assert work() == work()


def test_values_are_released() -> None:
    value = object()
    before = sys.getrefcount(value)
    for _ in range(10):
        messages = [Vector3(x=value, y=value) for _ in range(10)]  # type: ignore[arg-type]
        messages[0].x = messages[1].z = 0.0
    del messages
    assert sys.getrefcount(value) == before


def test_reused_memory_is_initialised() -> None:
    old = Vector3(x=5.0, check_fields=True)
    del old
    fresh = Vector3.__new__(Vector3)
    assert not hasattr(fresh, "x")
    decoded = cdr.decode(Vector3, cdr.encode(Vector3()))
    decoded.x = "not checked"  # type: ignore[assignment]
    twists = [Twist() for _ in range(1000)]
    del twists
    assert all(twist == Twist() for twist in [Twist() for _ in range(1000)])


def count(cls: type) -> int:
    gc.collect()
    return sum(type(instance) is cls for instance in gc.get_objects())


def in_threads(work: Callable[[], None]) -> None:
    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def test_cycles_are_collected() -> None:
    before = count(TransformStamped)
    for _ in range(100):
        made, read = TransformStamped(), cdr.decode(TransformStamped, cdr.encode(TransformStamped()))
        made.header = read  # type: ignore[assignment]
        read.header = made  # type: ignore[assignment]
    del made, read
    assert count(TransformStamped) <= before  # objects of other code may have been collected, too


def test_objects_that_can_form_cycles_are_tracked() -> None:
    message = cdr.decode(TFMessage, cdr.encode(TFMessage(transforms=[TransformStamped()])))
    stamped = message.transforms[0]
    parts = (message, message.transforms, stamped, stamped.header, stamped.transform)
    assert all(map(gc.is_tracked, parts))


def test_a_decoded_message_that_refers_to_itself_is_collected() -> None:
    before = count(Vector3)
    data = cdr.encode(Vector3())
    for _ in range(100):
        vector = cdr.decode(Vector3, data)
        vector.x = [vector]  # type: ignore[assignment]
    del vector
    assert count(Vector3) == before


def test_decoded_number_is_bitwise_equal() -> None:
    numbers = [0.0, -0.0, 1.0, -1.0, 5e-324, float("inf"), float("nan")]
    cls = define("my_msgs/msg/Reals", "\n".join(f"float64 x{i}" for i in range(10)))
    message: Any = cls(**{f"x{i}": number for i, number in enumerate(numbers)})
    again: Any = cdr.decode(cls, cdr.encode(message))
    for i in range(10):
        assert struct.pack("d", getattr(again, f"x{i}")) == struct.pack("d", getattr(message, f"x{i}"))


def test_truncated_numbers_name_the_field() -> None:
    data = cdr.encode(Twist())
    with pytest.raises(cdr.DecodeError, match=r"^Twist\.angular\.y: byte 36: 8 bytes are needed, 4 are left"):
        cdr.decode(Twist, data[:40])


def test_long_chains_are_freed_without_overflow() -> None:
    for cls in (Vector3, type("Longer", (Vector3,), {})):
        chain: Any = None
        for _ in range(100_000):
            chain = cls(x=chain)
        del chain
    gc.collect()


def test_subclasses_follow_the_rules_of_python() -> None:
    ended: list[float] = []

    class Noted(Vector3):
        """Has a __dict__, weak references and a finalizer."""

        def __del__(self) -> None:
            ended.append(self.x)

    noted = Noted(x=3.0)
    noted.note = "mine"  # type: ignore[attr-defined]
    reference = weakref.ref(noted)
    assert reference() is noted
    del noted
    assert reference() is None
    assert ended == [3.0]
    decoded = [cdr.decode(Noted, cdr.encode(Vector3(x=4.0))) for _ in range(3)]
    del decoded
    assert ended == [3.0, 4.0, 4.0, 4.0]


def test_finalizer_can_resurrect_the_message() -> None:
    cls = define("my_msgs/msg/Kept", "float64 x")
    kept: list[Message] = []
    cls(x=1.0)
    cls.__del__ = lambda self: kept.append(self)  # noqa: PLW0108 a method must be a function
    cls(x=2.0)
    assert [vector.x for vector in kept] == [2.0]
    assert gc.is_tracked(kept[0])
    del cls.__del__
    kept.clear()
    assert cls(x=3.0).x == 3.0


def test_classes_made_at_run_time_are_collected() -> None:
    references = []
    for n in range(20):
        cls = define("my_msgs/msg/Passing", f"float64 x{n}")
        messages = [cls() for _ in range(10)]
        references.append(weakref.ref(cls))
        del cls, messages
    gc.collect()
    assert [reference() is None for reference in references] == [True] * 19 + [False]


def test_threads_compile_a_type_concurrently(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "share" / "racing_msgs" / "msg"
    folder.mkdir(parents=True)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        for n in range(5):
            (folder / f"Inner{n}.msg").write_text("float64 x\nstring name\n")
            (folder / f"Outer{n}.msg").write_text(f"Inner{n} a\nInner{n}[] b\n")
            found: list[Message] = []
            barrier = threading.Barrier(4)

            def work(n: int = n, found: list[Message] = found, barrier: threading.Barrier = barrier) -> None:
                barrier.wait()
                message = get_message_class(f"racing_msgs/msg/Outer{n}")()
                found.append(cdr.decode(type(message), cdr.encode(message)))

            in_threads(work)
            assert len(found) == 4
            assert len({type(message) for message in found}) == 1
    finally:
        sys.setswitchinterval(interval)


def test_threads_use_messages_concurrently() -> None:
    data = cdr.encode(TFMessage(transforms=[TransformStamped(child_frame_id="é") for _ in range(20)]))
    wrong: list[object] = []

    def work() -> None:
        for _ in range(100):
            message = cdr.decode(TFMessage, data)
            if cdr.encode(message) != data or String(data="a").data != "a":
                wrong.append(message)

    in_threads(work)
    assert not wrong


FAULTS_OF_LARGE_MESSAGES = """
import os, resource
os.environ.update({SETTINGS!r})
from tfloom.interfaces.std_msgs.msg import UInt8MultiArray
from tfloom.rosidl import cdr
size, held = {SIZE}, 5
data = cdr.encode(UInt8MultiArray(data=bytes(size)))
def turn():
    messages = [cdr.decode(UInt8MultiArray, data) for _ in range(held)]
turn()
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(10):
    turn()
pages = 10 * held * size / resource.getpagesize()
print((resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before) / pages)
"""


@pytest.mark.skipif("glibc" not in platform.libc_ver(), reason="only glibc's settings are changed")
@pytest.mark.parametrize(
    ("settings", "size", "keeps"),
    [
        ({}, 1_000_000, True),
        ({}, 100_000, False),  # a program of small messages allocates as before
        ({"MALLOC_ARENA_MAX": "2"}, 1_000_000, False),
        ({"GLIBC_TUNABLES": "glibc.malloc.arena_max=2"}, 1_000_000, False),
    ],
)
def test_memory_of_large_messages_is_kept_unless_the_user_sets_it(
    start_program: Any, settings: dict[str, str], size: int, keeps: bool
) -> None:
    code = FAULTS_OF_LARGE_MESSAGES.format(SETTINGS=settings, SIZE=size)
    environment = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("MALLOC_", "GLIBC_TUNABLES", "PYTHONMALLOC"))
    }
    program = start_program("python", "-c", code, env=environment)
    assert program.wait() == 0, program.output
    faults_of_a_page = float(program.lines[-1])
    assert (faults_of_a_page < 0.1) is keeps, f"{faults_of_a_page} faults a page"
