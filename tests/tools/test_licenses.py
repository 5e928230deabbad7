"""The licences of what tfloom needs: read from metadata, accepted or refused for a use."""

from __future__ import annotations

import sys
from email.message import Message
from importlib.metadata import PackageMetadata
from pathlib import Path
from typing import cast

import pytest
from tests.conftest import run_to_end
from tools import licenses
from tools.licenses import COMPILED_IN, DEVELOPMENT, REQUIRED, fault_of, stated_licence

ROOT = Path(__file__).parents[2]
EXTRA = "extra turtlesim"


def metadata_of(*fields: tuple[str, str]) -> PackageMetadata:
    message = Message()
    for name, value in fields:
        message[name] = value
    return cast("PackageMetadata", message)


def test_all_installed_requirements_have_an_accepted_licence() -> None:
    done = run_to_end([sys.executable, "-m", "tools.licenses"], cwd=ROOT)
    assert done.returncode == 0, done.stderr
    uses = {line.split()[0]: line for line in done.stdout.splitlines()}
    assert COMPILED_IN in uses["nanobind"]
    assert REQUIRED in uses["numpy"]
    assert DEVELOPMENT in uses["hypothesis"]


def test_packages_that_others_require_have_their_strictest_use() -> None:
    roots = {REQUIRED: ["argcomplete"], EXTRA: ["pytest", "argcomplete"], DEVELOPMENT: ["pluggy", "tfloom"]}
    found = licenses.uses(roots)
    assert found["argcomplete"] == REQUIRED
    assert found["pytest"] == found["pluggy"] == EXTRA
    assert "tfloom" not in found


def test_extras_of_a_package_that_is_already_listed_are_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    required = {"a": ["b", "c; extra == 'x'", "d; extra == 'y'"], "c": ["a[y]"]}
    monkeypatch.setattr(licenses.metadata, "requires", required.get)
    found = licenses.uses({REQUIRED: ["a"], EXTRA: ["a[x]", "b"]})
    assert found == {"a": REQUIRED, "b": REQUIRED, "c": EXTRA, "d": EXTRA}


@pytest.mark.parametrize(
    ("licence", "accepted", "refused"),
    [
        ("MIT", [COMPILED_IN, REQUIRED, EXTRA, DEVELOPMENT], []),
        ("BSD-3-Clause AND 0BSD AND MIT", [COMPILED_IN, REQUIRED], []),
        ("LGPL-2.1-or-later", [EXTRA, DEVELOPMENT], [COMPILED_IN, REQUIRED]),
        ("GNU Library or Lesser General Public License (LGPL)", [EXTRA], [REQUIRED]),
        ("Mozilla Public License 2.0 (MPL 2.0)", [EXTRA, DEVELOPMENT], [REQUIRED]),
        ("GPL-3.0-only", [], [REQUIRED, EXTRA, DEVELOPMENT]),
        ("GNU General Public License v2 (GPLv2)", [], [EXTRA, DEVELOPMENT]),
        ("GNU Affero General Public License v3", [], [DEVELOPMENT]),
        ("AGPL-3.0", [], [DEVELOPMENT]),
        ("MIT AND GPL-2.0", [], [DEVELOPMENT]),
        ("Proprietary", [], [DEVELOPMENT]),
        ("", [], [DEVELOPMENT]),
    ],
)
def test_a_licence_is_accepted_for_some_uses(licence: str, accepted: list[str], refused: list[str]) -> None:
    assert [use for use in accepted if fault_of(licence, use)] == []
    assert [use for use in refused if not fault_of(licence, use)] == []


@pytest.mark.parametrize(
    ("fields", "licence"),
    [
        ([("License-Expression", "MIT"), ("License", "other")], "MIT"),
        (
            [("Classifier", "License :: OSI Approved :: MIT License"), ("License", "The text\nof it")],
            "MIT License",
        ),
        ([("Classifier", "License :: OSI Approved"), ("License", "BSD")], "BSD"),
        ([("License", "UNKNOWN")], ""),
        ([("Classifier", "Topic :: Scientific/Engineering")], ""),
    ],
)
def test_the_licence_is_read_from_metadata(fields: list[tuple[str, str]], licence: str) -> None:
    assert stated_licence(metadata_of(*fields)) == licence


def test_a_decision_holds_for_what_was_read_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(licenses, "DECIDED", {"pytest": ("GPL-3.0", "MIT", "a reason")})
    monkeypatch.setattr(licenses, "stated_licence", lambda _: "GPL-3.0")
    row = licenses.row_of("pytest", REQUIRED)
    assert row is not None
    assert (row.licence, row.fault) == ("MIT", "")
    monkeypatch.setattr(licenses, "stated_licence", lambda _: "GPL-3.0 AND more")
    row = licenses.row_of("pytest", REQUIRED)
    assert row is not None
    assert row.fault


def test_the_licences_of_code_that_is_not_ours_are_in_the_source_tree() -> None:
    holders = {
        "nanobind": "Wenzel Jakob",
        "robin-map": "Thibaut Goetghebuer-Planchon",
        "uplot": "Leon Sorokin",
    }
    for name, holder in holders.items():
        assert holder in (ROOT / "licenses" / f"{name}.txt").read_text("utf-8")
