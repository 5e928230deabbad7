"""The page of deliberate differences: its rows, and in Chromium its filter at three widths."""

from __future__ import annotations

import re
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end
from tests.docs.page import DOCS

PAGE = DOCS / "deviations.md"
BROWSER = shutil.which("chromium")
CONF = 'extensions = ["myst_parser"]\nhtml_theme = "furo"\nhtml_static_path = ["_static"]\n'


def test_each_row_is_under_a_heading_and_has_its_own_id(deviations: dict[str, dict[str, str]]) -> None:
    text = PAGE.read_text("utf-8")
    ids = re.findall(r"^\| `?([a-z0-9-]+)`? \|", text, re.MULTILINE)
    areas = text.split("\n## ")
    assert len(areas) > 10
    assert "\n| " not in areas[0]
    assert sorted(row for row in ids if row != "id") == sorted(deviations)
    assert all(area.count("\n| id | where | reference | ours | why |\n") == 1 for area in areas[1:])


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="needs playwright, which `make check` installs"
    )
    if BROWSER is None:
        pytest.skip("needs Debian's Chromium: apt-get install chromium")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=BROWSER, headless=True, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="module")
def page_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the page alone, with the site's theme, style and script."""
    pytest.importorskip("furo", reason="furo is not installed: make setup")
    folder = tmp_path_factory.mktemp("page")
    shutil.copytree(DOCS / "_static", folder / "_static")
    # Its links lead to other pages, which are not built.
    (folder / "index.md").write_text(re.sub(r"\]\([^)]*\)", "]", PAGE.read_text("utf-8")), "utf-8")
    settings = re.findall(
        r"^html_(?:css|js)_files = .*$", (DOCS / "conf.py").read_text("utf-8"), re.MULTILINE
    )
    (folder / "conf.py").write_text(CONF + "\n".join(settings), "utf-8")
    done = run_to_end([sys.executable, "-m", "sphinx", "-q", folder, folder / "html"], timeout_s=200)
    assert done.returncode == 0, done.stderr
    return folder / "html" / "index.html"


@pytest.mark.slow
@pytest.mark.parametrize("width", [390, 820, 1400])
def test_the_filter_leaves_the_cards_that_have_its_words(
    browser: Any, page_file: Path, width: int, deviations: dict[str, dict[str, str]]
) -> None:
    page = browser.new_page(viewport={"width": width, "height": 900})
    page.goto(page_file.as_uri())
    count, field = page.locator(".differences-filter output"), page.locator(".differences-filter input")
    cards, areas = page.locator("tbody tr:visible"), page.locator("#deliberate-differences > section:visible")
    assert count.text_content() == f"{len(deviations)} differences"
    assert cards.count() == len(deviations)
    assert page.evaluate("document.documentElement.scrollWidth - innerWidth") == 0  # nothing is cut off
    field.fill("TF2_monitor  delay")
    assert [card.get_attribute("id") for card in cards.all()] == ["tf2-monitor-pair"]
    assert (areas.count(), count.text_content()) == (1, f"1 of {len(deviations)}")
    field.fill("no such word")
    assert (cards.count(), areas.count()) == (0, 0)
    page.goto(f"{page_file.as_uri()}#node-task-order")  # a link to a card that is filtered out shows all
    page.wait_for_function("document.querySelector('.differences-filter input').value === ''")
    assert cards.count() == len(deviations)
    page.wait_for_function(  # the page scrolls smoothly
        "(y => 0 <= y && y < innerHeight)(document.querySelector('#node-task-order').getBoundingClientRect().y)"
    )
    page.close()
