"""What an argument accepts where it takes entities: one, or several."""

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.some_entities_type import SomeEntitiesType_types_tuple as SomeEntitiesType_types_tuple
