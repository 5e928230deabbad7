"""Programs of GoogleTest."""

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.testing.actions.gtest import GTest as GTest
from tfloom.launch.testing.actions.test import Test as Test
