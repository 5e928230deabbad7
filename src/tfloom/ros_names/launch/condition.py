"""The base class of conditions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.condition import Condition as Condition
