"""Assertions on the order of output."""

from tfloom.launch.testing.assert_sequential_output import SequentialTextChecker as SequentialTextChecker
from tfloom.launch.testing.assert_sequential_output import assertSequentialStdout as assertSequentialStdout
from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
