"""What the tracker and people say of parts, a card a person."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from app.core.colours.track_colours import ColourOf
from app.core.i18n import tr
from app.core.scenes import Colour
from app.core.scenes.labels import SAID, PartMark, SuggestedPart
from app.core.scenes.part_names import part_name
from app.core.scenes.pictured_parts import CardLine, PartBox, PartCard, Verdict


def cards_of(
    boxes: Sequence[PartBox],
    marks: Sequence[PartMark],
    selected: int,
    colour_of: ColourOf,
    suggested: SuggestedPart | None = None,
) -> tuple[PartCard, ...]:
    """All that is said of the selected person's parts, and of others, by id, what people said.

    Args:
        boxes: as the tracker had them. marks: as people said, or the guesses that are labelled.
        suggested: the part that is looked at because the detector in use is unsure of it.
    """
    of_selected = [box for box in boxes if box.track == selected]
    labelled = sorted({one.track for one in marks if one.given} - {selected})
    cards = [
        _others(track, colour_of(track), [one for one in marks if one.track == track])
        for track in labelled
    ]
    own = [one for one in marks if one.track == selected]
    lines = _lines(of_selected, own)
    if lines:
        foot = tuple(_foot(of_selected, suggested))
        colour = colour_of(selected)
        cards.insert(0, PartCard(selected, colour, lines, foot, selected=True))
    return tuple(cards)


def _others(track: int, colour: Colour, marks: Iterable[PartMark]) -> PartCard:
    given = sorted((one for one in marks if one.given), key=lambda one: one.part)
    lines = tuple(
        CardLine(one.part, f"{track} {_text(None, one)}", Verdict.NONE, one.box) for one in given
    )
    return PartCard(track, colour, lines)


def _lines(boxes: Sequence[PartBox], marks: Sequence[PartMark]) -> tuple[CardLine, ...]:
    seen = {box.part: box for box in boxes}
    said = {mark.part: mark for mark in marks}
    return tuple(_line(seen.get(part), said.get(part)) for part in sorted({*seen, *said}))


def _line(box: PartBox | None, mark: PartMark | None) -> CardLine:
    verdict = box.verdict if box is not None else Verdict.NONE
    at = mark or box
    assert at is not None
    chosen = any(one.chosen for one in (box, mark) if one is not None)
    return CardLine(at.part, _text(box, mark), verdict, at.box, chosen)


def _text(box: PartBox | None, mark: PartMark | None) -> str:
    """The tracker's words, then a person's."""
    label = None
    if mark is not None and mark.given:
        label = tr("labelled {said}", said=tr(SAID[mark.on_part]))
    if box is not None:
        return f"{box.text}; {label}" if label else box.text
    name = part_name(mark.part) if mark is not None else ""
    return f"{name}: {label}" if label else name


def _foot(boxes: Sequence[PartBox], suggested: SuggestedPart | None) -> Iterable[str]:
    """Whose the scores are: a detector chosen since may say something else."""
    if any(box.scored for box in boxes):
        yield tr("score of the run, above 0: off")
    if suggested is not None:
        yield f"{suggested.title}: {tr(suggested.reason)}"
