"""The path of an executable."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.find_executable import FindExecutable as FindExecutable
