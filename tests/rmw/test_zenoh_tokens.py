"""Keys, tokens, qualities and attachments of the Zenoh wire, byte by byte: as recorded from rmw_zenoh_cpp 0.2.10."""

from __future__ import annotations

import random
import struct
from pathlib import Path

import pytest
from tests.zenoh_ports import NEEDS_ZENOH

from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import (
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)
from tfloom.rmw.zenoh.tokens import (
    End,
    Kind,
    Token,
    TokenError,
    data_key,
    gid_of,
    pack_attachment,
    parse_qos,
    parse_token,
    qos_text,
    token_key,
    unpack_attachment,
    wire_qos,
)

RECORDED = [
    line
    for line in (Path(__file__).parents[1] / "golden" / "zenoh_tokens.txt").read_text("utf-8").splitlines()
    if line.startswith("@")
]
HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
ZID = "893196b9fb9ba3df2f8374d425c5f1b7"
CHATTER = (
    f"@ros2_lv/65/{ZID}/0/10/MS/%/%real/real_node/%chatter/std_msgs::msg::dds_::String_/{HASH}/::,10:,:,:,,"
)


@pytest.mark.parametrize("key", RECORDED, ids=lambda key: key.split("/")[4])
def test_recorded_tokens_are_written_back_unchanged(key: str) -> None:
    assert token_key(parse_token(key)) == key


def test_recorded_tokens_cover_all_kinds_but_clients() -> None:
    assert {parse_token(key).kind for key in RECORDED} == set(Kind) - {Kind.CLIENT}


def test_a_token_tells_of_its_entity() -> None:
    assert parse_token(CHATTER) == Token(
        65,
        ZID,
        0,
        10,
        Kind.SUBSCRIPTION,
        "/",
        NodeName("/real", "real_node"),
        End("/chatter", "std_msgs/msg/String", HASH, QoS()),
    )
    node = f"@ros2_lv/65/{ZID}/3/3/NN/%robot%arm/%/lone"
    token = parse_token(node)
    assert (token.enclave, token.node, token.end) == ("/robot/arm", NodeName("/", "lone"), None)
    assert token_key(token) == node


def test_a_token_without_a_hash_or_an_enclave_has_no_empty_chunk() -> None:
    token = parse_token(CHATTER)
    unknown = token._replace(enclave="", end=token.end._replace(type_hash=""))
    assert "" not in token_key(unknown).split("/")
    assert parse_token(token_key(unknown)).end.type_hash == ""


def test_further_chunks_of_newer_releases_are_ignored() -> None:
    assert parse_token(CHATTER + "/backends:cuda:1;/more") == parse_token(CHATTER)


@pytest.mark.parametrize(
    "key",
    [
        "",
        "@ros2_lv",
        "65/chatter",
        CHATTER.replace("@ros2_lv", "@ros2_xx"),
        CHATTER.replace("/MS/", "/XX/"),
        CHATTER.replace("/65/", "/six/"),
        CHATTER.replace("/65/", "/-1/"),
        CHATTER.replace("/65/", "/" + "9" * 400 + "/"),
        CHATTER.replace("/65/", "/\N{ARABIC-INDIC DIGIT ONE}/"),
        CHATTER.replace("/%/%real", "//%real"),
        CHATTER.replace("/%real/", "/real/"),
        CHATTER.replace("real_node", "real%node"),
        CHATTER.rpartition("/")[0],
        CHATTER.replace("::,10:,:,:,,", ":"),
        CHATTER.replace("::,10:,:,:,,", "9::,10:,:,:,,"),
        CHATTER.replace("::,10:,:,:,,", "::,x:,:,:,,"),
        CHATTER.replace("::,10:,:,:,,", "::,10:,:,:2,,"),
    ],
)
def test_another_form_is_an_error_of_its_own(key: str) -> None:
    with pytest.raises(TokenError):
        parse_token(key)


def test_random_changes_give_a_token_or_a_token_error() -> None:
    picker = random.Random(7)
    letters = "/%:,@9a\0\N{SNOWMAN}"
    outcomes = set()
    for _ in range(5_000):
        text = list(picker.choice(RECORDED))
        for _ in range(picker.randrange(1, 5)):
            at = picker.randrange(len(text))
            text[at : at + picker.randrange(3)] = picker.choices(letters, k=picker.randrange(3))
        try:
            token = parse_token("".join(text))
        except TokenError:
            outcomes.add("error")
        else:
            assert token.node.namespace.startswith("/")
            outcomes.add("token")
    assert outcomes == {"error", "token"}


@pytest.mark.parametrize(
    ("qos", "text"),
    [
        (QoS(), "::,10:,:,:,,"),
        (QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1), ":1:,1:,:,:,,"),
        (QoS(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5), "2::,5:,:,:,,"),
        (QoS(history=HistoryPolicy.KEEP_ALL), "::2,10:,:,:,,"),
        (QoS(history=HistoryPolicy.KEEP_ALL, depth=0), "::2,:,:,:,,"),
        (QoS(depth=42), "::,:,:,:,,"),
        (QoS(deadline_ns=100_000_000), "::,10:0,100000000:,:,,"),
        (QoS(lifespan_ns=9_223_372_036_000_000_001), "::,10:,:,1:,,"),
        (
            QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=2_000_000_003),
            "::,10:,:,:3,2,3",
        ),
    ],
)
def test_quality_texts_of_the_table(qos: QoS, text: str) -> None:
    assert qos_text(wire_qos(qos)) == text
    assert parse_qos(text) == wire_qos(qos)


def test_quality_texts_are_read_leniently() -> None:
    assert parse_qos("::,10:0,0:0,0:,0,0:more:groups").deadline_ns == INFINITE_NS
    assert parse_qos("1:2:1,10:9223372036,854775807:,:1,,") == QoS()
    assert parse_qos("::,0:,:,:,,").depth == 42


def test_data_keys() -> None:
    assert data_key(65, "/robot1/chatter", "std_msgs/msg/String", HASH) == (
        f"65/robot1/chatter/std_msgs::msg::dds_::String_/{HASH}"
    )
    assert data_key(0, "/chatter", "std_msgs/msg/String", "").endswith("String_/*")
    assert data_key(1, "/fib/_action/send_goal", "example_interfaces/action/Fibonacci_SendGoal", HASH) == (
        f"1/fib/_action/send_goal/example_interfaces::action::dds_::Fibonacci_SendGoal_/{HASH}"
    )


def test_gids_are_the_two_halves_of_the_hash_each_in_little_endian() -> None:
    xxhash = pytest.importorskip("xxhash", reason="xxhash is not installed: pip install 'tfloom[zenoh]'")
    for length in (1, 3, 4, 8, 9, 16, 17, 128, 129, 240, 241, 393):
        key = ("ab/" * length)[:length]
        number = xxhash.xxh3_128_intdigest(key.encode(), seed=0)
        assert gid_of(key) == struct.pack("<QQ", number & (2**64 - 1), number >> 64)


@NEEDS_ZENOH
def test_attachments_are_those_of_zenohs_serialization() -> None:
    from zenoh.ext import Int64, z_serialize

    gid = bytes(range(16))
    data = pack_attachment(7, gid)
    stamp_ns = struct.unpack_from("<q", data, 8)[0]
    assert data == z_serialize((Int64(7), Int64(stamp_ns), gid)).to_bytes()
    assert len(data) == 33
    assert data[16] == 0x10


@NEEDS_ZENOH
@pytest.mark.parametrize("cut", range(33))
def test_short_attachments_are_none(cut: int) -> None:
    import zenoh

    assert unpack_attachment(zenoh.ZBytes(pack_attachment(1, bytes(16))[:cut])) is None


@NEEDS_ZENOH
def test_attachments_with_a_gid_of_another_size_are_none_and_longer_ones_are_read() -> None:
    import zenoh

    data = bytearray(pack_attachment(1, bytes(16)))
    assert unpack_attachment(zenoh.ZBytes(bytes(data) + b"more")).sequence_number == 1
    data[16] = 15
    assert unpack_attachment(zenoh.ZBytes(bytes(data))) is None
    assert unpack_attachment(None) is None
