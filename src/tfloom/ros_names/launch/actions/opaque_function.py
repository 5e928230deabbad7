"""Call a function."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
