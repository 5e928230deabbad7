"""Faults of package.xml and setup.py, as sentences."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import MANIFEST

from tfloom.workspace.package_faults import find_manifest_fault, find_setup_fault, name_in_manifest

SOUND = MANIFEST.format(name="my_pkg", depends="", build_type="ament_python")
LEFT, RIGHT = "\N{LEFT DOUBLE QUOTATION MARK}", "\N{RIGHT DOUBLE QUOTATION MARK}"


@pytest.mark.parametrize(
    ("before", "after", "fault"),
    [
        ("", "", None),
        (
            "</license>",
            "",
            ":11:3: not XML: mismatched tag: close each tag before the one around it, as <a><b></b></a>",
        ),
        ("test.", "a & b", ":5:24: not XML: not well-formed (invalid token): write & as &amp; and < as &lt;"),
        ("<license>Apache-2.0</license>", "", ": the tag <license> is missing: add <license>…</license>"),
        ("my_pkg", "p" * 201, ": the name of the package is too long: it has 201 letters, but may have 200"),
        ("my_pkg", "p" * 200, None),
        ("Of a test.", "<p>Of a <em>test</em>.</p>", None),
        ("Of a test.", "<p/>", ": the tag <description> is missing: add <description>…</description>"),
        ("<maintainer ", '<maintainer email="a@example.com"/><maintainer ', None),
        ("<license>", "<license> </license><license>", None),
        ("my_pkg", " ", ": the tag <name> is missing: add <name>…</name>"),
        ("</package>", "", ":12:1: not XML: no element found: every tag that opens must close"),
    ],
)
def test_fault_of_a_manifest_is_named(before: str, after: str, fault: str | None, tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    path.write_text(SOUND.replace(before, after))
    assert find_manifest_fault(path) == (None if fault is None else f"{path}{fault}")


def test_octets_of_another_encoding_are_named(tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    path.write_bytes(SOUND.replace("test.", "caf\u00e9").encode("latin-1"))
    fault = find_manifest_fault(path)
    assert fault == f"{path}:5:24: octet 0xe9 isn't UTF-8 text: save the file as UTF-8"


def test_file_of_another_kind_has_no_fault(tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    for text in ("<other/>", "<other", ""):
        path.write_text(text)
        assert find_manifest_fault(path) is None


def test_name_is_found_in_a_broken_manifest(tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    path.write_text("<package><name> my_pkg </name>")
    assert name_in_manifest(path) == "my_pkg"
    for text in ("<package>", f"<package><name>{'p' * 201}</name>"):
        path.write_text(text)
        assert name_in_manifest(path) == tmp_path.name


def test_curly_quotes_are_shown_as_they_must_be_typed(tmp_path: Path) -> None:
    path = tmp_path / "setup.py"
    path.write_text(
        f"from x import y\nscripts = [\n    {LEFT}a = b.a:main{RIGHT},\n    {LEFT}c{RIGHT},\n]\n", "utf-8"
    )
    assert find_setup_fault(path) == (
        f"{path}:3:5: curly quotes {LEFT} from a web page are not Python's: type this line as\n"
        '    "a = b.a:main",\n'
        "1 more line below have them, too"
    )


def test_no_break_spaces_are_shown_as_they_must_be_typed(tmp_path: Path) -> None:
    path = tmp_path / "setup.py"
    path.write_text("def f():\n    x\u00a0= 1\n\u00a0   y = 2\n", "utf-8")
    assert find_setup_fault(path) == (
        f"{path}:2:6: no-break spaces U+00A0 from a web page are not Python's: type this line as\n"
        "    x = 1\n"
        "1 more line below have them, too"
    )


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (b"x = 1\n", None),
        (b"x = (\n", ":1:5: '(' was never closed: x = ("),
        (b"x = '\xe9'\n", ": octet 0xe9 isn't UTF-8 text: save the file as UTF-8"),
    ],
)
def test_fault_of_a_setup_file_is_named(data: bytes, fault: str | None, tmp_path: Path) -> None:
    path = tmp_path / "setup.py"
    path.write_bytes(data)
    assert find_setup_fault(path) == (None if fault is None else f"{path}{fault}")


def test_missing_setup_file_is_named(tmp_path: Path) -> None:
    assert (
        find_setup_fault(tmp_path / "setup.py")
        == f"{tmp_path}/setup.py: can't be read: No such file or directory"
    )
