from collections.abc import Iterator

import pytest

from app.core import i18n
from tracking.translation import joined, msg

STOP = "\N{IDEOGRAPHIC FULL STOP}"


def test_places_in_a_text_are_filled():
    assert i18n.tr("Swap {a} with...", a=4) == "Swap 4 with..."


def test_times_are_said_as_on_a_clock():
    assert i18n.time_text(41.7) == "00:41.70"
    assert i18n.time_text(3725.5) == "1:02:05.50"


def test_a_stretch_is_said_by_both_its_ends_and_one_frame_by_its_time():
    assert i18n.span_text(16.25, 16.3) == "00:16.25 to 00:16.30"
    assert i18n.span_text(16.25, 16.25) == "00:16.25"


@pytest.mark.parametrize(("count", "said"), [(0, "0 frames"), (1, "1 frame"), (2, "2 frames")])
def test_one_is_not_said_in_the_plural(count, said):
    assert i18n.count_text(count, "{n} frame", "{n} frames") == said


@pytest.mark.parametrize(
    ("message", "said"),
    [
        (msg("floor: {count} points", count=3), "Floor: 3 points."),
        (msg("{path}: no video", path="a.mp4"), "a.mp4: no video."),
        (joined("; ", (msg("{path}: no video", path="a.mp4"), "look")), "a.mp4: no video; look."),
        (joined("; ", (msg("the board is blurred"), msg("go on"))), "The board is blurred; go on."),
        (msg("already a sentence."), "Already a sentence."),
        (msg("with {braces}", braces="{x}"), "With {x}."),
        ("plain words", "Plain words."),
        (msg(""), ""),
    ],
)
def test_a_sentence_begins_with_a_capital_but_a_name_stays_as_it_is(message, said):
    assert i18n.sentence(message) == said


@pytest.fixture
def japanese() -> Iterator[None]:
    i18n.use_language("ja")
    yield
    i18n.use_language("en")


@pytest.mark.usefixtures("japanese")
@pytest.mark.parametrize(
    "message", [msg("floor: {count} points", count=3), joined("", ("ab" + STOP,))]
)
def test_a_sentence_ends_with_the_full_stop_of_its_language(message):
    text = i18n.sentence(message)
    assert text.count(STOP) == 1
    assert text.endswith(STOP)
    assert i18n.strip_full_stop(text) == text.removesuffix(STOP)
