"""Copies of tfloom, and of its DDS library, in folders that another Python with the same ABI can have on its path."""

from __future__ import annotations

import shutil
import sys
from importlib.machinery import PathFinder
from pathlib import Path


def stage(folder: Path) -> Path:
    """Put into a folder what the wheel of tfloom installs into site-packages, without compiling; return it."""
    import tfloom
    from tfloom import _native

    source = Path(tfloom.__file__).parent
    shutil.copytree(source, folder / "tfloom", ignore=shutil.ignore_patterns("__pycache__"))
    extension = Path(_native.__file__)
    if not (folder / "tfloom" / extension.name).exists():
        shutil.copy(extension, folder / "tfloom")
    installed = next(path for entry in sys.path if (path := Path(entry, "tfloom.pth")).exists())
    _, finder = installed.read_text("utf-8").splitlines()
    (folder / "tfloom.pth").write_text(f"tfloom/ros_names\n{finder}\n", "utf-8")
    return folder


def stage_dds(folder: Path) -> Path:
    """Put links to the installed wheel of cyclonedds into a folder, and return it.

    Raises:
        FileNotFoundError: cyclonedds is not installed.
    """
    spec = PathFinder.find_spec("cyclonedds")
    if spec is None or not spec.submodule_search_locations:
        raise FileNotFoundError("cyclonedds is not installed")
    package = Path(next(iter(spec.submodule_search_locations)))
    for part in (package, package.parent / "cyclonedds.libs"):
        if part.exists():
            (folder / part.name).symlink_to(part, target_is_directory=True)
    return folder
