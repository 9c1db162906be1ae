"""Every dialog, panel, page, question and edit is in a snapshot, and snapshots are made."""

import json

import pytest

from tests.pictures.snapshots import __main__ as snapshots
from tests.pictures.snapshots.catalogue import SNAPSHOTS, uncovered, unknown


def test_every_dialog_panel_page_question_and_edit_has_a_snapshot():
    assert list(uncovered()) == []


def test_snapshots_cover_what_there_is():
    assert list(unknown()) == []


def test_no_two_snapshots_have_one_name():
    names = [f"{one.group}-{one.name}" for one in SNAPSHOTS]
    assert len(names) == len(set(names))


@pytest.mark.slow
def test_the_first_page_is_pictured_in_both_looks_at_200_percent_in_japanese(qapp, tmp_path):
    picture = "pages-welcome-without-recordings"
    asked = [str(tmp_path), "--bare", "--settings", "ja-200", "--only", picture]
    assert snapshots.main(asked) == 0
    folder = tmp_path / "ja-200"
    assert {path.name for path in folder.glob("*.png")} == {
        f"{picture}-{look}.png" for look in ("light", "dark")
    }
    assert json.loads((folder / "record.json").read_text())["failed"] == {}
    assert "ja-200/sheets/pages-1.png" in (tmp_path / "index.html").read_text()
