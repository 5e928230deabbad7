"""Processes: start, output, events, respawn, signals, and that none is left."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest

from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler, Shutdown
from tfloom.launch.actions.executable import Executable
from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.events.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from tfloom.launch.events.process import (
    ProcessExited,
    ProcessStarted,
    ProcessStdin,
    ShutdownProcess,
    SignalProcess,
    matches_action,
    matches_executable,
    matches_name,
    matches_pid,
)
from tfloom.launch.logs import logging as launch_logging
from tfloom.launch.processes.family import KILL_S, TAG, end, find, members_of, tagged
from tfloom.launch.processes.guard import guardian_command
from tfloom.launch.substitutions.variables import LaunchConfiguration

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the programs are of a POSIX shell")

Launch = Callable[..., tuple]


def python(code: str, **options: object) -> ExecuteProcess:
    return ExecuteProcess(
        cmd=[sys.executable, "-c", code], **{"name": "python", "output": "screen", **options}
    )


def shell(code: str, **options: object) -> ExecuteProcess:
    return ExecuteProcess(cmd=["bash", "-c", code], **{"name": "bash", "output": "screen", **options})


def masked(ran: tuple) -> list[str]:
    """Return the lines with process ids as N."""
    return [re.sub(r"pid (\[?)\d+", r"pid \1N", line) for line in ran.lines]


def test_lines_of_a_process_are_prefixed_with_its_name(launch: Launch) -> None:
    ran = launch(shell("echo out; echo err >&2; printf rest"), shell("exit 3", name="crash"))
    assert ran.code == 0
    lines = masked(ran)
    assert [line for line in lines if line.startswith("[bash-1] ")] in (
        [f"[bash-1] {text}" for text in order] for order in (["out", "err", "rest"], ["err", "out", "rest"])
    )
    assert "[INFO] [bash-1]: process started with pid [N]" in lines
    assert "[INFO] [bash-1]: process has finished cleanly [pid N]" in lines
    assert "[ERROR] [crash-2]: process has died [pid N, exit code 3, cmd 'bash -c exit 3']." in lines


def test_a_line_is_printed_when_it_is_complete(launch: Launch) -> None:
    ran = launch(
        python("import sys, time\nfor c in 'a', 'b', 'c\\n': sys.stdout.write(c); sys.stdout.flush()")
    )
    assert "[python-1] abc" in ran.lines


def test_text_that_is_no_utf_8_is_shown(launch: Launch) -> None:
    code = "import sys; out = sys.stdout.buffer\nfor part in b'\\xff\\xc3', b'\\xa9\\n': out.write(part); out.flush()"
    assert "[python-1] \ufffd\u00e9" in launch(python(code)).lines


def test_a_program_that_prints_without_flush_is_heard_at_once(launch: Launch) -> None:
    """It would keep its output for itself, because its stdout is a pipe."""
    heard = python("print('hi'); import time; time.sleep(600)")
    ran = launch(
        RegisterEventHandler(OnProcessIO(target_action=heard, on_stdout=lambda _: Shutdown())),
        heard,
    )
    assert "[python-1] hi" in ran.lines


@pytest.mark.parametrize(
    ("output", "printed", "logged"),
    [
        ("log", ["err"], 2),
        ("screen", ["err", "out"], 0),
        ("both", ["err", "out"], 2),
        ("own_log", [], 0),
        ("full", ["err", "out"], 2),
        ({"stdout": "screen", "stderr": {"log"}}, ["out"], 1),
    ],
)
def test_output_goes_where_it_is_sent(
    launch: Launch, output: object, printed: list[str], logged: int
) -> None:
    ran = launch(shell("echo out; echo err >&2", output=output))
    assert sorted(line[9:] for line in ran.lines if line.startswith("[bash-1] ")) == printed
    folder = Path(launch_logging.launch_config.log_dir)
    launch_logging.reset()
    main = (folder / "launch.log").read_text("utf-8")
    assert sum("[bash-1] " in line for line in main.splitlines()) == logged
    own = {path.name for path in folder.iterdir()} - {"launch.log"}
    has_own = output in ("own_log", "full")
    assert own == ({"bash-1.log", "bash-1-stdout.log", "bash-1-stderr.log"} if has_own else set())
    if has_own:
        assert (folder / "bash-1-stdout.log").read_text("utf-8") == "[bash-1] out\n"


def test_the_output_of_every_process_is_shown_by_an_environment_variable(
    launch: Launch, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_PROCESS_OUTPUT", "screen")
    assert "[bash-1] out" in launch(shell("echo out", output="own_log")).lines


@pytest.mark.parametrize("output", ["scren", {"out": "screen"}, {"stdout": "file"}])
def test_a_wrong_output_is_named(launch: Launch, output: object) -> None:
    ran = launch(shell("true", output=output))
    assert ran.code == 1
    assert "'bash-1'" in ran.lines[0]
    assert "use " in ran.lines[0]


def test_cached_output_is_kept(launch: Launch) -> None:
    action = shell("echo one; echo two; echo three >&2", cached_output=True)
    launch(action)
    assert action.get_stdout() == "one\ntwo\n"
    assert action.get_stderr() == "three\n"
    assert action.return_code == 0


def test_a_terminal_is_emulated(launch: Launch) -> None:
    code = "import sys; print(sys.stdout.isatty(), sys.stderr.isatty(), file=sys.stderr)"
    assert "[python-1] True True" in launch(python(code, emulate_tty=True)).lines
    assert "[python-2] False False" in launch(python(code)).lines


def test_folder_and_environment_of_a_process(
    launch: Launch, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OF_THE_LAUNCH", "1")
    code = "import os, json; print(json.dumps([os.getcwd(), os.environ.get('OF_THE_LAUNCH'), os.environ.get('MORE')]))"
    options = {"cwd": str(tmp_path), "additional_env": {"MORE": [TextSubstitution(text="mo"), "re"]}}
    printed = [
        json.loads(line.partition("] ")[2])
        for action in (python(code, **options), python(code, env={"MORE": "alone"}))
        for line in launch(action).lines
        if line.startswith("[python-")
    ]
    assert printed == [[str(tmp_path), "1", "more"], [str(Path.cwd()), None, "alone"]]


def test_a_shell_runs_a_command_line(launch: Launch) -> None:
    assert (
        "[echo a; echo b-1] b"
        in launch(ExecuteProcess(cmd=["echo a; echo b"], shell=True, output="screen")).lines
    )


@pytest.mark.parametrize(
    ("cmd", "options", "text"),
    [
        (["no_such_program"], {}, "no program 'no_such_program' was found"),
        (["/etc/passwd"], {}, "'/etc/passwd' is not executable"),
        (["true"], {"cwd": "/no/such/folder"}, "its folder '/no/such/folder' does not exist"),
        (["true", "a\0b"], {}, "'true': "),
    ],
)
def test_a_process_that_cannot_be_started_is_named_and_the_rest_goes_on(
    launch: Launch, cmd: list[str], options: dict, text: str
) -> None:
    ran = launch(ExecuteProcess(cmd=cmd, name="wrong", **options), shell("echo here"))
    assert ran.code == 0
    (line,) = [line for line in ran.lines if "[wrong-1]" in line]
    assert line.startswith(f"[ERROR] [wrong-1]: process could not be started: {text}")
    assert "[bash-2] here" in ran.lines


def test_events_of_a_process_reach_their_handlers(launch: Launch) -> None:
    events: list[tuple] = []
    action = shell("read line; echo got $line; exit 4")
    launch(
        RegisterEventHandler(
            OnProcessStart(
                target_action=action,
                on_start=lambda event, _: [
                    EmitEvent(event=ProcessStdin(text="word\n", process_matcher=matches_pid(event.pid)))
                ],
            )
        ),
        RegisterEventHandler(
            OnProcessIO(
                target_action=action,
                on_stdout=lambda event: events.append((event.text, event.from_stdout)),
            )
        ),
        RegisterEventHandler(
            OnProcessExit(
                target_action=lambda other: other is action,
                on_exit=lambda event, _: events.append((event.process_name, event.returncode, event.cmd[0])),
            )
        ),
        action,
    )
    assert events == [(b"got word\n", True), ("bash-1", 4, "bash")]


def test_on_exit_entities_are_visited_at_each_end(launch: Launch) -> None:
    ends: list[int] = []
    action = shell(
        "exit 5",
        respawn=True,
        respawn_max_retries=2,
        respawn_delay=0.01,
        on_exit=OpaqueFunction(function=lambda context: ends.append(context.locals.event.returncode)),
    )
    ran = launch(action)
    assert ends == [5, 5, 5]
    assert sum("process started" in line for line in ran.lines) == 3


def test_respawn_waits_as_told_and_ends_with_the_launch(launch: Launch) -> None:
    action = shell("true", respawn=True, respawn_delay=600.0)
    ran = launch(RegisterEventHandler(OnProcessExit(target_action=action, on_exit=[Shutdown()])), action)
    assert sum("process started" in line for line in ran.lines) == 1


def test_respawn_may_be_a_configuration_of_a_group(launch: Launch) -> None:
    action = shell("true", respawn=LaunchConfiguration("again"), respawn_max_retries=1)
    ran = launch(GroupAction([action], launch_configurations={"again": "true"}))
    assert sum("process started" in line for line in ran.lines) == 2


@pytest.mark.parametrize(
    "matcher",
    [
        matches_action,
        lambda _: matches_name("sleeper"),
        lambda _: matches_name("sleeper-1"),
        lambda _: matches_executable("sleep"),
    ],
)
def test_a_signal_reaches_the_process_that_is_meant(launch: Launch, matcher: Callable) -> None:
    meant = ExecuteProcess(cmd=["sleep", "600"], name="sleeper")
    other = shell("read line; echo $line")
    ran = launch(
        meant,
        other,
        RegisterEventHandler(
            OnProcessStart(
                target_action=meant,
                on_start=EmitEvent(
                    event=SignalProcess(signal_number="SIGUSR1", process_matcher=matcher(meant))
                ),
            )
        ),
        RegisterEventHandler(
            OnProcessExit(
                target_action=meant,
                on_exit=EmitEvent(event=ProcessStdin(text=b"on\n", process_matcher=matches_action(other))),
            )
        ),
    )
    assert "[INFO] [sleeper-1]: sending signal 'SIGUSR1' to process[sleeper-1]" in ran.lines
    assert meant.return_code == -signal.SIGUSR1
    assert other.return_code == 0


def test_one_process_is_shut_down_alone(launch: Launch) -> None:
    deaf = shell(
        "trap '' INT TERM; echo deaf; while :; do sleep 0.1; done",
        sigterm_timeout="0.2",
        sigkill_timeout="0.1",
    )
    ran = launch(
        RegisterEventHandler(
            OnProcessIO(
                target_action=deaf,
                on_stdout=lambda _: EmitEvent(event=ShutdownProcess(process_matcher=matches_action(deaf))),
            )
        ),
        deaf,
    )
    assert deaf.return_code == -signal.SIGKILL
    failed = "[ERROR] [bash-1]: process[bash-1] failed to terminate"
    assert [line for line in ran.lines if "signal" in line or "escalating" in line] == [
        "[INFO] [bash-1]: sending signal 'SIGINT' to process[bash-1]",
        f"{failed} '0.2' seconds after receiving 'SIGINT', escalating to 'SIGTERM'",
        "[INFO] [bash-1]: sending signal 'SIGTERM' to process[bash-1]",
        f"{failed} '0.1' seconds after receiving 'SIGTERM', escalating to 'SIGKILL'",
        "[INFO] [bash-1]: sending signal 'SIGKILL' to process[bash-1]",
    ]


def test_a_signal_reaches_the_children_of_a_process(launch: Launch) -> None:
    """A shell that waits for its child passes no signal on."""
    parent = shell("echo begun; sleep 600; echo never")
    ran = launch(
        RegisterEventHandler(
            OnProcessStart(target_action=parent, on_start=TimerAction(period=0.1, actions=[Shutdown()]))
        ),
        parent,
    )
    assert parent.return_code in (-signal.SIGINT, 128 + signal.SIGINT)
    assert "[bash-1] never" not in ran.lines


def test_what_a_process_left_behind_is_ended_and_named(launch: Launch) -> None:
    """Also where it left the process group, and where it dropped the environment."""
    ran = launch(shell("setsid sleep 4321 & env -i $(command -v sleep) 4321 & sleep 0.1; echo $!"))
    (line,) = [line for line in ran.lines if line.startswith("[WARNING]")]
    assert line.startswith(
        "[WARNING] [launch]: ended processes that others had started and left: sleep [pid "
    )
    assert line.count("sleep [pid") == 2
    assert not [
        process for process in psutil.process_iter(["cmdline"]) if "4321" in (process.info["cmdline"] or [])
    ]


@contextmanager
def sleeping(group: int = 0) -> Iterator[subprocess.Popen[bytes]]:
    """Start a process that no launch has started, in a process group; 0: in one of its own."""
    process = subprocess.Popen(
        ["sleep", "600"],
        preexec_fn=lambda: os.setpgid(0, group),  # noqa: PLW1509  # `process_group` needs Python 3.11
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def test_the_process_group_of_an_ended_process_may_be_anothers(launch: Launch) -> None:
    """The system gives the id to another group when no member is left that the launch had there."""
    with ExitStack() as left, ExitStack() as others:
        unrelated: list[subprocess.Popen[bytes]] = []

        def leave_a_member(event: ProcessStarted, _: LaunchContext) -> EmitEvent:
            left.enter_context(sleeping(event.pid))
            return EmitEvent(event=ProcessStdin(text=b"\n", process_matcher=matches_action(leader)))

        def replace_it(event: ProcessExited, _: LaunchContext) -> None:
            # Another process can join while a member is left; after the end of that, all is as if the id were new.
            unrelated.append(others.enter_context(sleeping(event.pid)))
            left.close()

        leader = shell("read")
        ran = launch(
            RegisterEventHandler(OnProcessStart(target_action=leader, on_start=leave_a_member)),
            RegisterEventHandler(OnProcessExit(target_action=leader, on_exit=replace_it)),
            leader,
        )
        assert ran.code == 0
        assert not [line for line in ran.lines if line.startswith("[WARNING]")]
        assert unrelated[0].poll() is None


def test_the_guardian_ends_no_group_that_the_launch_no_longer_has() -> None:
    with sleeping() as ended, sleeping(ended.pid) as unrelated:
        with sleeping(ended.pid) as left:
            start = next(member for member in members_of(ended.pid) if member[0] == left.pid)[1]
        for lines in (
            f"{ended.pid}\nended {ended.pid}\n",
            f"{ended.pid}\nended {ended.pid} {left.pid}:{start!r}\n",
        ):
            run_guardian(lines)
            assert unrelated.poll() is None
        run_guardian(f"{ended.pid}\n")
        assert unrelated.wait(10) == -signal.SIGINT


def run_guardian(lines: str) -> None:
    """Run a guardian of a launch that was killed, after it had sent some lines."""
    command = guardian_command(uuid.uuid4().hex, 0.0)
    subprocess.run(command, input=lines.encode(), timeout=30, check=True)


def test_no_process_is_of_a_launch_that_began_after_it() -> None:
    """Its group's id may be that of a group before the launch."""
    with sleeping() as process:
        started = psutil.Process(process.pid).create_time()
        assert [relative.pid for relative in find(uuid.uuid4().hex, {process.pid: None}, started)] == [
            process.pid
        ]
        assert find(uuid.uuid4().hex, {process.pid: None}, started + 10.0) == []


def test_what_a_process_starts_because_of_a_signal_is_ended_with_it() -> None:
    """The process itself stays a zombie until this test waits for it, which holds nothing up."""
    launch_id = uuid.uuid4().hex
    code = "trap 'setsid sleep 600 & exit' TERM; echo ready; while :; do sleep 0.02; done"
    process = subprocess.Popen(
        ["bash", "-c", code],
        stdout=subprocess.PIPE,
        env=tagged(os.environ, launch_id),
        start_new_session=True,
    )
    try:
        assert process.stdout.readline() == b"ready\n"
        start_s = time.monotonic()
        end(launch_id, {process.pid: None}, 0.0, {signal.SIGTERM: 30.0})
        assert time.monotonic() - start_s < KILL_S
        assert find(launch_id) == []
    finally:
        for left in find(launch_id):
            left.kill()
        process.communicate()


def test_an_end_that_overtakes_the_start_of_a_process_reaches_it(launch: Launch) -> None:
    """The event is handled while the process is being started, before it can be sent a signal."""
    process = ExecuteProcess(cmd=["sleep", "600"], sigterm_timeout="1")
    ran = launch(process, Shutdown())
    assert "[INFO] [sleep-1]: process started with pid [N]" in masked(ran)
    assert process.return_code == -signal.SIGINT


def test_a_process_knows_its_launch_and_the_one_around_it(
    launch: Launch, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(TAG, "outer")
    (line,) = [line for line in launch(shell(f"echo ${TAG}")).lines if line.startswith("[bash-1] ")]
    outer, inner = line.removeprefix("[bash-1] ").split(":")
    assert (outer, len(inner)) == ("outer", 32)


def test_an_action_is_executed_once(launch: Launch) -> None:
    action = shell("true")
    ran = launch(action, action)
    assert ran.code == 1
    assert "executed more than once" in ran.lines[-1] or any(
        "executed more than once" in line for line in ran.lines
    )


def test_no_process_is_started_after_the_shutdown(launch: Launch) -> None:
    late = shell("echo never")
    launch(Shutdown(), TimerAction(period=0.0, actions=[late], cancel_on_shutdown=False))
    assert late.process_details is None


def test_details_of_a_process_are_known_before_its_start(launch: Launch) -> None:
    seen: list[dict[str, Any] | None] = []
    action = shell("true", cwd="/", name="early")
    look = OpaqueFunction(function=lambda _: seen.append(dict(action.process_details or {})))
    assert action.process_details is None
    assert launch(look, action, look).code == 0
    before, planned = seen
    assert before == {}
    assert planned is not None
    name = planned["name"]
    assert name.startswith("early-")
    assert (planned["action"], planned["cwd"], planned["env"] is not None) == (action, "/", True)
    assert action.process_details == {**planned, "pid": action.process_details["pid"]}  # type: ignore[index]


@pytest.mark.parametrize("timeout", ["soon", "-1", "nan"])
def test_a_timeout_that_is_no_time_is_named(launch: Launch, timeout: str) -> None:
    ran = launch(shell("true", sigterm_timeout=timeout))
    assert ran.code == 1
    assert f"the timeout '{timeout}' of 'bash-1' is " in ran.lines[-1]


def test_a_prefix_is_put_before_the_programs_that_the_filter_matches(launch: Launch) -> None:
    def with_prefix(context: LaunchContext) -> None:
        context.launch_configurations["launch-prefix"] = "env A=1 B='2 3'"
        context.launch_configurations["launch-prefix-filter"] = "bash"

    one = ExecuteProcess(cmd=["bash", "-c", "echo $A $B"], output="screen")
    two = ExecuteProcess(cmd=[sys.executable, "-c", "print(1)"])
    own = ExecuteProcess(cmd=[sys.executable, "-c", "print(1)"], prefix="env")
    ran = launch(OpaqueFunction(function=with_prefix), one, two, own)
    assert "[bash-1] 1 2 3" in ran.lines
    assert one.cmd[:3] == ["env", "A=1", "B=2 3"]
    assert two.cmd[0] == sys.executable
    assert own.cmd[0] == "env"


def test_a_described_program_runs_without_its_own_action(launch: Launch) -> None:
    action = ExecuteLocal(
        process_description=Executable(cmd=["echo", "a"], arguments=["b"]), output="screen", log_cmd=True
    )
    lines = launch(action).lines
    assert "[echo-1] a b" in lines
    assert "[INFO] [echo-1]: process details: cmd='echo a b', cwd='None'" in lines


@pytest.mark.parametrize("number", ["SIGNONE", 999])
def test_a_signal_that_does_not_exist_is_refused(number: object) -> None:
    with pytest.raises(ValueError, match=str(number)):
        SignalProcess(signal_number=number, process_matcher=lambda _: True)


def test_a_frozen_program_has_no_guardian(launch: Launch, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its `sys.executable` is the program itself."""
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", "/no/such/python")
    ran = launch(shell("setsid sleep 4322 & sleep 0.1; echo ran"))
    assert "[bash-1] ran" in ran.lines
    assert any("left: sleep [pid" in line for line in ran.lines)


def test_the_guardian_ends_with_the_launch(launch: Launch) -> None:
    ran = launch(shell("true"), ExecuteProcess(cmd=["no_such_program"]))
    assert ran.code == 0
    assert not [child for child in psutil.Process().children() if "guardian" in " ".join(child.cmdline())]


def test_a_script_runs_whose_interpreter_has_a_space_in_its_path(
    launch: Launch, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Setuptools writes such first lines, which the kernel cuts at the space."""
    folder = tmp_path / "a space"
    folder.mkdir()
    interpreter = folder / "sh"
    interpreter.symlink_to("/bin/sh")
    script = folder / "program"
    script.write_text(f"#!{interpreter}\necho ran $1\n", "utf-8")
    script.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    assert (
        "[program-1] ran by-path"
        in launch(ExecuteProcess(cmd=[str(script), "by-path"], output="screen")).lines
    )
    assert (
        "[program-2] ran by-name" in launch(ExecuteProcess(cmd=["program", "by-name"], output="screen")).lines
    )


SLOW_MODULE = """
import time
print("imports", flush=True)
try:
    time.sleep(60)
except KeyboardInterrupt:
    if {converts}:
        raise ImportError("interrupted")
    raise
"""


def interrupt_at(line: str, program: ExecuteProcess) -> RegisterEventHandler:
    return RegisterEventHandler(
        OnProcessIO(
            target_action=program,
            on_stdout=lambda event: Shutdown() if line.encode() in event.text else None,
        )
    )


@pytest.mark.parametrize("converts", [False, True])
def test_a_program_that_is_interrupted_while_it_imports_shows_no_traceback(
    launch: Launch, tmp_path: Path, converts: bool
) -> None:
    (tmp_path / "slow_module.py").write_text(SLOW_MODULE.format(converts=converts))
    (tmp_path / "program.py").write_text("import slow_module\n")
    program = ExecuteProcess(
        cmd=[sys.executable, str(tmp_path / "program.py")], name="python", output="screen"
    )
    screen = "\n".join(launch(program, interrupt_at("imports", program)).lines)
    assert "imports" in screen
    assert "Traceback" not in screen
    assert program.return_code == (1 if converts else -signal.SIGINT)


def test_a_program_that_is_interrupted_at_work_shows_where(launch: Launch) -> None:
    program = python("import time\nprint('works', flush=True)\ntime.sleep(60)")
    screen = "\n".join(launch(program, interrupt_at("works", program)).lines)
    assert "KeyboardInterrupt" in screen
    assert program.return_code == -signal.SIGINT


@pytest.mark.parametrize("_round", range(5))
def test_an_interpreter_that_starts_is_interrupted_when_it_has_started(launch: Launch, _round: int) -> None:
    """Otherwise Python prints `Fatal Python error`, because the interrupt comes while it imports `site`."""
    program = python("import json, decimal, asyncio, http.client, numpy, unittest.mock, multiprocessing.pool")
    ends = RegisterEventHandler(OnProcessStart(target_action=program, on_start=[Shutdown()]))
    screen = "\n".join(launch(ends, program).lines)
    assert "sending signal 'SIGINT'" in screen
    assert "Fatal Python error" not in screen
    assert "Traceback" not in screen
