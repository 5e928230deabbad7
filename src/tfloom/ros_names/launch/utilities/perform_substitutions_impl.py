"""The text of several substitutions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
