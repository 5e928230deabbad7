"""Scripts that start tfloom's own programs, in the temporary files of a launch."""

from __future__ import annotations

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.temporary_files import folder_of
from tfloom.workspace.program_scripts import write_script

__all__ = ["script_for"]


def script_for(context: LaunchContext, package: str, program: str, target: str) -> str:
    """Return the path of a script that runs one of tfloom's programs by the Python of this process.

    Args:
        context: The launch, whose temporary folder holds the script.
        package: Package of the program, for the path.
        program: Name of the program, which becomes the file's.
        target: `module:function` of the program.
    """
    return str(write_script(folder_of(context), package, program, target))
