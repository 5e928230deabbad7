"""What an argument accepts where it takes entities: one, or several."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.some_entities_type import SomeEntitiesType_types_tuple as SomeEntitiesType_types_tuple
