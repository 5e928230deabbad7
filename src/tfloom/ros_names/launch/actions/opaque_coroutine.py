"""Run a coroutine."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.opaque_coroutine import OpaqueCoroutine as OpaqueCoroutine
from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
