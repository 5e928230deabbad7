"""The decorator of fixtures."""

from tfloom.launch.testing.fixtures.fixture import fixture as fixture
