"""What is known before the viewer is loaded: whether the extra `view` is installed, and what a path is that of."""

from __future__ import annotations

from importlib.util import find_spec

__all__ = ["MISSING", "is_description", "is_installed"]

DESCRIPTIONS = (".urdf", ".xacro")
"""Of descriptions of robots."""
MISSING = "{name} needs viser, which is not installed: pip install 'tfloom[view]'"
"""What a user is told without it; `name` is what was asked for."""


def is_description(name: str) -> bool:
    """Return whether a word of a command line is that of a robot's description, by its ending."""
    return name.lower().endswith(DESCRIPTIONS)


def is_installed() -> bool:
    """Return whether the extra `view` is installed."""
    return all(find_spec(name) is not None for name in ("viser", "websockets", "msgspec", "trimesh"))
