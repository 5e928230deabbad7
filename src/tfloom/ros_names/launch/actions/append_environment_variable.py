"""Append to an environment variable."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.append_environment_variable import AppendEnvironmentVariable as AppendEnvironmentVariable
