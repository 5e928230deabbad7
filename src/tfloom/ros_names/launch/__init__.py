"""Describe systems of programs, and launch them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Action",
    "Condition",
    "Event",
    "EventHandler",
    "InvalidLaunchFileError",
    "LaunchContext",
    "LaunchDescription",
    "LaunchDescriptionEntity",
    "LaunchDescriptionSource",
    "LaunchIntrospector",
    "LaunchService",
    "SomeEntitiesType",
    "SomeEntitiesType_types_tuple",
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
    "actions",
    "conditions",
    "descriptions",
    "event_handlers",
    "events",
    "frontend",
    "launch_description_sources",
    "logging",
    "substitutions",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch import action as action
    from launch import actions as actions
    from launch import condition as condition
    from launch import conditions as conditions
    from launch import descriptions as descriptions
    from launch import event as event
    from launch import event_handler as event_handler
    from launch import event_handlers as event_handlers
    from launch import events as events
    from launch import frontend as frontend
    from launch import invalid_launch_file_error as invalid_launch_file_error
    from launch import launch_context as launch_context
    from launch import launch_description as launch_description
    from launch import launch_description_entity as launch_description_entity
    from launch import launch_description_source as launch_description_source
    from launch import launch_description_sources as launch_description_sources
    from launch import launch_introspector as launch_introspector
    from launch import launch_service as launch_service
    from launch import logging as logging
    from launch import some_entities_type as some_entities_type
    from launch import some_substitutions_type as some_substitutions_type
    from launch import substitution as substitution
    from launch import substitutions as substitutions
    from launch import utilities as utilities
    from tfloom.launch.action import Action as Action
    from tfloom.launch.condition import Condition as Condition
    from tfloom.launch.event import Event as Event
    from tfloom.launch.event_handler import EventHandler as EventHandler
    from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
    from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
    from tfloom.launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
    from tfloom.launch.launch_introspector import LaunchIntrospector as LaunchIntrospector
    from tfloom.launch.launch_service import LaunchService as LaunchService
    from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
    from tfloom.launch.some_entities_type import SomeEntitiesType_types_tuple as SomeEntitiesType_types_tuple
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Condition="tfloom.launch.condition",
        Event="tfloom.launch.event",
        EventHandler="tfloom.launch.event_handler",
        InvalidLaunchFileError="tfloom.launch.invalid_launch_file_error",
        LaunchContext="tfloom.launch.launch_context",
        LaunchDescription="tfloom.launch.launch_description",
        LaunchDescriptionEntity="tfloom.launch.launch_description_entity",
        LaunchDescriptionSource="tfloom.launch.launch_description_source",
        LaunchIntrospector="tfloom.launch.launch_introspector",
        LaunchService="tfloom.launch.launch_service",
        SomeEntitiesType="tfloom.launch.some_entities_type",
        SomeEntitiesType_types_tuple="tfloom.launch.some_entities_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        action="launch",
        actions="launch",
        condition="launch",
        conditions="launch",
        descriptions="launch",
        event="launch",
        event_handler="launch",
        event_handlers="launch",
        events="launch",
        frontend="launch",
        invalid_launch_file_error="launch",
        launch_context="launch",
        launch_description="launch",
        launch_description_entity="launch",
        launch_description_source="launch",
        launch_description_sources="launch",
        launch_introspector="launch",
        launch_service="launch",
        logging="launch",
        some_entities_type="launch",
        some_substitutions_type="launch",
        substitution="launch",
        substitutions="launch",
        utilities="launch",
    )
