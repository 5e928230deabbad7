"""Recordings: they are readable, and have the duration of the session."""

from __future__ import annotations

import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image, ImageSequence

from tfloom.turtlesim.record import FRAME_MS, SIDE_PX, STILL_MS, RecordingError, open_recorder


def picture(color: tuple[int, int, int]) -> Callable[[], Image.Image]:
    return lambda: Image.new("RGB", (SIDE_PX, SIDE_PX), color)


@pytest.mark.parametrize("ending", ["gif", "webp"])
def test_animations_are_written(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"out.{ending}"
    recorder = open_recorder(path)
    for color in [(255, 0, 0)] * 3 + [(0, 255, 0)] + [(0, 0, 255)] * 2:
        recorder.add(picture(color))
    recorder.finish()
    with Image.open(path) as found:
        frames = [
            (frame.convert("RGB").getpixel((9, 9)), frame.info["duration"])
            for frame in ImageSequence.Iterator(found)
        ]
    for (color, lasting), (expected, frames_long) in zip(
        frames, [((255, 0, 0), 3), ((0, 255, 0), 1), ((0, 0, 255), 2)], strict=True
    ):
        assert color == pytest.approx(expected, abs=12)
        assert lasting == frames_long * FRAME_MS


@pytest.mark.parametrize("ending", ["gif", "webp", "png"])
def test_last_picture_is_written(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"out.{ending}"
    recorder = open_recorder(path)
    recorder.add(picture((1, 2, 3)))
    recorder.finish()
    with Image.open(path) as found:
        assert found.size == (SIDE_PX, SIDE_PX)


def test_last_picture_is_written_meanwhile(tmp_path: Path) -> None:
    """If the disk is full, the simulation goes on and the error is reported at the end."""
    path = tmp_path / "out.png"
    recorder = open_recorder(path)
    path.mkdir()
    for _ in range(STILL_MS // FRAME_MS):
        recorder.add(picture((1, 2, 3)))
    with pytest.raises(RecordingError, match="can't record to"):
        recorder.finish()
    path.rmdir()
    count = STILL_MS // FRAME_MS
    for _ in range(count - 1):
        recorder.add(lambda: pytest.fail("a picture was rendered that is not written"))
        assert not path.exists()
    recorder.add(picture((4, 5, count)))
    with Image.open(path) as found:
        assert found.convert("RGB").getpixel((9, 9)) == (4, 5, count)


@pytest.mark.parametrize("ending", ["gif", "webp", "png"])
def test_recording_without_pictures_writes_no_file(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"out.{ending}"
    open_recorder(path).finish()
    assert not path.exists()


def test_invalid_recording_raises_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(RecordingError, match=r"must end in \.gif, \.webp, \.png or \.mp4"):
        open_recorder(tmp_path / "out.txt")
    with pytest.raises(RecordingError, match="there is no folder"):
        open_recorder(tmp_path / "missing" / "out.gif")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(RecordingError, match="needs ffmpeg on the PATH"):
        open_recorder(tmp_path / "out.mp4")


def test_films_are_written_by_ffmpeg(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # A substitute for ffmpeg that only counts the bytes of its input.
    ffmpeg = tmp_path / "ffmpeg"
    ffmpeg.write_text('#!/bin/sh\nfor last; do :; done\n/usr/bin/wc -c > "$last"\n')
    ffmpeg.chmod(ffmpeg.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(tmp_path))
    recorder = open_recorder(tmp_path / "out.mp4")
    for _ in range(3):
        recorder.add(picture((1, 2, 3)))
    recorder.finish()
    assert int((tmp_path / "out.mp4").read_text()) == 3 * SIDE_PX * SIDE_PX * 3


def test_failing_ffmpeg_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ffmpeg = tmp_path / "ffmpeg"
    ffmpeg.write_text("#!/bin/sh\necho no room >&2\nexit 1\n")
    ffmpeg.chmod(ffmpeg.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(tmp_path))
    recorder = open_recorder(tmp_path / "out.mp4")
    with pytest.raises(RecordingError, match="no room"):
        recorder.finish()
