"""What tfloom's nodes send on Zenoh, beside what rmw_zenoh_cpp does, by records and by a script."""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.zenoh_ports import hold_zenoh_port

pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

from tests.oracles import compare_rmw_zenoh

from tfloom.rmw.topic_names import type_to_dds
from tfloom.rmw.zenoh.tokens import parse_token, token_key

RECORDED = (Path(__file__).parents[1] / "golden" / "zenoh_tokens.txt").read_text("utf-8").splitlines()
SHORT = re.compile(r"…/0/\d+/(?P<kind>\w\w)/…/(?P<name>/\S+) (?P<type>\S+) (?P<qos>\S+)")
"""A token that was recorded without the parts that all of its node have."""


DOMAIN = 65


@pytest.fixture(scope="module")
def ours() -> list[str]:
    """Return what tfloom's nodes send, as the script records it."""
    with hold_zenoh_port() as port, compare_rmw_zenoh.running_router(port):
        return compare_rmw_zenoh.recorded([sys.executable, str(compare_rmw_zenoh.PROGRAM)], DOMAIN, port)


@pytest.fixture
def compare(ours: list[str], monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., int]]:
    """Return the script, which records the other program alone."""
    records, record = [ours], compare_rmw_zenoh.recorded
    monkeypatch.setattr(
        compare_rmw_zenoh, "recorded", lambda *words: records.pop() if records else record(*words)
    )
    with hold_zenoh_port() as port:
        words = [sys.executable, "--port", str(port), "--domain", str(DOMAIN)]
        yield lambda *more: compare_rmw_zenoh.main([*words, *more])


def test_a_node_announces_what_rmw_zenoh_announces_for_the_same_program(ours: list[str]) -> None:
    tokens = [line.removeprefix("token ") for line in ours if line.startswith("token ")]
    for line in RECORDED:
        if short := SHORT.fullmatch(line):
            name = short["name"].replace("/", "%")
            pattern = f"/{short['kind']}/%/%real/real_node/{name}/{type_to_dds(short['type'])}/RIHS01_"
            assert [token for token in tokens if pattern in token and token.endswith(f"/{short['qos']}")], (
                line
            )
        else:
            recorded = parse_token(line)._replace(zid="ZID", node_number=0, entity_number=0)
            assert token_key(recorded) in tokens, line


def test_the_script_says_same_for_the_same_program(
    compare: Callable[..., int], capsys: pytest.CaptureFixture[str]
) -> None:
    assert compare() == 0
    assert capsys.readouterr().out == "same\n"


@pytest.mark.parametrize(
    ("planted", "difference"),
    [
        (
            "endpoints.pack_attachment = lambda number, gid: tokens.pack_attachment(number, bytes(16))",
            "a gid of no token",
        ),
        ("tokens.DEFAULT_DEPTH = 10", "std_msgs::msg::dds_::String_/RIHS01_"),
    ],
    ids=["attachment", "token"],
)
def test_the_script_names_a_difference(
    planted: str,
    difference: str,
    compare: Callable[..., int],
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    """The program in the place of the stock one runs on a tfloom with a mistake."""
    code = f"from tfloom.rmw.zenoh import endpoints, tokens\n{planted}\n"
    (tmp_path / "sitecustomize.py").write_text(code, "utf-8")
    setup = tmp_path / "setup.bash"
    setup.write_text(f"export PYTHONPATH={shlex.quote(str(tmp_path))}\n", "utf-8")
    assert compare("--setup", str(setup)) == 1
    printed = capsys.readouterr().out
    assert re.fullmatch(r"tfloom \d times, rmw_zenoh \d times: .*\n", printed)
    assert difference in printed
