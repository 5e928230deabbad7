"""The checks that `colcon test` runs, by the names that generated tests import."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib import util
from pathlib import Path

import pytest
from ament_copyright.main import main as copyright_main
from ament_flake8.main import main as flake8_main
from ament_flake8.main import main_with_errors
from ament_mypy.main import main as mypy_main
from ament_pep257.main import main as pep257_main
from ament_xmllint.main import main as xmllint_main
from tests.conftest import PYTEST, run_to_end
from tests.workspace.conftest import BIN, colcon, write_files

from tfloom.workspace.licenses import LICENSES, find_license

APACHE = """\
# Copyright 2020-2024, 2026 Me and others
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.
"""
LONG = "x = '" + 94 * "a" + "'\n"
DOCSTRINGS = '''\
def publish():
    """
    Publish the pose
    of the turtle.
    """


def area(turtle):
    """
    Return the area.

    Args:
        turtle: The turtle.

    Returns:
        The area.

    """


def first():
    """returns area(1)."""  # noqa: D401


def second():  # noqa: D403
    """returns nothing."""
'''
"""Docstrings in which other checkers find other faults."""

needs_linters = pytest.mark.skipif(
    not all(util.find_spec(module) for module in ("flake8", "pydocstyle")),
    reason="needs flake8 and pydocstyle",
)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@needs_linters
def test_flake8_applies_the_settings_of_ros(here: Path) -> None:
    write_files(here, {"good.py": LONG[:98] + "'\n", "setup.cfg": "[flake8]\nmax-line-length = 10\n"})
    assert main_with_errors(argv=[]) == (0, [])
    write_files(
        here,
        {"sub/bad.py": "import os\n" + LONG, "_no/bad.py": LONG, "off/AMENT_IGNORE": "", "off/a.py": LONG},
    )
    code, errors = main_with_errors(argv=[])
    assert code == 1
    assert errors == [
        "sub/bad.py:1:1: F401 'os' imported but unused",
        "sub/bad.py:2:100: E501 line too long (100 > 99 characters)",
    ]
    assert flake8_main(argv=["--linelength", "100", "--exclude", "sub/bad.py", "--", "."]) == 0


@needs_linters
def test_pep257_applies_the_rules_of_ros(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_files(here, {"good.py": 'def f():\n    pass\n\n\ndef g():\n    """Return nothing."""\n'})
    assert pep257_main(argv=["."]) == 0
    assert "1 files checked\nNo problems found" in capsys.readouterr().out
    write_files(here, {"test/test_bad.py": 'def f():\n    """returns nothing"""\n'})
    assert pep257_main(argv=[".", "--exclude", "good.py"]) == 1
    shown = capsys.readouterr().err
    assert "test/test_bad.py:2 in public function `f`: D400: First line should end with a period" in shown
    assert "D403: First word of the first line should be properly capitalized" in shown
    assert pep257_main(argv=[".", "--select", "D300"]) == 0


@needs_linters
def test_pep257_finds_what_the_reference_finds(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_files(here, {"docstrings.py": DOCSTRINGS})
    assert pep257_main(argv=[]) == 1
    shown = capsys.readouterr().err
    faults = re.findall(r"^docstrings.py:\d+ in public function (.*): (D\d+): ", shown, re.MULTILINE)
    assert sorted(faults) == [
        ("`area`", "D406"),
        ("`area`", "D407"),
        ("`first`", "D401"),
        ("`first`", "D403"),
        ("`publish`", "D205"),
        ("`publish`", "D400"),
        ("`publish`", "D415"),
        ("`second` (skipping D403)", "D401"),
    ]
    assert "D401: First line should be in imperative mood (perhaps 'Return', not 'returns')" in shown
    assert "docstrings.py:9 in public function `area`: D407: Missing dashed underline after section" in shown


@needs_linters
def test_pep257_reports_files_that_it_cannot_parse(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_files(here, {"broken.py": "def (\n"})
    assert pep257_main(argv=[]) == 1
    assert capsys.readouterr() == ("\n1 files checked\n1 errors\n", "broken.py: Cannot parse file.\n")
    write_files(here, {"good.py": "x = 1\n", "test_bad.py": 'def f():\n    """Return."""\n\n    pass\n'})
    assert pep257_main(argv=[]) == 1
    shown = capsys.readouterr()
    assert shown.out == "\n3 files checked\n2 errors\n"
    assert "broken.py: Cannot parse file.\n" in shown.err
    assert "test_bad.py:2 in public function `f`: D202: No blank lines allowed after function" in shown.err


@pytest.mark.skipif(util.find_spec("mypy") is None, reason="needs mypy")
def test_mypy_finds_wrong_types_and_takes_the_settings_of_a_file(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good = "import no_such_module\n\n\ndef double(number: int) -> int:\n    return 2 * number\n"
    loose = "def f(x): return x\n"
    write_files(
        here, {"good.py": good, "loose.py": loose, "mypy.ini": "[mypy]\ndisallow_untyped_defs = True\n"}
    )
    assert mypy_main(argv=[]) == 0
    assert capsys.readouterr().out == "\n2 files checked\nNo problems found\n"
    write_files(here, {"bad.py": "from good import double\n\ndouble('a')\n", "left_out.py": "double('a')\n"})
    assert mypy_main(argv=["--config", "mypy.ini", "--exclude", "left_out.py", "--", "."]) == 1
    printed = capsys.readouterr().out
    assert 'bad.py:3: error: Argument 1 to "double" has incompatible type "str"' in printed
    assert "loose.py:1: error: Function is missing a type annotation" in printed
    assert printed.endswith("3 files checked\n3 errors\n")
    assert not (here / ".mypy_cache").exists()
    assert mypy_main(argv=["--config", "none.ini"]) == 1
    assert capsys.readouterr().err == "Could not find config file 'none.ini'\n"
    write_files(here, {"broken.py": "def (\n"})
    assert mypy_main(argv=["broken.py"]) == 1
    assert mypy_main(argv=["empty"]) == 1
    (here / "empty").mkdir()
    assert mypy_main(argv=["empty"]) == 1
    assert capsys.readouterr().err.endswith("No files found\n")


def test_copyright_wants_a_notice_and_a_known_license(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_files(
        here,
        {
            "good.py": "#!/usr/bin/env python3\n" + APACHE + "\nx = 1\n",
            "empty.py": "",
            "good.hpp": APACHE.replace("#", "//"),
            "package.xml": "",
            "setup.py": "x = 1\n",
        },
    )
    assert copyright_main(argv=[".", "--verbose"]) == 0
    out = capsys.readouterr().out
    assert "copyright=Me and others (2020-2024, 2026), license=apache2" in out
    assert "No problems found, checked 3 files" in out
    write_files(here, {"bare.py": "x = 1\n", "odd.py": "# Copyright 2026 Me\n#\n# All rights reserved.\n"})
    (here / ".git").mkdir()
    assert copyright_main(argv=["."]) == 1
    err = capsys.readouterr().err
    assert "bare.py: could not find copyright notice" in err
    assert "odd.py: copyright=Me (2026), license=<unknown>" in err
    assert "LICENSE: file not found" in err
    assert "4 errors, checked 7 files" in err


def test_every_license_is_recognised() -> None:
    for licence in LICENSES:
        assert find_license("\n   ".join(licence.phrases)) == licence.name
    assert find_license("All rights reserved.") is None


def test_xmllint_finds_what_is_not_well_formed(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_files(here, {"package.xml": "<package/>", "launch/a.launch.xml": "<launch/>", "b.urdf": "<robot>"})
    assert xmllint_main(argv=[]) == 0
    assert capsys.readouterr().out.endswith("No problems found\n")
    write_files(
        here, {"c.xml": "<a>\n<b></a>", "_build/d.xml": "<", "off/AMENT_IGNORE": "", "off/e.xml": "<"}
    )
    assert xmllint_main(argv=[]) == 1
    assert "c.xml:2:6: mismatched tag\n1 files are invalid\n" in capsys.readouterr().err
    assert xmllint_main(argv=[".", "--exclude", "c.xml"]) == 0
    assert xmllint_main(argv=["--extensions", "urdf", "--", "."]) == 1
    assert xmllint_main(argv=["nothere.xml"]) == 1


def test_missing_library_skips_the_test_with_the_reason(here: Path) -> None:
    modules = {"ament_flake8": "flake8", "ament_pep257": "pydocstyle", "ament_mypy": "mypy"}
    text = f"""
import importlib
import pytest
import tfloom.workspace.lint as lint
lint.find_spec = lambda name: None

@pytest.mark.parametrize("module", {list(modules)})
def test_it(module):
    importlib.import_module(module + ".main").main(argv=['.'])
"""
    write_files(here, {"test_it.py": text})
    result = run_to_end([sys.executable, *PYTEST, "-rs", "-p", "no:cacheprovider", "test_it.py"])
    for library in modules.values():
        assert f"{library} is not installed: pip install {library}" in result.stdout
    assert "3 skipped" in result.stdout


@pytest.mark.slow
@needs_linters
def test_created_packages_build_and_pass_their_tests(tmp_path: Path) -> None:
    source = tmp_path / "src"
    create = [BIN / "tfloom", "pkg", "create", "--destination-directory", source, "--license", "MIT"]
    node = ["--node-name", "my_node", "--library-name", "my_lib", "--dependencies", "my_msgs", "--", "my_pkg"]
    for words in (node, ["--build-type", "ament_cmake", "my_msgs", "--dependencies", "geometry_msgs"]):
        subprocess.run([*create, *words], check=True, timeout=60, capture_output=True)
    built = colcon(tmp_path, "build")
    assert built.code == 0, built.output
    tested = colcon(tmp_path, "test", "--return-code-on-test-failure")
    assert tested.code == 0, tested.output
    # pytest warns of the loader of an editable tfloom, which is a module of a package with a plugin.
    assert "Warning" not in tested.output.replace("PytestAssertRewriteWarning: Module already imported", "")
    result = colcon(tmp_path, "test-result")
    assert "Summary: 3 tests, 0 errors, 0 failures, 1 skipped" in result.output
    node_file = source / "my_pkg" / "my_pkg" / "my_node.py"
    node_file.write_text("import os\n" + node_file.read_text())
    assert colcon(tmp_path, "test", "--return-code-on-test-failure").code == 1
    result = colcon(tmp_path, "test-result", "--verbose")
    assert (result.code, "F401" in result.output) == (1, True)
