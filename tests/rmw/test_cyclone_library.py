"""The search for libddsc, its order, and its errors."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tfloom._native import DdsParticipant
from tfloom.rmw.cyclone import library as cyclone_library
from tfloom.rmw.cyclone.library import VARIABLE, candidates, find_library, open_library
from tfloom.rmw.errors import NoBackendError


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder that is the only one on sys.path; there is no other libddsc on the machine."""
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    monkeypatch.setattr(sys, "path_importer_cache", {})
    monkeypatch.setattr(cyclone_library, "_SYSTEM_FOLDERS", ())
    monkeypatch.setattr(cyclone_library, "_ROS_FOLDER", str(tmp_path / "ros"))
    monkeypatch.delenv(VARIABLE, raising=False)
    return tmp_path


def put(path: Path) -> str:
    """Write a file that is not a library, and return its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("not a library")
    return str(path)


def install(site: Path, package: str, library: str | None) -> None:
    put(site / package / "__init__.py")
    if library is not None:
        put(site / package / library)


@pytest.fixture
def use_only(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Return a function that makes `(origin, path)` pairs the libraries of this machine."""

    def use(*pairs: tuple[str, str]) -> None:
        monkeypatch.setattr(cyclone_library, "candidates", lambda: iter(pairs))

    return use


@pytest.mark.wire
def test_the_library_is_found_without_importing_its_package() -> None:
    sys.modules.pop("cyclonedds", None)
    path = Path(find_library())
    assert path.is_file()
    assert "ddsc" in path.name
    assert "cyclonedds" not in sys.modules


@pytest.mark.parametrize(
    ("package", "library"),
    [
        ("cyclonedds", "../cyclonedds.libs/libddsc-ad12c33a.so.11.0.1"),
        ("cyclonedds", ".dylibs/libddsc.11.0.1.dylib"),
        ("cyclonedds", "../cyclonedds.libs/ddsc-1a2b.dll"),
        ("tfloom_ddsc", "libddsc-ad12c33a.so.11.0.1"),
        ("tfloom_ddsc", "libddsc.11.0.1.dylib"),
        ("tfloom_ddsc", "ddsc-1a2b.dll"),
    ],
)
def test_library_path_on_each_platform(site: Path, package: str, library: str) -> None:
    install(site, package, library)
    assert find_library() == str((site / package / library).resolve())


def test_places_are_in_order(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    install(site, "cyclonedds", "../cyclonedds.libs/libddsc-ad12c33a.so.11.0.1")
    install(site, "tfloom_ddsc", "libddsc-ad12c33a.so.11.0.1")
    system = site / "usr lib"
    monkeypatch.setattr(cyclone_library, "_SYSTEM_FOLDERS", (str(system),))
    put(system / "libddsc.so.0.10.5")
    (system / "libddsc.so.0t64").symlink_to("libddsc.so.0.10.5")
    put(system / "libddsc_other.so.1")
    monkeypatch.setattr(sys.implementation, "_multiarch", "a-linux-gnu", raising=False)
    for distribution in ("humble", "jazzy", "kilted"):
        put(site / "ros" / distribution / "lib" / "a-linux-gnu" / "libddsc.so.0.10.5")
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    monkeypatch.setenv(VARIABLE, "/named/libddsc.so")
    ros = [
        (f"ROS 2 in {site}/ros/{name}", f"{site}/ros/{name}/lib/a-linux-gnu/libddsc.so.0.10.5")
        for name in ("jazzy", "kilted", "humble")
    ]
    assert list(candidates()) == [
        (VARIABLE, "/named/libddsc.so"),
        ("tfloom-ddsc", f"{site}/tfloom_ddsc/libddsc-ad12c33a.so.11.0.1"),
        ("the wheel of cyclonedds", f"{site}/cyclonedds.libs/libddsc-ad12c33a.so.11.0.1"),
        ("the system", f"{system}/libddsc.so.0.10.5"),
        *ros,
    ]


@pytest.mark.wire
def test_a_library_that_fails_is_named_and_the_next_is_used(
    tmp_path: Path, use_only: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    bad, missing, good = put(tmp_path / "libddsc.so.11"), str(tmp_path / "none.so"), find_library()
    use_only((VARIABLE, missing), ("the system", bad), ("the wheel of cyclonedds", good))
    for _ in range(2):
        library = open_library()
        assert (library.path, library.origin) == (good, "the wheel of cyclonedds")
        named, system = library.passed_over
        assert named.startswith(f"the DDS library of {VARIABLE} can't be used: cannot open the DDS library: ")
        assert missing in named
        assert system.startswith("the DDS library of the system can't be used: ")
    printed = capsys.readouterr().err.splitlines()
    assert printed == [f"tfloom: {named}; {good} is used", f"tfloom: {system}; {good} is used"]


def test_libraries_that_all_fail_are_named(tmp_path: Path, use_only: Callable[..., None]) -> None:
    use_only(("the system", put(tmp_path / "a.so")), ("ROS 2 in /opt/ros/x", put(tmp_path / "b.so")))
    with pytest.raises(NoBackendError) as caught:
        open_library()
    for part in ("library of the system can't be used: ", "a.so", "of ROS 2 in /opt/ros/x can't", "b.so"):
        assert part in str(caught.value)
    assert str(caught.value).endswith("RMW_IMPLEMENTATION=tfloom_local needs nothing")


@pytest.mark.parametrize(
    ("machine", "multiarch", "version", "advice"),
    [
        (
            "x86_64",
            "x86_64-linux-gnu",
            (3, 13),
            "there is no DDS: install one with: pip install 'cyclonedds",
        ),
        (
            "x86_64",
            "x86_64-linux-gnu",
            (3, 14),
            "pip install ./packages/tfloom-ddsc, in tfloom's sources; or pip",
        ),
        (
            "x86_64",
            "x86_64-linux-gnu",
            (3, 15),
            "--python-version 3.13 --only-binary=:all: cyclonedds==11.0.1",
        ),
        ("x86_64", "x86_64-linux-musl", (3, 13), f"none for musl; {VARIABLE} names one"),
        (
            "aarch64",
            "aarch64-linux-gnu",
            (3, 13),
            "apt-get install libddsc0t64 (Debian 13, Ubuntu) or libddsc0debian",
        ),
    ],
)
def test_missing_library_raises_with_what_installs_it_there(
    site: Path,
    monkeypatch: pytest.MonkeyPatch,
    machine: str,
    multiarch: str,
    version: tuple[int, int],
    advice: str,
) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr("platform.machine", lambda: machine)
    monkeypatch.setattr(sys.implementation, "_multiarch", multiarch, raising=False)
    monkeypatch.setattr(sys, "version_info", version)
    with pytest.raises(NoBackendError, match=re.escape(advice)):
        find_library()
    with pytest.raises(NoBackendError, match=re.escape(advice)):
        open_library()


def test_package_without_library_is_passed_over(site: Path) -> None:
    install(site, "cyclonedds", None)
    with pytest.raises(NoBackendError, match="there is no DDS"):
        find_library()


def test_named_file_that_is_missing_is_not_found(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, os.fspath(site / "libddsc.so"))
    with pytest.raises(NoBackendError, match="there is no DDS"):
        find_library()
    with pytest.raises(NoBackendError, match=f"the DDS library of {VARIABLE} can't be used: .*libddsc.so"):
        open_library()


def test_file_that_is_not_a_library_raises(tmp_path: Path) -> None:
    path = put(tmp_path / "libddsc.so")
    with pytest.raises(RuntimeError, match=r"cannot open the DDS library: .*libddsc.so"):
        DdsParticipant(path, 0, "", b"")


@pytest.mark.skipif(sys.platform != "linux", reason="takes a library that every Linux has")
def test_library_without_the_symbols_raises() -> None:
    with pytest.raises(
        RuntimeError, match=r"libc\.so\.6 has no dds_create_domain: it isn't Cyclone DDS 0\.10 or 11"
    ):
        DdsParticipant("libc.so.6", 0, "", b"")
