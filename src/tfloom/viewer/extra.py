"""Whether the extra `view` is installed."""

from __future__ import annotations

from importlib.util import find_spec

__all__ = ["MISSING", "is_installed"]

MISSING = "{name} needs viser, which is not installed: pip install 'tfloom[view]'"
"""What a user is told without it; `name` is what was asked for."""


def is_installed() -> bool:
    """Return whether the extra `view` is installed."""
    return all(find_spec(name) is not None for name in ("viser", "websockets", "msgspec", "trimesh"))
