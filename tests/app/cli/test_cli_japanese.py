"""The command line in Japanese: help, messages, figures, pages."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.text_columns import columns_of
from tracking.translation import forget_asked_language, use_catalogue

_KANA = re.compile(r"[\u3041-\u30ff\u4e00-\u9fff]")


@pytest.fixture(autouse=True)
def language_of_others() -> Iterator[None]:
    """What a command line asked for holds for no other test."""
    before = os.environ["LANGUAGE"]
    yield
    os.environ["LANGUAGE"] = before
    forget_asked_language()
    use_catalogue(None)


@pytest.mark.parametrize("asked", [("--language", "ja"), ("--language=ja",)])
def test_help_is_japanese_wherever_the_option_stands(trackwright: Trackwright, asked) -> None:
    first = trackwright(*asked, "score", "--help")
    assert first == trackwright("score", "--help", *asked)
    status, page, _ = first
    assert status == 0
    assert "使い方" in page or "使用法" in page
    assert "正解データ" in page


def test_lines_of_help_fit_the_terminal(trackwright: Trackwright) -> None:
    for command in ((), ("score",), ("track",), ("setup",)):
        page = trackwright("--language", "ja", *command, "--help")[1]
        wide = [line for line in page.splitlines() if _KANA.search(line)]
        assert len(wide) > 5
        assert [line for line in wide if columns_of(line) > 80] == []


def test_errors_and_misuse_are_told_in_japanese(trackwright: Trackwright) -> None:
    status, _, err = trackwright("--language", "ja", "info", "nothing-here")
    assert status == 1
    assert _KANA.search(err)
    assert "nothing-here" in err
    assert err.count("\n") == 1
    status, _, err = trackwright("--language", "ja", "track", "--nix")
    assert status == 2
    assert _KANA.search(err)


def test_an_unknown_language_is_refused_in_a_line(trackwright: Trackwright) -> None:
    for words in (("--language", "xx", "trackers"), ("--language",)):
        status, out, err = trackwright(*words)
        assert (status, out) == (2, "")
        assert "en, ja" in err
        assert err.count("\n") == 1


def test_a_file_may_be_named_like_the_option(trackwright: Trackwright) -> None:
    _, _, err = trackwright("info", "--", "--language")
    assert "--language" in err
    assert not _KANA.search(err)


def test_english_is_had_over_the_environment(trackwright: Trackwright, monkeypatch) -> None:
    monkeypatch.setenv("LANGUAGE", "ja")
    assert not _KANA.search(trackwright("--language", "en", "--help")[1])


def test_what_is_measured_is_told_in_columns(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    rows = trackwright("--language", "ja", "info", footage)[1].splitlines()
    named = [re.match(r"(\S+(?: \S+)*)  +(?=\S)", line) for line in rows]
    begins = {columns_of(found[0]) for found in named if found is not None}
    assert len(begins) == 1
    said = trackwright("--language", "ja", "score", session, "--truth", footage)[1]
    assert _KANA.search(said)
    same = json.loads(trackwright("--language", "ja", "info", footage, "--json")[1])
    assert same == json.loads(trackwright("--language", "en", "info", footage, "--json")[1])


def test_a_score_report_is_japanese(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path
) -> None:
    out = tmp_path / "report"
    status, _, err = trackwright(
        "--language", "ja", "score", session, "--truth", footage, "--report", out
    )
    assert (status, err) == (0, err)
    (page, *_) = out.glob("*.html")
    text = page.read_text(encoding="utf-8")
    assert '<html lang="ja"' in text
    assert "IDスイッチ" in text
