"""Begin a scope of environment variables."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.push_environment import PushEnvironment as PushEnvironment
