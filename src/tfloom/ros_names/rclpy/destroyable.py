"""The type of objects that are destroyed when they are not in use."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.destroyable import DestroyableType as DestroyableType
