"""Set an environment variable."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.set_environment_variable import SetEnvironmentVariable as SetEnvironmentVariable
