"""Assertions on the order of a process's output. PYTEST_DONT_REWRITE."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from tfloom.launch.testing.assert_output import ProcOutput, text_of
from tfloom.launch.testing.proc_lookup import CmdArgs, Process, resolveProcesses

__all__ = ["SequentialTextChecker", "assertSequentialStdout"]

_NEARBY = 3
"""Number of line breaks before a text, and of those after it, between which the lines near it are."""


class SequentialTextChecker:
    """Finds texts in an output, each after the one before.

    Args:
        output: Lines with their line breaks, or parts of any length.
    """

    def __init__(self, output: Sequence[str]) -> None:
        self._output = "".join(output)
        self._at = 0  # after the last text that was found

    def assertInStdout(self, msg: str) -> None:
        """Assert that a text follows the ones that were found before.

        Raises:
            AssertionError: it is not there, or only before.
        """
        begin = self._output.find(msg, self._at)
        if begin >= 0:
            self._at = begin + len(msg)
            return
        raise AssertionError(
            f"'{msg}' not found in sequence after previous match.  "
            f"The output near the last matched line:\n{self.get_nearby_lines()}"
        )

    def assertInText(self, msg: str) -> None:
        """Assert that a text follows the ones that were found before, as `assertInStdout` does."""
        self.assertInStdout(msg)

    def get_nearby_lines(self) -> str:
        """Return the lines around the last text that was found, as one text: two before it, and up to three after."""
        breaks = [found.start() for found in re.finditer("\n", self._output)]
        before = [place for place in breaks if place < self._at][-_NEARBY:]
        after = [place for place in breaks if place > self._at][:_NEARBY]
        begin = before[0] + 1 if len(before) == _NEARBY else 0
        return self._output[begin : after[-1] if after else self._at]


@contextmanager
def assertSequentialStdout(
    proc_output: ProcOutput, process: Process, cmd_args: CmdArgs = None
) -> Iterator[SequentialTextChecker]:
    """Return a context manager that gives a checker of the order in a process's standard output.

    Args:
        proc_output: Recorded output, of a test's argument of this name.
        process: An action, or a part of a process's name.
        cmd_args: With a name: arguments that the process was given.

    Raises:
        NoMatchingProcessException: no process matches.
        Exception: several do.
    """
    actions = resolveProcesses(proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=True)
    if len(actions) > 1:
        raise Exception("Found multiple processes: the order of one process is checked; name it")
    yield SequentialTextChecker([text_of(proc_output[actions[0]], "stdout")])
