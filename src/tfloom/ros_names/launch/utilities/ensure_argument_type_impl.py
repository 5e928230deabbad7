"""The check of an argument's type."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
