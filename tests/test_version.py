"""The version is defined once, in `tfloom.__version__`, and the classifiers match the tested systems."""

from __future__ import annotations

import re
import sys
from importlib.metadata import metadata, version
from pathlib import Path

import pytest
from tests.conftest import run_to_end

import tfloom

ROOT = Path(__file__).parents[1]


def classifiers() -> list[str]:
    return metadata("tfloom").get_all("Classifier") or []


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (["-m", "tfloom"], "tfloom"),
        (["-c", "import sys, tfloom_ros2; sys.exit(tfloom_ros2.main())"], "ros2 (tfloom)"),
    ],
)
def test_each_command_prints_the_version(command: list[str], name: str) -> None:
    answer = run_to_end([sys.executable, *command, "--version"])
    assert (answer.returncode, answer.stdout, answer.stderr) == (0, f"{name} {tfloom.__version__}\n", "")


def test_version_is_printed_without_loading_the_rooms() -> None:
    code = (
        "import sys\n"
        "from tfloom.cli.main import main\n"
        "try:\n    main(['--version'])\n"
        "finally:\n    print(*sys.modules, sep='\\n')\n"
    )
    loaded = run_to_end([sys.executable, "-c", code]).stdout
    assert loaded.startswith(f"tfloom {tfloom.__version__}\n")
    ours = {name for name in loaded.splitlines() if name.startswith("tfloom.")}
    files = ("main", "parser", "quiet_imports", "shared", "shared.errors")
    assert ours == {"tfloom.cli", *(f"tfloom.cli.{name}" for name in files)}
    assert not {"numpy", "importlib.metadata"} & set(loaded.splitlines())


def test_version_is_in_the_metadata_of_each_distribution() -> None:
    assert version("tfloom") == tfloom.__version__, "run `make setup`"
    for beside in ("tfloom-ros2", "tfloom-rviz", "tfloom-interfaces", "tfloom-sensing"):
        assert version(beside) == tfloom.__version__, "run `make setup`"


def test_version_is_written_once_and_its_copies_match() -> None:
    own, *beside = (
        re.findall(r'^version = "(.*)"$', path.read_text("utf-8"), re.MULTILINE)
        for path in (ROOT / "pyproject.toml", *(ROOT / "packages").glob("*/pyproject.toml"))
        if path.parent.name != "tfloom-ddsc"  # which has the version of its library
    )
    assert own == []
    # Their sdists are built without tfloom's sources, so they can't read them.
    assert beside == [[tfloom.__version__]] * 4


def test_classifiers_match_the_systems_in_the_readme() -> None:
    text = (ROOT / "README.md").read_text("utf-8")
    tested = re.search(r"Tested: (.*?)\. Not yet tested: (.*?)\.\n", text, re.DOTALL)
    assert tested
    run = set(re.findall(r"\b3\.\d+\b", tested[1]))
    prefix = "Programming Language :: Python :: "
    named = {
        classifier.removeprefix(prefix)
        for classifier in classifiers()
        if classifier.startswith(f"{prefix}3.")
    }
    assert named == run
    systems = {
        classifier.split(" :: ")[-1]
        for classifier in classifiers()
        if classifier.startswith("Operating System")
    }
    assert systems == {name for name in ("Linux", "MacOS", "Windows") if name.lower() in tested[1].lower()}
    assert not any("Free Threading" in classifier for classifier in classifiers())
    assert metadata("tfloom").get_all("Project-URL") is None
