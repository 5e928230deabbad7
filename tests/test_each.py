"""tests/each.py: a case that fails is found and named."""

from __future__ import annotations

import pytest
from tests.each import for_each


def test_each_failed_case_is_named() -> None:
    seen = []

    @for_each([1, 2, 3, 4], name=lambda value: f"case {value}")
    def test(value: int) -> None:
        seen.append(value)
        assert value != 2
        if value == 3:
            pytest.fail("no three")

    with pytest.raises(pytest.fail.Exception) as failure:
        test()
    assert seen == [1, 2, 3, 4]
    assert str(failure.value).startswith("2 of 4 cases: case 2, case 3\n== case 2\nTraceback")


def test_no_cases_fail() -> None:
    with pytest.raises(AssertionError, match="there are no cases"):
        for_each([])(lambda _: None)()
    with pytest.raises(AssertionError, match="there are no cases"):
        for_each(list)(lambda _: None)()


def test_cases_of_a_function_are_found_when_the_test_runs() -> None:
    cases: list[int] = []

    @for_each(lambda: cases)
    def test(value: int) -> None:
        assert value != 2

    cases += [1, 2]
    with pytest.raises(pytest.fail.Exception, match="1 of 2 cases: 2"):
        test()
