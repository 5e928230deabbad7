"""The hook that other plug-ins of pytest can implement for launch tests. PYTEST_DONT_REWRITE."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

__all__ = ["pytest_launch_collect_makemodule"]


@pytest.hookspec(firstresult=True)
def pytest_launch_collect_makemodule(module_path: Path, parent: Any, entrypoint: Any) -> Any:
    """Return the collector of a file with `generate_test_description`, or None to leave it to the next plug-in."""
