"""End a scope of environment variables."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.pop_environment import PopEnvironment as PopEnvironment
