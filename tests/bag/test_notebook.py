"""The notebook about a recording: its cells run, and the whole runs in Jupyter's kernel with pictures."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parents[2] / "examples" / "bags"
NOTEBOOK = FOLDER / "trajectory_and_clouds.ipynb"
RESULT = "all clouds: "


def code_cells() -> list[str]:
    cells = json.loads(NOTEBOOK.read_text("utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def assert_result(text: str) -> None:
    """Check that deskewing moves the points onto the walls."""
    (line,) = (line for line in text.splitlines() if line.startswith(RESULT))
    words = line.split()
    assert float(words[2]) > 0.1
    assert float(words[words.index("moment,") + 1]) < 0.002


def test_cells_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.syspath_prepend(str(FOLDER))
    names: dict[str, Any] = {}
    from matplotlib import pyplot as plt

    with plt.rc_context({"backend": "agg"}):
        for number, cell in enumerate(code_cells()):
            exec(compile(cell, f"cell {number}", "exec"), names)
        plt.close("all")
    sys.modules.pop("make_recording", None)
    assert_result(capsys.readouterr().out)
    assert names["trajectory"].length_m == pytest.approx(24, rel=0.01)


@pytest.mark.slow
def test_notebook_runs_in_jupyters_kernel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat = pytest.importorskip("nbformat", reason="`make setup` installs it")
    client = pytest.importorskip("nbclient", reason="`make setup` installs it")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    notebook = nbformat.read(NOTEBOOK, 4)
    client.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(FOLDER)}}).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    shown = [kind for output in outputs for kind in output.get("data", {})]
    assert shown.count("image/png") == 2
    assert shown.count("text/html") == 3
    assert_result("".join(output.get("text", "") for output in outputs))
