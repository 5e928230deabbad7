"""The verbs of `bag`, compared with the recorded ones, and real processes that record and play."""

from __future__ import annotations

import argparse
import os
import pty
import re
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from itertools import chain, count, pairwise
from pathlib import Path
from typing import Any

import pytest
import transcript
from test_usage import VERBS
from tests.bag.written_bags import START_NS, read_by_rosbags, topic
from tests.conftest import wait_until
from tests.recorded_outputs import recorded_output

from tfloom.bag import open_bag
from tfloom.bag.reindexing import reindex
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.cli.main import main
from tfloom.cli.verb_classes.verbs import ConvertVerb
from tfloom.interfaces.std_msgs.msg import String

BAGS = Path(__file__).parents[1] / "golden" / "bags"
CLOCK = re.compile(r"\[\d+\.\d+\] ")
SIGNAL_LINE = re.compile(r"\[INFO\] \[rclcpp\]: signal_handler\(signum=\d+\)\n?")
NO_KEYS = "stdin is not a terminal device. Keyboard handling disabled."


@pytest.fixture
def bags(tmp_path: Path) -> Iterator[Path]:
    """Return a folder with copies of the recorded bags, under the names that the transcripts have, and make it current.

    The time zone is that of the transcripts.
    """
    for name, short in {"mcap": "b1", "zstd_file": "b3", "split": "b4", "sqlite3": "b6"}.items():
        shutil.copytree(BAGS / name, tmp_path / short, copy_function=shutil.copyfile)
        (tmp_path / short).chmod(0o755)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        patch.setenv("TZ", "UTC")
        time.tzset()
        yield tmp_path
    time.tzset()


def unstamped(text: str) -> str:
    """Remove what differs between any two runs: the times of log lines, and the signal's line (row signal-line)."""
    return SIGNAL_LINE.sub("", CLOCK.sub("", text).replace(NO_KEYS + "\n", NO_KEYS)).strip("\n")


def sorted_choices(text: str) -> str:
    """Order the choices of the usage text, because those of the reference are in the order of a set.

    From Python 3.13 on argparse breaks the lines at other places, so there all whitespace is one space.
    """
    text = re.sub(r"\{(\w+),(\w+)\}", lambda match: "{" + ",".join(sorted(match.groups())) + "}", text)
    return " ".join(text.split()) if sys.version_info >= (3, 13) else text


@pytest.mark.parametrize(
    "name",
    [
        "bag_info",
        "bag_info_v",
        "bag_info_topics",
        "bag_info_split",
        "bag_info_bad",
        "bag_play_bad",
        "bag_record_bad",
    ],
)
def test_answers_are_the_recorded_ones(name: str, bags: Path) -> None:
    recorded = transcript.golden(name)
    found = transcript.run_here(*recorded.command)
    assert sorted_choices(found.text) == sorted_choices(recorded.text)
    assert found.exit_code == recorded.exit_code


def test_bag_without_metadata_and_reindexing(bags: Path) -> None:
    shutil.copytree(bags / "b1", bags / "b5")
    (bags / "b5" / "metadata.yaml").unlink()
    recorded = transcript.golden("bag_info_no_metadata")
    found = transcript.run_here(*recorded.command)
    assert found.exit_code == recorded.exit_code
    # A second line tells what to do: bag-errors of docs/deviations.md.
    assert found.text == f"{recorded.text}\n`ros2 bag reindex b5` writes one from its files"
    recorded_lines = recorded_output("bag_reindex")
    found = transcript.run_here("bag", "reindex", "b5")
    assert found.exit_code == 0
    text = f"{found.text}\n{(bags / 'b5' / 'metadata.yaml').read_text('utf-8')}[exit 0]\n"
    assert CLOCK.sub("", text) == CLOCK.sub("", recorded_lines.partition("\n")[2])


def test_conversion(bags: Path) -> None:
    shutil.rmtree(bags / "b6")
    (bags / "conv.yaml").write_text("output_bags:\n- uri: b6\n  storage_id: sqlite3\n  all: true\n")
    found = transcript.run_here("bag", "convert", "-i", "b1", "-o", "conv.yaml")
    info = transcript.run_here("bag", "info", "b6")
    recorded = transcript.golden("bag_convert").text
    # Types that we know have hashes in the converted bag, so it is larger.
    size = re.compile(r"Bag size:          \d+\.\d KiB")
    assert size.sub("", unstamped(f"{found.text}\n{info.text}")) == size.sub("", unstamped(recorded))
    assert read_by_rosbags(bags / "b6") == read_by_rosbags(BAGS / "mcap")


def test_conversion_joins_filters_and_compresses(bags: Path) -> None:
    (bags / "two.yaml").write_text(
        """output_bags:
- {uri: joined, exclude_topics: [/tf_static]}
- {uri: chatter, topics: [/chatter], compression_mode: file, compression_format: zstd, max_bagfile_size: 1000}
- {uri: part, regex: pose, start_time_ns: 1795304290532093605, end_time_ns: 1795304291532093605}
"""
    )
    assert transcript.run_here("bag", "convert", "-i", "b1", "-i", "b4", "mcap", "-o", "two.yaml").text == ""
    with open_bag(bags / "joined") as bag:
        assert bag.message_count == 876 - 1 + 1521
        stamps = [message.log_time_ns for message in bag.messages()]
        assert stamps == sorted(stamps)
    with open_bag(bags / "chatter") as bag:
        assert [file.message_count for file in bag.files] != [16]
        assert bag.message_count == 16
    with open_bag(bags / "part") as bag:
        assert bag.topics.keys() == {"/turtle1/pose"}
        assert bag.end_ns - bag.start_ns <= 10**9


def test_conversion_of_the_bags_that_a_file_names(bags: Path) -> None:
    (bags / "in.yaml").write_text(
        "input_bags:\n- {uri: b1}\n- {uri: b4, storage_id: mcap, max_cache_size: 1}\n"
    )
    (bags / "out.yaml").write_text("output_bags:\n- {uri: joined}\n- {uri: more, all: true}\n")
    found = transcript.run_here("bag", "convert", "--input-options", "in.yaml", "-o", "out.yaml")
    assert (found.exit_code, found.text) == (0, "")
    for name in ("joined", "more"):
        with open_bag(bags / name) as bag:
            assert bag.message_count == 876 + 1521
    (bags / "one.yaml").write_text("output_bags:\n- {uri: three}\n")
    words = ("bag", "convert", "-i", "b1", "--input-options", "in.yaml", "-o", "one.yaml")
    assert transcript.run_here(*words).exit_code == 0
    with open_bag(bags / "three") as bag:
        assert bag.message_count == 2 * 876 + 1521
    (bags / "last.yaml").write_text("output_bags:\n- {uri: last}\n")
    args = argparse.Namespace(input_options="in.yaml", output_options="last.yaml")
    assert ConvertVerb().main(args=args) == 0
    assert (bags / "last" / "metadata.yaml").exists()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", 'in.yaml: Input options must have the key "input_bags", with a list of bags'),
        ("input_bags: {uri: b1}", 'must have the key "input_bags", with a list of bags'),
        ("input_bags: []", "no input bag: name one by -i, or in the file of --input-options"),
        ("input_bags: [{storage_id: mcap}]", "in.yaml: an input can't be used: it has no uri"),
        ("input_bags: [b1]", "in.yaml: an input can't be used: "),
        ("input_bags: [{uri: b1, storage_id: odd}]", "storage_id is one of "),
        ("input_bags: [{uri: b1, start_time_ns: 1}]", "no option of an input is start_time_ns"),
        ("input_bags: [{uri: absent}]", "absent: there is no such file or folder"),
        ("input_bags: [", "in.yaml: "),
    ],
)
def test_mistakes_in_a_file_of_inputs_are_explained(text: str, said: str, bags: Path) -> None:
    (bags / "in.yaml").write_text(text)
    (bags / "out.yaml").write_text("output_bags:\n- {uri: new}\n")
    found = transcript.run_here("bag", "convert", "--input-options", "in.yaml", "-o", "out.yaml")
    assert found.exit_code == 1
    assert said in found.text
    assert "Traceback" not in found.text
    assert not (bags / "new").exists()


def test_input_bags_are_required_and_shown_by_distribution(bags: Path) -> None:
    (bags / "out.yaml").write_text("output_bags:\n- {uri: new}\n")
    words = ("bag", "convert", "-o", "out.yaml")
    older, newer = (
        transcript.run(*words, env={**os.environ, "ROS_DISTRO": distribution}, cwd=bags)
        for distribution in ("kilted", "lyrical")
    )
    assert older.exit_code == 2
    assert older.text.endswith("error: the following arguments are required: -i/--input")
    assert "--input-options" not in older.text
    assert newer.exit_code == 1
    assert newer.text == "[ERROR] [ros2bag]: no input bag: name one by -i, or in the file of --input-options"
    shown = transcript.run("bag", "convert", "-h", env={**os.environ, "ROS_DISTRO": "lyrical"}).text
    assert "[--input-options INPUT_OPTIONS]" in shown


MISTAKES: list[tuple[tuple[str, ...], str]] = [
    (("record", "-o", "b1", "/x"), "[ERROR] [ros2bag]: Output folder 'b1' already exists."),
    (("record", "-a", "--compression-mode", "file"), "Compression format must be specified"),
    (("record", "-a", "--compression-format", "zstd"), "without a compression mode"),
    (("record", "-a", "--custom-data", "a"), "--custom-data needs KEY=VALUE, not 'a'"),
    (("record", "-e", "("), "'(' is not a regular expression"),
    (("record", "-a", "-s", "sqlite3", "--storage-preset-profile", "fastwrite"), "a preset of mcap"),
    (("record", "-a", "--storage-preset-profile", "resilient"), "a preset of sqlite3"),
    (("play", "b1", "-r", "0"), "must be a number greater than zero, not '0'"),
    (("play", "b1", "-m", "a"), "'a' is not a remap"),
    (
        ("convert", "--input-options", "none.yaml", "-o", "empty.yaml"),
        "none.yaml: it can't be read: No such file",
    ),
    (("convert", "-i", "b1", "-o", "none.yaml"), "none.yaml: it can't be read: No such file"),
    (("convert", "-i", "b1", "-o", "empty.yaml"), 'must have the key "output_bags"'),
    (("convert", "-i", "b1", "odd", "-o", "empty.yaml"), "Unknown storage 'odd'; known are sqlite3, mcap"),
    (("reindex", "b1/metadata.yaml"), "Must specify a bag directory"),
    (("reindex", "."), "there are no files of a bag in it"),
    (("info", "empty.yaml"), "empty.yaml: a file of a recording ends in .mcap"),
    (("play", "empty.yaml"), "empty.yaml: a file of a recording ends in .mcap"),
]


def test_mistakes_are_explained_in_a_sentence(
    bags: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    (bags / "empty.yaml").touch()
    wrong = []
    for words, said in MISTAKES:
        try:
            exit_code = main(["bag", *words], prog="ros2")
        except SystemExit as ended:
            exit_code = int(ended.code or 0)
        text = "".join(capfd.readouterr())
        if said not in text or "Traceback" in text or exit_code not in {1, 2}:
            wrong.append((words, exit_code, text))
    assert wrong == []


def test_lists() -> None:
    lines = [
        line
        for kind in ("storage", "converter", "compressor", "decompressor")
        for line in transcript.run_here("bag", "list", kind).text.splitlines()
    ]
    recorded = recorded_output("bag_list").splitlines()
    assert lines == recorded[1:-1]
    assert "zstd: " in transcript.run_here("bag", "list", "-v", "compressor").text


def test_services_are_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    writer = BagWriter(tmp_path / "bag")
    channel = writer.add_topic(topic("/add/_service_event", "example_interfaces/srv/AddTwoInts_Event"))
    for number, kind in enumerate([0, 1, 2, 3, 1]):
        writer.push(channel, bytes([0, 1, 0, 0, kind, *bytes(40)]), START_NS + number, START_NS)
    writer.close()
    lines = "\n".join(transcript.run_here("bag", "info", *words).text for words in (("bag",), ("-v", "bag")))
    start = "Service information: Service: /add | Type: example_interfaces/srv/AddTwoInts | "
    assert f"{start}Event Count: 5 | Serialization Format: cdr" in lines
    assert f"{start}Request Count: 2 | Response Count: 1 | Serialization Format: cdr" in lines
    assert lines.count("Service:           1") == 2


def test_sizes_of_topics_are_counted_and_sorted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    writer = BagWriter(tmp_path / "bag")
    service = writer.add_topic(topic("/add/_service_event", "example_interfaces/srv/AddTwoInts_Event"))
    small, large = (writer.add_topic(topic(name, "std_msgs/msg/String")) for name in ("/small", "/large"))
    writer.add_topic(topic("/none", "std_msgs/msg/String"))
    for number, (channel, size) in enumerate([(service, 10), (small, 10), (large, 1000), (large, 1028)]):
        writer.push(channel, bytes([0, 1, 0, 0, 0, *bytes(size - 5)]), START_NS + number, START_NS)
    writer.close()
    found = transcript.run_here("bag", "info", "--size-contribution", "--sort", "name", "-v", "bag").text
    names = re.findall(r"Topic: (\S+)", found)
    assert names == ["/large", "/none", "/small"]
    assert (
        "/large | Type: std_msgs/msg/String | Count: 2 | Size Contribution: 2.0 KiB (99.0 %) | Ser" in found
    )
    assert "| Count: 1 | Size Contribution: 10 B (0.5 %) |" in found
    assert "| Count: 0 | Size Contribution: 0 B (0.0 %) |" in found
    assert "Request Count: 1 | Response Count: 0 | Size Contribution: 10 B (0.5 %) | Serial" in found
    assert "Contribution" not in transcript.run_here("bag", "info", "-v", "bag").text


def test_sizes_of_an_empty_bag_are_zero(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    writer = BagWriter(tmp_path / "bag")
    writer.add_topic(topic("/none", "std_msgs/msg/String"))
    writer.close()
    found = transcript.run_here("bag", "info", "--size-contribution", "bag")
    assert found.exit_code == 0
    assert "| Size Contribution: 0 B (0.0 %) |" in found.text


def test_sizes_of_a_damaged_file_are_those_of_what_can_be_read(bags: Path) -> None:
    path = bags / "b1" / "b1_0.mcap"
    whole = transcript.run_here("bag", "info", "--size-contribution", "b1").text
    data = bytearray(path.read_bytes())
    data[len(data) // 4 : len(data) // 4 + 200] = bytes(200)
    path.write_bytes(data)
    found = transcript.run_here("bag", "info", "--size-contribution", "b1").text
    assert "[WARN] [ros2bag]: b1/b1_0.mcap: " in found
    sizes = [re.findall(r"Size Contribution: ([\d.]+ \w+)", text) for text in (whole, found)]
    assert len(sizes[1]) == len(sizes[0]) == 3
    assert sizes[1] != sizes[0]


@pytest.fixture
def chatter(publish: Callable[..., None]) -> None:
    """Publish numbered texts on /chatter, ten a second."""
    numbers = count()
    publish("/chatter", lambda: String(data=f"Hello World: {next(numbers)}"), 10.0)


def texts_on_disk(folder: Path) -> int:
    """Return how many numbered messages the files of a bag hold."""
    # One by its number, because sqlite3 has a message in its log and in the database, until the log is used again.
    texts = (re.findall(rb"Hello World: \d+", path.read_bytes()) for path in folder.glob("*_0.*"))
    return len(set(chain.from_iterable(texts)))


def recorder_lines(recorded: str) -> list[str]:
    return sorted(line for line in unstamped(recorded).replace(NO_KEYS, "").splitlines() if line)


def test_recording_and_playing_as_recorded(
    domain_id: int,
    start_program: Callable[..., Any],
    tmp_path: Path,
    deviations: dict[str, dict[str, str]],
) -> None:
    assert {"bag-play-lines", "signal-line"} <= deviations.keys()
    talker = start_program("tfloom", "run", "demo_nodes_py", "talker")
    talker.wait_for("Hello World: 0")
    recorder = start_program("tfloom", "bag", "record", "-o", tmp_path / "b1", "/chatter", cwd=tmp_path)
    recorder.wait_for("Stopping discovery...")
    wait_until(lambda: texts_on_disk(tmp_path / "b1") >= 2)
    recorder.process.send_signal(signal.SIGINT)
    assert recorder.process.wait(20.0) == 0
    expected = recorder_lines(transcript.golden("bag_record").text)
    expected = [line for line in expected if "/turtle1/pose" not in line and "/tf_static" not in line]
    assert recorder_lines("\n".join(recorder.lines)) == expected
    talker.process.send_signal(signal.SIGINT)
    talker.process.wait(20.0)

    listener = start_program("tfloom", "run", "demo_nodes_py", "listener")
    player = start_program(
        "tfloom",
        "bag",
        "play",
        tmp_path / "b1",
        "--rate",
        "3",
        "--clock",
        "--delay",
        "1.5",
        "--wait-for-all-acked",
        "0",
    )
    assert player.process.wait(30.0) == 0
    recorded = recorder_lines(transcript.golden("bag_play_rate").text)
    assert [line for line in recorder_lines("\n".join(player.lines)) if "Sleep" not in line] == recorded
    with open_bag(tmp_path / "b1") as bag:
        texts = [message.data for _, message in bag.read("/chatter")]
    assert len(texts) >= 2
    listener.wait_for(texts[-1])
    heard = [line.partition("I heard: [")[2].rstrip("]") for line in listener.lines if "I heard" in line]
    assert heard == texts


def test_killed_recorder_loses_at_most_the_last_second(
    chatter: None, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    folders = {storage_id: tmp_path / storage_id for storage_id in ("mcap", "sqlite3")}
    recorders = [
        start_program("tfloom", "bag", "record", "-s", storage_id, "-o", folder, "--topics", "/chatter")
        for storage_id, folder in folders.items()
    ]
    for folder in folders.values():
        wait_until(lambda: texts_on_disk(folder) >= 2)  # noqa: B023
    for recorder in recorders:
        recorder.signal(signal.SIGKILL)
        recorder.wait()
    for storage_id, folder in folders.items():
        with pytest.warns(match="no end") if storage_id == "mcap" else nullcontext():
            reindex(folder)
            with open_bag(folder) as bag:
                assert len(list(bag.messages("/chatter"))) >= 2


@pytest.mark.parametrize("verb", ["burst", "convert", "info", "list", "play", "record", "reindex"])
def test_usage_is_the_recorded_one(verb: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    recorded = transcript.golden(f"help_bag_{verb}").text
    usage = recorded[: recorded.index("\n\n")]
    found = VERBS[f"bag {verb}"].format_usage().rstrip("\n")
    assert sorted_choices(found) == sorted_choices(usage)


def test_type_that_only_a_peer_knows_is_recorded_with_its_definition(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    lab = start_program("python", Path(__file__).with_name("a_node_with_own_types.py"))
    lab.wait_for("ready")
    recorder = start_program("tfloom", "bag", "record", "-o", tmp_path / "bag", "-e", "^/samples$")
    recorder.wait_for("Subscribed to topic '/samples'")
    path = tmp_path / "bag" / "bag_0.mcap"
    wait_until(lambda: path.exists() and path.stat().st_size > 3000)
    recorder.signal(signal.SIGINT)
    assert recorder.wait() == 0
    with open_bag(tmp_path / "bag") as bag:
        definition = bag.topics["/samples"].definition
        assert definition is not None
        assert "MSG: lab_msgs/Part" in definition.text
        (first, *_) = [list(message.at) for _, message in bag.read("/samples")]
        assert first == [1.0, 2.0, 3.0]
    assert read_by_rosbags(tmp_path / "bag")


def test_unfinished_file_is_told_of_in_a_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    data = (BAGS / "mcap" / "b1_0.mcap").read_bytes()
    (tmp_path / "cut.mcap").write_bytes(data[:60_000])
    found = transcript.run_here("bag", "info", "cut.mcap")
    warnings = [
        line for line in found.text.splitlines() if "[WARN] [ros2bag]: cut.mcap: the file has no end" in line
    ]
    assert len(warnings) == 1
    assert "BagWarning" not in found.text
    assert "Messages:          876" in found.text


def test_keys_of_a_terminal_pause_and_step(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    terminal, theirs = pty.openpty()
    player = start_program("tfloom", "bag", "play", BAGS / "mcap", "-p", "--rate", "100", stdin=theirs)
    os.close(theirs)
    try:
        player.wait_for("Playback until timestamp")
        for keys, said in (
            (b" ", "Resuming play."),
            (b" ", "Pausing play."),
            (b"\x1b[A", "Set rate to 110"),
            (b"\x1b[B", "Set rate to 99"),
        ):
            os.write(terminal, keys)
            player.wait_for(said)
        os.write(terminal, b"\x1b[C<>")
        os.write(terminal, b" ")
        assert player.wait() == 0
        assert "Keyboard handling disabled" not in player.output
    finally:
        os.close(terminal)


def test_full_disk_is_explained(chatter: None, start_program: Callable[..., Any], tmp_path: Path) -> None:
    command = f"ulimit -f 1; exec '{transcript.PROGRAM}' bag record -o '{tmp_path / 'bag'}' -a"
    recorder = start_program("bash", "-c", command)
    assert recorder.wait(30.0) == 1
    assert (
        "bag_0.mcap: it can't be written: File too large. What was recorded before is kept" in recorder.output
    )
    assert "Traceback" not in recorder.output


@pytest.mark.parametrize("rate_hz", [3.0, 62.0])
def test_files_are_split_by_their_duration_beside_talkers(
    rate_hz: float, publish: Callable[..., None], start_program: Callable[..., Any], tmp_path: Path
) -> None:
    """A slow talker's messages are all written when the next one is of a new file, a quick one's are not."""
    folder = tmp_path / "bag"
    publish("/chatter", lambda: String(data="a"), rate_hz)
    recorder = start_program("tfloom", "bag", "record", "-d", "1", "-o", folder, "--topics", "/chatter")
    wait_until((folder / "bag_3.mcap").exists, 40.0)
    recorder.signal(signal.SIGINT)
    assert recorder.wait() == 0
    paths = sorted(folder.glob("bag_*.mcap"))
    files = [open_bag(path) for path in paths]
    for file, following in pairwise(files):
        assert file.end_ns - file.start_ns <= 1_000_000_000 < following.start_ns - file.start_ns
    with open_bag(folder) as bag:
        assert bag.message_count == sum(file.message_count for file in files)
