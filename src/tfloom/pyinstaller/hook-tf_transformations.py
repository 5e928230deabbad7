"""Collect transforms3d, which tf_transformations imports for Euler angles, if it is installed."""

from __future__ import annotations

from PyInstaller.utils.hooks import collect_submodules

hiddenimports = collect_submodules(
    "transforms3d", filter=lambda name: ".tests" not in name, on_error="ignore"
)
