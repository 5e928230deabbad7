"""Launch tests under plain pytest, as packages of users write them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.launch.testing.conftest import Run, run_pytest
from tests.launch.testing.users import FAILING, LAUNCH, PASSING

SKIPPED = {"test_skipped_launch.py": "no robot here"}


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Run all the files at once, because each start of pytest takes a second."""
    files = {**PASSING, **{name: text for name, (text, _) in FAILING.items()}}
    texts = {name: LAUNCH + text for name, text in files.items()}
    # Such a name can't be that of a module.
    texts["good.launch.test.py"] = texts["test_good.py"]
    folder = tmp_path_factory.mktemp("users")
    return run_pytest(folder, texts, *texts, "--launch-args", "colour:=blue")


@pytest.mark.parametrize("name", sorted(PASSING))
def test_launch_test_passes(run: Run, name: str) -> None:
    module = name.removesuffix(".py")
    item = f"{module}.TestPlain::test_plain" if module == "test_plain" else f"{module}::{module}"
    case = run.cases[item]
    expected = ("skipped", SKIPPED[name]) if name in SKIPPED else ("passed", "")
    assert case.outcome == expected[0], case.text + run.output
    assert expected[1] in case.text


def test_file_whose_name_is_no_modules_is_collected(run: Run) -> None:
    assert run.outcome("good.launch.test::good") == "passed", run.output


@pytest.mark.parametrize("name", sorted(FAILING))
def test_launch_test_fails_with_its_text(run: Run, name: str) -> None:
    module = name.removesuffix(".py")
    case = run.cases[f"{module}::{module}"]
    assert case.outcome == "failure"
    for text in FAILING[name][1]:
        assert text in case.text, case.text


def test_failing_launch_tests_fail_pytest(run: Run) -> None:
    assert run.code == 1
    assert "launch/testing/" not in run.cases["test_extra_argument::test_extra_argument"].text, (
        "our stack is shown"
    )


def test_no_process_is_left(run: Run) -> None:
    processes = subprocess.run(["ps", "-eo", "pid,args"], capture_output=True, text=True, check=True).stdout
    log = [line for line in run.output.splitlines() if "process started with pid" in line]
    started = {line.rpartition("[")[2].strip("]") for line in log}
    assert started
    left = [line for line in processes.splitlines() if line.split()[0] in started and "Starting Up" in line]
    assert not left


def test_missing_launch_argument_is_named(tmp_path: Path) -> None:
    run = run_pytest(tmp_path, {"test_arguments.py": LAUNCH + PASSING["test_arguments.py"]})
    assert run.code == 1
    assert "colour" in run.cases["test_arguments::test_arguments"].text


PROBE = """\
import sys

def test_nothing():
    pass

def test_loaded():
    loaded = [name for name in sys.modules if name.split(".")[0] == "tfloom"]
    assert sorted(loaded) == [
        "tfloom", "tfloom.launch", "tfloom.launch.testing", "tfloom.launch.testing.hookspecs",
        "tfloom.launch.testing.plugin", "tfloom.ros_imports", "tfloom.ros_imports.guard", "tfloom.testing",
        "tfloom.testing.plugin",
    ], loaded
    import tfloom.tf2.transform
    assert "AssertionRewritingHook" not in repr(tfloom.tf2.transform.__loader__)
"""


def test_other_tests_load_the_plugin_alone(tmp_path: Path) -> None:
    """The distribution with tfloom's files stands for a wheel's, all of whose packages pytest would rewrite."""
    wheel = tmp_path / "wheel"
    files = {
        "wheel/other_plugin.py": "",
        "wheel/other-1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: other\nVersion: 1.0\n",
        "wheel/other-1.0.dist-info/entry_points.txt": "[pytest11]\nother = other_plugin\n",
        "wheel/other-1.0.dist-info/RECORD": "other_plugin.py,,\ntfloom/__init__.py,,\n",
        "test_probe.py": PROBE,
    }
    run = run_pytest(tmp_path, files, "test_probe.py", PYTHONPATH=str(wheel))
    assert run.code == 0, run.output
    assert "plugins:" in run.output
    assert "other-1.0" in run.output


def test_plugin_leaves_a_real_ros_alone(tmp_path: Path) -> None:
    """A `launch_testing` from elsewhere has its own plug-in, whose option has the same name."""
    real = tmp_path / "real" / "launch_testing"
    real.mkdir(parents=True)
    (real / "__init__.py").touch()
    (real / "hooks.py").write_text(
        "def pytest_addoption(parser):\n    parser.addoption('--launch-args', nargs='*')\n"
    )
    files = {"test_some.py": "def generate_test_description():\n    pass\n\n\ndef test_one():\n    pass\n"}
    run = run_pytest(tmp_path, files, "-p", "launch_testing.hooks", PYTHONPATH=str(tmp_path / "real"))
    assert run.code == 0, run.output
    assert run.outcome("test_some::test_one") == "passed"


def test_plugin_can_be_switched_off(tmp_path: Path) -> None:
    files = {"test_some.py": "def generate_test_description():\n    pass\n\n\ndef test_one():\n    pass\n"}
    run = run_pytest(tmp_path, files, "-p", "no:launch_testing")
    assert run.outcome("test_some::test_one") == "passed", run.output


def test_import_of_launch_testing_is_light() -> None:
    code = (
        "import launch_testing, launch_testing.actions, launch_testing.asserts, sys\n"
        "print([name for name in ('numpy', 'pytest', 'tfloom.node') if name in sys.modules])"
    )
    result = run_to_end([sys.executable, "-c", code])
    assert result.stdout == "[]\n", result.stderr
