"""The check of an argument's type."""

from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
