"""The base class of substitutions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitution import Substitution as Substitution
