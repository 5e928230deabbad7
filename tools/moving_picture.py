"""Record README's moving picture: `.venv/bin/python tools/moving_picture.py PICTURE.gif [RECORDING]`.

The page of `tfloom view` shows a recording of `tfloom demo robot` in Debian's Chromium. Each picture is taken when the
page shows its time, so the speed of the machine doesn't matter. Without RECORDING the demonstration is run first.
"""

from __future__ import annotations

import argparse
import io
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from PIL.Image import Image

FLAGS = ("--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
RECORDED_S = 60
FIRST_S = 4.0
"""When the picture begins [s of the recording]."""
STEP_S = 0.25
PICTURES = 64
PICTURE_MS = 100
"""How long each is shown: the robot drives two and a half times as fast as it did."""
SIZE = (1120, 600)
WIDTH = 960
"""Of the pictures, which are smaller than the page [pixels]."""
COLORS = 255
CAMERA = "camera=0.8,-4.5,4.9&look_at=2.0,0.65,0"
TIMEOUT_MS = 120_000.0
SETTLE_MS = 150.0
MAX_LOOKS = 50
MAX_BYTES = 3_000_000
STYLE = "#left { width: 290px; } td.publisher, th:nth-child(4) { display: none; }"
"""The tree without its publishers, which a recording doesn't have: there it is the file's name."""
COMMANDS = (
    "{ op: 'names', on: false }",
    "{ op: 'axes', length: 0.35 }",
    "{ op: 'trail', frame: 'base_link', on: true }",
)


def main() -> int:
    """Write the picture."""
    parser = argparse.ArgumentParser(description="Record a moving picture of a robot that maps its room.")
    parser.add_argument("picture", type=Path)
    parser.add_argument("recording", type=Path, nargs="?", help="of `tfloom demo robot`")
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        recording = words.recording or record(Path(folder))
        with served(recording) as address:
            pictures = take(address)
    write(pictures, words.picture)
    print(f"{words.picture}: {len(pictures)} pictures, {words.picture.stat().st_size / 1e6:.1f} MB")
    return 0


def record(folder: Path) -> Path:
    """Run the demonstration in a folder, and return its recording."""
    command = [sys.executable, "-m", "tfloom", "demo", "robot", "--seconds", f"{RECORDED_S}"]
    subprocess.run(command, cwd=folder, check=True)
    return next(folder.iterdir())


@contextmanager
def served(recording: Path) -> Iterator[str]:
    """Serve a recording for the block; give the address."""
    topics = [word for topic in ("/map", "/scan", "/robot_description") for word in ("--display", topic)]
    command = [sys.executable, "-m", "tfloom", "view", str(recording), "--no-open", "--port", "0"]
    with subprocess.Popen(
        [*command, "--fixed-frame", "map", *topics], stdout=subprocess.PIPE, text=True
    ) as view:
        try:
            lines = iter(view.stdout or ())
            yield next(line for line in lines if line.startswith("Open ")).removeprefix("Open ").strip()
        finally:
            view.terminate()


def take(address: str) -> list[Image]:
    """Return the pictures of the page."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as driver:
        browser = driver.chromium.launch(
            executable_path=shutil.which("chromium"), headless=True, args=[*FLAGS]
        )
        # Conditions that are waited for are text that the page evaluates, which its policy forbids.
        page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]}, bypass_csp=True)
        page.set_default_timeout(TIMEOUT_MS)
        page.goto(f"{address}?dpr=1&{CAMERA}")
        page.wait_for_selector("body[data-ready=yes]")
        page.evaluate(f"document.head.append(element('style', {{ textContent: {STYLE!r} }}))")
        for command in COMMANDS:
            page.evaluate(f"send({command})")
        page.wait_for_function("state.rows.some((row) => row.frame === 'tool')")
        start_ns = int(page.evaluate("state.span[0]"))
        times = [start_ns + int((FIRST_S + STEP_S * number) * 1e9) for number in range(PICTURES)]
        show(page, times[0])
        page.wait_for_timeout(20 * SETTLE_MS)  # meshes and the map are loaded
        pictures = [show(page, time_ns) for time_ns in times]
        browser.close()
    return pictures


def show(page: Any, time_ns: int) -> Image:
    """Let the page show a time, and return its picture as soon as nothing changes in it.

    Raises:
        SystemExit: it changes for ever.
    """
    import PIL.Image

    page.evaluate(f"send({{ op: 'hold', stamp_ns: '{time_ns}' }})")
    page.wait_for_function(f"state.held_ns === '{time_ns}'")
    before = b""
    for _ in range(MAX_LOOKS):
        if (now := page.screenshot()) == before:
            return PIL.Image.open(io.BytesIO(now)).convert("RGB")
        before = now
        page.wait_for_timeout(SETTLE_MS)
    sys.exit(f"the page still changes after {MAX_LOOKS} looks at one time")


def write(pictures: list[Image], path: Path) -> None:
    """Write pictures as one that moves for ever.

    Raises:
        SystemExit: it is too large.
    """
    import PIL.Image

    height = round(SIZE[1] * WIDTH / SIZE[0])
    small = [picture.resize((WIDTH, height), PIL.Image.Resampling.LANCZOS) for picture in pictures]
    # One palette for all, because colours that differ would flicker, of the first and the last one.
    both = PIL.Image.new("RGB", (WIDTH, 2 * height))
    both.paste(small[0], (0, 0))
    both.paste(small[-1], (0, height))
    palette = both.quantize(COLORS, PIL.Image.Quantize.MAXCOVERAGE, kmeans=3)
    first, *others = (picture.quantize(palette=palette, dither=PIL.Image.Dither.NONE) for picture in small)
    first.save(path, save_all=True, append_images=others, duration=PICTURE_MS, loop=0, optimize=True)
    if path.stat().st_size > MAX_BYTES:
        sys.exit(f"{path} has {path.stat().st_size} bytes, more than {MAX_BYTES}")


if __name__ == "__main__":
    sys.exit(main())
