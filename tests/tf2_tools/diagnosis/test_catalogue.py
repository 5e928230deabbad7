"""The catalogue of findings: its codes, and the page that is written from it."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

from tfloom.tf2_tools.diagnosis.catalogue import GROUPS, KINDS

DOCS = Path(__file__).parents[3] / "docs"


def test_the_page_is_that_of_the_catalogue() -> None:
    spec = importlib.util.spec_from_file_location("tf_doctor_page", DOCS / "tf_doctor.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert (DOCS / "tf_doctor.md").read_text("utf-8") == module.page(), "run docs/tf_doctor.py"


def test_each_kind_is_whole() -> None:
    for code, kind in KINDS.items():
        assert re.fullmatch(r"TF[1-6]\d\d", code), code
        assert code[2] in GROUPS, code
        assert not kind.title.endswith("."), code
        for text in (kind.meaning, kind.cause, kind.mend):
            assert text.endswith("."), (code, text)
    assert list(KINDS) == sorted(KINDS)


def test_codes_in_the_code_are_in_the_catalogue() -> None:
    folder = Path(__file__).parents[3] / "src" / "tfloom" / "tf2_tools" / "diagnosis"
    used = {
        code
        for path in folder.glob("*.py")
        if path.name != "catalogue.py"
        for code in re.findall(r'"(TF\d{3})"', path.read_text("utf-8"))
    }
    assert used == set(KINDS)
