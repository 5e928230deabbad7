"""Execute a command."""

from typing import TYPE_CHECKING

from tfloom.launch.actions.execute_local import ExecuteLocal as ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
from tfloom.launch.descriptions.executable import Executable as Executable
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.substitutions.text_substitution import TextSubstitution as TextSubstitution

if TYPE_CHECKING:
    from tfloom.launch.actions.shutdown_action import Shutdown as Shutdown
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
        Shutdown="tfloom.launch.actions.shutdown_action",
    )
