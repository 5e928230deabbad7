"""Call a function."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
