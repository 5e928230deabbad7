"""Matchers of processes, for the events that do something to some of them."""

from tfloom.launch.events.process.process_matchers import matches_executable as matches_executable
from tfloom.launch.events.process.process_matchers import matches_name as matches_name
from tfloom.launch.events.process.process_matchers import matches_pid as matches_pid
