"""Parsers of launch files in other languages than Python."""

from typing import TYPE_CHECKING

from tfloom.launch.frontend.parser import *

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import instantiate_action as instantiate_action
    from tfloom.launch.frontend.parse_substitution import parse_if_substitutions as parse_if_substitutions
    from tfloom.launch.frontend.parse_substitution import parse_substitution as parse_substitution
    from tfloom.launch.frontend.parse_substitution import (
        replace_escaped_characters as replace_escaped_characters,
    )
    from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.type_utils import NormalizedValueType as NormalizedValueType
    from tfloom.launch.utilities.type_utils import StrSomeValueType as StrSomeValueType
    from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        instantiate_action="tfloom.launch.frontend.expose",
        parse_if_substitutions="tfloom.launch.frontend.parse_substitution",
        parse_substitution="tfloom.launch.frontend.parse_substitution",
        replace_escaped_characters="tfloom.launch.frontend.parse_substitution",
        InvalidLaunchFileError="tfloom.launch.invalid_launch_file_error",
        Substitution="tfloom.launch.substitution",
        NormalizedValueType="tfloom.launch.utilities.type_utils",
        StrSomeValueType="tfloom.launch.utilities.type_utils",
        FilePath="tfloom.launch.utilities.typing_file_path",
    )
