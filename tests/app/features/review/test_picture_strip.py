"""Small pictures before, at and after a review item's instant, with words for the same."""

import numpy as np
import pytest
from PySide6.QtGui import QColor
from two_people import table as two_people

from app.features.review.strip import StripAsk, StripScene, prepare_strip, strip_frames
from app.features.review.strip_view import StripView
from tracking.errors import CancelledError
from tracking.review import ReviewItem

RED, BLUE = (200, 40, 40), (40, 40, 200)


def _item(frame, start, end):
    return ReviewItem("crossing", (4, 7), frame, start, end, 0.5, 9.0, "", "swap")


def _asked(frames, tracks=(4, 7)):
    labels, colours = ("4 red", "7")[: len(tracks)], (RED, BLUE)[: len(tracks)]
    return StripAsk(tracks, frames, 0, 10.0, labels, colours)


def _picture(frame):
    return np.full((480, 640, 3), min(frame, 255), np.uint8)


def _strip(asked, table):
    return prepare_strip(asked, table, _picture)(lambda *_: None)


def test_frames_are_half_a_second_apart_within_the_stretch_and_the_footage():
    assert strip_frames(_item(50, 20, 90), 10.0, 100) == (45, 50, 55)
    assert strip_frames(_item(50, 48, 52), 10.0, 100) == (48, 50, 51)
    assert strip_frames(_item(50, 50, 51), 10.0, 100) == (49, 50, 51)
    assert strip_frames(_item(0, 0, 5), 10.0, 1) == (0, 0, 0)


def test_each_picture_is_of_its_frame_and_has_the_people_at_their_places():
    table = two_people()
    frames = tuple(int(frame) for frame in table.frames_of_track(4)[[1, 3, 5]])
    scene = _strip(_asked(frames), table)
    assert [int(one.image[0, 0, 0]) for one in scene.pictures] == list(frames)
    for frame, picture in zip(frames, scene.pictures, strict=True):
        rows = table.of_tracks((4, 7), frame, frame + 1)
        assert len(picture.boxes) == len(rows["track"])
        assert {one.colour for one in picture.boxes} <= {RED, BLUE}
        height, width = picture.image.shape[:2]
        assert max(height, width) <= 320
        for one, box_height in zip(picture.boxes, rows["height"].tolist(), strict=True):
            assert one.box[3] > 0
            assert box_height > 0


def test_words_say_who_is_there_and_who_is_not():
    table = two_people()
    end = table.frame_range(4)[1]
    scene = _strip(_asked((end - 1, end - 1, end), (4,)), table)
    first, _, last = scene.text.split("; ")
    assert first.endswith("4 red in sight")
    assert last.endswith("4 red not there")


def test_without_anybody_there_are_no_pictures():
    assert _strip(_asked((5000, 5001, 5002)), two_people()).pictures == ()


def test_work_that_is_not_wanted_any_more_reads_no_further():
    read = []

    def stop(done, _total):
        if done == 1:
            raise CancelledError("stopped by the user")

    table = two_people()
    frame = int(table.frames_of_track(4)[0])
    work = prepare_strip(
        _asked((frame, frame, frame)), table, lambda one: read.append(one) or _picture(one)
    )
    with pytest.raises(CancelledError):
        work(stop)
    assert len(read) == 1


def test_the_view_draws_boxes_in_their_colours_and_tells_screen_readers(qtbot):
    table = two_people()
    frames = tuple(int(frame) for frame in table.frames_of_track(4)[[1, 3, 5]])
    scene = _strip(_asked(frames), table)
    view = StripView(None)
    qtbot.addWidget(view)
    view.resize(360, 120)
    view.show_scene(scene)
    assert view.accessibleDescription() == scene.text
    drawn = view.grab().toImage()
    colours = {
        drawn.pixelColor(x, y).rgb() for x in range(drawn.width()) for y in range(drawn.height())
    }
    assert QColor(*RED).rgb() in colours
    view.show_scene(StripScene())
    assert view.accessibleDescription() == ""
