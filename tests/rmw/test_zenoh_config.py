"""The configuration of sessions and routers of the Zenoh wire: ranges, files, overrides, and each mistake in them."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.zenoh_ports import hold_zenoh_port

from tfloom.rmw.errors import ConfigurationError
from tfloom.rmw.zenoh import config as zenoh_config

pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")


@pytest.fixture(autouse=True)
def port() -> Iterator[int]:
    with hold_zenoh_port() as held:
        yield held


def value(config: Any, key: str) -> Any:
    return json.loads(config.get_json(key))


def endpoints(config: Any) -> tuple[list[str], list[str]]:
    return (
        zenoh_config.endpoints_of(config, "connect/endpoints"),
        zenoh_config.endpoints_of(config, "listen/endpoints"),
    )


def test_a_session_stays_on_this_machine(port: int) -> None:
    config = zenoh_config.session_configuration()
    assert endpoints(config) == ([f"tcp/127.0.0.1:{port}"], ["tcp/127.0.0.1:0"])
    assert value(config, "mode") == "peer"
    assert value(config, "scouting/multicast/enabled") is False
    assert value(config, "transport/shared_memory/enabled") is False
    drop = "transport/link/tx/queue/congestion_control/drop"
    assert value(config, f"{drop}/wait_before_drop") == 50_000
    assert value(config, f"{drop}/max_wait_before_drop_fragments") == 5_000_000
    assert value(config, "transport/link/tx/lease") == 60_000
    assert value(config, "timestamping/enabled") == {"router": True, "peer": True, "client": True}


def test_a_router_stays_on_this_machine(port: int) -> None:
    config = zenoh_config.router_configuration()
    assert endpoints(config) == ([], [f"tcp/127.0.0.1:{port}"])
    assert value(config, "mode") == "router"
    assert value(config, "scouting/multicast/enabled") is False


def test_default_port_is_that_of_rmw_zenoh(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TFLOOM_ZENOH_PORT")
    assert endpoints(zenoh_config.session_configuration())[0] == ["tcp/127.0.0.1:7447"]


def test_subnet_listens_everywhere_and_scouts(port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")
    config = zenoh_config.session_configuration()
    assert endpoints(config)[1] == ["tcp/[::]:0"]
    assert value(config, "scouting/multicast/enabled") is True
    assert endpoints(zenoh_config.router_configuration())[1] == [f"tcp/[::]:{port}"]


def test_off_neither_listens_nor_connects(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    monkeypatch.setenv("ROS_STATIC_PEERS", "robot")
    config = zenoh_config.session_configuration()
    assert endpoints(config) == ([], [])
    assert value(config, "scouting/gossip/enabled") is False


def test_static_peers_are_routers(port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", "robot; 10.0.0.2:7500;localhost; ;tls/base:7447;fe80::1")
    peers = [f"tcp/robot:{port}", "tcp/10.0.0.2:7500", "tls/base:7447", f"tcp/[fe80::1]:{port}"]
    assert endpoints(zenoh_config.session_configuration())[0] == [f"tcp/127.0.0.1:{port}"]
    assert endpoints(zenoh_config.router_configuration())[0] == peers


def test_lease_is_that_of_the_variable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TFLOOM_LEASE_S", "2.5")
    assert value(zenoh_config.session_configuration(), "transport/link/tx/lease") == 2500


def test_a_file_precedes_what_it_states(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "session.json5"
    file.write_text(
        """{ // listen: nothing is stated here, as in "a comment about endpoints"
        mode: "client", connect: {endpoints: ["tcp/robot:7447"]},
        transport: {'shared_memory': {enabled: true}}, /* wait_before_drop: 1, drop */
        scouting: {multicast: {enabled: true}},
        }"""
    )
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    config = zenoh_config.session_configuration()
    assert value(config, "mode") == "client"
    assert endpoints(config) == (["tcp/robot:7447"], ["tcp/127.0.0.1:0"])
    assert value(config, "transport/shared_memory/enabled") is True
    assert value(config, "scouting/multicast/enabled") is True
    assert value(config, "transport/link/tx/queue/congestion_control/drop/wait_before_drop") == 50_000
    assert value(config, "scouting/delay") == 0
    assert endpoints(zenoh_config.router_configuration())[0] == []  # another variable's


def settings_of_file(text: str, path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    path.write_text(text)
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(path))
    return zenoh_config.session_configuration()


OPENS_NOTHING = [
    '{connect: {endpoints: ["tcp/robot:7447"]}, listen: {exit_on_failure: true}}',
    '{listen: {timeout_ms: 5}, "connect": {"endpoints": ["tcp/robot:7447"]}}',
    '{metadata: {listen: {endpoints: ["tcp/[::]:0"]}}, connect: {endpoints: ["tcp/robot:7447"]}}',
    '{metadata: {name: "I listen at endpoints"}, connect: {endpoints: ["tcp/robot:7447"]}}',
    '{listen: {endpoints: {router: ["tcp/[::]:7447"]}}, connect: {endpoints: {peer: ["tcp/robot:7447"]}}}',
    '{listen: {endpoints: {}}, connect: {endpoints: ["tcp/robot:7447"], retry: {period_init_ms: 1}}}',
    '{transport: {shared_memory: {mode: "lazy"}}, connect: {endpoints: ["tcp/robot:7447"]}}',
    '{scouting: {multicast: {ttl: 3, enabled: null}}, connect: {endpoints: ["tcp/robot:7447"]}}',
]


@pytest.mark.parametrize("text", OPENS_NOTHING)
def test_a_file_opens_nothing_that_it_does_not_name(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    config = settings_of_file(text, tmp_path / "session.json5", monkeypatch)
    assert endpoints(config) == (["tcp/robot:7447"], ["tcp/127.0.0.1:0"])
    assert value(config, "transport/shared_memory/enabled") is False
    assert value(config, "scouting/multicast/enabled") is False


def test_a_file_that_names_few_parts_leaves_the_others(
    port: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = """{listen: {endpoints: ["tcp/[::]:7999"]}, connect: {retry: {period_init_ms: 7}},
    timestamping: {enabled: {peer: false}}, transport: {link: {tx: {lease: 5}}},
    scouting: {gossip: {target: ["peer"]}}}"""
    config = settings_of_file(text, tmp_path / "session.json", monkeypatch)
    assert endpoints(config) == ([f"tcp/127.0.0.1:{port}"], ["tcp/[::]:7999"])
    assert value(config, "connect/retry") == {
        "period_init_ms": 7,
        "period_max_ms": 1000,
        "period_increase_factor": 2,
    }
    assert value(config, "timestamping/enabled") == {"router": True, "peer": False, "client": True}
    assert value(config, "transport/link/tx/lease") == 5
    assert value(config, "transport/unicast/max_sessions") == 10_000
    assert value(config, "scouting/gossip/target") == ["peer"]


@pytest.mark.parametrize("suffix", ["yaml", "yml"])
def test_a_file_in_yaml_opens_nothing_that_it_does_not_name(
    suffix: str, port: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / f"session.{suffix}"
    config = settings_of_file("listen:\n  exit_on_failure: true  # endpoints\n", path, monkeypatch)
    assert endpoints(config) == ([f"tcp/127.0.0.1:{port}"], ["tcp/127.0.0.1:0"])
    config = settings_of_file("listen: {endpoints: ['tcp/127.0.0.1:7999']}\n", path, monkeypatch)
    assert endpoints(config) == ([f"tcp/127.0.0.1:{port}"], ["tcp/127.0.0.1:7999"])


def test_a_file_may_listen_nowhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "session.json5"
    file.write_text('{listen: {endpoints: []}, "connect": {"endpoints": []}}')
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    assert endpoints(zenoh_config.session_configuration()) == ([], [])


def test_overrides_come_last_and_wrong_ones_are_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "session.json5"
    file.write_text('{mode: "client"}')
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    monkeypatch.setenv(
        "ZENOH_CONFIG_OVERRIDE",
        'mode="peer";no/such=1;mode="blah";noequals;=3;listen/endpoints=["tcp/127.0.0.1:7999"];scouting/delay=',
    )
    config = zenoh_config.session_configuration()
    assert value(config, "mode") == "peer"
    assert endpoints(config)[1] == ["tcp/127.0.0.1:7999"]
    assert capsys.readouterr().err.splitlines() == [
        "tfloom: ZENOH_CONFIG_OVERRIDE: 'noequals' is ignored, because it isn't key=value",
        "tfloom: ZENOH_CONFIG_OVERRIDE: '=3' is ignored, because it isn't key=value",
        "tfloom: ZENOH_CONFIG_OVERRIDE: 'scouting/delay=' is ignored, because it isn't key=value",
        'tfloom: ZENOH_CONFIG_OVERRIDE: no/such=1 is ignored: Str("unknown key")',
        'tfloom: ZENOH_CONFIG_OVERRIDE: mode="blah" is ignored: unknown variant `blah`, '  # noqa: ISC004
        "expected one of `router`, `peer`, `client` (line 1, column 1)",
    ]
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", "scouting/delay=7")
    assert value(zenoh_config.router_configuration(), "scouting/delay") == 7


@pytest.mark.parametrize(
    ("content", "text"),
    [
        (b"{mode:", "is not a configuration of Zenoh: "),
        (
            b'{mode: "blah"}',
            "unknown variant `blah`, expected one of `router`, `peer`, `client` (line 1, column 8)",
        ),
        (b"{mod: 1}", "unknown field `mod`"),
        (b"", "Empty config file"),
        pytest.param(
            b"{metadata: " + 3000 * b"[" + 3000 * b"]" + b"}",
            "maximum recursion depth exceeded",
            marks=pytest.mark.skipif(sys.version_info >= (3, 12), reason="its JSON is read as deep as this"),
        ),
        (b"\xff", "isn't UTF-8 text"),
        (b" " * (zenoh_config.MAX_FILE_SIZE + 1), "is longer than 1048576 bytes"),
    ],
    ids=["cut", "value", "key", "empty", "deep", "bytes", "long"],
)
def test_a_wrong_file_is_named_with_the_reason(
    content: bytes, text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "session.json5"
    file.write_bytes(content)
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    with pytest.raises(ConfigurationError) as told:
        zenoh_config.session_configuration()
    assert str(told.value).startswith(f"ZENOH_SESSION_CONFIG_URI names {file}, ")
    assert text in str(told.value)
    assert ".rs:" not in str(told.value)
    assert "\n" not in str(told.value)


def test_a_missing_file_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CONFIG_URI", "/no/such.json5")
    with pytest.raises(
        ConfigurationError,
        match=r"ZENOH_ROUTER_CONFIG_URI names /no/such.json5, which can't be read: No such file or directory",
    ):
        zenoh_config.router_configuration()


@pytest.mark.parametrize("text", ["0", "65536", "x", "-1", "1.5", "²", "9" * 5000])
def test_wrong_ports_are_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TFLOOM_ZENOH_PORT", text)
    with pytest.raises(ConfigurationError, match="TFLOOM_ZENOH_PORT must be an integer from 1 to 65535"):
        zenoh_config.port()


@pytest.mark.parametrize(("text", "checks"), [("", 1), ("3", 3), ("0", None), ("-1", 0), (" 2 ", 2)])
def test_router_checks(text: str, checks: int | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", text)
    assert zenoh_config.router_checks() == checks


def test_wrong_router_checks_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "often")
    with pytest.raises(ConfigurationError, match=r"ZENOH_ROUTER_CHECK_ATTEMPTS must be an integer.*'often'"):
        zenoh_config.router_checks()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize("stderr", [">/dev/full", ">&-"])
def test_warning_that_can_not_be_printed_ends_nothing(
    stderr: str, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    program = "from tfloom.rmw.backends import open_participant; open_participant().close(); print('opened and closed')"
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", "nonsense; no_such_key=1")
    done = subprocess.run(
        ["sh", "-c", f'exec "$0" -c "$1" 2{stderr}', sys.executable, program],
        stdout=subprocess.PIPE,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "opened and closed\n")
