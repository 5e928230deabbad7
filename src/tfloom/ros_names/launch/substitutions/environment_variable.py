"""The value of an environment variable."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.environment_variable import EnvironmentVariable as EnvironmentVariable
