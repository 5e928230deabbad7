"""The search for libddsc, and its errors."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tfloom._native import DdsParticipant
from tfloom.rmw.cyclone_library import find_library
from tfloom.rmw.errors import NoBackendError


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder that is the only one on sys.path."""
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    monkeypatch.setattr(sys, "path_importer_cache", {})
    return tmp_path


def install(site: Path, library: str | None) -> None:
    (site / "cyclonedds").mkdir()
    (site / "cyclonedds" / "__init__.py").touch()
    if library is not None:
        path = site / "cyclonedds" / library
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()


@pytest.mark.wire
def test_the_library_is_found_without_importing_its_package() -> None:
    sys.modules.pop("cyclonedds", None)
    path = Path(find_library())
    assert path.is_file()
    assert "ddsc" in path.name
    assert "cyclonedds" not in sys.modules


@pytest.mark.parametrize(
    "library",
    [
        "../cyclonedds.libs/libddsc-ad12c33a.so.11.0.1",
        ".dylibs/libddsc.11.0.1.dylib",
        "../cyclonedds.libs/ddsc-1a2b.dll",
    ],
)
def test_library_path_on_each_platform(site: Path, library: str) -> None:
    install(site, library)
    assert find_library() == str((site / "cyclonedds" / library).resolve())


def test_missing_package_raises(site: Path) -> None:
    with pytest.raises(
        NoBackendError, match="cyclonedds isn't installed; install it with: pip install 'cyclonedds>=11,<12'"
    ):
        find_library()


def test_package_without_library_raises(site: Path) -> None:
    install(site, None)
    with pytest.raises(NoBackendError, match="came without libddsc"):
        find_library()


def test_file_that_is_not_a_library_raises(tmp_path: Path) -> None:
    path = tmp_path / "libddsc.so"
    path.write_text("not a library")
    with pytest.raises(RuntimeError, match=r"cannot open the DDS library: .*libddsc.so"):
        DdsParticipant(str(path), 0, "", b"")


@pytest.mark.skipif(sys.platform != "linux", reason="takes a library that every Linux has")
def test_library_without_the_symbols_raises() -> None:
    with pytest.raises(
        RuntimeError, match=r"libc\.so\.6 has no dds_create_domain: it isn't Cyclone DDS 11; install"
    ):
        DdsParticipant("libc.so.6", 0, "", b"")
