"""`for_each`: one test over many recorded cases.

Thousands of parametrized tests take longer to collect, in each worker, than to run.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterable
from typing import TypeVar

import pytest

Value = TypeVar("Value")
SHOWN = 20
"""Failed cases whose traceback is shown; the others are only named."""


def for_each(
    values: Iterable[Value] | Callable[[], Iterable[Value]], *, name: Callable[[Value], object] = str
) -> Callable[[Callable[[Value], None]], Callable[[], None]]:
    """Make a test of one argument a test of all `values`, which fails once and names each value that failed.

    Args:
        values: The cases; there must be at least one. A function that returns them is called when the test runs.
        name: What names a case in the report.
    """
    known = values if callable(values) else list(values)

    def decorate(test: Callable[[Value], None]) -> Callable[[], None]:
        def run() -> None:
            cases = list(known()) if callable(known) else known
            assert cases, "there are no cases"
            failed: list[tuple[object, str]] = []
            for case in cases:
                try:
                    test(case)
                except (Exception, pytest.fail.Exception):  # noqa: BLE001 reported below, with the others
                    failed.append((name(case), traceback.format_exc()))
            if failed:
                shown = "\n".join(f"== {case}\n{text}" for case, text in failed[:SHOWN])
                names = ", ".join(str(case) for case, _ in failed)
                pytest.fail(f"{len(failed)} of {len(cases)} cases: {names}\n{shown}", pytrace=False)

        run.__name__, run.__doc__, run.__module__ = test.__name__, test.__doc__, test.__module__
        return run

    return decorate
