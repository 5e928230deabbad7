"""Recordings of the turtles' picture: an animation, a film, or the last picture alone."""

from __future__ import annotations

import shutil
import subprocess
import zlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any, Protocol, TypeAlias

from tfloom.common.files import Replacement
from tfloom.turtlesim.picture import Picture, from_rgb, save

FRAME_MS = 40
"""Time between two pictures [ms]: 25 a second, which GIF can express."""
STILL_MS = 1000
"""Time between two writes of the last picture [ms]."""
SIDE_PX = 500
Render: TypeAlias = Callable[[], Picture]
"""Returns the picture of this moment: RGB, SIDE_PX by SIDE_PX."""


class RecordingError(Exception):
    """The recording can't be made; the text has the reason and the alternatives."""


class Recorder(Protocol):
    """Collects a picture every FRAME_MS and writes a file of them."""

    def add(self, render: Render) -> None:
        """Add the next picture."""

    def finish(self) -> None:
        """Write the file.

        Raises:
            RecordingError: it can't be written.
        """


def open_recorder(path: Path) -> Recorder:
    """Return a recorder for a file, by its name's ending.

    Raises:
        RecordingError: no such kind of recording, its folder doesn't exist, or ffmpeg is missing for a film.
    """
    if not path.parent.is_dir():
        raise RecordingError(f"can't record to {path}: there is no folder {path.parent}")
    kind = path.suffix.lower()
    if kind == ".png":
        return Still(path)
    if kind in {".gif", ".webp"}:
        return Animation(path)
    if kind == ".mp4":
        return Film(path)
    raise RecordingError(f"can't record to {path}: the name must end in .gif, .webp, .png or .mp4")


class Still:
    """Keeps the last picture; its file is written every STILL_MS, too, so that it can be looked at meanwhile."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._render: Render | None = None
        self._added = 0

    def add(self, render: Render) -> None:
        """Count the next picture, which is rendered only if it is written."""
        self._render = render
        self._added += 1
        if self._added % (STILL_MS // FRAME_MS) == 0:
            with suppress(RecordingError):  # a full disk may have room at the end, which reports an error
                self.finish()

    def finish(self) -> None:
        """Write the last picture."""
        if self._render is not None:
            _save(self._render(), self._path)


class Animation:
    """Keeps all pictures, compressed; equal successive pictures are kept once, with their duration."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._frames: list[bytes] = []
        self._lasting_ms: list[int] = []
        self._last = b""

    def add(self, render: Render) -> None:
        """Add the next picture."""
        pixels = render().tobytes()
        if pixels == self._last:
            self._lasting_ms[-1] += FRAME_MS
            return
        self._last = pixels
        self._frames.append(zlib.compress(pixels, 1))
        self._lasting_ms.append(FRAME_MS)

    def _pictures(self) -> Iterator[Picture]:
        for frame in self._frames:
            yield from_rgb(zlib.decompress(frame), SIDE_PX)

    def finish(self) -> None:
        """Write the animation, which repeats without end."""
        if self._frames:
            pictures = self._pictures()
            first = next(pictures)
            lasting = self._lasting_ms if len(self._lasting_ms) > 1 else self._lasting_ms[0]
            _save(first, self._path, save_all=True, append_images=pictures, duration=lasting, loop=0)


class Film:
    """Passes each picture on to ffmpeg."""

    def __init__(self, path: Path) -> None:
        ffmpeg = shutil.which("ffmpeg")
        if ffmpeg is None:
            raise RecordingError("an .mp4 needs ffmpeg on the PATH; .gif, .webp and .png need nothing")
        self._path = path
        try:
            self._replacement = Replacement(path)
        except OSError as error:
            raise RecordingError(f"can't record to {path}: {error.strerror}") from None
        side, rate = f"{SIDE_PX}x{SIDE_PX}", str(1000 // FRAME_MS)
        source = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", side, "-r", rate, "-i", "-"]
        target = ["-pix_fmt", "yuv420p", str(self._replacement.partial)]
        command = [ffmpeg, "-y", "-loglevel", "error", *source, *target]
        # In a separate session, because Ctrl-C must end the recording first, and ffmpeg at the end of its input.
        self._ffmpeg = subprocess.Popen(
            command, stdin=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
        )

    def add(self, render: Render) -> None:
        """Add the next picture."""
        if self._ffmpeg.stdin is not None:
            with suppress(BrokenPipeError):  # it has ended; `finish` raises with the reason
                self._ffmpeg.stdin.write(render().tobytes())

    def finish(self) -> None:
        """Close ffmpeg's input and wait until the film is complete."""
        _, errors = self._ffmpeg.communicate()
        try:
            if not self._ffmpeg.returncode:
                self._replacement.commit()
        except OSError as error:
            raise RecordingError(f"can't record to {self._path}: {error.strerror}") from None
        finally:
            self._replacement.discard()
        if self._ffmpeg.returncode:
            raise RecordingError(
                f"ffmpeg can't record to {self._path}: {errors.decode(errors='replace').strip()}"
            )


def _save(picture: Picture, path: Path, **options: Any) -> None:
    try:
        save(picture, path, **options)
    except OSError as error:
        raise RecordingError(f"can't record to {path}: {error.strerror or error}") from None
