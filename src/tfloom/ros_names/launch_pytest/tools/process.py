"""Waits for what a process does."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.fixtures.process import assert_output as assert_output
from tfloom.launch.testing.fixtures.process import assert_output_sync as assert_output_sync
from tfloom.launch.testing.fixtures.process import assert_stderr as assert_stderr
from tfloom.launch.testing.fixtures.process import assert_stderr_sync as assert_stderr_sync
from tfloom.launch.testing.fixtures.process import register_event_handler as register_event_handler
from tfloom.launch.testing.fixtures.process import wait_for_exit as wait_for_exit
from tfloom.launch.testing.fixtures.process import wait_for_exit_sync as wait_for_exit_sync
from tfloom.launch.testing.fixtures.process import wait_for_output as wait_for_output
from tfloom.launch.testing.fixtures.process import wait_for_output_sync as wait_for_output_sync
from tfloom.launch.testing.fixtures.process import wait_for_start as wait_for_start
from tfloom.launch.testing.fixtures.process import wait_for_start_sync as wait_for_start_sync
from tfloom.launch.testing.fixtures.process import wait_for_stderr as wait_for_stderr
from tfloom.launch.testing.fixtures.process import wait_for_stderr_sync as wait_for_stderr_sync
