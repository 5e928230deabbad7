"""Matchers of processes, for the events that do something to some of them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.process_matchers import matches_executable as matches_executable
from tfloom.launch.events.process.process_matchers import matches_name as matches_name
from tfloom.launch.events.process.process_matchers import matches_pid as matches_pid
