"""The functions of ament_package."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from ament_package.templates import IS_WINDOWS, configure_file, configure_string


@pytest.mark.parametrize(
    ("template", "text"),
    [
        ("a=@FOO@", "a=x"),
        ("a=@FOO@;b=@BAR@", "a=x;b="),
        ("@FOO@-@foo_2@-@FOO@", "x-y-x"),
        ("name@host, @a b@, @@", "name@host, @a b@, @@"),
        ("", ""),
    ],
)
def test_variables_are_replaced(template: str, text: str) -> None:
    assert configure_string(template, {"FOO": "x", "foo_2": "y"}) == text


def test_values_are_not_replaced_again() -> None:
    assert configure_string("@A@@B@", {"A": "@B@", "B": "\\1"}) == "@B@\\1"


def test_file_is_read_as_utf_8(tmp_path: Path) -> None:
    path = tmp_path / "setup.sh.in"
    path.write_text("prefix=@P@ # ü\n", encoding="utf-8")
    assert configure_file(str(path), {"P": "/opt"}) == "prefix=/opt # ü\n"
    with pytest.raises(FileNotFoundError):
        configure_file(tmp_path / "none", {})


def test_is_windows_is_of_this_platform() -> None:
    assert IS_WINDOWS is (os.name == "nt")
