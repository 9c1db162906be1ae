"""The public face of the library: frozen, cheap to import, and as its page says."""

from __future__ import annotations

import inspect
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import tracking
from tests import library_page
from tracking.synthesis import render_recording
from tracking.tracks import TrackTable

ROOT = Path(__file__).parents[2]
GOLDEN = ROOT / "tests" / "golden" / "library.txt"


@pytest.fixture(scope="module")
def lobby(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A rendered recording of its name, with truth."""
    folder = tmp_path_factory.mktemp("library") / "lobby"
    return render_recording(folder, "lobby", 6.0, 3, 5, size=(320, 240), fps=10.0)


@pytest.fixture(scope="module")
def session(lobby: Path) -> tracking.Session:
    """Tracked, and never saved."""
    return tracking.track(str(lobby), "stereo-joint", settings={"particles": 60})


def test_the_signatures_of_the_library_stay_as_they_are() -> None:
    assert library_page.signatures() == GOLDEN.read_text(encoding="utf-8"), (
        "the public face changed; where that is meant: python -m tests.library_page"
    )


def test_the_reference_is_what_the_docstrings_say() -> None:
    written = library_page.PAGE.read_text(encoding="utf-8")
    assert library_page.page(written) == written, "python -m tests.library_page"


def test_type_checkers_are_told_of_every_public_name() -> None:
    stub = (ROOT / "tracking" / "__init__.pyi").read_text(encoding="utf-8")
    assert set(re.findall(r" as (\w+)$", stub, re.MULTILINE)) == set(tracking.__all__)
    assert (ROOT / "tracking" / "py.typed").is_file()


@pytest.mark.parametrize("name", tracking.__all__)
def test_every_public_name_has_a_docstring_and_leads_somewhere(name: str) -> None:
    assert inspect.getdoc(getattr(tracking, name))
    assert name in dir(tracking)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        tracking.nothing  # type: ignore[attr-defined] # noqa: B018


def test_importing_the_library_imports_none_of_its_libraries() -> None:
    heavy = ("numpy", "cv2", "h5py", "scipy", "sklearn", "av", "PySide6", "pandas", "jinja2")
    code = f"import sys, tracking; print([name for name in {heavy} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_the_examples_of_the_page_run(
    lobby: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "lobby").symlink_to(lobby)
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
    examples = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    assert len(examples) == 2
    assert len(examples[0].strip().splitlines()) <= 10
    names: dict[str, object] = {}
    for example in examples:
        exec(compile(example, "docs/library.md", "exec"), names)
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_file()) == [
        "lobby.h5",
        "paths.svg",
        "tracks.txt",
    ]


def test_paths_may_be_texts_and_paths(lobby: Path) -> None:
    for path in (lobby, str(lobby)):
        with tracking.open_recording(path) as recording:
            assert recording.frame_count == 60


def test_a_session_is_scored_against_the_truth_beside_its_recording(
    lobby: Path, session: tracking.Session
) -> None:
    whole = tracking.score(session, lobby)
    assert whole.as_json()["truth_people"] == 3
    assert whole.as_json()["MOTA"] > 0.5
    perfect = tracking.score(lobby / "truth.txt", str(lobby), match="floor")
    assert perfect.as_json()["MOTA"] == 1.0


def test_tracks_are_scored_however_they_are_held(session: tracking.Session) -> None:
    held = (session, session.runs[0], TrackTable(session.runs[0].tracks))
    scores = [tracking.score(each, session).as_json()["IDF1"] for each in held]
    assert scores == [1.0, 1.0, 1.0]


def test_an_edit_is_logged_and_undone(session: tracking.Session) -> None:
    before = session.tracks.columns()["track"].copy()
    first, second = sorted(session.tracks.track_ids)[:2]
    entry = tracking.edit(session, "swap", first, second, start=20)
    assert entry.author
    assert not np.array_equal(session.tracks.columns()["track"], before)
    session.undo()
    np.testing.assert_array_equal(session.tracks.columns()["track"], before)


EDITS = {
    "split": lambda one, _other, frame: (one, frame),
    "delete": lambda one, _other, frame: (one, frame, frame + 5),
    "rename": lambda one, _other, _frame: (one, "Ann"),
    "mark-reviewed": lambda one, _other, frame: (one, frame, frame + 5),
}


@pytest.mark.parametrize("kind", EDITS)
def test_every_kind_of_edit_is_made_and_undone(session: tracking.Session, kind: str) -> None:
    one, other = sorted(session.tracks.track_ids)[:2]
    start, stop = session.tracks.frame_range(one)
    done = len(session.history)
    tracking.edit(session, kind, *EDITS[kind](one, other, (start + stop) // 2))
    assert len(session.history) == done + 1
    session.undo()


@pytest.mark.parametrize(
    ("what", "said"),
    [
        (("sway", 1, 2), "edit 'sway' is unknown; choose one of: swap"),
        (("swap", 1), "edit 'swap': plan_swap"),
        (("split", 99, 5), "99"),
    ],
)
def test_an_edit_that_cannot_be_made_is_told_in_one_line(
    session: tracking.Session, what: tuple[object, ...], said: str
) -> None:
    with pytest.raises(tracking.TrackwrightError) as caught:
        tracking.edit(session, *what)  # type: ignore[arg-type]
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_an_export_replaces_nothing_unless_told(session: tracking.Session, tmp_path: Path) -> None:
    place = tmp_path / "tracks.csv"
    assert tracking.export(session, place, "csv") == (place,)
    with pytest.raises(tracking.TrackwrightError, match="is there already"):
        tracking.export(session, place, "csv")
    assert tracking.export(session, str(place), "csv", run=0, replace=True) == (place,)
    with pytest.raises(tracking.TrackwrightError, match="format 'word' is unknown"):
        tracking.export(session, tmp_path / "t", "word")


def test_tracks_become_a_data_frame(session: tracking.Session, lobby: Path) -> None:
    frame = tracking.to_pandas(session)
    assert len(frame) == len(session.tracks.columns()["frame"])
    assert set(frame["track"]) == set(session.tracks.track_ids)
    assert tracking.to_pandas(lobby)["track"].nunique() == 3


def test_a_missing_pandas_is_told_with_its_cure(
    session: tracking.Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(tracking.TrackwrightError, match=r"pip install \"trackwright\[pandas\]\""):
        tracking.to_pandas(session)


def test_progress_is_told_frame_by_frame(lobby: Path) -> None:
    told: list[tuple[int, int]] = []
    tracking.track(
        lobby, "three-part", frames=(5, 9), progress=lambda done, total: told.append((done, total))
    )
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4)]


def test_a_session_is_read_without_claiming_it(session: tracking.Session, tmp_path: Path) -> None:
    place = tmp_path / "s.h5"
    copy = tracking.export(session, tmp_path / "t.txt", "mot")
    assert copy
    session.save(place)
    looked = tracking.read_session(str(place), read_only=True)
    assert looked.read_only
    looked.close()


def test_a_picture_of_paths_is_svg_with_every_track(session: tracking.Session) -> None:
    import xml.etree.ElementTree as ET

    drawn = ET.fromstring(tracking.plot(session).svg)
    lines = [one for one in drawn.iter() if one.tag.endswith("polyline")]
    assert len(lines) == len(session.tracks.track_ids)
