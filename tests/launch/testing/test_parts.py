"""The small parts of launch_testing: texts, marks, parametrized descriptions, results as XML."""

from __future__ import annotations

import functools
import io
import re
import unittest
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.testing import legacy_output
from tfloom.launch.testing.arguments import parse_launch_arguments
from tfloom.launch.testing.junitxml import unittestResultsToXml
from tfloom.launch.testing.loader import (
    DescriptionError,
    LoadTestsFromPythonModule,
    PostShutdownTestLoader,
    PreShutdownTestLoader,
    TestRun,
)
from tfloom.launch.testing.markers import is_kept_alive, keep_alive, post_shutdown_test, retry_on_failure
from tfloom.launch.testing.output import basic_output_filter, expect_output, expected_output_from_file
from tfloom.launch.testing.parametrize import parametrize
from tfloom.launch.testing.readiness import ReadyAggregator, ready_to_test_action_timeout, timeout_of
from tfloom.launch.testing.test_result import FailResult, SkipResult, TestResult
from tfloom.launch.testing.test_runner import LaunchTestRunner
from tfloom.launch.testing.text import build_line_match, build_text_match, remove_ansi_escape_sequences

LINES = ["[talker] red", "[listener] red", "[talker] blue", "[listener] blue"]
TEXT = "\n".join(LINES)


def test_filter_leaves_lines_out() -> None:
    keep = basic_output_filter(filtered_patterns=[r".*\[listener\].*"])
    assert keep(TEXT) == "[talker] red\n[talker] blue\n"
    assert basic_output_filter()("pid 7\nrc 0\nhello\n") == "hello\n"
    assert basic_output_filter([], [])("pid 7\n") == "pid 7\n"


@pytest.mark.parametrize("strict", [False, True])
def test_output_as_expected(strict: bool) -> None:
    assert expect_output(expected_text=TEXT, text=TEXT, strict=strict)
    assert expect_output(expected_lines=LINES, text=TEXT, strict=strict)
    assert expect_output(expected_text=TEXT, lines=LINES, strict=strict)
    assert expect_output(expected_lines=LINES, lines=LINES, strict=strict)
    patterns = [re.compile(r"^\[talker\].*$"), re.compile(r"^\[listener\].*$")] * 2
    assert expect_output(expected_lines=patterns, text=TEXT, strict=strict)


def test_part_of_the_output_is_enough_unless_strict() -> None:
    listener = re.compile(r"^\[listener\].*$", re.MULTILINE)
    assert expect_output(expected_text=listener, text=TEXT)
    assert not expect_output(expected_text=listener, text=TEXT, strict=True)
    assert expect_output(expected_lines=["talker", "blue"], text=TEXT)
    assert functools.partial(expect_output, expected_lines=["blue"])(TEXT)
    assert expect_output("\x1b[1mred\x1b[0m", expected_text="red", strict=True)
    assert not expect_output(
        "\x1b[1mred\x1b[0m", expected_text="red", strict=True, strip_ansi_escape_sequences=False
    )
    assert not expect_output(expected_lines=["blue", "red"], text=TEXT)
    assert expect_output(expected_lines=LINES[:3], text=TEXT, strict=True)
    assert not expect_output(expected_lines=LINES[1:], text=TEXT, strict=True)
    assert not expect_output(expected_lines=LINES[::2], text=TEXT, strict=True)
    assert expect_output(expected_lines=["[talker] red\n[listener]", "blue"], text=TEXT)
    assert not expect_output(expected_lines=[re.compile("red")], text=TEXT)
    with pytest.raises(ValueError, match="Either expected lines or text, but not both, must be specified"):
        expect_output(text=TEXT)
    with pytest.raises(ValueError, match="Either lines or text, but not both, must be specified"):
        expect_output(expected_text=TEXT)


def test_matches_give_their_place() -> None:
    assert build_text_match("lo")("hello low") == (3, 5)
    assert build_text_match(re.compile("l+"))("hello") == (2, 4)
    assert build_text_match(["h", "o"])("hello") == (0, 5)
    assert build_text_match(["o", "h"])("hello") is None
    assert build_text_match(["a", "b"], strict=True)("a\nb\n") == (0, 4)
    assert build_line_match("b")(["a", "b", "c"]) == (1, 2)
    assert build_line_match(["a", "c"])(["a", "b", "c"]) == (0, 3)
    with pytest.raises(ValueError, match="a text, a pattern or a list"):
        build_text_match(7)  # type: ignore[arg-type]
    assert remove_ansi_escape_sequences("\x1b[1;31mred\x1b[0m") == "red"


def test_expected_output_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "plain.txt").write_text("one\ntwo\n")
    (tmp_path / "escaped.txt").write_text("a\\tb\n")
    (tmp_path / "pattern.regex").write_text("o.e\n")
    assert expected_output_from_file(tmp_path / "plain") == ["one", "two"]
    assert expected_output_from_file(str(tmp_path / "escaped"), encoding="unicode_escape") == ["a\tb"]
    assert expected_output_from_file(tmp_path / "pattern") == [re.compile("o.e")]
    with pytest.raises(RuntimeError, match="could not find output check file"):
        expected_output_from_file(tmp_path / "none")


def test_older_checks_of_output(tmp_path: Path) -> None:
    check, lines = legacy_output.create_output_lines_test(["one", "two"])
    assert lines == ["one", "two"]
    check("two\none\n")
    with pytest.raises(AssertionError, match=r"\['two'\]"):
        check("one\n")
    check, _ = legacy_output.create_output_regex_test(["o.e"])
    check("one\n")
    legacy_output.create_output_regex_test([r"zero\no.e"])[0]("zero\none\n")
    with pytest.raises(AssertionError, match=r"no line of the output matches: \['o.e'\]"):
        check("two\n")
    (tmp_path / "both.regex").write_text("t.o\n")
    legacy_output.create_output_test_from_file(tmp_path / "both")[0]("two")
    assert legacy_output.create_output_lines_filter(["x"])("xy\nz\n") == "z\n"


def test_parametrize_gives_each_set_of_values() -> None:
    @parametrize("colour, size", [("red", 1), ("blue", 2)])
    def describe(colour: str, size: int) -> str:
        return f"{colour} {size}"

    assert [(function(), arguments) for function, arguments in describe] == [
        ("red 1", {"colour": "red", "size": 1}),
        ("blue 2", {"colour": "blue", "size": 2}),
    ]
    assert [function() for function, _ in parametrize("size", [1, 2])(lambda size: size)] == [1, 2]
    rows = parametrize("size", [(1,), [2], (3, 4), "5"])(lambda size: size)
    assert [function() for function, _ in rows] == [1, 2, (3, 4), "5"]
    with pytest.raises(ValueError, match=r"2 names \(colour, size\), but 1 values"):
        parametrize(["colour", "size"], [["red"]])


def test_last_ready_process_reports() -> None:
    calls: list[int] = []
    aggregator = ReadyAggregator(lambda: calls.append(1), 2)
    aggregator.ready_fn()
    assert not calls
    aggregator.ready_fn()
    aggregator.ready_fn()
    assert calls == [1]


def test_marks_of_descriptions() -> None:
    def describe() -> None: ...

    assert timeout_of(describe) == 15
    assert timeout_of(ready_to_test_action_timeout(3)(describe)) == 3
    assert not is_kept_alive(describe)
    assert is_kept_alive(keep_alive(describe))


def test_retry_on_failure() -> None:
    calls: list[int] = []

    def fail() -> None:
        calls.append(1)
        assert len(calls) == 3

    retry_on_failure(times=3, delay=0)(fail)()
    with pytest.raises(AssertionError):
        retry_on_failure(times=2)(fail)()
    assert len(calls) == 5

    @retry_on_failure(times=2)
    class Case(unittest.TestCase):
        tries = 0

        def test_second_time(self) -> None:
            Case.tries += 1
            assert Case.tries == 2

    assert unittest.TestLoader().loadTestsFromTestCase(Case).run(unittest.TestResult()).wasSuccessful()
    with pytest.raises(ValueError, match="at least 1"):
        retry_on_failure(times=0)


def test_launch_arguments_of_a_command_line() -> None:
    assert parse_launch_arguments(["a:=1", "b:=x:=y", "a:=2"]) == [("a", "2"), ("b", "x:=y")]
    with pytest.raises(
        RuntimeError, match="malformed launch argument 'a=1', expected format '<name>:=<value>'"
    ):
        parse_launch_arguments(["a=1"])


def module_with(description: object, *cases: type[unittest.TestCase]) -> ModuleType:
    module = ModuleType("some_test")
    module.generate_test_description = description  # type: ignore[attr-defined]
    for number, case in enumerate(cases):
        setattr(module, f"Case{number}", case)
    return module


class Before(unittest.TestCase):
    __test__ = False  # for pytest

    def test_it(self) -> None: ...


@post_shutdown_test()
class After(unittest.TestCase):
    __test__ = False  # for pytest

    def test_it(self) -> None: ...


def test_cases_before_and_after_the_end_are_told_apart() -> None:
    module = module_with(LaunchDescription, Before, After, unittest.TestCase)
    (run,) = LoadTestsFromPythonModule(module, name="some")
    assert (run.pre_shutdown_tests, run.post_shutdown_tests, str(run)) == ([Before], [After], "some")
    assert PreShutdownTestLoader().loadTestsFromModule(module).countTestCases() == 1
    assert PostShutdownTestLoader().loadTestsFromModule(module).countTestCases() == 1
    runs = LoadTestsFromPythonModule(module_with(parametrize("x", [1, 2])(lambda x: x)), name="some")
    assert [str(run) for run in runs] == ["some[x=1]", "some[x=2]"]


@pytest.mark.parametrize(
    ("description", "text"),
    [
        (lambda ready_fn, more: None, "unexpected extra argument 'more'"),
        (parametrize("size", [1])(lambda: None), "Could not find an argument 'size'"),
        (lambda: (LaunchDescription(), 7), "must return a LaunchDescription"),
        (lambda: None, "and returned None"),
        (
            lambda: LaunchDescription([TimerAction(period=1.0, actions=[])]),
            "must return a LaunchDescription containing a ReadyToTest action",
        ),
    ],
)
def test_wrong_description_is_an_error(description: object, text: str) -> None:
    (run,) = LoadTestsFromPythonModule(module_with(description))
    with pytest.raises(DescriptionError, match=re.escape(text)):
        run.normalized_test_description(lambda: None)


def test_module_without_a_description_is_an_error() -> None:
    with pytest.raises(DescriptionError, match="there is no function generate_test_description"):
        LoadTestsFromPythonModule(ModuleType("nothing"))


class Mixed(unittest.TestCase):
    __test__ = False  # for pytest

    def test_error(self) -> None:
        raise RuntimeError("broken \x07 thing")

    def test_fail(self) -> None:
        self.assertEqual(1, 2)  # noqa: PT009  # unittest's own text

    def test_good(self) -> None: ...

    @unittest.skip("of no use")
    def test_skip(self) -> None: ...


class BadSetUp(unittest.TestCase):
    __test__ = False  # for pytest

    @classmethod
    def setUpClass(cls) -> None:
        raise RuntimeError("no robot")

    def test_never(self) -> None: ...


def run_cases(*cases: type[unittest.TestCase]) -> unittest.TestResult:
    suites = [unittest.TestLoader().loadTestsFromTestCase(case) for case in cases]
    return unittest.TextTestRunner(io.StringIO(), resultclass=TestResult).run(unittest.TestSuite(suites))


def test_skipped_test_that_never_started_is_a_result() -> None:
    """Python 3.12.1 reports skipped tests so."""
    result, case = TestResult(unittest.runner._WritelnDecorator(io.StringIO())), Mixed("test_skip")
    result.addSkip(case, "of no use")
    result.stopTest(case)
    (suite,) = unittestResultsToXml(test_results={"one": result}).getroot()
    assert [element.get("name") for element in suite] == ["test_skip"]


@unittest.skip("no robot")
def skipped_description() -> None:
    raise RuntimeError


def skipping_description() -> None:
    raise unittest.SkipTest("no robot")


@pytest.mark.parametrize(
    "describe", [skipped_description, skipping_description, functools.partial(skipped_description)]
)
def test_tests_of_a_skipped_launch_are_skipped_each(describe: Callable[..., Any]) -> None:
    run = TestRun("run", describe, {}, [Mixed], [BadSetUp])
    (result,) = LaunchTestRunner([run]).run().values()
    names = {case._testMethodName for case, _ in result.skipped}
    assert names >= {"test_good", "test_fail", "test_error", "test_skip"}
    assert result.testsRun == len(result.skipped) == len(names)
    assert result.wasSuccessful()
    (suite,) = unittestResultsToXml(test_results={"run": result}).getroot()
    assert suite.get("tests") == suite.get("skipped") == str(len(names))
    assert {element.get("name") for element in suite} == names
    assert all(element.find("skipped").get("message") == "no robot" for element in suite)  # type: ignore[union-attr]


def test_results_as_xml() -> None:
    results = {
        "tests": run_cases(Mixed, BadSetUp),
        "failed": FailResult(None, "processes died", "output"),
        "skipped": SkipResult(msg="no robot"),
    }
    root = unittestResultsToXml(name="all", test_results=results).getroot()
    assert root is not None
    assert (root.get("name"), root.get("failures"), root.get("errors")) == ("all", "2", "2")
    tests, failed, skipped = root
    assert {key: tests.get(key) for key in ("name", "tests", "failures", "errors", "skipped")} == {
        "name": "tests",
        "tests": "4",
        "failures": "1",
        "errors": "2",
        "skipped": "1",
    }
    cases = {case.get("name"): case for case in tests}
    assert cases["test_good"].get("classname") == f"{__name__}.Mixed"
    assert not list(cases["test_good"])
    assert "1 != 2" in cases["test_fail"].find("failure").get("message")  # type: ignore[union-attr, operator]
    assert cases["test_error"].find("error").get("message") == "RuntimeError: broken  thing"  # type: ignore[union-attr]
    assert cases["test_skip"].find("skipped").get("message") == "of no use"  # type: ignore[union-attr]
    assert any("setUpClass" in str(name) for name in cases)
    assert failed.find("testcase/failure").get("message") == "processes died"  # type: ignore[union-attr]
    assert skipped.find("testcase/skipped").get("message") == "no robot"  # type: ignore[union-attr]
    assert skipped.find("testcase").get("name") == "skipped_launch"  # type: ignore[union-attr]
