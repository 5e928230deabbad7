"""The verb `tf doctor`: its arguments, its report, its exit code."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.tf2_tools.diagnosis.test_recorded import moving, scan, write_bag

from tfloom.cli.main import main

REPORT = """\
{path}, 1.0 s: 3 frames, 1 tree, 1 publisher, 21 transforms; a recording does not name publishers

TF601 error: what /scan publishes is in the frame 'laser', which no transform holds
         - 1 message
         mend: Set the driver's frame id to one of the tree's, or publish the sensor's mounting on /tf_static.

TF404 warning: /tf publishes rarely: odom -> arm
         - odom -> arm: 1.00 Hz, 1 transform in 1.0 s
         mend: Publish more often than the data that needs the frame, or raise the timeout of the lookup above
               the period.

1 error, 1 warning; `tfloom tf doctor --explain CODE` says more of one
"""


@pytest.fixture
def bag(tmp_path: Path) -> str:
    times = [1000.0 + 0.05 * step for step in range(21)]
    messages = [("/tf", at_s, moving("odom", "base_link", at_s)) for at_s in times[1:]]
    return str(
        write_bag(
            tmp_path / "bag.db3",
            [("/tf", 1000.0, moving("odom", "arm", 1000.0)), *messages, ("/scan", 1000.5, scan("laser"))],
        )
    )


def test_the_report(bag: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tf", "doctor", bag, "--topics"]) == 1
    assert capsys.readouterr().out == REPORT.format(path=bag)


def test_exit_codes(bag: str, capsys: pytest.CaptureFixture[str]) -> None:
    for words, code in (
        ([bag, "--topics"], 1),
        ([bag], 0),
        (["--bag", bag], 0),
        ([bag, "--strict"], 1),
        ([bag, "--strict", "--ignore", "tf404"], 0),
        ([bag, "--strict", "--min-rate", "0.5"], 0),
        ([bag, "--topics", "--ignore", "TF601", "TF404"], 0),
        ([bag, "--tf-topic", "/scan"], 2),
        (["/missing.mcap"], 2),
        (["/missing.yaml"], 2),
        (["--explain", "TF101"], 0),
        (["--list"], 0),
    ):
        assert main(["tf", "doctor", *words]) == code, (words, capsys.readouterr())
    for words in (
        [bag, "--bag", bag],
        ["--ignore", "TF999"],
        ["--explain", "101"],
        ["--min-rate", "-1"],
        ["--max-jump", "far"],
        ["--seconds", "nan"],
    ):
        with pytest.raises(SystemExit) as ended:
            main(["tf", "doctor", *words])
        assert ended.value.code == 2, words


def test_json(bag: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tf", "doctor", bag, "--topics", "--json"]) == 1
    report = json.loads(capsys.readouterr().out)
    findings = report.pop("findings")
    assert report == {
        "origin": bag,
        "is_live": False,
        "is_simulated": False,
        "duration_s": 1.0,
        "frames": 3,
        "edges": 2,
        "publishers": 1,
        "transforms": 21,
        "roots": ["odom"],
        "errors": 1,
        "warnings": 1,
        "exit_code": 1,
    }
    assert [(finding["code"], finding["severity"], finding["frames"]) for finding in findings] == [
        ("TF601", "error", ["laser"]),
        ("TF404", "warning", ["arm"]),
    ]
    assert findings[1]["evidence"] == [
        {
            "text": "odom -> arm: 1.00 Hz, 1 transform in 1.0 s",
            "parent": "odom",
            "child": "arm",
            "node": "",
            "topic": "/tf",
            "rate_hz": 1.0,
            "count": 1,
        }
    ]


def test_names_cannot_command_a_terminal(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bag = write_bag(tmp_path / "bag.db3", [("/tf", 1000.0, moving("/\x1b[2J", "a\nb", 1000.0))])
    assert main(["tf", "doctor", str(bag)]) == 0
    printed = capsys.readouterr().out
    assert "TF201" in printed
    assert "a\nb" not in printed


def test_explanations(capsys: pytest.CaptureFixture[str]) -> None:
    main(["tf", "doctor", "--explain", "tf301"])
    explained = capsys.readouterr().out
    assert explained.startswith("TF301 (error, values): a transform has numbers that are not finite\n")
    assert all(word in explained for word in ("meaning:", "cause:", "mend:", "TF_NAN_INPUT"))
    main(["tf", "doctor", "--list"])
    assert "TF503  error    quality of service that does not match\n" in capsys.readouterr().out


def test_the_text_has_the_first_findings_of_a_code(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scans = [("/scan", 1000.0, scan(f"laser_{number:02}")) for number in range(30)]
    bag = write_bag(tmp_path / "bag.db3", [("/tf", 1000.0, moving("odom", "base", 1000.0)), *scans])
    assert main(["tf", "doctor", str(bag), "--topics"]) == 1
    printed = capsys.readouterr().out
    assert printed.count("TF601 error") == 20
    assert "TF601: and 10 more; `--json` has all\n" in printed
