"""The substitutions in a text: `$(name argument 'quoted argument' $(nested argument))`."""

from typing import TYPE_CHECKING

from tfloom.launch.frontend.parse_substitution import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import instantiate_substitution as instantiate_substitution
    from tfloom.launch.substitutions.text_substitution import TextSubstitution as TextSubstitution
    from tfloom.launch.utilities.type_utils import NormalizedValueType as NormalizedValueType
    from tfloom.launch.utilities.type_utils import StrSomeValueType as StrSomeValueType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        instantiate_substitution="tfloom.launch.frontend.expose",
        TextSubstitution="tfloom.launch.substitutions.text_substitution",
        NormalizedValueType="tfloom.launch.utilities.type_utils",
        StrSomeValueType="tfloom.launch.utilities.type_utils",
    )
