"""The tf2 programs as processes over DDS, against the reference's output."""

from __future__ import annotations

import json
import re
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.recorded_outputs import recorded_output

from tfloom.node.context.utilities import get_default_context
from tfloom.tf2_tools import echo, static_publisher, view_frames

STATIC = ("tfloom", "run", "tf2_ros", "static_transform_publisher")
ECHO = ("tfloom", "run", "tf2_ros", "tf2_echo")
VIEW_FRAMES = ("tfloom", "run", "tf2_tools", "view_frames")
CAMERA = (
    *("--x", "1", "--y", "2", "--z", "3", "--yaw", "1.5707963267948966"),
    *("--frame-id", "world", "--child-frame-id", "camera"),
)
SPINNING = "Spinning until stopped"


def golden(name: str) -> list[str]:
    """Return the reference's output, without the command, the shell's last line and the signal's."""
    lines = recorded_output(name).splitlines()[1:-1]
    return [line for line in lines if "signal_handler" not in line]


def masked(lines: list[str]) -> list[str]:
    """Replace stamps, random names, and the time that has more digits here."""
    text = "\n".join(lines)
    text = re.sub(r"\[\d+\.\d+\]", "[stamp]", text)
    text = re.sub(r"static_transform_publisher_\w{16}", "static_transform_publisher_X", text)
    text = re.sub(r"Recorded at time: [\d.]+", "Recorded at time: T", text)
    return re.sub(r"^At time 0\.0+$", "At time 0", text, flags=re.MULTILINE).split("\n")


def test_echo_of_a_static_transform_matches_the_reference(
    domain_id: int, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    expected = masked(golden("tf2_echo"))
    program = start_program(*ECHO, "world", "camera")
    program.wait_for("Waiting for transform")
    static = start_program(*STATIC, *CAMERA)
    static.wait_for("from 'world' to 'camera'")
    assert masked(static.lines) == masked(golden("static_log"))
    wait_until(lambda: program.output.count("At time") >= 3)
    program.signal(signal.SIGINT)
    assert program.wait() == 0
    lines = [line for line in masked(program.lines) if "Waiting" not in line]
    assert masked(program.lines)[0] == expected[0]
    assert lines[: len(expected) - 1] == expected[1:]
    static.signal(signal.SIGINT)
    assert static.wait() == 0


def test_echo_waits_and_prints_the_reason(domain_id: int, start_program: Callable[..., Any]) -> None:
    program = start_program(*ECHO, "world", "nowhere")
    program.wait_for('"world" passed to canTransform argument target_frame')
    start_program(*STATIC, *CAMERA)
    program.wait_for('"nowhere" passed to canTransform argument source_frame')
    expected = set(masked(golden("tf2_echo_wait")))
    assert set(masked(program.lines)) == expected
    program.signal(signal.SIGTERM)
    assert program.wait() == 0


def test_echo_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert echo.main([]) == 1
    *usage, last = golden("tf2_echo_usage")
    assert capsys.readouterr().out.splitlines() == usage
    assert last == "[ros2run]: Process exited with failure 1"


@pytest.mark.parametrize(
    ("rate", "code"), [("fast", 2), ("1Hz", 3), ("", 2), ("0", 2), ("-1", 2), ("nan", 2)]
)
def test_echo_rates(rate: str, code: int, capsys: pytest.CaptureFixture[str]) -> None:
    assert echo.main(["a", "b", rate]) == code
    if rate in {"fast", "1Hz"}:
        text = f"Failed to convert rate argument '{rate}' to a floating-point number\n"
        assert capsys.readouterr().err == text


def test_child_frame_equal_to_frame_is_an_error(
    domain_id: int, start_program: Callable[..., Any], deviations: dict[str, dict[str, str]]
) -> None:
    static = start_program(*STATIC, "--frame-id", "a", "--child-frame-id", "a")
    assert static.wait() == 1
    assert masked(static.lines[:1]) == masked(golden("static_bad")[:1])
    assert static.lines[1] == "child_frame_id cannot equal frame_id"
    assert "static-same-frame" in deviations


def test_static_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert static_publisher.main(["--x", "one"]) == 1
    first, *_ = capsys.readouterr().err.splitlines()
    assert first == "error parsing command line arguments: Failed to parse --x argument as float"
    assert static_publisher.main(["--help"]) == 0
    assert "--child-frame-id" in capsys.readouterr().out


def test_the_older_form_is_deprecated(domain_id: int, start_program: Callable[..., Any]) -> None:
    static = start_program(*STATIC, "1", "2", "3", "0", "0", "0", "world", "camera")
    static.wait_for("Old-style arguments are deprecated; see --help for new-style arguments")
    static.wait_for("from 'world' to 'camera'")


def test_view_frames_matches_the_reference(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path, deviations: dict[str, dict[str, str]]
) -> None:
    static = ("--ros-args", "-r", "__node:=calibration")
    start_program(*STATIC, *CAMERA, *static).wait_for(SPINNING)
    view = start_program(*VIEW_FRAMES, "-o", "out", cwd=tmp_path)
    assert view.wait() == 0
    assert "view-frames-nodes" in deviations
    (ours,) = (line for line in view.lines if line.endswith("[view_frames]: /calibration publishes camera"))
    assert masked(line for line in view.lines if line != ours) == masked(golden("view_frames"))
    text = (tmp_path / "out.gv").read_text()
    assert masked([text]) == masked([recorded_output("view_frames_out").removesuffix("\n")])
    assert (tmp_path / "out.pdf").read_bytes() == (tmp_path / "frames.pdf").read_bytes()
    assert (tmp_path / "out.pdf").read_bytes().startswith(b"%PDF-")


def view_here(capfd: pytest.CaptureFixture[str], *words: str) -> tuple[int, str]:
    """Run view_frames in this process, in its current folder; return exit code and output."""
    context = get_default_context()
    code = view_frames.main([*words])
    context.destroy()
    return code, "".join(capfd.readouterr())


def test_view_frames_names_the_publishing_node_in_each_format(
    domain_id: int,
    start_program: Callable[..., Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    static = start_program(*STATIC, *CAMERA, "--ros-args", "-r", "__node:=calibration")
    static.wait_for("from 'world' to 'camera'")
    code, text = view_here(capfd, "-t", "1", "-o", "out", "--format", "svg,html", "--format", "json")
    assert (code, text.count("Exporting graph in out.")) == (0, 3)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.html", "out.json", "out.svg"]
    (transform,) = json.loads((tmp_path / "out.json").read_text("utf-8"))["transforms"]
    assert transform["publishers"] == ["/calibration"]
    assert transform["authority"] == "default_authority"
    for name in ("out.svg", "out.html"):
        assert "published by: /calibration" in (tmp_path / name).read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--format", "svg,jpg"], "argument --format: 'jpg' is not one of gv, html, json, pdf, png, svg"),
        (["-o", "missing/out"], "argument -o/--output: there is no folder missing"),
    ],
)
def test_view_frames_refuses_other_formats_and_a_missing_folder(
    words: list[str], text: str, deviations: dict[str, dict[str, str]], capsys: pytest.CaptureFixture[str]
) -> None:
    assert "view-frames-folder" in deviations
    with pytest.raises(SystemExit, match="2"):
        view_frames.main(words)
    assert text in capsys.readouterr().err


def test_view_frames_names_its_files_by_the_time(
    domain_id: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    code, text = view_here(capfd, "-t", "0.1")
    assert (code, "No tf data received" in text) == (0, True)
    names = sorted(path.name for path in tmp_path.iterdir())
    stamped = re.compile(r"frames_\d{4}-\d\d-\d\d_\d\d\.\d\d\.\d\d\.(gv|pdf)")
    assert names[0] == "frames.pdf"
    assert len(names) == 3
    assert all(stamped.fullmatch(name) for name in names[1:])
    assert (tmp_path / names[1]).read_text() == 'digraph G { "No tf data received" }'


def test_view_frames_with_an_unwritable_file(
    domain_id: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "out.gv").mkdir()
    code, text = view_here(capfd, "-t", "0", "-o", "out")
    assert (code, f"can't write {tmp_path / 'out.gv'}: Is a directory" in text) == (1, True)
