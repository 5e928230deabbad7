"""docs/rclpy_api.md, its sources, and the existing names agree."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Iterator

import pytest
from docs import rclpy_api

NAMES = rclpy_api.all_names()
REASONS = rclpy_api.missing()
pytestmark = pytest.mark.filterwarnings("ignore:importing 'qos_event'")
TO_DO = "`make api` writes docs/rclpy_api.md anew from docs/rclpy_api_missing.txt"


def test_page_equals_the_output_of_the_script() -> None:
    assert rclpy_api.PAGE.read_text("utf-8") == rclpy_api.page(), TO_DO


def test_each_name_exists_with_the_recorded_signature() -> None:
    amiss = [
        f"{name.full}: {difference}"
        for name in NAMES
        if rclpy_api.reason_for(name, REASONS) is None
        for difference in rclpy_api.differences(name)
    ]
    assert not amiss, "\n".join(amiss)


def test_another_object_than_the_homes_is_detected() -> None:
    """Check the instrument itself."""
    duration = rclpy_api.Name("rclpy.time", "Time", "import", "rclpy.duration")
    (found,) = rclpy_api.differences(duration)
    assert found.endswith("not the object of rclpy.duration")


def test_an_imported_name_is_one_object_in_all_modules() -> None:
    """Compare names of one home, compiled modules included, and the QoS profiles."""
    objects: dict[tuple[str, str], dict[int, str]] = {}
    for name in NAMES:
        is_profile = name.path.startswith("qos_profile_")
        if (
            name.kind == "import"
            and (name.signature or is_profile)
            and not rclpy_api.reason_for(name, REASONS)
        ):
            found = getattr(importlib.import_module(name.module), name.path)
            objects.setdefault((name.signature, name.path), {})[id(found)] = name.module
    assert len(objects) > 100
    assert not [where for where in objects.values() if len(where) > 1]


def test_dir_lists_imported_names() -> None:
    missing = [
        name.full
        for name in NAMES
        if name.kind == "import"
        and not rclpy_api.reason_for(name, REASONS)
        and name.path not in dir(importlib.import_module(name.module))
    ]
    assert not missing


def wrongly_missing(patterns: Iterable[str]) -> Iterator[str]:
    """Yield the patterns that match no recorded name, and the existing names that they match."""
    for pattern in patterns:
        matched = [name for name in NAMES if rclpy_api.is_of(name, pattern)]
        if not matched:
            yield f"{pattern}: no recorded name is so called"
        yield from (
            f"{pattern}: {name.full} is there" for name in matched if not any(rclpy_api.differences(name))
        )


def test_names_listed_as_missing_are_missing() -> None:
    amiss = list(wrongly_missing(REASONS))
    assert not amiss, "\n".join([*amiss, f"take it out of docs/rclpy_api_missing.txt; {TO_DO}"])


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
        return list(rclpy_api._signature_differences(signature, ours))

    assert seen("(node: Node, *, depth: Union[int, None] = 10) -> None") == []
    assert seen("(self, node, **kwargs)") == []
    assert seen("(node, *, queue=1)") == ["it has no parameter queue"]
    assert seen("(node, depth=10)")[0] == "its parameter depth is keyword, not positional"
    assert seen("(node, *, depth=5)") == ["the default of depth is 10, not 5"]
    assert seen("(*, depth=10)") == ["it requires a parameter node that the recorded one lacks"]
    assert seen("(node='x')") == ["the default of node is None, not 'x'"]
    missing = rclpy_api.Name("rclpy.node", "Node.fly", "method", "(self)")
    assert list(rclpy_api.differences(missing)) == ["it does not exist"]
    elsewhere = rclpy_api.Name("rclpy.nowhere", "Node", "class", "")
    assert list(rclpy_api.differences(elsewhere)) == ["the module does not exist"]
