"""The report on scores: what its page, its Markdown and its JSON say."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import report_scenes as scenes
from hypothesis import given
from hypothesis import strategies as st

from tracking.errors import OutputError
from tracking.scoring import Conventions, ErrorKind, PassageScore
from tracking.scoring.parts import Rates
from tracking.scoring.report import (
    Finding,
    Shown,
    Source,
    Subject,
    Yardstick,
    data_of,
    finding_of,
    page_of,
    place_picture,
    report_of,
    switch_pictures,
    write_score_report,
)
from tracking.scoring.report.data import finding_data
from tracking.scoring.report.distances import even_edges
from tracking.scoring.report.markdown import markdown_of, plain
from tracking.scoring.report.measures import measures_by
from tracking.scoring.report.stretches import Stretches, joined

VOID = {"meta", "img", "br"}


class Reader(HTMLParser):
    """What a page holds; every element must be closed by its own end."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[str] = []
        self.classes: list[str] = []
        self.texts: list[str] = []
        self.feed(page)
        self.close()
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.classes += [value or "" for name, value in attrs if name == "class"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def _pictured() -> tuple[list[Finding], dict[Finding, Shown]]:
    findings = scenes.found(footage=scenes.filmed())
    return findings, {one: Shown(switch_pictures(one, lambda *_: None)) for one in findings}


def test_the_page_tells_every_error_and_nothing_in_it_is_anybodys_markup() -> None:
    findings, shown = _pictured()
    read = Reader(page_of(report_of(findings, Yardstick()), shown))
    assert "script" not in read.tags
    assert read.texts.count(scenes.NAME) >= 2
    says = " ".join(read.texts)
    assert "frame 130 (5.20 s): person 1 changes from track 1 to 2" in says
    assert "person 2: missed, frames 120 to 124" in says
    assert "track 4: nobody is there, frames 140 to 144" in says
    assert "frame 125 (5.00 s): person 2 is found again after 5 frames, by track 3" in says
    assert read.tags.count("img") == 2
    assert "the camera" in read.texts


def test_a_page_is_the_same_every_time() -> None:
    pages = [page_of(report_of(findings, Yardstick()), shown) for findings, shown in
             (_pictured(), _pictured())]  # fmt: skip
    assert pages[0] == pages[1]


def test_several_results_stand_side_by_side_with_the_best_marked() -> None:
    read = Reader(page_of(scenes.report(), {}))
    assert read.classes.count("best") > 20
    assert "+0.045" in read.texts  # recall of the better one
    assert "first<b>" in read.texts


def test_recordings_have_a_row_each_and_one_together() -> None:
    report = scenes.report("one", "two")
    read = Reader(page_of(report, {}))
    assert read.texts.count("COMBINED") == 2
    assert markdown_of(report).count("| COMBINED |") == 2
    combined = data_of(report)["results"]["first<b>"]["combined"]
    assert (combined["frames"], combined["misses"], combined["id_switches"]) == (120, 10, 2)


def test_the_data_holds_every_error_as_often_as_the_score_counts_it() -> None:
    data = json.loads(json.dumps(data_of(scenes.report()), allow_nan=False))
    one = data["results"]["first<b>"]["sequences"][scenes.NAME]
    errors = one["errors"]
    lasted = {kind: sum(e["stop"] - e["start"] for e in errors[kind])
              for kind in ("misses", "false_alarms")}  # fmt: skip
    assert lasted == {"misses": one["misses"], "false_alarms": one["false_positives"]}
    assert lasted == {"misses": 5, "false_alarms": 5}
    assert len(errors["switches"]) == one["id_switches"] == 1
    assert len(errors["fragmentations"]) == one["fragmentations"] == 1
    assert errors["switches"][0] == {
        "frame": 130, "person": 1, "earlier_track": 1, "earlier_frame": 129, "track": 2,
    }  # fmt: skip
    assert [row["person"] for row in one["per_person"]] == [1, 2]
    assert one["per_person"][0]["start"] == 100
    assert [(row["start"], row["stop"], row["id_switches"]) for row in one["ranges"]] == [
        (100, 130, 0)
    ]


def test_markdown_has_names_as_text_and_as_many_cells_in_each_row_of_a_table() -> None:
    text = markdown_of(scenes.report())
    assert "<script>" not in text
    assert "\\[x\\](y)" in text
    for table in (part for part in text.split("\n\n") if part.startswith("|")):
        bars = {line.replace("\\|", "").count("|") for line in table.splitlines()}
        assert len(bars) == 1, table


@given(st.text())
def test_markdown_keeps_any_text_on_its_line(text: str) -> None:
    shown = plain(text)
    assert len(shown.splitlines()) <= 1
    shown.encode("utf-8")


def test_a_report_takes_no_place_but_an_earlier_reports(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(OutputError, match=r"holds thesis.txt"):
        write_score_report(tmp_path, scenes.report())
    (tmp_path / "thesis.txt").unlink()
    for _ in range(2):
        assert write_score_report(tmp_path, scenes.report()).is_file()
    names = {each.name for each in tmp_path.iterdir()}
    assert names == {"report.html", "report.md", "report.json"}


def test_switches_have_pictures_of_before_and_after_and_the_rest_is_told() -> None:
    (first, better) = scenes.found(footage=scenes.filmed())
    (shown,) = switch_pictures(first, lambda *_: None)
    assert (shown.earlier_frame, shown.frame) == (129, 130)
    assert (shown.earlier, shown.track) == (1, 2)
    assert shown.before[:2] == shown.after[:2] == b"\xff\xd8"
    assert switch_pictures(better, lambda *_: None) == ()
    assert switch_pictures(first, lambda *_: None, most=0) == ()
    page = page_of(report_of([first], Yardstick()), {first: Shown(why_none="it is gone")})
    assert "No pictures: it is gone." in page


def test_without_metres_the_map_is_the_picture() -> None:
    one = scenes.subject(footage=scenes.filmed())
    unplaced = replace(
        one,
        truth=replace(one.truth, position=np.full_like(one.truth.position, np.nan)),
        results={
            name: replace(each, position=np.full_like(each.position, np.nan))
            for name, each in one.results.items()
        },
    )
    finding = finding_of(unplaced, "first<b>", Yardstick())
    page = page_of(report_of([finding], Yardstick()), {finding: Shown((), place_picture(one))})
    assert "x in the image, px" in page
    assert "<image " in page
    assert "position error" not in page
    assert "the ground truth has no positions on the floor" in page
    assert "the ground truth has no positions on the floor" in markdown_of(
        report_of([finding], Yardstick())
    )
    assert finding_data(finding)["distances"] == []


def test_nobody_anywhere_makes_a_page_all_the_same() -> None:
    one = scenes.subject()
    nobody = one.truth.rows(np.zeros(len(one.truth), bool))
    for truth, result in ((nobody, nobody), (one.truth, nobody), (nobody, one.truth)):
        empty = replace(one, truth=truth, results={"nobody": result})
        finding = finding_of(empty, "nobody", Yardstick())
        page = Reader(page_of(report_of([finding], Yardstick()), {}))
        assert "rows of the ground truth" in page.texts
        told = json.dumps(data_of(report_of([finding], Yardstick())), allow_nan=False)
        assert f'"truth_rows": {finding.score.clear.truth_rows}' in told


def test_who_does_not_count_in_the_truth_walks_on_no_map() -> None:
    still = scenes.subject()
    walked = np.stack((0.2 * still.truth.frame, 5.0 + still.truth.track), axis=1)
    truth = replace(still.truth, position=walked)
    walks = []
    for counted in (truth.counted, truth.track != 2):
        one = replace(still, truth=replace(truth, counted=counted))
        finding = finding_of(one, next(iter(one.results)), Yardstick())
        walks.append(page_of(report_of([finding], Yardstick()), {}).count('class="walk"'))
    assert walks == [3, 2]  # the legend's and each person's


def test_figures_by_distance_are_told_in_ranges_of_the_reports_own() -> None:
    report = scenes.report()
    says = " ".join(Reader(page_of(report, {})).texts)
    assert "By distance from the camera" in says
    assert "6 and more" in markdown_of(report)
    one = finding_data(report.findings[0])
    edges = [(each["from_m"], each["to_m"]) for each in one["distances"]]
    assert edges == [(0, 2), (2, 4), (4, 6), (6, None)]
    assert sum(each["id_switches"] for each in one["distances"]) == one["id_switches"] == 1


@given(st.floats(0, 500))
def test_ranges_of_distance_are_few_and_reach_where_people_are(reach_m: float) -> None:
    edges = even_edges(reach_m)
    assert edges[0] == 0
    assert 1 <= len(edges) <= 6
    assert len(edges) == 1 or edges[-1] < reach_m <= edges[-1] + edges[1]


@pytest.mark.parametrize("stop", [KeyboardInterrupt(), OSError(28, "No space left on device")])
def test_who_is_stopped_while_writing_leaves_the_folder_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, stop: BaseException
) -> None:
    earlier, new = tmp_path / "earlier", tmp_path / "new" / "inner"
    write_score_report(earlier, scenes.report())
    held = {each.name: each.read_bytes() for each in earlier.iterdir()}
    report, synced = scenes.report("other"), [0]

    def fsync(_file: int) -> None:
        synced[0] += 1
        if synced[0] % 3 == 2:
            raise stop

    monkeypatch.setattr("tracking.pages.folder.os.fsync", fsync)
    for folder in (earlier, new):
        with pytest.raises((KeyboardInterrupt, OutputError)):
            write_score_report(folder, report)
        synced[0] = 0
    assert {each.name: each.read_bytes() for each in earlier.iterdir()} == held
    assert [each.name for each in tmp_path.iterdir()] == ["earlier"]


def test_passages_are_told_where_there_are_lines() -> None:
    finding = scenes.found()[0]
    counted = replace(finding, score=replace(finding.score, passages=(PassageScore("d", 4, 3, 2),)))
    assert "Counted passages" in page_of(report_of([counted], Yardstick()), {})


def test_body_parts_have_their_curves_where_they_were_followed() -> None:
    finding = scenes.found()[0]
    rates = Rates(
        2, 0, np.array([2, 2, 1, 0]), np.full((4, 4), 0.5), np.zeros((4, 4)),
        np.array([0.9, 0.8, np.nan, 0.7]), np.array([0.1, 0.2, 0.3]),
    )  # fmt: skip
    report = report_of([replace(finding, parts=rates)], Yardstick())
    read = Reader(page_of(report, {}))
    assert {"Body parts", "hip-leg", "90.0 %", "10.0 %"} <= set(read.texts)
    assert "| head | 90.0 % | 10.0 % |" in markdown_of(report)
    one = data_of(report)["results"]["first<b>"]["sequences"][scenes.NAME]
    assert one["parts"]["people_judged"] == 2


def test_the_best_is_what_reads_best_and_differences_have_their_sign() -> None:
    first, better = (one.score for one in scenes.found())
    known = {each.name: each for each in measures_by(Conventions.TRACKEVAL, [first, better])}
    assert known["misses"].best([first, better]) == {1}
    assert known["recall"].difference(better, first) == "+0.045"
    assert known["misses"].difference(better, first) == "−5"
    assert known["LocA"].best([first, first]) == frozenset()
    assert known["frames"].best([first, better]) == frozenset()
    other = {each.name: each for each in measures_by(Conventions.MOTMETRICS, [first])}
    assert (known["MOTP"].better, other["MOTP"].better) == ("higher", "lower")


rows = st.lists(st.tuples(st.integers(0, 40), st.integers(1, 4)), unique=True)


@given(rows)
def test_stretches_hold_every_row_once_and_no_two_touch(rows: list[tuple[int, int]]) -> None:
    frame, who = np.array(rows, np.int64).reshape(-1, 2).T
    found = Stretches.of(frame, who, np.column_stack((frame, who)).astype(float))
    held = [
        (each, person)
        for person in range(1, 5)
        for start, stop in found.ranges_of(person)
        for each in range(start, stop)
    ]
    assert sorted(held) == sorted(rows)
    assert len(found.paths()) == len(found)
    for person in range(1, 5):
        ranges = found.ranges_of(person)
        assert all(a[1] < b[0] for a, b in pairwise(ranges))
        assert [(a, b) for a, b, _ in joined(ranges, 0.5)] == ranges
        assert sum(frames for *_, frames in joined(ranges, math.inf)) == sum(
            b - a for a, b in ranges
        )


def test_errors_far_out_stand_on_the_maps_edge_and_are_told() -> None:
    one = scenes.subject()
    moved = one.results["first<b>"].position.copy()
    moved[one.results["first<b>"].track == 4, 0] = 9000.0
    far = replace(one, results={"far": replace(one.results["first<b>"], position=moved)})
    page = page_of(report_of([finding_of(far, "far", Yardstick())], Yardstick()), {})
    assert "5 errors lie farther out than the map goes" in page


def test_a_map_shows_no_more_than_can_be_seen_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tracking.scoring.report.error_map.MOST_MARKS", 0)
    finding = scenes.found()[0]
    assert finding.errors.count(ErrorKind.MISS) == 5
    page = page_of(report_of([finding], Yardstick()), {})
    assert "1 ranges of misses beyond" in page


def test_a_report_says_which_files_it_is_of() -> None:
    sources = {
        name: Source(f"{name}/one.h5", "lane|0", 100, 12.5, "flow")
        for name in ("first<b>", "better")
    }
    one = replace(scenes.subject(), true_source=Source("a/truth.txt"), result_sources=sources)
    findings = [finding_of(one, name, Yardstick()) for name in one.results]
    for report in (report_of(findings, Yardstick()), report_of(findings[:1], Yardstick())):
        texts = "".join(Reader(page_of(report, {})).texts)
        known = ", recording lane|0, 100 frames, 12.5 frames per second, tracker flow"
        assert texts.count(f"first<b>/one.h5{known}") == 1
        assert texts.count("a/truth.txt") == len(report.findings)
    text = markdown_of(report_of(findings, Yardstick()))
    assert "- Result: better/one.h5, recording lane\\|0, 100 frames" in text
    assert "- Truth: a/truth.txt" in text
    told = finding_data(findings[1])["sources"]
    assert (told["result"]["tracker"], told["truth"]["path"]) == ("flow", "a/truth.txt")
    assert told["truth"]["recording"] is None


def test_kept_is_said_to_count_from_the_first_match_on() -> None:
    assert "half of their frames from the first match on" in page_of(scenes.report(), {})


@pytest.mark.parametrize(
    ("true", "found", "why"),
    [
        ([], [], "Neither the ground truth nor the result has anybody in these frames"),
        ([], range(20), "The ground truth has nobody in these frames"),
        (range(20), [], "The result has nobody in these frames"),
        (range(20), range(30, 40), "those of the ground truth stand in frames 100 to 119"),
        (range(20), range(-20, 0), "No row of the result matches one of the ground truth"),
        (range(20), range(20), None),
    ],
)
def test_page_and_markdown_say_why_there_are_dashes(true, found, why) -> None:
    beside = 9.0 if found and found[0] < 0 else 1.0
    rows = scenes.standing(1, [abs(frame) for frame in found], beside, 1)
    truth, result = scenes.table(scenes.standing(1, true, 1, 1)), scenes.table(rows)
    one = Subject("s", truth, {"r": result}, scenes.START, scenes.START + scenes.FRAMES)
    told = report_of([finding_of(one, "r", Yardstick())], Yardstick())
    page, marked = " ".join(Reader(page_of(told, {})).texts), markdown_of(told)
    for text in (page, marked.replace("\\", "")):
        assert ("0 or a dash" in text) == (why is not None)
        assert why is None or why in text
        assert text.count("in these frames:") <= 1
