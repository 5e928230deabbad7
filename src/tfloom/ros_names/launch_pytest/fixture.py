"""The decorator of fixtures."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.fixtures.fixture import fixture as fixture
