"""Collect what tfloom finds by name at run time: modules, definitions, and the DDS library."""

from __future__ import annotations

from pathlib import Path

from PyInstaller.utils.hooks import collect_data_files, collect_submodules

from tfloom.rmw.cyclone import library as cyclone_library
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.errors import NoBackendError

# RMW_IMPLEMENTATION names a module of rmw/, a type's name one of interfaces/, a façade's deferred names those of node/.
ROOMS = ("interfaces", "node", "rmw", "rosidl", "tf2")

hiddenimports = [module for room in ROOMS for module in collect_submodules(f"tfloom.{room}")]
datas = collect_data_files("tfloom", excludes=["**/*.pyi"])
binaries: list[tuple[str, str]] = []

try:
    library = Path(find_library())
except NoBackendError:
    pass  # such a program has only the wire inside one process
else:
    # As if tfloom-ddsc were installed, wherever it comes from: the search looks into that package's folder.
    binaries.append((str(library), "tfloom_ddsc"))
    # The package isn't imported: the search locates its folder by this file, whatever it holds.
    datas.append((str(Path(cyclone_library.__file__).with_name("__init__.py")), "tfloom_ddsc"))
