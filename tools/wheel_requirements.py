"""The requirements in the metadata of tfloom's wheel: scikit-build-core calls these functions while it builds.

They stand in pyproject.toml, but not as static ones: PyPI's wheels of cyclonedds for Linux need glibc. No marker of a
requirement distinguishes glibc and musl, so pip would compile it on Alpine.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any


def dynamic_metadata(settings: Mapping[str, Any], project: Mapping[str, Any]) -> dict[str, list[str]]:  # noqa: ARG001
    """Return what a wheel requires that the running Python builds.

    Args:
        settings: The rest of the provider's table in pyproject.toml: `dependencies` and `needs-glibc`.
        project: The table `project`.
    """
    is_musl = "musl" in getattr(sys.implementation, "_multiarch", "")
    return {"dependencies": [*settings["dependencies"], *([] if is_musl else settings["needs-glibc"])]}


def dynamic_wheel(settings: Mapping[str, Any]) -> dict[str, bool]:  # noqa: ARG001
    """Return which fields of a wheel may differ from those of the source distribution."""
    return {"dependencies": True}
