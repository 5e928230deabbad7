"""`__all__` lists existing names, in every module that has one."""

from __future__ import annotations

import importlib
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

HOUSE = Path(__file__).parents[1] / "src" / "tfloom"


def has_all(path: Path) -> bool:
    return re.search(r"^__all__ ?[=:]", path.read_text("utf-8"), re.MULTILINE) is not None


def broken_exports(folder: Path, package: str) -> Iterator[str]:
    """Yield the errors in the `__all__` of each module under a package's folder."""
    for path in sorted(folder.rglob("*.py")):
        if "ros_names" in path.parts or not has_all(path):
            continue
        parts = path.relative_to(folder).with_suffix("").parts
        name = ".".join([package, *parts]).removesuffix(".__init__")
        module = importlib.import_module(name)
        exported = list(module.__all__)
        yield from (
            f"{name} names {exported_name} twice"
            for exported_name, times in Counter(exported).items()
            if times > 1
        )
        yield from (f"{name} has no {missing}" for missing in exported if not hasattr(module, missing))


def test_dunder_all_names_exist() -> None:
    assert any(has_all(path) for path in HOUSE.rglob("*.py"))
    broken = list(broken_exports(HOUSE, "tfloom"))
    assert not broken, "\n".join(broken)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("__all__ = ['here']\nhere = 1", []),
        ("__all__ = ['here', 'here']\nhere = 1", ["planted.module names here twice"]),
        ("__all__: list[str] = ['gone']", ["planted.module has no gone"]),
        ("gone = 1", []),
    ],
)
def test_wrong_dunder_all_is_found(text: str, found: list[str], planted: Path) -> None:
    (planted / "module.py").write_text(text)
    assert list(broken_exports(planted, "planted")) == found
