"""Tests of pytest as processes."""

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.testing.actions.pytest import PyTest as PyTest
from tfloom.launch.testing.actions.test import Test as Test
