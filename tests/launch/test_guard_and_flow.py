"""The guard and its guardian, and the flow of a process's output, by themselves."""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
import uuid
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom.launch.processes.guard import Guard, guardian_command
from tfloom.launch.processes.local_process import OUTPUT_S, LocalProcess

pytestmark = pytest.mark.skipif(os.name == "nt", reason="process groups are of POSIX")

PAUSE_S = 1.4 * OUTPUT_S


def sleeping() -> subprocess.Popen[bytes]:
    return subprocess.Popen(["sleep", "600"], start_new_session=True)


def test_a_guard_forgets_a_group_that_has_ended_and_tells_the_guardian_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The id of such a group may be another's when the launch ends, or is killed."""
    lines: list[str] = []
    guard = Guard()
    monkeypatch.setattr(guard, "_send_line", lines.append)
    monkeypatch.setattr(guard, "_start_guardian", lambda: None)
    process = sleeping()
    guard.add(process.pid)
    process.kill()
    process.wait()
    guard.ended(process.pid)
    guard.add_folder("/tmp/a b")
    assert not guard._groups
    assert lines == [str(process.pid), f"ended {process.pid}", f"remove {b'/tmp/a b'.hex()}"]


KILLED_EARLY = """
import os, signal
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.temporary_files import folder_of
print(folder_of(context := LaunchContext()), flush=True)
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_a_folder_goes_with_a_launch_that_is_killed_before_its_first_process(
    tmp_path: Path, wait_until: Callable[..., None]
) -> None:
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    killed = run_to_end([sys.executable, "-c", KILLED_EARLY], env=environment)
    assert killed.returncode == -signal.SIGKILL, killed.stderr
    assert Path(killed.stdout.strip()).parent == tmp_path
    wait_until(lambda: not any(tmp_path.iterdir()), what="the end of the folder")


@pytest.mark.skipif(sys.platform != "linux", reason="the ignored signals are read from /proc")
def test_a_guardian_ignores_the_signals_that_end_others(wait_until: Callable[..., None]) -> None:
    """A system that shuts down sends SIGTERM to all: the guardian stays until the launch has ended."""
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT)
    process = sleeping()
    guardian = subprocess.Popen(
        guardian_command(uuid.uuid4().hex, 0.0),
        stdin=subprocess.PIPE,
    )
    try:
        wait_until(
            lambda: all(is_ignored(guardian.pid, number) for number in numbers), what="ignored signals"
        )
        for number in numbers:
            guardian.send_signal(number)
        guardian.communicate(f"{process.pid}\n".encode(), timeout=30)
        assert guardian.returncode == 0
        assert process.wait(30) == -signal.SIGINT
    finally:
        for one in (process, guardian):
            one.kill()
            one.wait()


def is_ignored(pid: int, number: signal.Signals) -> bool:
    (line,) = [
        line
        for line in Path(f"/proc/{pid}/status").read_text("utf-8").splitlines()
        if line.startswith("SigIgn:")
    ]
    return bool(int(line.split()[1], 16) >> (number - 1) & 1)


async def start(
    code: str, parts: list[tuple[int, bytes]], is_behind: Callable[[], bool], *, emulate_tty: bool = False
) -> LocalProcess:
    return await LocalProcess.start(
        [sys.executable, "-c", code],
        lambda fd, data: parts.append((fd, data)),
        is_behind,
        cwd=None,
        env=os.environ,
        shell=False,
        emulate_tty=emulate_tty,
    )


def test_a_process_is_not_read_while_its_output_is_behind() -> None:
    parts: list[tuple[int, bytes]] = []
    behind = [True]

    async def run() -> int:
        process = await start("print('a' * 2_000_000)", parts, lambda: behind[0])
        while not parts:  # noqa: ASYNC110  # of the other program
            await asyncio.sleep(0.01)
        await asyncio.sleep(0.3)
        assert len(parts) == 1
        behind[0] = False
        return await process.wait()

    assert asyncio.run(asyncio.wait_for(run(), 60.0)) == 0
    assert b"".join(data for _, data in parts) == b"a" * 2_000_000 + b"\n"


@pytest.mark.parametrize("emulate_tty", [False, True])
def test_the_rest_of_the_output_is_read_however_long_its_pauses_are(emulate_tty: bool) -> None:
    """After each part, the output is behind for longer than the rest of it is waited for.

    A terminal gives a few thousand characters at a time, a pipe all that it has.
    """
    parts: list[tuple[int, bytes]] = []

    async def run() -> int:
        loop = asyncio.get_running_loop()
        seen = [0, 0.0]

        def is_behind() -> bool:
            if len(parts) > seen[0]:
                seen[:] = [len(parts), loop.time()]
            return loop.time() - seen[1] < PAUSE_S

        # They are written when both are read, because what comes before `start` returns is not paused.
        code = "import os\nos.read(0, 1)\nos.write(1, b'o' * 9000)\nos.write(2, b'err')"
        process = await start(code, parts, is_behind, emulate_tty=emulate_tty)
        process.write(b"x")
        code_of_exit = await process.wait()
        assert [b"".join(data for fd, data in parts if fd == stream) for stream in (1, 2)] == [
            b"o" * 9000,
            b"err",
        ]
        return code_of_exit

    assert asyncio.run(asyncio.wait_for(run(), 60.0)) == 0
