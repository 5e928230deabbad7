"""A plug-in of pytest: the markers in the tests that `ros2 pkg create` generates, which pytest would warn of.

`colcon test` names it in PYTEST_PLUGINS, because other runs of pytest do not need it.
"""

from __future__ import annotations

from typing import Protocol

MARKERS = {
    "linter": "checks style, not behaviour",
    "copyright": "checks notices of copyright",
    "flake8": "checks style with flake8",
    "pep257": "checks docstrings with pydocstyle",
    "mypy": "checks types",
    "xmllint": "checks XML",
}


class Config(Protocol):
    """What is used of pytest's configuration."""

    def addinivalue_line(self, name: str, line: str) -> None:
        """Add a line to an option."""


def pytest_configure(config: Config) -> None:
    """Register the markers."""
    for name, text in MARKERS.items():
        config.addinivalue_line("markers", f"{name}: {text}")
