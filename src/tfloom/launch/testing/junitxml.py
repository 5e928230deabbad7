"""Results of launches in JUnit's XML."""

from __future__ import annotations

import unittest
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from typing import Any

from tfloom.launch.testing.test_result import FailResult, SkipResult

__all__ = ["unittestCaseToXml", "unittestResultToXml", "unittestResultsToXml"]


def unittestResultsToXml(
    *, name: str = "launch_test", test_results: Mapping[Any, unittest.TestResult] | None = None
) -> ET.ElementTree:
    """Return the document of several launches.

    Args:
        name: Of the whole.
        test_results: The result of each launch, by its name.
    """
    results = dict(test_results or {})
    root = ET.Element("testsuites", {"name": name, "time": f"{sum(map(_seconds, results.values())):.3f}"})
    totals = {"tests": 0, "errors": 0, "failures": 0}
    for suite_name, result in results.items():
        suite = unittestResultToXml(str(suite_name), result)
        root.append(suite)
        totals = {key: value + int(suite.attrib[key]) for key, value in totals.items()}
    root.attrib.update({key: str(value) for key, value in totals.items()})
    return ET.ElementTree(root)


def unittestResultToXml(name: str, test_result: unittest.TestResult) -> ET.Element:
    """Return the element of one launch, with an element for each test.

    Args:
        name: Of the launch.
        test_result: Its result; of a launch that failed there is one element, `launch`, and of one that was skipped
            without tests `skipped_launch`.
    """
    suite = ET.Element("testsuite", {"name": name, "time": f"{_seconds(test_result):.3f}"})
    counts = {
        "tests": test_result.testsRun,
        "errors": len(test_result.errors),
        "failures": len(test_result.failures),
        "skipped": len(test_result.skipped),
    }
    if isinstance(test_result, FailResult) or (
        isinstance(test_result, SkipResult) and not test_result.testCases
    ):
        is_failure = isinstance(test_result, FailResult)
        kind, key = ("failure", "failures") if is_failure else ("skipped", "skipped")
        case_name = "launch" if is_failure else "skipped_launch"
        case = ET.SubElement(suite, "testcase", {"classname": name, "name": case_name, "time": "0.000"})
        element = ET.SubElement(case, kind, {"message": _xml_text(test_result.message)})
        element.text = _xml_text(getattr(test_result, "details", ""))
        counts = {**counts, "tests": counts["tests"] + 1, key: counts[key] + 1}
    suite.attrib.update({key: str(value) for key, value in counts.items()})
    suite.extend(unittestCaseToXml(test_result, case) for case in getattr(test_result, "testCases", ()))
    started = set(getattr(test_result, "testCases", ()))
    # An error in setUpClass is that of no test.
    suite.extend(
        unittestCaseToXml(test_result, case) for case, _ in test_result.errors if case not in started
    )
    return suite


def unittestCaseToXml(test_result: unittest.TestResult, test_case: unittest.TestCase) -> ET.Element:
    """Return the element of one test, with what it failed of or why it was skipped."""
    times: Mapping[Any, float] = getattr(test_result, "testTimes", {})
    name = getattr(test_case, "_testMethodName", None) or test_case.id()
    kind_of_case = type(test_case)
    element = ET.Element(
        "testcase",
        {
            "classname": f"{kind_of_case.__module__}.{kind_of_case.__qualname__}",
            "name": name,
            "time": f"{times.get(test_case, 0.0):.3f}",
        },
    )
    for kind, texts in (
        ("failure", test_result.failures),
        ("error", test_result.errors),
        ("skipped", test_result.skipped),
    ):
        for case, text in texts:
            if case is test_case or getattr(case, "test_case", None) is test_case:
                message = text.strip().splitlines()[-1] if text.strip() and kind != "skipped" else text
                ET.SubElement(element, kind, {"message": _xml_text(message)}).text = _xml_text(text)
    return element


def _seconds(result: unittest.TestResult) -> float:
    return float(sum(getattr(result, "testTimes", {}).values()))


def _xml_text(text: str) -> str:
    """Return a text without the characters that XML cannot hold."""
    return "".join(character for character in text if character >= " " or character in "\t\n\r")
