"""The page on a batch."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.page_reader import Portuguese, Reader, english
from tracking.batch import Cause, Ledger, Outcome, Row, State, write_batch_report
from tracking.batch.outcome import failure
from tracking.batch.report import suspicion
from tracking.translation import msg, use_catalogue

JPEG = b"\xff\xd8 an image"


def done(people: int = 1, **known) -> Outcome:
    return Outcome(
        State.DONE, people=people, frames=100, fps=10.0, tracker="flow", session="s", **known
    )


def page_of(out: Path, outcomes: dict[str, Outcome], **asked) -> str:
    with Ledger(out / "batch.sqlite") as ledger:
        for name, outcome in outcomes.items():
            ledger.put(Row(name, Path("/r") / name, "", "", "[]", outcome), JPEG)
        ledger.commit()
        return write_batch_report(ledger, out, **asked).read_text()


def test_failed_ones_come_first_then_suspicious_ones(tmp_path: Path) -> None:
    page = page_of(
        tmp_path,
        {
            "sure": done(review_rows=0.01),
            "scored": done(score={"IDF1": 0.9}),
            "doubtful": done(review_rows=0.4),
            "nobody": done(0),
            "kept": Outcome(State.SKIPPED, Cause.PROTECTED, msg("it was corrected")),
            "lost": failure(Cause.INPUT, msg("no video")),
        },
        missing={"/r/none": (State.FAILED, msg("no such recording"))},
    )
    said = [word for word in Reader(page).said if word]
    order = ["/r/none", "lost", "kept", "nobody", "doubtful", "scored", "sure"]
    names = [word for word in said if word in order]
    assert names == order
    assert {"no video", "it was corrected", "no such recording"} <= set(said)
    assert page.count("data:image/jpeg;base64,") == 4


def test_the_mean_score_is_of_all_that_are_scored(tmp_path: Path) -> None:
    outcomes = {
        "good": done(score={"IDF1": 0.9}),
        "nobody": done(0, score={"IDF1": 0.0}),
        "empty": done(score={"IDF1": None}, review_rows=0.3),
        "free": done(),
    }
    assert "0.450" in Reader(page_of(tmp_path, outcomes)).said


def test_names_and_reasons_never_become_markup(tmp_path: Path) -> None:
    hostile = "<script>alert(1)</script>"
    page = page_of(
        tmp_path,
        {
            "&lt;b&gt;": failure(Cause.INPUT, msg("{name} is bad", name=hostile)),
            "'a&b": done(page=True),
        },
    )
    assert "<script" not in page
    assert f"{hostile} is bad" in Reader(page).said
    assert "&lt;b&gt;" in Reader(page).said
    assert 'href="%27a%26b/report.html"' in page


@pytest.mark.parametrize(
    ("outcome", "expected"),
    [
        (done(0), 1.0),
        (done(2, score={"IDF1": 0.75}, review_rows=0.9), 0.25),
        (done(2, review_rows=0.3), 0.3),
        (done(2, score={"IDF1": None}, review_rows=0.3), 0.3),
    ],
)
def test_suspicion_is_the_share_that_is_probably_wrong(outcome: Outcome, expected: float) -> None:
    assert suspicion(outcome) == expected


def test_no_word_of_the_page_stays_english(tmp_path: Path) -> None:
    use_catalogue(Portuguese())
    try:
        page = page_of(
            tmp_path,
            {
                "one": done(review_rows=0.1, notes=(msg("nobody was found"),), corrected=True),
                "two": failure(Cause.WORKER, msg("its worker died ({how})", how=msg("stopped"))),
                "three": Outcome(State.SKIPPED, Cause.PROTECTED, msg("it was corrected")),
            },
        )
    finally:
        use_catalogue(None)
    read = Reader(page)
    data = {"one", "two", "three", "flow", "MOTA", "IDF", "HOTA", tmp_path.name}
    data |= set(tmp_path.name.replace("_", " ").split())
    assert read.language == "pt-BR"
    assert {word for word in english(read.said, data) if word not in tmp_path.name} == set()
