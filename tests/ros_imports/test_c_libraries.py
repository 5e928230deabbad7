"""Importing extension modules as ROS 2 packages do."""

from __future__ import annotations

import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest
from rpyutils import add_dll_directories_from_env, import_c_library

GUIDE = "https://docs.ros.org/en/jazzy/How-To-Guides/Installation-Troubleshooting.html"


def test_an_extension_module_is_imported() -> None:
    assert import_c_library("._native", "tfloom") is sys.modules["tfloom._native"]


def test_one_that_is_not_there_is_named_with_its_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    with pytest.raises(ModuleNotFoundError) as caught:
        import_c_library("._nope", "json.decoder")
    first, second = str(caught.value).splitlines()
    assert first == "No module named 'json.decoder._nope'; 'json.decoder' is not a package"
    with pytest.raises(ModuleNotFoundError) as caught:
        import_c_library("._nope", package="json")
    first, second = str(caught.value).splitlines()
    file = Path(sys.modules["json"].__file__ or "").parent / f"_nope{EXTENSION_SUFFIXES[0]}"
    section = "import-failing-without-library-present-on-the-system"
    assert first == "No module named 'json._nope'"
    assert second == (
        f"The C extension '{file}' isn't present on the system. Please refer to "
        f"'{GUIDE}#{section}' for possible solutions"
    )


def test_one_that_does_not_load_is_named_with_its_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    file = tmp_path / f"broken_for_a_test{EXTENSION_SUFFIXES[0]}"
    file.write_bytes(b"no library")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ImportError) as caught:
        import_c_library("broken_for_a_test")
    section = "import-failing-even-with-library-present-on-the-system"
    assert str(caught.value).splitlines()[-1] == (
        f"The C extension '{file}' failed to be imported while being present on the system. "
        f"Please refer to '{GUIDE}#{section}' for possible solutions"
    )


@pytest.mark.skipif(sys.platform == "win32", reason="Windows adds the folders")
def test_no_dll_folders_are_added_where_there_are_no_dlls() -> None:
    with add_dll_directories_from_env("PATH") as handles:
        assert handles == []


def test_the_function_stays_in_place_of_the_module_of_its_name() -> None:
    import rpyutils
    import rpyutils.import_c_library

    assert rpyutils.import_c_library is import_c_library
