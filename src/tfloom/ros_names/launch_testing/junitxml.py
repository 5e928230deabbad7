"""Results in JUnit's XML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.junitxml import unittestCaseToXml as unittestCaseToXml
from tfloom.launch.testing.junitxml import unittestResultToXml as unittestResultToXml
from tfloom.launch.testing.junitxml import unittestResultsToXml as unittestResultsToXml
