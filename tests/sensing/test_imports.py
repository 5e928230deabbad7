"""What imports load: nobody pays for what they don't use."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.test_facades import RULES, Rule

from tfloom.ros_imports.distributions import SENSING, find_prefix

ROOT = Path(__file__).parents[2]


def loaded_by(code: str) -> set[str]:
    """Run code and return the names of all modules that it loaded."""
    result = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport sys; print(*sys.modules)"],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return set(result.stdout.split())


def test_rclpy_loads_none_of_it() -> None:
    loaded = loaded_by("import rclpy, rclpy.node, rclpy.executors")
    assert not {name for name in loaded if name.startswith("tfloom_sensing")}


def test_a_package_loads_no_library_before_it_is_needed() -> None:
    loaded = loaded_by(f"import {', '.join(SENSING.ros_packages)}")
    assert not loaded & {"PIL", "cv2", "pygame", "reportlab"}


def test_what_is_installed_is_this_checkouts() -> None:
    prefix = find_prefix(SENSING)
    assert prefix is not None, "run `make setup`"
    house = ROOT / "packages" / SENSING.name / "src" / SENSING.import_package
    for path in house.rglob("*.py"):
        assert (prefix / path.relative_to(house)).read_bytes() == path.read_bytes(), "run `make setup`"


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_each_facade_keeps_the_rules_of_facades(rule: Rule) -> None:
    prefix = find_prefix(SENSING)
    assert prefix is not None
    folder = prefix / "ros_names"
    assert {path.name for path in folder.iterdir()} == set(SENSING.ros_packages)
    broken = list(rule(folder))
    assert not broken, "\n".join(broken)
