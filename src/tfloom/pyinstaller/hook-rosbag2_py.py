"""Collect the modules of recordings, which are imported by name: readers, writers, and the names of rosbag2_py."""

from __future__ import annotations

from PyInstaller.utils.hooks import collect_submodules

hiddenimports = collect_submodules("tfloom.bag")
