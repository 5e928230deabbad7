"""tools/set_up.py with missing or incomplete parts: its messages, and where a repeated run continues."""

from __future__ import annotations

import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

import pytest
from tests.conftest import run_to_end
from tools import set_up

ROOT = Path(__file__).parents[2]
NO_INDEX = {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": ""}
"""pip finds nothing: the set-up ends at its first package."""
AS_NOBODY = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the Makefile's set-up is for POSIX systems")


def run_set_up(venv: Path, *options: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return run_to_end(
        [sys.executable, ROOT / "tools" / "set_up.py", "--venv", venv, *options, "demo"],
        env=os.environ | NO_INDEX | environment,
    )


def write_program(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return an environment of a set-up that found no packages."""
    folder = tmp_path_factory.mktemp("set-up") / "a folder, ä"
    done = run_set_up(folder)
    assert done.returncode == 1
    assert "Making" in done.stdout
    assert "set-up: pip failed; its messages are above" in done.stderr
    assert "No matching distribution" in done.stderr
    return folder


@pytest.fixture
def environment(made: Path) -> Iterator[Path]:
    """Return that environment, unchanged."""
    record = (made / set_up.RECORD).read_text("utf-8")
    yield made
    (made / set_up.RECORD).write_text(record, "utf-8")


@pytest.mark.slow
def test_repeated_run_keeps_the_environment(environment: Path) -> None:
    assert "Making" not in run_set_up(environment).stdout


@pytest.mark.slow
def test_missing_network_gives_the_remedy(environment: Path) -> None:
    done = run_set_up(
        environment,
        PIP_NO_INDEX="0",
        PIP_INDEX_URL="http://127.0.0.1:9/simple",
        PIP_EXTRA_INDEX_URL="",
        PIP_RETRIES="1",
    )
    assert done.returncode == 1
    assert "pip reaches no package index" in done.stderr
    assert "make wheels" in done.stderr
    assert "Traceback" not in done.stdout + done.stderr


@pytest.mark.slow
@pytest.mark.parametrize(
    ("record", "said"),
    [
        ({"unfinished": "demo"}, "the one that is there was left unfinished"),
        ({"folder": "/elsewhere/.venv"}, "the one that is there was made in another folder"),
    ],
)
def test_interrupted_or_moved_environment_is_recreated(
    environment: Path, record: dict[str, str], said: str
) -> None:
    marker = environment / "marker"
    marker.touch()
    (environment / set_up.RECORD).write_text(json.dumps({"folder": str(environment), **record}), "utf-8")
    assert said in run_set_up(environment).stdout
    assert not marker.exists()
    assert json.loads((environment / set_up.RECORD).read_text("utf-8")) == {"folder": str(environment)}


@pytest.mark.slow
def test_environment_of_a_too_old_python_is_recreated(tmp_path: Path) -> None:
    write_program(tmp_path / "bin" / "python", "echo 3 9")
    (tmp_path / "pyvenv.cfg").touch()
    done = run_set_up(tmp_path)
    assert f"with Python {platform.python_version()}: the one that is there has Python 3.9\n" in done.stdout
    assert (tmp_path / "bin" / "pip").exists()


@pytest.mark.parametrize(
    ("python", "keep_python", "reason"),
    [
        ("exit 1", False, ": in the one that is there, Python or pip doesn't run"),
        ("echo 3 9", True, ": the one that is there has Python 3.9"),
        ("echo 3 99", False, ": the one that is there has Python 3.99"),
        ("echo 3 99", True, None),
    ],
)
def test_reason_for_recreating_an_environment(
    tmp_path: Path, python: str, keep_python: bool, reason: str | None
) -> None:
    write_program(tmp_path / "bin" / "python", python)
    (tmp_path / "pyvenv.cfg").touch()
    assert set_up.Environment(tmp_path).why_make(keep_python) == reason


def test_two_set_ups_of_one_environment_go_one_after_the_other(tmp_path: Path) -> None:
    command = [sys.executable, ROOT / "tools" / "set_up.py", "--venv", tmp_path, "demo"]
    with set_up.only_one(tmp_path):
        # What is there is no environment, which the second run says when its turn comes.
        (tmp_path / "notes.txt").touch()
        second = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        assert second.stdout is not None
        assert second.stdout.readline() == f"-- Waiting for another set-up, which is at work in {tmp_path}\n"
        assert second.poll() is None
    printed, errors = second.communicate(timeout=60)
    assert (printed, second.returncode) == ("", 1)
    assert "is there and is not a virtual environment" in errors


def test_compiler_and_packages_have_the_checkout_for_themselves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two environments of one Python compile into the same folder."""
    environment = set_up.Environment(tmp_path)
    others: list[str] = []
    look = f"import sys; sys.path.insert(0, {str(ROOT)!r}); from tools.set_up import ROOT, only_one\n"
    look += "with only_one(ROOT): print('in')"

    def pip(*_: str) -> bool:
        with subprocess.Popen([sys.executable, "-c", look], stdout=subprocess.PIPE, text=True) as other:
            assert other.stdout is not None
            others.append(other.stdout.readline())
            other.kill()
        return True

    monkeypatch.setattr(environment, "pip", pip)
    environment._compile()
    environment._install(ROOT / "packages" / "tfloom-ros2")
    assert [line.startswith("-- Waiting for another set-up") for line in others] == [True, True]


@pytest.mark.skipif(os.name != "posix", reason="the program in pip's place is a script")
def test_pip_compiles_only_where_an_import_does_not(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    environment = set_up.Environment(tmp_path)
    environment.python = tmp_path / "python"
    environment.python.write_text(f"#!/bin/sh\necho \"$@\" >>'{tmp_path}/called'\n")
    environment.python.chmod(0o755)
    for word, is_written in (
        ("install", True),
        ("install", False),
        ("download", True),
    ):  # which has no such option
        monkeypatch.setattr(sys, "dont_write_bytecode", not is_written)
        assert environment.pip(word, "numpy")
    calls = (tmp_path / "called").read_text().splitlines()
    assert ["--no-compile" in call.split() for call in calls] == [True, False, False]


@pytest.mark.slow
def test_two_set_ups_at_once_make_one_environment(tmp_path: Path) -> None:
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(run_set_up, [tmp_path / "venv"] * 2))
    assert sum("Making" in run.stdout for run in runs) == 1
    for run in runs:
        assert "set-up: pip failed; its messages are above" in run.stderr
        assert "Traceback" not in run.stdout + run.stderr


def test_other_folder_is_not_changed(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    done = run_set_up(tmp_path)
    assert done.returncode == 1
    assert (
        done.stderr
        == f"set-up: {tmp_path} is there and is not a virtual environment: move it away, and repeat\n"
    )
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_unwritable_folder_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for folder in (tmp_path / "file", tmp_path / "file" / "venv"):
        done = run_set_up(folder)
        assert done.returncode == 1
        assert str(folder) in done.stderr
        assert "Not a directory" in done.stderr
        assert "make VENV=FOLDER" in done.stderr
        assert "Traceback" not in done.stderr


@pytest.mark.skipif(
    os.geteuid() != 0 or not shutil.which("setpriv") or not Path("/usr/bin/python3").exists(),
    reason="needs root, to become a user without rights, and a python3 that everybody may run",
)
def test_a_folder_without_permission_is_named() -> None:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)  # so that the other user can read the script
        venv = Path(folder) / "venv"
        script = shutil.copytree(ROOT / "tools", Path(folder) / "tools") / "set_up.py"
        done = run_to_end([*AS_NOBODY, "/usr/bin/python3", script, "--venv", venv, "demo"])
    assert done.returncode == 1
    assert f"set-up: can't make {venv}: " in done.stderr
    assert "Permission denied" in done.stderr
    assert "make VENV=FOLDER" in done.stderr


@pytest.mark.parametrize(
    ("release", "command"),
    [
        ({"ID": "debian"}, "apt-get install g++"),
        ({"ID": "linuxmint", "ID_LIKE": "ubuntu debian"}, "apt-get install g++"),
        ({"ID": "fedora"}, "dnf install gcc-c++"),
        ({"ID": "alpine"}, "apk add g++"),
        ({"ID": "unheard-of"}, "your system's package of g++"),
    ],
)
def test_without_a_compiler_the_package_is_named(
    release: dict[str, str], command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(platform, "freedesktop_os_release", lambda: release)
    monkeypatch.setattr("sysconfig.get_path", lambda _: str(tmp_path))
    (tmp_path / "Python.h").touch()
    with pytest.raises(set_up.SetUpError) as raised:
        set_up.check_compiler()
    assert str(raised.value) == f"no C++ compiler was found; this brings one: {command}"
    (tmp_path / "Python.h").unlink()
    with pytest.raises(set_up.SetUpError) as raised:
        set_up.check_compiler()
    headers = {"apt-get": " python3-dev", "dnf": " python3-devel", "apk": " python3-dev"}
    assert str(raised.value).endswith(f": {command}{headers.get(command.split(maxsplit=1)[0], '')}")


def test_without_a_compiler_on_macos_apples_command_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """There is always a program of the compiler's name."""
    stub = write_program(
        tmp_path / "c++", "echo 'xcode-select: note: No developer tools were found' >&2; exit 1"
    )
    monkeypatch.setenv("CXX", str(stub))
    with pytest.raises(set_up.SetUpError, match=r"no C\+\+ compiler was found; .*: xcode-select --install$"):
        set_up.check_compiler()
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.delenv("CXX")
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))
    with pytest.raises(set_up.SetUpError, match=r"this brings one: xcode-select --install$"):
        set_up.check_compiler()


def test_without_a_compiler_on_windows_the_build_tools_are_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    monkeypatch.setenv("PROGRAMFILES(X86)", str(tmp_path))
    assert not set_up._has_windows_compiler()
    installer = tmp_path / "Microsoft Visual Studio" / "Installer"
    installer.mkdir(parents=True)
    (installer / "vswhere.exe").touch()
    assert set_up._has_windows_compiler()
    monkeypatch.setenv("PROGRAMFILES(X86)", str(tmp_path / "nothing"))
    assert not set_up._has_windows_compiler()
    write_program(tmp_path / "g++", "exit 0")
    assert set_up._has_windows_compiler()
    assert "Microsoft.VisualStudio.2022.BuildTools" in set_up.ON_WINDOWS


HOOK = "import build_backend, sys; print(getattr(build_backend, sys.argv[1])(eval(sys.argv[2])))"


@pytest.mark.skipif(sys.platform != "linux", reason="the message is that of Linux")
@pytest.mark.parametrize("hook", ["get_requires_for_build_wheel", "get_requires_for_build_editable"])
def test_build_ends_in_one_line_without_a_compiler(hook: str, tmp_path: Path) -> None:
    variables = {
        name: value
        for name, value in os.environ.items()
        if name not in {"CXX", "CMAKE_ARGS", "CMAKE_TOOLCHAIN_FILE"}
    } | {"PATH": str(tmp_path), "PYTHONPATH": str(set_up.ROOT / "tools")}

    def ask(
        settings: dict[str, str], cwd: Path = set_up.ROOT, **more: str
    ) -> subprocess.CompletedProcess[str]:
        return run_to_end(
            [sys.executable, "-c", HOOK, hook, repr(settings)], cwd=cwd, env={**variables, **more}
        )

    refused = ask({})
    assert refused.returncode == 1
    assert refused.stderr.startswith("tfloom: no C++ compiler was found; this brings one: ")
    assert (refused.stderr.count("\n"), refused.stdout) == (1, "")
    # What compiles nothing needs none; and where CMake was told of a compiler, it looks by itself.
    for good in (
        ask({"wheel.cmake": "false"}),
        ask({"cmake.define.CMAKE_CXX_COMPILER": "/opt/c++"}),
        ask({}, CMAKE_TOOLCHAIN_FILE="arm64.cmake"),
        ask({}, set_up.ROOT / "packages" / "tfloom-interfaces"),
    ):
        assert good.returncode == 0, good
        assert "compiler was found" not in good.stderr


def test_a_compiler_that_is_too_old_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    compiler = write_program(tmp_path / "g++-9", "echo warning: old >&2; echo error: no concepts >&2; exit 1")
    monkeypatch.setenv("CXX", str(compiler))
    expected = r"g\+\+-9 compiles no C\+\+20: g\+\+ 12, clang 15 or newer does; .*: error: no concepts$"
    with pytest.raises(set_up.SetUpError, match=expected):
        set_up.check_compiler()


def test_a_compiler_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CXX", "/nowhere/g++")
    with pytest.raises(set_up.SetUpError, match=r"/nowhere/g\+\+ can't be started: No such file"):
        set_up.check_compiler()


def test_a_compiler_writes_an_object(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """zig's fails where it is to check the syntax alone."""
    log = tmp_path / "arguments"
    monkeypatch.setenv("CXX", str(write_program(tmp_path / "zig-c++", f'echo "$@" > {log}')))
    set_up.check_compiler()
    assert re.search(r"-c \S+\.cpp -o \S+\.o\n$", log.read_text("utf-8"))


def test_compiling_tells_the_time(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(set_up, "TELL_S", 0.01)
    with set_up.telling_the_time("Still compiling"):
        end = time.monotonic() + 10.0
        output = ""
        while output.count("\n") < 2 and time.monotonic() < end:
            output += capsys.readouterr().out
    assert re.match(r"(-- Still compiling, for \d+ s\n){2}", output)
    threads = [thread.name for thread in threading.enumerate() if "tell" in thread.name]
    assert not threads


def test_documentation_needs_no_compiler() -> None:
    """Neither the core nor the DDS library nor the checkers are installed for it."""
    project = set_up.read_project(Path(sys.executable))
    assert set_up.up_to("docs") == ["docs"]
    names = {set_up.distribution(requirement) for requirement in set_up.requirements_of(project, "docs")}
    assert {"sphinx", "furo", "sphinx-copybutton", "numpy"} <= names
    assert not {"cyclonedds", "nanobind", "ruff", "mypy"} & names
    assert set_up.up_to("bench") == ["demo", "test", "check", "bench"]
    steps = set_up.Environment(Path("nowhere"))._steps(set_up.up_to("docs"), project)
    assert [name for name, _, _ in steps] == ["docs"]


def test_a_missing_header_of_python_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sysconfig.get_path", lambda _: str(tmp_path))
    with pytest.raises(set_up.SetUpError, match=r"Python\.h is missing; this brings it: "):
        set_up.check_compiler()


@pytest.mark.skipif(not shutil.which("make"), reason="make is not installed")
def test_python_below_3_10_is_rejected_in_one_line(tmp_path: Path) -> None:
    python = write_program(
        tmp_path / "python3", f'exec "{sys.executable}" -c "import sys; sys.version_info = (3, 9, 18); $2"'
    )
    for target in ("demo", "test"):
        done = run_to_end(["make", target, f"PYTHON={python}"], cwd=ROOT)
        assert done.returncode == 2
        assert f"set-up: tfloom needs Python 3.10 or newer, and {python} is 3.9" in done.stderr
        assert "Traceback" not in done.stderr


def test_extra_all_is_the_union_of_the_others() -> None:
    whole = set_up.read_project(Path(sys.executable))
    extras = whole["project"]["optional-dependencies"]
    others = [name for name in extras if name != "all"]
    assert extras["all"] == [f"tfloom[{','.join(others)}]"], "pyproject.toml: name each extra in `all`"
    together = [one for name in others for one in extras[name]]
    assert set_up.requirements_of_extra(whole, "all") == together
    # No command asks an index for tfloom itself.
    assert not [one for one in together if set_up.distribution(one).startswith("tfloom")]


def test_failed_command_is_named_with_its_last_lines() -> None:
    code = "import sys; print(*range(9), sep='\\n'); sys.exit('the end')"
    with pytest.raises(set_up.SetUpError) as raised:
        set_up.output_of([sys.executable, "-c", code], last=2)
    assert str(raised.value) == f"{Path(sys.executable).name} failed:\n8\nthe end"


def test_folder_of_wheels_is_passed_as_an_address_without_spaces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = tmp_path / "a clöne"
    (root / "wheels").mkdir(parents=True)
    monkeypatch.setattr(set_up, "ROOT", root)
    monkeypatch.setenv("PIP_FIND_LINKS", "wheels file:///elsewhere nowhere")
    (links,) = set_up.absolute_find_links().values()
    address, *others = links.split()
    assert others == ["file:///elsewhere", "nowhere"]
    assert Path(url2pathname(urlsplit(address).path)) == root / "wheels"
    monkeypatch.delenv("PIP_FIND_LINKS")
    assert set_up.absolute_find_links() == {}
