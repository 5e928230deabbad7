"""Small programs about launch and launch_testing: what they print, beside what they printed with the reference.

Each program prints a line a question. A line that differs on purpose names its row of docs/deviations.md.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.conftest import run_to_end

import tfloom

ANSWERS = Path(__file__).parents[1] / "golden" / "answers"
TIMEOUT_S = 100


class Ours(NamedTuple):
    """What tfloom prints in place of some lines of the reference."""

    deviation: str
    lines: tuple[str, ...]
    replaces: int = 1
    """Number of the reference's lines, from the one that begins with the key."""


UNIFORM = (
    "TypeError: Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, "
    'float, str. Got inconsistent input for "f"'
)
VALUE = "TypeError: Unexpected type for parameter value"
LIST = "TypeError: 'Node' expected 'parameters' to be one of [<class 'list'>], but got "
DIFFERENCES: dict[str, dict[str, Ours]] = {
    "launch_values": {
        "03 ": Ours("launch-untyped-parameters", ("03 ParameterValue(L) 1e-3: 0.001",)),
        "07 ": Ours("launch-untyped-parameters", ('07 ParameterValue(L) "[1.0, 2]": [1.0, 2.0]',)),
        "08 ": Ours("launch-untyped-parameters", ("08 ParameterValue(L) null: 'null'",)),
        "09 ": Ours("launch-list-of-floats", ("09 ParameterValue(L, List[float]): [1.0, 2.0]",)),
        "17 ": Ours(
            "launch-untyped-parameters",
            (
                (
                    "17 ParameterValue(\"[1, asd]\"): ValueError: the list of 'value' must be of one scalar type, not "
                    "int, str"
                ),
            ),
        ),
        "20 ": Ours(
            "launch-untyped-parameters",
            ("20 evaluate_parameters: ({'a': 0.001, 'b': (1, 2), 'c': '1x', 'd.e': 1.0, 'f': (1.0, 2.0)},)",),
        ),
        "21b ": Ours("launch-parameter-texts", (f"21b evaluate mixed: {UNIFORM}: [1, 'a']",)),
        "24 ": Ours(
            "launch-parameter-texts",
            (f"24 None: {VALUE} None, of class NoneType, given to the parameter 'f'",),
        ),
        "45 ": Ours(
            "launch-parameter-texts",
            (f"45 Node params str: {LIST}'x' of type '<class 'str'>': write parameters=['x']",),
        ),
        "46 ": Ours(
            "launch-parameter-texts",
            (
                f"46 Node params dict: {LIST}'{{'a': 1}}' of type '<class 'dict'>': write parameters=[{{'a': 1}}]",
            ),
        ),
        "47 ": Ours(
            "launch-parameter-texts",
            ("47 Node remappings: TypeError: remap_rule must be a tuple of length 2, got length 1: ('a',)",),
        ),
        "27 ": Ours(
            "launch-parameter-texts",
            (
                "27 dict with int key: TypeError: Expecting a text or substitutions as the name of a parameter, got 1",
            ),
        ),
        "28 ": Ours(
            "launch-parameter-texts",
            (
                (
                    "28 list of dicts: RuntimeError: Failed to handle type {'a': 1}: it is an item of the parameter "
                    "'f'"
                ),
            ),
        ),
        "57 ": Ours(
            "workspace-not-sourced",
            (
                (
                    "57 FindPackageShare missing: PackageNotFoundError: package 'nothere' not found, no workspace is "
                    "sourced in this terminal (AMENT_PREFIX_PATH is not set)"
                ),
            ),
        ),
        "59 ": Ours(
            "launch-program",
            (
                (
                    "59 ExecutableInPackage: SubstitutionFailure: executable 'nothere' not found on the libexec "
                    "directory '<tfloom>/lib/rclpy'; it has no programs"
                ),
            ),
        ),
        "63 ": Ours(
            "launch-parameter-file-stays",
            (
                "63 ParameterFile allow_substs: /**:",
                "  ros__parameters:",
                "    a: foo",
                "    b: <home>",
                "",
            ),
        ),
    },
    "launch_behaviour": {
        "27 ": Ours(
            "launch-substitution-texts", ("27 PythonLaunchDescriptionSource.location: '/x/y.launch.py'",)
        ),
        "[ERROR] [python-4]: process[python-4] failed to terminate": Ours(
            "launch-signal-group",
            (
                "[INFO] [python-4]: sending signal 'SIGINT' to process[python-4]",
                "[python-4] Traceback (most recent call last):",
                '[python-4]   File "<string>", line 1, in <module>',
                "[python-4] KeyboardInterrupt",
                (
                    "[ERROR] [python-4]: process has died [pid N, exit code -2, cmd '<prefix>/bin/python -S -c "
                    "input()']."
                ),
                "32 codes after a shutdown due to sigint: [-2, -2]",
            ),
            replaces=4,
        ),
    },
}
LISTS_NAMES = re.compile(r"3[0-3] ")
"""Lines of `launch_testing_output` with the names of a module: more names make no difference to a program."""


@pytest.mark.parametrize(
    "program", ["launch_values", "launch_behaviour", "launch_testing_output", "launch_testing_checks"]
)
def test_answers_are_those_of_the_reference(
    program: str, tmp_path: Path, domain_id: int, deviations: dict[str, dict[str, str]]
) -> None:
    environment = {**os.environ, "ROS_LOG_DIR": str(tmp_path / "log")}
    if program == "launch_values":
        del environment["ROS_LOG_DIR"]  # which the program changes, and the reference's had none
    environment.pop("AMENT_PREFIX_PATH", None)
    ran = run_to_end(
        [sys.executable, ANSWERS / f"{program}.py"],
        cwd=tmp_path,
        env={**environment, "HOME": str(tmp_path)},
        timeout_s=TIMEOUT_S,
    )
    assert ran.returncode == 0, ran.stderr
    recorded = (ANSWERS / f"{program}.txt").read_text("utf-8").splitlines()
    differences = DIFFERENCES.get(program, {})
    assert {ours.deviation for ours in differences.values()} <= deviations.keys()
    expected = list(masked(_with_differences(recorded, differences), tmp_path))
    printed = list(masked(ran.stdout.splitlines(), tmp_path))
    if program == "launch_testing_output":
        expected, printed = _without_more_names(expected, printed)
    assert printed == expected


def _with_differences(lines: Iterable[str], differences: dict[str, Ours]) -> Iterator[str]:
    left, skipped = dict(differences), 0
    for line in lines:
        if skipped:
            skipped -= 1
            continue
        key = next((key for key in left if line.startswith(key)), None)
        if key is None:
            yield line
        else:
            ours = left.pop(key)
            assert line not in ours.lines, f"{line}: there is no difference any more"
            yield from ours.lines
            skipped = ours.replaces - 1
    assert not left


def masked(lines: Iterable[str], home: Path) -> Iterator[str]:
    """Yield lines without what differs between machines: process ids, folders and addresses."""
    for line in lines:
        text = line.replace(str(Path(tfloom.__file__).parent), "<tfloom>").replace(str(home), "<home>")
        text = text.replace(sys.prefix, "<prefix>").replace(sys.executable, "<prefix>/bin/python")
        text = re.sub(r"<[\w.]*\.(\w+) obj(ect at 0x\w+>)?", r"<\1 object>", text)
        text = re.sub(r"pid \[?(\d+|N)\]?", "pid N", text)
        yield re.sub(r"(found below ).*", r"\1<log folder>", text)


def _without_more_names(expected: list[str], printed: list[str]) -> tuple[list[str], list[str]]:
    """Return the lines without those that list names; all that the reference lists have to be there."""
    own = {line.partition(": ")[0]: _names(line) for line in printed if LISTS_NAMES.match(line)}
    for line in filter(LISTS_NAMES.match, expected):
        start = line.partition(": ")[0]
        assert _names(line) <= own[start], start
    rest = [[line for line in lines if not LISTS_NAMES.match(line)] for lines in (expected, printed)]
    return rest[0], rest[1]


def _names(line: str) -> set[str]:
    return set(re.findall(r"'(\w+)'", line))
