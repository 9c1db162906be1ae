"""A score report is in the user's language: no word of it stays English."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from report_scenes import NAME, filmed, found, subject

from tests.page_reader import WORD, Portuguese, Reader, english
from tracking.scoring import PassageScore
from tracking.scoring.parts import Rates
from tracking.scoring.report import (
    Shown,
    Source,
    Yardstick,
    finding_of,
    page_of,
    report_of,
    switch_pictures,
)
from tracking.scoring.report.markdown import markdown_of
from tracking.scoring.score import FIGURES
from tracking.translation import use_catalogue

_MEASURES = {"HOTA", "DetA", "AssA", "LocA", "MOTA", "IDF", "COMBINED"}
"""What they are called in every language."""
_NAMES = {*WORD.findall(NAME), "first", "better", "lane", "txt", "truth", "one", "flow", "door"}
"""Of recordings, results and files in the scenes."""


@pytest.fixture(autouse=True)
def wide() -> Iterator[None]:
    use_catalogue(Portuguese())
    yield
    use_catalogue(None)


def test_no_word_of_a_score_report_stays_english() -> None:
    sources = {"first<b>": Source("one.txt", "lane", 100, 12.5, "flow", ("one.txt", "lane.txt"))}
    one = replace(
        subject(footage=filmed()), true_source=Source("truth.txt"), result_sources=sources
    )
    first = finding_of(one, "first<b>", Yardstick(ranges=((100, 130),)))
    rates = Rates(
        2, 0, np.array([2, 2, 1, 0]), np.full((4, 4), 0.5), np.zeros((4, 4)),
        np.array([0.9, 0.8, np.nan, 0.7]), np.array([0.1, 0.2, 0.3]),
    )  # fmt: skip
    passages = (PassageScore("door", 4, 3, 2),)
    whole = replace(first, parts=rates, score=replace(first.score, passages=passages))
    unfilmed = report_of(found(), Yardstick())
    nobody = replace(one, truth=one.truth.rows(np.zeros(len(one.truth), bool)))
    empty = report_of([finding_of(nobody, "better", Yardstick())], Yardstick())
    pictured = {whole: Shown(switch_pictures(whole, lambda *_: None))}
    single = report_of([whole], Yardstick())
    for report, shown in ((single, pictured), (unfilmed, {}), (empty, {})):
        data = _MEASURES | _NAMES
        assert english(Reader(page_of(report, shown)).said, data) == set()
        assert english([markdown_of(report)], data) == set()
    keys = {word for name in FIGURES for word in WORD.findall(name)}
    assert english([rates.as_text()], set()) == set()
    assert english([whole.score.as_text()], _MEASURES | _NAMES | keys) == set()
