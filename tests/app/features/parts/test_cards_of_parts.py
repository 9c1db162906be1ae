"""What the tracker and people say of parts, a card a person."""

from app.core.colours.track_colours import TrackColours
from app.core.scenes.labels import PartMark, SuggestedPart
from app.core.scenes.pictured_parts import PartBox, Verdict
from app.features.parts.cards import cards_of

COLOUR_OF = TrackColours().of
BOX = (10.0, 20.0, 8.0, 8.0)
GREY = (128, 128, 128)
HEAD, TORSO = 0, 1


def box(track, part, text, *, failed=False, scored=True):
    return PartBox(track, part, BOX, GREY, failed, False, text, scored=scored)


def mark(track, part, on_part, *, given=True, chosen=False):
    return PartMark(track, part, BOX, GREY, given, on_part, asked=chosen, chosen=chosen)


def texts(card):
    return [line.text for line in card.lines]


def test_verdict_and_label_of_a_part_stand_in_one_line():
    (card,) = cards_of([box(1, HEAD, "head: off, +0.69")], [mark(1, HEAD, True)], 1, COLOUR_OF)
    assert texts(card) == ["head: off, +0.69; labelled on"]


def test_a_guess_that_is_labelled_shows_the_verdict_alone():
    (card,) = cards_of(
        [box(1, HEAD, "head: on, -0.69")],
        [mark(1, HEAD, None, given=False, chosen=True)],
        1,
        COLOUR_OF,
    )
    assert texts(card) == ["head: on, -0.69"]
    assert card.lines[0].chosen


def test_of_others_only_what_people_said_is_told_and_the_selected_one_comes_first():
    boxes = [box(1, HEAD, "head: on, -1.00"), box(2, HEAD, "head: on, -2.00")]
    cards = cards_of(boxes, [mark(1, TORSO, False)], 2, COLOUR_OF)
    assert [card.track for card in cards] == [2, 1]
    assert [card.selected for card in cards] == [True, False]
    assert texts(cards[1]) == ["1 torso: labelled off"]


def test_a_card_says_whose_its_scores_are():
    suggested = SuggestedPart(
        (5, 1, HEAD), "unsure: score +0.01 of mine.h5", "head", "1", GREY, "00:01"
    )
    (card,) = cards_of([box(1, HEAD, "head: on, -1.00")], [], 1, COLOUR_OF, suggested)
    assert "of the run" in card.foot[0]
    assert card.foot[1] == "head: unsure: score +0.01 of mine.h5"
    (unscored,) = cards_of([box(1, HEAD, "head: not judged", scored=False)], [], 1, COLOUR_OF)
    assert unscored.foot == ()


def test_nobody_selected_and_nothing_said_makes_no_card():
    assert cards_of([box(1, HEAD, "head: on, -1.00")], [], 0, COLOUR_OF) == ()


def test_a_verdict_is_told_apart_in_one_word():
    assert box(1, HEAD, "").verdict is Verdict.ON
    assert box(1, HEAD, "", failed=True, scored=False).verdict is Verdict.OFF
    assert box(1, HEAD, "", scored=False).verdict is Verdict.NONE
    assert PartBox(1, HEAD, BOX, GREY, True, True, "").verdict is Verdict.HIDDEN
