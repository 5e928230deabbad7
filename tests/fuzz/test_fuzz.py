"""Fuzzers of what is decoded in Python, for a short time each, over a corpus that is checked in.

By hand and for longer: `python -m tests.fuzz.test_fuzz TARGET COUNT [SEED]`, with `all` for each of the targets.
"""

from __future__ import annotations

import random
import sys
import time
from collections.abc import Callable

import pytest
from tests.fuzz.mutator import mutations, seeds
from tests.fuzz.targets import TARGETS

COUNT = 3000
SEED = 20261122
"""The same in each run, so that a run says something of the change that it tests; by hand, take others."""
MAX_DURATION_S = 10.0


def fuzz(target: str, count: int, seed: int) -> tuple[int, int]:
    """Run so many inputs; return how many were accepted, and how many refused.

    Raises:
        AssertionError: the target failed on an input, or took long; the text has both. The failure is its cause.
    """
    run, corpus = TARGETS[target], seeds(target)
    accepted = 0
    for number, data in enumerate(mutations(corpus, seed)):
        if number == count:
            break
        start = time.monotonic()
        try:
            accepted += run(data)
        except BaseException as error:
            raise AssertionError(f"{target}, seed {seed}, input {number}: {data!r}") from error
        assert time.monotonic() - start < MAX_DURATION_S, (
            f"{target}, seed {seed}, input {number} is slow: {data!r}"
        )
    return accepted, count - accepted


@pytest.mark.parametrize("target", TARGETS)
def test_corpus_is_accepted(target: str) -> None:
    corpus = seeds(target)
    assert len(corpus) >= 3
    assert all(map(TARGETS[target], corpus))


@pytest.mark.slow
@pytest.mark.parametrize("target", TARGETS)
def test_mutated_inputs_raise_declared_errors_only(target: str) -> None:
    accepted, refused = fuzz(target, COUNT, SEED)
    assert min(accepted, refused) > COUNT // 100


def test_failing_input_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(data: bytes) -> bool:
        raise KeyError(len(data))

    monkeypatch.setitem(TARGETS, "yaml", fails)
    with pytest.raises(AssertionError, match=r"yaml, seed 5, input 0: b'") as error:
        fuzz("yaml", 10, 5)
    assert isinstance(error.value.__cause__, KeyError)


def test_slow_input_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter((0.0, MAX_DURATION_S + 1))
    monkeypatch.setattr(time, "monotonic", lambda: next(times))
    is_accepted: Callable[[bytes], bool] = bool
    monkeypatch.setitem(TARGETS, "yaml", is_accepted)
    with pytest.raises(AssertionError, match="input 0 is slow"):
        fuzz("yaml", 10, 5)


if __name__ == "__main__":
    names = TARGETS if sys.argv[1] == "all" else [sys.argv[1]]
    number = int(sys.argv[3]) if len(sys.argv) > 3 else random.randrange(2**32)
    for name in names:
        begin = time.monotonic()
        read, rejected = fuzz(name, int(sys.argv[2]), number)
        duration_s = time.monotonic() - begin
        print(f"{name}: seed {number}, {read} accepted, {rejected} refused, {duration_s:.0f} s", flush=True)
