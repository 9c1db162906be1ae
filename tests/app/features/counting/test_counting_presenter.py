"""What the counting panel says, of a document without a window."""

from types import SimpleNamespace

import numpy as np
import pytest
from two_people import FRAMES, columns

from app.core.document.document import Document
from app.features.counting.plots import plots_of
from app.features.counting.presenter import CountingPresenter, least_step_s, usual_step_s
from app.features.counting.subject import Length, count_subject
from tracking.counting import CountingLine, Steps, count
from tracking.errors import CancelledError, CountingError
from tracking.recording import open_recording
from tracking.tracks import Labels

FLOOR = CountingLine("door", (0.0, 0.0), (0.0, 9.0))
SCREEN = CountingLine("screen", (300.0, 0.0), (300.0, 400.0), in_picture=True)
BOUNDS = (-5.0, 0.0, 5.0, 9.0)


def _unplaced() -> dict[str, np.ndarray]:
    rows = columns()
    return {**rows, "x": np.full_like(rows["x"], np.nan), "y": np.full_like(rows["y"], np.nan)}


@pytest.fixture
def document(tiny_recording):
    with open_recording(tiny_recording) as recording:
        yield Document(recording, None)


@pytest.fixture
def drawn(document):
    """A presenter of lines that somebody drew, and what changes them."""

    class Drawn(CountingPresenter):
        labels = Labels(lines=(FLOOR, SCREEN))

    presenter = Drawn(document)

    def draw(*lines: CountingLine) -> None:
        Drawn.labels = Labels(lines=lines)

    return SimpleNamespace(presenter=presenter, draw=draw)


def _counted(presenter, rows):
    subject = presenter.current_subject(mapped=False)
    length = Length(20.0, FRAMES, (0, FRAMES))
    return count_subject(subject, lambda: rows, length, BOUNDS, lambda *_: None)


def test_a_line_on_a_floor_nobody_knows_leaves_the_others_their_counts(drawn, document):
    presenter = drawn.presenter
    presenter.take(_counted(presenter, _unplaced()))
    scene = presenter.scene(document.frame_state(0), "")
    door, screen = scene.rows
    alone = count(_unplaced(), 20.0, FRAMES, [SCREEN]).lines[0].totals
    assert screen.cells[:2] == tuple(f"0 of {most}" for most in alone)
    assert door.cells[0] == ""
    assert door.hint == scene.message
    assert "'door' lies on the floor" in scene.message
    presenter.pick(True, "screen")
    assert presenter.scene(document.frame_state(0), "").message == ""
    assert presenter.scene(document.frame_state(0), "").plots


def test_where_people_have_places_both_lines_are_counted(drawn):
    counted = _counted(drawn.presenter, columns())
    assert counted.left_out == ()
    assert [one.line for one in counted.counts.lines] == [FLOOR, SCREEN]


def test_a_refusal_goes_with_what_was_refused(drawn, document):
    presenter = drawn.presenter
    presenter.refuse(presenter.current_subject(mapped=False), CountingError("no such step"))
    assert presenter.scene(document.frame_state(0), "").message == "no such step"
    drawn.draw()
    assert "Draw a counting line" in presenter.scene(document.frame_state(0), "").message


def test_a_bug_is_told_as_one(drawn):
    presenter = drawn.presenter
    presenter.refuse(presenter.current_subject(mapped=False), KeyError("frame"))
    assert presenter.refused.startswith("A bug in trackwright: KeyError")


def test_the_table_shows_no_steps_of_lines_that_are_gone(drawn, document):
    presenter = drawn.presenter
    presenter.take(_counted(presenter, columns()))
    assert presenter.scene(document.frame_state(0), "").counts is not None
    drawn.draw()
    assert presenter.scene(document.frame_state(0), "").counts is None


def test_counting_stops_where_it_is_asked_to(drawn):
    def stop(*_: int) -> None:
        raise CancelledError("stopped")

    length = Length(20.0, FRAMES, (0, FRAMES))
    subject = drawn.presenter.current_subject(mapped=False)
    with pytest.raises(CancelledError):
        count_subject(subject, columns, length, BOUNDS, stop)


@pytest.mark.parametrize("fps", [1.0, 7.5, 24.0, 25.0, 29.97, 30.0, 59.94, 100.0, 120.0, 300.0])
def test_the_shortest_step_that_can_be_chosen_is_one(fps):
    shortest_s = least_step_s(fps)
    assert round(shortest_s, 2) == shortest_s
    assert len(Steps.of(FRAMES, fps, shortest_s)) >= 1  # a shorter one is refused
    assert shortest_s - 0.01 < 1 / fps


@pytest.mark.parametrize(
    ("seconds", "step_s"), [(10, 0.5), (20, 0.5), (65, 2.0), (600, 15.0), (7200, 300.0)]
)
def test_the_usual_step_gives_a_few_dozen_rows_at_most(seconds, step_s):
    assert usual_step_s(25 * seconds, 25.0) == step_s
    assert len(Steps.of(25 * seconds, 25.0, step_s)) <= 42


def test_nothing_is_plotted_beyond_the_frames_that_were_tracked():
    counts = count(columns(), 20.0, FRAMES, [FLOOR])
    for plot in plots_of(counts, 0, FRAMES, (20, 60)):
        for curve in plot.curves:
            assert np.isfinite(curve.values[20:60]).all()
            assert np.isnan(curve.values[:20]).all()
            assert np.isnan(curve.values[60:]).all()
