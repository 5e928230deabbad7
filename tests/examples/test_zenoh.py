"""The example of networks over Zenoh: two routers joined by TLS, a laptop that may read /tf, and who is refused."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.zenoh_ports import hold_zenoh_port

from tfloom.cli.doctor.finding import Verdict
from tfloom.cli.doctor.zenoh import check_router
from tfloom.rmw.errors import WireError
from tfloom.rmw.zenoh import config as zenoh_config
from tfloom.rmw.zenoh.config import SESSION_VARIABLE, session_configuration
from tfloom.rmw.zenoh.session import open_session

zenoh = pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

pytestmark = pytest.mark.skipif(shutil.which("openssl") is None, reason="certificates are made by openssl")

EXAMPLE = Path(__file__).parents[2] / "examples" / "zenoh"
TF = "0/tf/tf2_msgs::msg::dds_::TFMessage_/RIHS01_0"
STATIC = "0/tf_static/tf2_msgs::msg::dds_::TFMessage_/RIHS01_0"
CMD_VEL = "0/cmd_vel/geometry_msgs::msg::dds_::Twist_/RIHS01_0"
SERVICE = "0/reboot/std_srvs::srv::dds_::Empty_/RIHS01_0"
StartRouter = Callable[..., Program]
TOKEN = "@ros2_lv/0/1/0/0/NN/%/%/driver"


def direct(function: Callable[[Any], object]) -> Any:
    """Return a handler that calls a function on the session's own thread."""
    return zenoh.handlers.Callback(function, indirect=False)


def replaced(file: Path, changes: dict[str, str]) -> str:
    """Return a file's text with each of some parts, which are there, replaced."""
    text = file.read_text()
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return text


class Machine:
    """A session, and what has reached it: the keys of samples and of tokens."""

    def __init__(self, config: Any) -> None:
        self.samples: list[str] = []
        self.tokens: set[str] = set()
        self.session = zenoh.open(config)
        note_token = direct(lambda sample: self.tokens.add(str(sample.key_expr)))
        self._kept = [self.session.liveliness().declare_subscriber("@ros2_lv/0/**", note_token, history=True)]
        self.subscribe("**")

    def keep(self, entity: Any) -> None:
        """Keep an entity, which would be undeclared with its last reference."""
        self._kept.append(entity)

    def subscribe(self, key: str) -> None:
        """Subscribe to one topic by its name, too, because the router's rules let a laptop ask for no other."""
        note = direct(lambda sample: self.samples.append(str(sample.key_expr)))
        self.keep(self.session.declare_subscriber(key, note))


@pytest.fixture(scope="module")
def certificates(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the certificates of the example, and those of another authority."""
    made = tmp_path_factory.mktemp("made")
    for words in (("certificates", "robot=127.0.0.1", "base", "laptop", "stranger"), ("of_others", "laptop")):
        subprocess.run([sys.executable, EXAMPLE / "make_certificates.py", *words], cwd=made, check=True)
    return made


@pytest.fixture
def folder(
    certificates: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    start_program: Callable[..., Program],
) -> Iterator[Path]:
    """Return a copy of the example with ports of this test, in which the robot's address is 127.0.0.1."""
    with hold_zenoh_port() as port:
        base = port + 2
        for file in EXAMPLE.glob("*.json5"):
            text = file.read_text().replace("tls/robot:", "tls/127.0.0.1:").replace("0.0.0.0", "127.0.0.1")
            text = text.replace(":7447", f":{base if file.name == 'base_router.json5' else port}")
            (tmp_path / file.name).write_text(text.replace(":7448", f":{port + 1}"))
        for made in certificates.iterdir():
            (tmp_path / made.name).symlink_to(made)
        monkeypatch.chdir(tmp_path)
        yield tmp_path


@pytest.fixture
def start_router(start_program: Callable[..., Program]) -> StartRouter:
    """Start a router with a file of the example, and wait until it listens."""

    def start(file: str = "robot_router.json5") -> Program:
        program = start_program("tfloom", "zenoh", "router", "-c", file)
        program.wait_for("listening on")
        return program

    return start


@pytest.fixture
def join(folder: Path) -> Iterator[Callable[..., Machine]]:
    """Open a session with a file of the example, or, without one, as one of the robot's own programs."""
    with ExitStack() as stack, pytest.MonkeyPatch.context() as patch:

        def open_machine(file: str = "", **changes: str) -> Machine:
            patch.delenv(SESSION_VARIABLE, raising=False)
            if file:
                (folder / "session.json5").write_text(replaced(folder / file, changes))
                patch.setenv(SESSION_VARIABLE, "session.json5")
            machine = Machine(session_configuration())
            stack.callback(machine.session.close)
            return machine

        yield open_machine


def serve(robot: Machine) -> list[str]:
    """Let the robot have a node, a service and static transforms of before; return the requests that reach it."""
    asked: list[str] = []
    robot.keep(robot.session.liveliness().declare_token(TOKEN))
    note = direct(lambda query: asked.append(str(query.key_expr)))
    robot.keep(robot.session.declare_queryable(SERVICE, note, complete=True))
    static = zenoh.ext.declare_advanced_publisher(
        robot.session, STATIC, cache=zenoh.ext.CacheConfig(max_samples=1), publisher_detection=True
    )
    static.put(b"of before")
    robot.keep(static)
    return asked


@pytest.mark.parametrize("file", ["robot_router.json5", "robot_router_tf_only.json5"])
def test_laptop_reads_tf_and_nothing_else(
    file: str, join: Callable[..., Machine], start_router: StartRouter
) -> None:
    start_router(file)
    robot = join()
    asked = serve(robot)
    laptop = join("laptop.json5")
    for key in (TF, CMD_VEL):
        laptop.subscribe(key)
    statics: list[bytes] = []
    note = direct(lambda sample: statics.append(sample.payload.to_bytes()))
    history = zenoh.ext.HistoryConfig(detect_late_publishers=True, max_samples=1)
    laptop.keep(zenoh.ext.declare_advanced_subscriber(laptop.session, STATIC, note, history=history))

    def tf_arrives() -> bool:
        robot.session.put(CMD_VEL, b"secret")
        robot.session.put(TF, b"transform")
        return TF in laptop.samples

    wait_until(tf_arrives)
    wait_until(lambda: statics[:1] == [b"of before"])
    assert CMD_VEL not in laptop.samples
    if file == "robot_router.json5":
        wait_until(lambda: TOKEN in laptop.tokens)
    else:
        assert laptop.tokens == set()
    robot.samples.clear()
    for key in (CMD_VEL, TF):
        laptop.session.put(key, b"drive")
    assert list(laptop.session.get(SERVICE, timeout=1.0)) == []
    # What the laptop has written precedes what another program writes now.
    other = join()
    robot.samples.clear()
    wait_until(lambda: other.session.put("0/mark", b"") or "0/mark" in robot.samples)
    assert not {CMD_VEL, TF} & set(robot.samples)
    assert asked == []


def test_routers_join_two_machines(join: Callable[..., Machine], start_router: StartRouter) -> None:
    router = start_router()
    robot = join()
    robot.keep(robot.session.liveliness().declare_token(TOKEN))
    start_router("base_router.json5")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TFLOOM_ZENOH_PORT", str(zenoh_config.port() + 2))
        base = join()
    wait_until(lambda: TOKEN in base.tokens)
    wait_until(lambda: robot.session.put(CMD_VEL, b"") or CMD_VEL in base.samples)
    # The router ends and comes back: the link is made anew, with nothing to start on the other machine.
    router.end()
    base.samples.clear()
    start_router()
    wait_until(lambda: robot.session.put(CMD_VEL, b"") or CMD_VEL in base.samples)


STRANGERS = {
    "no certificate": {"enable_mtls: true": "enable_mtls: false"},
    "of another authority": {
        "certificates/laptop.pem": "of_others/laptop.pem",
        "certificates/laptop.key": "of_others/laptop.key",
    },
    "a name without rules": {
        "certificates/laptop.pem": "certificates/stranger.pem",
        "certificates/laptop.key": "certificates/stranger.key",
    },
    "trusts another authority": {"certificates/ca.pem": "of_others/ca.pem"},
    "plain TCP": {"tls/": "tcp/"},
}


REASONS = {
    "no certificate": "demands a certificate, which isn't sent: set transport/link/tls/enable_mtls to true",
    "of another authority": "refuses the certificate of_others/laptop.pem: its authority isn't the router's",
    "trusts another authority": "has a certificate that of_others/ca.pem doesn't vouch for: ",
    "plain TCP": "is open, but doesn't answer as a router: is it stopped, or does it want TLS (tls/…)?",
    "no such file": "can't be tried: a file of transport/link/tls (certificates/ca.pem, nobody.pem, ",
    "nothing there": "refuses: nothing listens there",
}
CASES = {
    **STRANGERS,
    "no such file": {"certificates/laptop.pem": "nobody.pem"},
    "nothing there": {"127.0.0.1": "127.0.0.2"},
}


def test_client_and_doctor_say_why_there_is_no_link(
    folder: Path, start_router: StartRouter, monkeypatch: pytest.MonkeyPatch
) -> None:
    start_router()
    file = folder / "laptop.json5"
    example = file.read_text()
    monkeypatch.setenv(SESSION_VARIABLE, "laptop.json5")
    for case, reason in REASONS.items():
        file.write_text(example)
        file.write_text(replaced(file, CASES[case]))
        with pytest.raises(WireError) as told:
            open_session()
        assert reason in str(told.value), case
        finding = check_router()
        assert finding.verdict is Verdict.FAILED, case
        assert reason in finding.summary, case
        assert finding.advice.startswith("start a router there"), case


def test_a_router_says_that_another_refuses_its_certificate(
    folder: Path, start_router: StartRouter, start_program: Callable[..., Program]
) -> None:
    start_router()
    file = folder / "base_router.json5"
    file.write_text(file.read_text().replace("certificates/base", "of_others/laptop"))
    base = start_program("tfloom", "zenoh", "router", "-c", "base_router.json5")
    base.wait_for(f"no link to tls/127.0.0.1:{zenoh_config.port() + 1} yet, which refuses the certificate ")


def test_doctor_names_the_router_and_the_transport(
    folder: Path,
    start_router: StartRouter,
    start_program: Callable[..., Program],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    own = f"tcp/127.0.0.1:{zenoh_config.port()}"
    assert check_router()[:2] == (Verdict.OK, f"no router at {own} yet: the first program opens one")
    router = start_router()
    zid = router.lines[-1].split("id ")[1].split(",")[0]
    finding = check_router()
    assert finding.verdict is Verdict.OK
    assert finding.summary.startswith(f"linked to the router {zid} by {own}")
    monkeypatch.setenv(SESSION_VARIABLE, "laptop.json5")
    finding = check_router()
    assert finding.summary == f"linked to the router {zid} by tls/127.0.0.1:{zenoh_config.port() + 1}"
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    doctor = start_program("tfloom", "doctor", "-ep")
    doctor.wait()
    assert f"router: {finding.summary}" in doctor.output


def test_strangers_get_nothing(join: Callable[..., Machine], start_router: StartRouter) -> None:
    start_router()
    robot = join()
    robot.keep(robot.session.liveliness().declare_token(TOKEN))
    laptop = join("laptop.json5")
    laptop.subscribe(TF)
    # The link of a client with a certificate is made meanwhile, and gets what the strangers don't.
    # A client without a link raises an error when it is opened, a peer goes on to search for its router.
    linked = "a name without rules"
    denied = {
        stranger: join(
            "laptop.json5", **changes, **({} if stranger == linked else {'mode: "client"': 'mode: "peer"'})
        )
        for stranger, changes in STRANGERS.items()
    }
    for machine in denied.values():
        machine.subscribe(TF)
    wait_until(lambda: robot.session.put(TF, b"") or laptop.samples.count(TF) > 20)
    wait_until(lambda: TOKEN in laptop.tokens)
    for stranger, machine in denied.items():
        assert machine.samples == [], stranger
        assert machine.tokens == set(), stranger
        assert bool(machine.session.info.routers_zid()) == (stranger == linked), stranger
