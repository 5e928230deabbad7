"""Selection of a wire and a domain by the environment."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import pytest

from tfloom.rmw import backends
from tfloom.rmw.cyclone import library as cyclone_library
from tfloom.rmw.errors import ConfigurationError, NoBackendError


def test_the_local_wire_by_its_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", "17")
    participant = backends.open_participant()
    assert participant.domain_id == 17
    participant.close()


@pytest.mark.parametrize("value", ["", None])
def test_cyclone_is_the_default(monkeypatch: pytest.MonkeyPatch, value: str | None) -> None:
    monkeypatch.setattr(backends, "is_installed", lambda name: True)
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    if value is not None:
        monkeypatch.setenv("RMW_IMPLEMENTATION", value)
    assert backends.implementation_identifier() == "rmw_cyclonedds_cpp"


@pytest.mark.parametrize(
    ("installed", "name", "lines"),
    [
        ({"rmw_cyclonedds_cpp", "rmw_zenoh_cpp"}, "rmw_cyclonedds_cpp", 0),
        ({"rmw_cyclonedds_cpp"}, "rmw_cyclonedds_cpp", 0),
        ({"rmw_zenoh_cpp"}, "rmw_zenoh_cpp", 1),
        (set(), "rmw_cyclonedds_cpp", 0),
    ],
)
def test_zenoh_is_the_default_where_there_is_no_dds_and_one_line_says_so(
    monkeypatch, capsys, installed: set[str], name: str, lines: int
) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    monkeypatch.setattr(backends, "_reported_replacements", set())
    monkeypatch.setattr(backends, "is_installed", installed.__contains__)
    assert backends.implementation_identifier() == name
    assert backends.implementation_identifier() == name
    told = capsys.readouterr().err
    assert told.count("\n") == lines
    assert ("there is no DDS library, so rmw_zenoh_cpp is used" in told) == bool(lines)


def test_cyclone_replaces_fast_dds_with_one_message(monkeypatch, capsys) -> None:
    monkeypatch.setattr(backends, "_reported_replacements", set())
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_fastrtps_cpp")
    assert backends.implementation_identifier() == "rmw_cyclonedds_cpp"
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "rmw_fastrtps_cpp isn't available, so rmw_cyclonedds_cpp is used" in told
    assert backends.implementation_identifier() == "rmw_cyclonedds_cpp"
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    ("variable", "platform", "processor", "passing"),
    [
        ("", "linux", "x86_64", "topics and services pass between the two"),
        ("", "linux", "aarch64", "topics and services pass between the two"),
        ("0", "linux", "x86_64", "services don't, because TFLOOM_FASTDDS_SERVICES is 0"),
        ("", "darwin", "arm64", "services don't, because they are translated on Linux only"),
        (
            *("", "linux", "riscv64"),
            "services don't, because they are translated on x86_64 and aarch64 only, and this is riscv64",
        ),
    ],
)
def test_stand_in_says_whether_services_pass(
    monkeypatch, capsys, variable, platform, processor, passing
) -> None:
    monkeypatch.setattr(backends, "_reported_replacements", set())
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_fastrtps_cpp")
    monkeypatch.setenv("TFLOOM_FASTDDS_SERVICES", variable)
    monkeypatch.setattr(backends.sys, "platform", platform)
    monkeypatch.setattr(backends.os, "uname", lambda: SimpleNamespace(machine=processor), raising=False)
    assert backends.implementation_identifier() == "rmw_cyclonedds_cpp"
    assert capsys.readouterr().err.endswith(f"{passing}\n")


def test_unknown_wire_error_lists_the_known_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_conext_cpp")
    with pytest.raises(
        NoBackendError,
        match="'rmw_conext_cpp', which is none of: rmw_cyclonedds_cpp, rmw_zenoh_cpp, tfloom_local",
    ):
        backends.open_participant()


@pytest.mark.parametrize(("text", "domain"), [(None, 0), ("", 0), ("0", 0), ("232", 232), (" 42 ", 42)])
def test_domain_from_the_environment(monkeypatch, text: str | None, domain: int) -> None:
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
    if text is not None:
        monkeypatch.setenv("ROS_DOMAIN_ID", text)
    assert backends.domain_id_from_environment() == domain


@pytest.mark.parametrize("text", ["233", "-1", "1.5", "abc", "0x10"])
def test_invalid_domain_error_has_the_reason(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", text)
    with pytest.raises(
        ConfigurationError, match="ROS_DOMAIN_ID must be an integer from 0 to 232, not '?" + text
    ):
        backends.domain_id_from_environment()


def test_invalid_domain_argument_is_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    with pytest.raises(ConfigurationError, match="domain_id must be an integer from 0 to 232, not 1000"):
        backends.open_participant(1000)


def test_every_backend_is_a_module_that_opens_participants() -> None:
    for module in backends.BACKENDS.values():
        assert callable(import_module(module).open_participant)


def test_is_installed_reports_the_libraries(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    monkeypatch.setattr(sys, "path_importer_cache", {})
    monkeypatch.setattr(cyclone_library, "_SYSTEM_FOLDERS", ())
    monkeypatch.setattr(cyclone_library, "_ROS_FOLDER", str(tmp_path))
    monkeypatch.delenv(cyclone_library.VARIABLE, raising=False)
    assert backends.is_installed("tfloom_local")
    assert not backends.is_installed("rmw_zenoh_cpp")
    (tmp_path / "zenoh").mkdir()
    (tmp_path / "zenoh" / "__init__.py").touch()
    assert backends.is_installed("rmw_zenoh_cpp")
    assert not backends.is_installed("rmw_cyclonedds_cpp")
    for name in ("cyclonedds", "cyclonedds.libs"):
        (tmp_path / name).mkdir()
    (tmp_path / "cyclonedds" / "__init__.py").touch()
    assert not backends.is_installed("rmw_cyclonedds_cpp")
    (tmp_path / "cyclonedds.libs" / "libddsc-ad12c33a.so.11.0.1").touch()
    assert backends.is_installed("rmw_cyclonedds_cpp")


def test_each_library_belongs_to_a_wire() -> None:
    assert set(backends.LIBRARIES) <= set(backends.BACKENDS)
    for module in backends.LIBRARIES.values():
        assert callable(import_module(module).find_library)
