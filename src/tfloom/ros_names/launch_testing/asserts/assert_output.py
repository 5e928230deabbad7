"""Assertions on output."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.assert_output import assertDefaultStream as assertDefaultStream
from tfloom.launch.testing.assert_output import assertInStderr as assertInStderr
from tfloom.launch.testing.assert_output import assertInStdout as assertInStdout
from tfloom.launch.testing.assert_output import assertInStream as assertInStream
from tfloom.launch.testing.text import remove_ansi_escape_sequences as remove_ansi_escape_sequences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
    from tfloom.launch.testing.text import build_text_match as build_text_match
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        build_text_match="tfloom.launch.testing.text",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
