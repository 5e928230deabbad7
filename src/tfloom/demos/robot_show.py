"""The demonstration `tfloom demo robot`: the example `robot_in_a_room`, recorded, and compared with the truth.

The programs are those of the example, which a wheel holds beside this file. They use ROS's names alone.
"""

from __future__ import annotations

import contextlib
import math
import time
from pathlib import Path

from tfloom.demos.program_group import ProgramGroup, ShowError, StartProgram, unexpected_end

EXAMPLE = "robot_in_a_room"
TOPICS = (
    *("/tf", "/tf_static", "/ground_truth", "/odom", "/scan", "/map"),
    *("/cmd_vel", "/joint_states", "/robot_description"),
)
"""What is recorded."""
SHOWN_TOPICS = ("/map", "/scan", "/robot_description")
"""What the page shows from the start."""
RECORDER = "recorder"
MAX_RECORDING_MB = 500
"""Size at which the recording ends [MB]: that of some hours."""
LOOK_S = 1.0
"""Period at which its size is looked at [s]."""
PERIOD_S = 5.0
"""Time between the lines on the robot's errors."""
IS_CORRECTED = "the corrected pose off by"
"""What is in such a line once the mapper works."""
PATIENCE_S = 40.0
"""The longest time until the mapper works, and that of the comparison at the end [s]."""


def example_folder() -> Path:
    """Return the folder of the example: in a wheel beside this file, otherwise in the sources.

    Raises:
        ShowError: there is none, as where files of the package were left out.
    """
    here = Path(__file__)
    for folder in (here.parent / EXAMPLE, here.parents[3] / "examples" / EXAMPLE):
        if (folder / "robot.py").is_file():
            return folder
    raise ShowError(f"the example's programs are not in {here.parent / EXAMPLE}: install tfloom again")


def new_recording(folder: Path) -> Path:
    """Return the path of a recording that doesn't exist yet."""
    stem = f"{EXAMPLE}_{time.strftime('%Y_%m_%d-%H_%M_%S')}"
    names = (stem if number == 1 else f"{stem}_{number}" for number in range(1, 1000))
    return next(path for name in names if not (path := folder / name).exists())


def size_mb(folder: Path) -> float:
    """Return the size of the files in a folder [MB]; 0 if there is none."""
    total = 0
    for path in folder.glob("*"):
        with contextlib.suppress(OSError):  # it is being renamed
            total += path.stat().st_size
    return total / 1e6


def robot_programs(folder: Path, recording: Path | None, *, has_page: bool) -> dict[str, list[str]]:
    """Return the programs of the demonstration by their names, with their arguments.

    Args:
        folder: The folder of the example.
        recording: The path of the recording; None: without one.
        has_page: Whether to serve the page of `tfloom view`.
    """
    description = (folder / "robot.urdf").read_text("utf-8")
    programs = {}
    if recording is not None:
        programs[RECORDER] = ["tfloom.cli.main:main", "bag", "record", "-o", str(recording), *TOPICS]
    programs |= {
        "robot": [str(folder / "robot.py")],
        "robot_state_publisher": [
            "tfloom.robot.robot_state_publisher:main",
            *("--ros-args", "-p", f"robot_description:={description}"),
        ],
        "mapper": [str(folder / "mapper.py")],
        "tour": [str(folder / "tour.py")],
        "pose_errors": [str(folder / "pose_errors.py"), "--ros-args", "-p", f"period:={PERIOD_S}"],
    }
    if has_page:
        displays = [word for topic in SHOWN_TOPICS for word in ("--display", topic)]
        programs["view"] = ["tfloom.cli.main:main", "view", "--no-open", "--fixed-frame", "map", *displays]
    return programs


class RobotShow(ProgramGroup):
    """Runs the robot, prints its errors as it drives, and at the end those of the recording.

    Args:
        start: Starts a program.
        folder: The folder of the example.
        recording: The path of the recording; None: without one.
        has_page: Whether to serve the page of `tfloom view`.
        opens_page: Whether to open it in a browser.
    """

    def __init__(
        self,
        start: StartProgram,
        folder: Path,
        recording: Path | None,
        *,
        has_page: bool,
        opens_page: bool = False,
    ) -> None:
        programs = robot_programs(folder, recording, has_page=has_page)
        super().__init__(start, programs, ["pose_errors"], opens_page=opens_page)
        self._recording = recording
        self._comparison = [str(folder / "compare.py"), str(recording)]
        self._works = False
        self._is_full = False
        """Whether the recording has ended before the robot."""
        self._next_look_s = 0.0

    def run(self, seconds: float | None) -> None:
        """Print how far the robot is from where it is taken to be.

        Args:
            seconds: Duration, extended until the mapper works and the page is there; None: until interrupted.

        Raises:
            ShowError: a program ended unexpectedly, or the mapper or the page did not work in time.
        """
        started = time.monotonic()
        end = math.inf if seconds is None else started + seconds
        while not self._works or self._awaits_page or time.monotonic() < end:
            for name, program in self._programs.items():
                if program.exit_code() is not None and not (name == RECORDER and self._is_full):
                    raise unexpected_end(name, program)
            self._print_line()
            self._end_full_recording()
            if time.monotonic() > started + PATIENCE_S:
                if not self._works:
                    raise ShowError(f"the robot's pose was not corrected in {PATIENCE_S:.0f} s")
                if self._awaits_page:
                    raise ShowError(f"the page was not there in {PATIENCE_S:.0f} s")

    def _end_full_recording(self) -> None:
        """End the recorder as soon as its files have `MAX_RECORDING_MB`; the robot drives on."""
        now_s = time.monotonic()
        if self._recording is None or self._is_full or now_s < self._next_look_s:
            return
        self._next_look_s = now_s + LOOK_S
        if size_mb(self._recording) >= MAX_RECORDING_MB:
            self._is_full = True
            self._programs[RECORDER].request_end()
            print(f"The recording has {MAX_RECORDING_MB} MB, and ends; the robot drives on.", flush=True)

    def _note(self, line: str) -> None:
        self._works |= IS_CORRECTED in line

    def _has_told(self) -> bool:
        return self._works

    def compare(self) -> None:
        """Print the errors of the recording, and where it is. The programs have to be at their end.

        Raises:
            ShowError: the recording can't be compared; the text has the reason.
        """
        if self._recording is None:
            return
        if not self._works:
            print("It ended before the mapper worked, so there is nothing to compare.")
            return
        print(f"The recording is in {self._recording} ({size_mb(self._recording):.1f} MB)", flush=True)
        with ProgramGroup(self._start_program, {"compare": self._comparison}) as group:
            print(group.output_of("compare", PATIENCE_S))
