"""The recorded names of ROS 2 exist in tfloom, with their signatures; those that are listed as missing do not."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from docs import rclpy_api
from tests.conftest import run_to_end
from tests.recorded_signatures import differences, signature_differences
from tools.facades.recorded import Name, all_names, is_of, is_only_imported, missing, reason_for

NAMES = all_names()
REASONS = missing()
pytestmark = pytest.mark.filterwarnings("ignore:importing 'qos_event'")


def test_each_name_exists_with_the_recorded_signature() -> None:
    amiss = [
        f"{name.full}: {difference}"
        for name in NAMES
        if reason_for(name, REASONS) is None
        for difference in differences(name)
    ]
    assert not amiss, "\n".join(amiss)


def test_another_object_than_the_homes_is_detected() -> None:
    """Check the instrument itself."""
    duration = Name("rclpy.time", "Time", "import", "rclpy.duration")
    (found,) = differences(duration)
    assert found.endswith("not the object of rclpy.duration")


def test_an_imported_name_is_one_object_in_all_modules() -> None:
    """Compare names of one home, compiled modules included, and the QoS profiles."""
    objects: dict[tuple[str, str], dict[int, str]] = {}
    for name in NAMES:
        is_profile = name.path.startswith("qos_profile_")
        if name.kind == "import" and (name.signature or is_profile) and not reason_for(name, REASONS):
            thing = getattr(importlib.import_module(name.module), name.path)
            objects.setdefault((name.signature, name.path), {})[id(thing)] = name.module
    assert len(objects) > 100
    assert not [where for where in objects.values() if len(where) > 1]


def test_dir_lists_imported_names() -> None:
    missing = [
        name.full
        for name in NAMES
        if name.kind == "import"
        and not reason_for(name, REASONS)
        and name.path not in dir(importlib.import_module(name.module))
    ]
    assert not missing


def wrongly_missing(patterns: Iterable[str]) -> Iterator[str]:
    """Yield the patterns that match no recorded name, and the existing names that they match."""
    for pattern in patterns:
        matched = [name for name in NAMES if is_of(name, pattern)]
        if not matched:
            yield f"{pattern}: no recorded name is so called"
        yield from (f"{pattern}: {name.full} is there" for name in matched if not any(differences(name)))


def test_names_listed_as_missing_are_missing() -> None:
    amiss = list(wrongly_missing(REASONS))
    assert not amiss, "\n".join(
        [*amiss, "take it out of tools/facades/missing.txt, and run `make generated`"]
    )


def test_existing_or_unrecorded_names_are_not_missing() -> None:
    assert list(wrongly_missing(["rclpy.node.Node.fly", "rclpy.node.Node.create_timer"])) == [
        "rclpy.node.Node.fly: no recorded name is so called",
        "rclpy.node.Node.create_timer: rclpy.node.Node.create_timer is there",
    ]


def test_signature_differences_are_found() -> None:
    """The comparison reports each difference from these recorded signatures."""

    def ours(node: object, *, depth: int = 10, raw: bool = False) -> None:
        """Return a substitute for one of tfloom's functions."""

    def seen(signature: str) -> list[str]:
        return list(signature_differences(signature, ours))

    assert seen("(node: Node, *, depth: Union[int, None] = 10) -> None") == []
    assert seen("(self, node, **kwargs)") == []
    assert seen("(node, *, queue=1)") == ["it has no parameter queue"]
    assert seen("(node, depth=10)")[0] == "its parameter depth is keyword, not positional"
    assert seen("(node, *, depth=5)") == ["the default of depth is 10, not 5"]
    assert seen("(*, depth=10)") == ["it requires a parameter node that the recorded one lacks"]
    assert seen("(node='x')") == ["the default of node is None, not 'x'"]
    missing = Name("rclpy.node", "Node.fly", "method", "(self)")
    assert list(differences(missing)) == ["it does not exist"]
    elsewhere = Name("rclpy.nowhere", "Node", "class", "")
    assert list(differences(elsewhere)) == ["the module does not exist"]


def test_names_that_are_only_imported_are_not_there() -> None:
    """In launch and launch_ros a module has what it defines, and of its imports those that a program uses."""
    dropped = [name for name in NAMES if is_only_imported(name)]
    assert {name.module.split(".")[0] for name in dropped} == {"launch", "launch_ros"}
    assert len(dropped) > 600
    assert not [name.full for name in dropped if name.path in dir(importlib.import_module(name.module))]


@pytest.mark.parametrize(
    ("module", "name", "home"),
    [
        ("launch.action", "LaunchContext", "launch"),
        ("launch.actions.execute_local", "TimerAction", "launch.actions"),
        ("launch_ros.actions.node", "ExecuteProcess", "launch.actions"),
        ("launch_ros.parameters_type", "ParameterFile", "launch_ros.parameter_descriptions"),
        ("launch_ros.substitutions.find_package", "get_package_share_directory", "ament_index_python"),
    ],
)
def test_names_that_programs_import_from_elsewhere_are_there(module: str, name: str, home: str) -> None:
    found = getattr(importlib.import_module(module), name)
    assert found is getattr(importlib.import_module(home), name)


def test_page_of_the_site_is_made_without_tfloom() -> None:
    code = "import sys; sys.modules['tfloom'] = None\nfrom docs import rclpy_api; print(rclpy_api.page())"
    result = run_to_end([sys.executable, "-c", code], cwd=Path(__file__).parents[1])
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    assert (
        "| `Node.create_timer(timer_period_sec, callback, callback_group=None, clock=None, autostart=True)` | ✓ |"
        in lines
    )
    assert "| `ParameterEventHandler.Callbacks()` | an internal of rclpy |" in lines
    assert result.stdout == rclpy_api.page() + "\n"
