"""The temporary files of a launch: parameters of nodes, and scripts that start tfloom's own programs."""

from __future__ import annotations

import os
import shutil
import tempfile
import weakref
from pathlib import Path

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.processes.running import guard_of
from tfloom.whole_files import write_file

__all__ = ["folder_of", "write_temporary_file"]

_folders: weakref.WeakKeyDictionary[LaunchContext, Path] = weakref.WeakKeyDictionary()


def folder_of(context: LaunchContext) -> Path:
    """Return the folder of a launch's temporary files.

    It is removed with the context, at the latest when Python ends, because a node that is started again reads its files
    again; if the launch is killed, its guardian removes it.
    """
    if context not in _folders:
        folder = Path(tempfile.mkdtemp(prefix="launch_"))
        weakref.finalize(context, shutil.rmtree, folder, ignore_errors=True)
        guard_of(context).add_folder(str(folder))
        _folders[context] = folder
    return _folders[context]


def write_temporary_file(context: LaunchContext, text: str, *, prefix: str, suffix: str = "") -> Path:
    """Write a file of a new name in the folder of a launch's temporary files, and return its path."""
    descriptor, path = tempfile.mkstemp(suffix, prefix, folder_of(context))
    os.close(descriptor)
    write_file(path, text)
    return Path(path)
