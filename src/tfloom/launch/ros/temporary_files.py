"""The temporary files of a launch: parameters of nodes, and scripts that start tfloom's own programs."""

from __future__ import annotations

import os
import shutil
import tempfile
import uuid
import weakref
from pathlib import Path

from tfloom.common.files import write_file
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.processes.guard import guard_of
from tfloom.workspace.program_scripts import write_script

__all__ = ["folder_of", "script_for", "write_temporary_file"]

_folders: weakref.WeakKeyDictionary[LaunchContext, Path] = weakref.WeakKeyDictionary()


def folder_of(context: LaunchContext) -> Path:
    """Return the folder of a launch's temporary files.

    It is removed with the context, at the latest when Python ends, because a node that is started again reads its files
    again; if the launch is killed, its guardian removes it.
    """
    if context not in _folders:
        # Not by `mkdtemp`: the guardian has to know the name before the folder is there. Nobody can guess the name, and
        # a folder that exists is an error, so it is never another user's.
        folder = Path(tempfile.gettempdir(), f"launch_{uuid.uuid4().hex}")
        guard_of(context).add_folder(str(folder))
        folder.mkdir(mode=0o700)
        weakref.finalize(context, shutil.rmtree, folder, ignore_errors=True)
        _folders[context] = folder
    return _folders[context]


def write_temporary_file(context: LaunchContext, text: str, *, prefix: str, suffix: str = "") -> Path:
    """Write a file of a new name in the folder of a launch's temporary files, and return its path."""
    descriptor, path = tempfile.mkstemp(suffix, prefix, folder_of(context))
    os.close(descriptor)
    write_file(path, text)
    return Path(path)


def script_for(context: LaunchContext, package: str, program: str, target: str) -> str:
    """Return the path of a script that runs one of tfloom's programs by the Python of this process.

    Args:
        context: The launch, whose temporary folder holds the script.
        package: Package of the program, for the path.
        program: Name of the program, which becomes the file's.
        target: `module:function` of the program.
    """
    return str(write_script(folder_of(context), package, program, target))
