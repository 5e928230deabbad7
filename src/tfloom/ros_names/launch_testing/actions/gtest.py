"""Programs of GoogleTest."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.actions.gtest import GTest as GTest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.testing.actions.test import Test as Test
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Test="tfloom.launch.testing.actions.test",
    )
