"""Collect what launch files name: tags, substitutions, languages, and the façades' deferred names."""

from __future__ import annotations

from PyInstaller.utils.hooks import collect_submodules

# The modules of launch_testing import pytest, which a frozen program seldom has; one that has them imports them itself.
hiddenimports = collect_submodules("tfloom.launch", filter=lambda name: ".testing" not in name)
