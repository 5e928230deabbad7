"""Folders of rosbag2: metadata of each version, split and compressed files, what is missing in them."""

from __future__ import annotations

import os
import shutil
import sys
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
import yaml
import zstandard
from tests.bag.recordings import START, drive, error_of, found_in, rows_of, write_mcap, write_sqlite

from tfloom.bag import BagError, frames, open_bag
from tfloom.bag.metadata import parse_metadata, read_metadata

GOLDEN = Path(__file__).parents[1] / "golden" / "bags"
DRIVE = drive()

HUMBLE = """\
rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  duration:
    nanoseconds: 490000001
  starting_time:
    nanoseconds_since_epoch: 1700000000000000000
  message_count: 101
  topics_with_message_count:
    - topic_metadata:
        name: /tf
        type: tf2_msgs/msg/TFMessage
        serialization_format: cdr
        offered_qos_profiles: "- history: 3\\n  depth: 0\\n  reliability: 1"
      message_count: 50
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - bag_0.mcap
  files:
    - path: bag_0.mcap
      starting_time:
        nanoseconds_since_epoch: 1700000000000000000
      duration:
        nanoseconds: 490000001
      message_count: 101
"""


def folder_of(path: Path, names: dict[str, list[object]], text: str = HUMBLE) -> Path:
    path.mkdir()
    for name, messages in names.items():
        write_mcap(path / name, messages)  # type: ignore[arg-type]
    files = "".join(f"    - {name}\n" for name in names)
    (path / "metadata.yaml").write_text(text.replace("    - bag_0.mcap\n", files, 1), "utf-8")
    return path


def test_metadata_of_humble(tmp_path: Path) -> None:
    found = parse_metadata(HUMBLE, tmp_path)
    assert (found.version, found.storage_identifier, found.ros_distro) == (5, "sqlite3", "")
    assert found.topics[0].offered_qos == "- history: 3\n  depth: 0\n  reliability: 1"
    assert found.files[0].message_count == 101


SINCE = {
    "compression_format": 3,
    "compression_mode": 3,
    "offered_qos_profiles": 4,
    "files": 5,
    "custom_data": 6,
    "type_description_hash": 7,
    "ros_distro": 8,
}
"""The first version of metadata.yaml that has a field."""


@pytest.mark.parametrize("version", range(1, 10))
def test_metadata_of_each_version(version: int, tmp_path: Path) -> None:
    qos: Any = "- depth: 7\n  history: keep_last"
    duration = {"nanoseconds": 490000001}
    starting_time = {"nanoseconds_since_epoch": START}
    topic = {
        "name": "/tf",
        "type": "tf2_msgs/msg/TFMessage",
        "serialization_format": "cdr",
        "offered_qos_profiles": yaml.safe_load(qos) if version == 9 else qos,
        "type_description_hash": "RIHS01_ab",
    }
    span = {"starting_time": starting_time, "duration": duration, "message_count": 101}
    document: dict[str, Any] = {
        "version": version,
        "storage_identifier": "mcap",
        **span,
        "relative_file_paths": ["bag_0.mcap" if version > 3 else "my_bag/bag_0.mcap"],
        "topics_with_message_count": [{"topic_metadata": known(topic, version), "message_count": 50}],
        "compression_format": "",
        "compression_mode": "",
        "files": [{"path": "bag_0.mcap", **span}],
        "custom_data": {"robot": "a"},
        "ros_distro": "jazzy",
    }
    folder = folder_of(tmp_path / "bag", {"bag_0.mcap": DRIVE})
    text = yaml.safe_dump({"rosbag2_bagfile_information": known(document, version)}, sort_keys=False)
    (folder / "metadata.yaml").write_text(text, "utf-8")
    with open_bag(folder) as bag:
        assert found_in(bag) == DRIVE
        found = bag.metadata
    assert found is not None
    assert (found.version, found.start_ns) == (version, START)
    assert (found.duration_ns, found.message_count) == (490000001, 101)
    assert found.topics[0].offered_qos == (qos if version > 3 else "")
    assert found.topics[0].type_hash == ("RIHS01_ab" if version > 6 else "")
    assert [file.message_count for file in found.files] == ([101] if version > 4 else [])
    assert found.custom_data == ({"robot": "a"} if version > 5 else {})
    assert found.ros_distro == ("jazzy" if version > 7 else "")


def known(values: dict[str, Any], version: int) -> dict[str, Any]:
    return {key: value for key, value in values.items() if SINCE.get(key, 1) <= version}


def test_numbers_that_are_not_finite_are_named(tmp_path: Path) -> None:
    with pytest.raises(BagError, match="this is not metadata of a recording: cannot convert float infinity"):
        parse_metadata(HUMBLE.replace("message_count: 101", "message_count: .inf"), tmp_path)


def test_metadata_of_jazzy() -> None:
    found = read_metadata(GOLDEN / "mcap")
    assert (found.version, found.ros_distro, found.message_count) == (9, "jazzy", 876)
    assert found.topics[0].offered_qos.startswith("- history: keep_last\n  depth: 10\n")
    assert found.topics[0].type_hash.startswith("RIHS01_df66")
    with open_bag(GOLDEN / "mcap") as bag:
        assert bag.topics["/tf_static"].offered_qos == found.topics[1].offered_qos


def test_files_of_one_recording_are_one(tmp_path: Path) -> None:
    parts = {f"b_{i}.mcap": DRIVE[i * 40 : (i + 1) * 40] for i in range(3)}
    with open_bag(folder_of(tmp_path / "b", parts)) as bag:  # type: ignore[arg-type]
        assert found_in(bag) == DRIVE
        assert bag.topics["/tf"].message_count == 50
        assert bag.message_count == len(DRIVE)
    assert len(frames(tmp_path / "b").trajectory("map", "lidar").stamps_ns) == 50


def test_files_that_overlap_in_time_are_merged(tmp_path: Path) -> None:
    parts = {"b_0.mcap": DRIVE[::2], "b_1.mcap": DRIVE[1::2]}
    assert found_in(open_bag(folder_of(tmp_path / "b", parts))) == DRIVE  # type: ignore[arg-type]


def test_files_with_the_folders_name_before_them(tmp_path: Path) -> None:
    folder = folder_of(tmp_path / "b", {"b_0.mcap": DRIVE})  # type: ignore[dict-item]
    text = (folder / "metadata.yaml").read_text("utf-8").replace("    - b_0.mcap", "    - b/b_0.mcap")
    (folder / "metadata.yaml").write_text(text, "utf-8")
    assert found_in(open_bag(folder)) == DRIVE


def test_decompressed_file_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(temporary))
    path = write_mcap(tmp_path / "a.mcap", DRIVE)
    whole = path.read_bytes()
    compressed = tmp_path / "a.mcap.zstd"
    compressed.write_bytes(zstandard.ZstdCompressor().compress(whole))
    with open_bag(compressed) as bag:
        assert found_in(bag) == DRIVE
        assert frames(bag).has_frame("lidar")
        assert len(list(temporary.iterdir())) == 1
    assert frames(compressed).has_frame("lidar")
    compressed.write_bytes(compressed.read_bytes()[:-200])
    with pytest.raises(BagError, match=r"a\.mcap\.zstd: the (file is cut off|zstd data is damaged)"):
        open_bag(compressed)
    assert list(temporary.iterdir()) == []


def test_read_only_folder_is_read(tmp_path: Path) -> None:
    for name in ("mcap", "sqlite3", "zstd_file"):
        folder = Path(shutil.copytree(GOLDEN / name, tmp_path / name))
        for file in folder.iterdir():
            file.chmod(0o444)
        folder.chmod(0o555)
        try:
            before = sorted(folder.iterdir())
            with open_bag(folder) as bag:
                assert len(found_in(bag)) == bag.message_count
            assert sorted(folder.iterdir()) == before
        finally:
            folder.chmod(0o755)


def test_what_is_missing_or_wrong_in_a_folder_is_named(tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    cases: dict[str, tuple[str, str]] = {
        "yaml": ("a: [", "it is not valid YAML"),
        "list": ("- 1", "this is not metadata of a recording"),
        "keys": ("rosbag2_bagfile_information: {version: 9}", "'storage_identifier' is missing"),
        "numbers": (HUMBLE.replace("message_count: 101", "message_count: many"), "this is not metadata"),
        "files": (
            HUMBLE.replace("bag_0.mcap", "gone.mcap"),
            "there is no such file, which metadata.yaml names",
        ),
        "none": (HUMBLE.replace("\n    - bag_0.mcap", " []", 1), "names no files: `ros2 bag reindex"),
        "compression": (
            HUMBLE.replace('format: ""', "format: lzma").replace('mode: ""', "mode: MESSAGE"),
            "the messages' compression is 'lzma', which isn't zstd",
        ),
    }
    for name, (text, expected) in cases.items():
        folder = tmp_path / name
        folder.mkdir()
        (folder / "metadata.yaml").write_text(text, "utf-8")
        with error_of(folder, expected):
            open_bag(folder)
    with pytest.raises(
        BagError, match=r"the folder has no metadata\.yaml: `ros2 bag reindex .*empty` writes one"
    ):
        open_bag(empty)


@pytest.mark.parametrize(("method", "module"), [("zstd", "zstandard"), ("lz4", "lz4.frame")])
def test_missing_library_is_named(
    method: str, module: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, method)
    monkeypatch.setitem(sys.modules, module, None)
    with error_of(path, "pip install 'tfloom[bag]'"):
        rows_of(path)


def test_topic_that_is_not_there_is_named() -> None:
    with (
        open_bag(GOLDEN / "mcap") as bag,
        pytest.raises(
            BagError, match="no topic '/scan'; the topics are: /chatter, /tf_static, /turtle1/pose"
        ),
    ):
        bag.messages("/scan")


def test_namespaces_and_other_topics(tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", drive(namespace="/robot1"))
    assert len(frames(path, namespace="robot1").edges()) == 3
    both = frames(path, tf_topics=["/robot1/tf"], static_topics=["/robot1/tf_static"])
    assert both.lookup("map", "lidar", START).translation == pytest.approx((1.5, 0, 0))
    with pytest.raises(
        BagError, match="no topics /tf and /tf_static; transforms are on /robot1/tf_static, /robot1/tf"
    ):
        frames(path)
    with pytest.raises(BagError, match="the topic /chatter has the type std_msgs/msg/String, not TFMessage"):
        frames(path, tf_topics=["/chatter"])
    with pytest.raises(BagError, match="no others with transforms"):
        frames(GOLDEN / "split")


def test_progress_is_shown_on_standard_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE)
    frames(path, progress=True)
    shown = capsys.readouterr().err
    assert shown.startswith(f"\rReading the transforms of {path} [")
    assert shown.endswith(" \r")
    frames(path)
    assert capsys.readouterr().err == ""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no FIFOs in folders")
@pytest.mark.parametrize(
    "name",
    [
        "a.mcap",
        "a.db3",
        "a.bag",
        "a.bag.active",
        "a.mcap.zstd",
        "a.db3-wal",
        "a.db3-journal",
        "metadata.yaml",
    ],
)
def test_fifo_in_the_place_of_a_file_is_refused(name: str, tmp_path: Path) -> None:
    opened = fifo = tmp_path / name
    if name.startswith("a.db3-"):
        opened = write_sqlite(tmp_path / "a.db3", DRIVE[:9])
    elif name == "metadata.yaml":
        opened = tmp_path
    os.mkfifo(fifo)
    errors: list[str] = []

    def read() -> None:
        try:
            rows_of(opened)
        except BagError as error:
            errors.append(str(error))

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    reader.join(10.0)
    with suppress(OSError):  # ends a wait for the writer
        os.close(os.open(fifo, os.O_WRONLY | os.O_NONBLOCK))
    assert [text.partition(",")[0] for text in errors] == [f"{fifo}: this is not a file but a folder"]


def test_bag_is_printed_with_its_topics(tmp_path: Path) -> None:
    write_mcap(tmp_path / "a.mcap", DRIVE)
    with open_bag(tmp_path / "a.mcap") as bag:
        assert repr(bag).startswith(f"<Bag {tmp_path / 'a.mcap'}: {bag.message_count} messages in ")
        assert all(
            f"{name} ({topic.type}, {topic.message_count})" in repr(bag) for name, topic in bag.topics.items()
        )
    with open_bag(tmp_path / "a.mcap") as gone:
        (tmp_path / "a.mcap").unlink()
        assert repr(gone).startswith(f"<Bag {tmp_path / 'a.mcap'}")


def test_topics_are_printed_without_their_definitions(tmp_path: Path) -> None:
    write_mcap(tmp_path / "a.mcap", DRIVE)
    topics = open_bag(tmp_path / "a.mcap").topics
    tf = topics["/tf"]
    assert f"'/tf': <Topic /tf: tf2_msgs/msg/TFMessage, {tf.message_count} messages>" in repr(topics)
    assert tf.definition is not None
    assert repr(tf.definition) == f"<Definition ros2msg, {len(tf.definition.text)} characters>"
    assert repr(tf._replace(name="/a\x1b[2J")).startswith("<Topic /a\\x1b[2J: ")


def test_folder_of_recordings_names_one(tmp_path: Path) -> None:
    for name in ("second", "first"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "metadata.yaml").touch()
    with pytest.raises(BagError, match=f"has recordings, and is none: open one, as {tmp_path / 'first'}"):
        open_bag(tmp_path)
