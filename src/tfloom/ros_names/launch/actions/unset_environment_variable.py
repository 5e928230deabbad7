"""Remove an environment variable."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.unset_environment_variable import UnsetEnvironmentVariable as UnsetEnvironmentVariable
