"""Constants of time."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.constants import S_TO_NS as S_TO_NS
