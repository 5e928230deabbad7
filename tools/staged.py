"""Copies of tfloom, and of its DDS library, in folders that another Python with the same ABI can have on its path."""

from __future__ import annotations

import shutil
import sys
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
    _, finder, *_ = installed.read_text("utf-8").splitlines()
    (folder / "tfloom.pth").write_text(f"tfloom/ros_names\n{finder}\n", "utf-8")
    return folder


def stage_dds(folder: Path) -> Path:
    """Put a link to this environment's libddsc into a folder, as tfloom-ddsc would install it; return the folder.

    Raises:
        FileNotFoundError: there is no libddsc.
    """
    from tfloom.rmw.cyclone.library import find_library
    from tfloom.rmw.errors import NoBackendError

    try:
        library = Path(find_library())
    except NoBackendError as error:
        raise FileNotFoundError(error) from None
    (folder / "tfloom_ddsc").mkdir()
    (folder / "tfloom_ddsc" / "__init__.py").touch()
    (folder / "tfloom_ddsc" / library.name).symlink_to(library)
    return folder
