"""How a tag gets its action, and a name after `$(` its substitution."""

from typing import TYPE_CHECKING

from tfloom.launch.frontend.expose import *

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
    )
