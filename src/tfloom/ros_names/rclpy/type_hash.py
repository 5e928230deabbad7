"""The hash of a type's definition."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.type_hash import TypeHash as TypeHash
