"""What other packages add to launch files, by entry points."""

from __future__ import annotations

import warnings
from typing import Any

from tfloom.ros_imports.distributions import may_have_entry_points

__all__ = ["load_entry_points", "load_launch_extensions"]

_loaded = False


def load_launch_extensions() -> None:
    """Import all modules of the entry points `launch.frontend.launch_extension`, at the first call.

    They expose actions and substitutions. One that cannot be imported is reported by a warning.
    """
    global _loaded  # noqa: PLW0603  # all of the process shares what they expose
    if not _loaded:
        _loaded = True
        load_entry_points("launch.frontend.launch_extension")


def load_entry_points(group: str) -> dict[str, Any]:
    """Return the objects of all entry points of a group, by their names. One that fails is reported by a warning."""
    if not may_have_entry_points(group):
        return {}
    from importlib.metadata import entry_points

    loaded = {}
    for entry_point in entry_points(group=group):
        try:
            loaded[entry_point.name] = entry_point.load()
        except Exception as error:  # of any package
            what = f"the extension '{entry_point.name}' of {group} ({entry_point.value})"
            warnings.warn(f"Failed to load {what}: {type(error).__name__}: {error}", stacklevel=3)
    return loaded
