"""Restore the environment variables of the launch's start."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.reset_environment import ResetEnvironment as ResetEnvironment
