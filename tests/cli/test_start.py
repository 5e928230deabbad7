"""Ctrl-C while a command is being imported ends it without a traceback."""

from __future__ import annotations

import ast
import os
import signal
import subprocess
import sys

import pytest

from tfloom.cli.quiet_imports import INTERRUPTED, QuietImports

INTERRUPTED_IMPORT = """
import os, signal, sys
{start}
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Finder())
sys.argv = ["ros2", "topic", "list", "--help"]
sys.exit(main())
"""
COMMANDS = ("from tfloom.cli.start import main", "from tfloom_ros2 import main")

pytestmark = pytest.mark.skipif(os.name != "posix", reason="a process signals itself otherwise elsewhere")


@pytest.mark.parametrize("start", COMMANDS)
@pytest.mark.parametrize("module", ["tfloom.cli.main", "tfloom.cli.parser", "tfloom.cli.topic.queries"])
def test_ctrl_c_during_an_import_prints_nothing(start: str, module: str) -> None:
    code = INTERRUPTED_IMPORT.format(start=start, module=module)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=60, check=False)
    assert (run.returncode, run.stdout, run.stderr) == (INTERRUPTED, b"", b"")


def test_script_imports_next_to_nothing() -> None:
    code = "import tfloom.cli.start, sys; print([name for name in sys.modules if name.startswith('tfloom.')])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert set(ast.literal_eval(run.stdout)) == {"tfloom.cli", "tfloom.cli.start", "tfloom.cli.quiet_imports"}


def test_parsing_imports_no_shutil_and_the_exit_searches_no_objects_for_cycles() -> None:
    code = (
        "import atexit, gc, sys; "
        "atexit.register(lambda: print('shutil' in sys.modules, len(gc.get_objects()) < 1000)); "
        "from tfloom.cli.start import main; sys.argv = ['ros2', 'daemon', 'status']; sys.exit(main())"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert run.stdout.endswith("\nFalse True\n")


def test_error_that_python_makes_of_an_interrupt_is_one(monkeypatch: pytest.MonkeyPatch) -> None:
    from tfloom.cli import main

    def made(_: object) -> int:
        raise RuntimeError("Error calling __set_name__") from KeyboardInterrupt()

    monkeypatch.setattr("tfloom.cli.topic.queries.list_main", made)
    assert main.main(["topic", "list"]) == INTERRUPTED


@pytest.mark.parametrize("former", [signal.SIG_IGN, lambda *_: None], ids=["ignored", "handled"])
def test_handler_of_somebody_else_stays(former: object) -> None:
    before = signal.signal(signal.SIGINT, former)  # type: ignore[arg-type]
    try:
        with QuietImports():
            assert signal.getsignal(signal.SIGINT) is former
        assert signal.getsignal(signal.SIGINT) is former
    finally:
        signal.signal(signal.SIGINT, before)


def test_handler_is_pythons_after_the_imports() -> None:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(ImportError), QuietImports():
            import no_such_module  # noqa: F401
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
