"""Results in JUnit's XML."""

from tfloom.launch.testing.junitxml import unittestCaseToXml as unittestCaseToXml
from tfloom.launch.testing.junitxml import unittestResultsToXml as unittestResultsToXml
from tfloom.launch.testing.junitxml import unittestResultToXml as unittestResultToXml
