"""Collect the message classes and the definitions of the distribution `tfloom-interfaces`."""

from __future__ import annotations

from PyInstaller.utils.hooks import collect_data_files, collect_submodules

hiddenimports = collect_submodules("tfloom_interfaces")
datas = collect_data_files("tfloom_interfaces")
