"""A score report in a real browser: Debian's Chromium, where it is installed."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
import pytest
import report_scenes as scenes
from browser import Browser, browser

from tracking.scoring.report import (
    Shown,
    Yardstick,
    place_picture,
    report_of,
    switch_pictures,
    write_score_report,
)


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """A browser that shows a report with everything in it."""
    findings = scenes.found(footage=scenes.filmed())
    shown = {
        one: Shown(switch_pictures(one, lambda *_: None), place_picture(one.subject))
        for one in findings
    }
    folder = tmp_path_factory.mktemp("seen")
    page = write_score_report(folder / "report", report_of(findings, Yardstick()), shown)
    with browser(folder / "profile") as found:
        found.shape(1280)
        found.open(page)
        yield found


_ALL = "[...document.querySelectorAll"


def _brightness(png: bytes) -> float:
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    return float(np.median(image))


def test_it_asks_for_nothing_and_complains_of_nothing(seen: Browser) -> None:
    assert [each for each in seen.asked if not each.startswith("data:")] == [seen.asked[0]]
    assert seen.asked[0].endswith("/report.html")
    assert seen.told == []


def test_a_recordings_name_is_text_and_runs_nothing(seen: Browser) -> None:
    assert seen.value("typeof told") == "undefined"
    assert seen.value("document.scripts.length") == 0
    assert seen.value("document.title").endswith(scenes.NAME)
    assert seen.value("document.querySelector('nav a:last-child').textContent") == scenes.NAME


def test_drawings_and_pictures_are_there(seen: Browser) -> None:
    widths = seen.value(f"{_ALL}('.drawn > svg')].map(e => e.getBoundingClientRect().width)")
    assert len(widths) == 5  # the curves, and of each result its errors over time and on the map
    assert min(widths) > 100
    assert seen.value(f"{_ALL}('figure img')].map(e => e.naturalWidth)") == [400, 400]
    missed = seen.value(f"{_ALL}('.drawn .miss title')].map(e => e.textContent)")
    assert any(each.startswith("person 2: missed") for each in missed)


@pytest.mark.parametrize("width", [1280, 390])
def test_it_is_no_wider_than_the_window(seen: Browser, width: int) -> None:
    seen.shape(width)
    assert seen.value("document.documentElement.scrollWidth") == width


def test_over_a_narrow_page_errors_in_time_are_scrolled_rather_than_shrunk(seen: Browser) -> None:
    seen.shape(400)
    drawn = "document.querySelector('.drawn:not(.narrow)')"
    assert seen.value(f"{drawn}.scrollWidth") > 900
    assert seen.value(f"{drawn}.clientWidth") < 400
    assert seen.value(f"getComputedStyle({drawn}).overflowX") == "auto"


def test_over_a_narrow_page_explanations_wrap(seen: Browser) -> None:
    seen.shape(400)
    assert seen.value("document.querySelector('td.says').offsetWidth") < 200
    assert seen.value("getComputedStyle(document.querySelector('.scrolled')).overflowX") == "auto"
    words = f"{_ALL}('td.word')].slice(0, 4).map(e => e.firstChild)"
    lines = (
        "t => {const r = document.createRange(); r.selectNode(t); return r.getClientRects().length}"
    )
    assert seen.value(f"{words}.map({lines})") == [1, 1, 1, 1]


def test_it_is_dark_where_its_reader_likes_it_dark(seen: Browser) -> None:
    seen.shape(1280, "dark")
    dark = _brightness(seen.screenshot())
    seen.shape(1280, "light")
    assert dark < 60 < 230 < _brightness(seen.screenshot())


def test_it_prints_black_on_white_however_dark_the_screen_is(seen: Browser) -> None:
    seen.shape(1280, "dark", media="print")
    ground, ink = (
        seen.value(f"getComputedStyle(document.body).{each}")
        for each in ("backgroundColor", "color")
    )
    assert (ground, ink) == ("rgb(255, 255, 255)", "rgb(0, 0, 0)")
    printed = seen.printed()
    assert printed.startswith(b"%PDF")
    assert printed.count(b"/Type /Page\n") > 1
