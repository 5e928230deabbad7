"""The text of several substitutions."""

from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
