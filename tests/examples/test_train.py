"""The turtle train by one launch file, in Python, XML and YAML; from the sources, which need no build for that."""

from __future__ import annotations

import math
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.launch.conftest import Ran, _logs, launch  # noqa: F401  # fixtures
from tests.launch.ros.conftest import SHOW, make_package
from tests.launch.ros.user import User, expect_clean_end, is_running, pids_of

from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.files.sources import AnyLaunchDescriptionSource

SOURCE = Path(__file__).parents[2] / "examples" / "workspace" / "src"
LAUNCH = SOURCE / "train_bringup" / "launch"
FORMATS = ("py", "xml", "yaml")
NODES = ("driver", "follower", "frames", "train")
WAGONS = 10
BOUND_S = 60.0
"""The longest time until all wagons follow [s], on a loaded machine."""

pytestmark = pytest.mark.skipif(os.name != "posix", reason="its programs are scripts")


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a prefix with the packages of the workspace, except for the programs."""
    prefix = tmp_path / "install"
    for package, folders in (("train_bringup", ("launch", "config")), ("train_interfaces", ("msg", "srv"))):
        share = make_package(prefix, package)
        for folder in folders:
            shutil.copytree(SOURCE / package / folder, share / folder)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    return prefix


@pytest.mark.parametrize(
    "arguments",
    [pytest.param({}, marks=pytest.mark.slow), {"gap": "0.9", "speed": "0.5"}],
    ids=["defaults", "arguments"],
)
def test_three_formats_start_the_same_processes(
    prefix: Path,
    launch: Callable[..., Ran],  # noqa: F811
    arguments: dict[str, str],
) -> None:
    """Each program prints its arguments and its parameter files."""
    show = SHOW.replace("word $word", "word ${word##*/launch_params_*}")
    make_package(prefix, "turtle_train", **dict.fromkeys(NODES, show))
    make_package(prefix, "turtlesim", turtlesim_node=show)
    printed = {}
    for name in FORMATS:
        source = AnyLaunchDescriptionSource(str(LAUNCH / f"train.launch.{name}"))
        os.environ["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "screen"
        try:
            ran = launch(IncludeLaunchDescription(source, launch_arguments=arguments.items()))
        finally:
            del os.environ["OVERRIDE_LAUNCH_PROCESS_OUTPUT"]
        assert ran.code == 0, ran.lines
        lines = [line for line in ran.lines if not line.startswith("[INFO]")]
        values: dict[str, list[str]] = {}
        numbers = [int(line.partition("] ")[0].rpartition("-")[2]) for line in lines]
        for line in lines:
            # The numbers of processes count on from one launch of a program to the next.
            process, _, number = line.partition("] ")[0].rpartition("-")
            text = line.partition("] ")[2]
            values.setdefault(f"{process}-{int(number) - min(numbers) + 1}", []).append(text)
        # The formats may divide a node's values among files in different ways.
        printed[name] = {process: sorted(set(texts)) for process, texts in values.items()}
    processes = ["turtlesim_node-1", "frames-2", "driver-3", "train-4"]
    processes += [f"follower-{number}" for number in range(5, 5 + WAGONS)]
    for name in FORMATS:
        assert sorted(printed[name]) == sorted(f"[{process}" for process in processes)
        assert printed[name] == printed["py"], name
    assert f"file     gap: {arguments.get('gap', '0.4')}" in printed["py"]["[train-4"]
    assert f"file     speed: {arguments.get('speed', '0.8')}" in printed["py"]["[driver-3"]


@pytest.fixture
def user(domain_id: int) -> Iterator[User]:
    user = User()
    yield user
    user.end()


@pytest.mark.slow
def test_ten_wagons_come_to_follow(
    prefix: Path, user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    program_of = "#!/bin/sh\nexec '{}' -c 'from turtle_train.{} import main; main()' \"$@\"\n"
    programs = {name: program_of.format(sys.executable, name) for name in NODES}
    make_package(prefix, "turtle_train", **programs)
    path = f"{SOURCE / 'turtle_train'}{os.pathsep}{os.environ.get('PYTHONPATH', '')}".rstrip(os.pathsep)
    begin = time.monotonic()
    program = start_program(
        "tfloom", "launch", "train_bringup", "train.launch.py", env={**os.environ, "PYTHONPATH": path}
    )
    turtles = ["turtle1", *(f"wagon{number}" for number in range(1, WAGONS + 1))]

    def has_left(number: int) -> bool:
        """Return whether a wagon has left the place where it was spawned."""
        at = user.position("world", turtles[number])
        return at is not None and math.dist(at, (5.5 - 0.5 * number, 5.5)) > 0.1

    def follows(number: int) -> bool:
        """Return whether a wagon is at the distance that the gap, the speed and the gain give, 0.8 m, or near it."""
        at = user.position(turtles[number], turtles[number - 1])
        return at is not None and at[0] > 0.0 and math.hypot(*at) < 1.1

    def train_drives() -> bool:
        assert program.process.poll() is None, program.output
        return all(has_left(number) and follows(number) for number in range(1, WAGONS + 1))

    wait_until(user.sees(train_drives), BOUND_S, what="all wagons to follow")
    print(f"{len(pids_of(program))} nodes, all wagons following after {time.monotonic() - begin:.1f} s")
    pids = pids_of(program)
    assert len(pids) == 4 + WAGONS
    assert "WARNING" not in program.output
    expect_clean_end(program)
    wait_until(lambda: not any(map(is_running, pids)))
