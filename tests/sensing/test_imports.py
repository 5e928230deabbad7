"""What imports load: nobody pays for what they don't use."""

from __future__ import annotations

import subprocess
import sys

import pytest


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
    assert not {name for name in loaded if name.startswith("tfloom.sensing")}


@pytest.mark.parametrize(
    "package", ["cv_bridge", "image_geometry", "diagnostic_updater", "interactive_markers"]
)
def test_a_package_loads_no_library_before_it_is_needed(package: str) -> None:
    assert not loaded_by(f"import {package}") & {"PIL", "cv2", "pygame", "reportlab"}
