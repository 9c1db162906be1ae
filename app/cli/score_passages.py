"""Counted passages of results against those of the truth, over lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.cli.output import say
from app.cli.score_inputs import LoadedSequence
from app.cli.shape_options import line_of, refuse_repeated
from app.cli.tracks import Tracks
from tracking.counting import Passages, check_countable, compare_passages, passages
from tracking.errors import CountingError
from tracking.scoring import PassageScore, Score
from tracking.tracks import CountingLine
from tracking.translation import msg


def lines_named(floor: Sequence[str], picture: Sequence[str]) -> tuple[CountingLine, ...]:
    """The lines that were typed. Raises BadParameter where something is none."""
    lines = [line_of(text, in_picture=False) for text in floor]
    lines += [line_of(text, in_picture=True) for text in picture]
    refuse_repeated(lines, "line")
    return tuple(lines)


def with_passages(
    score: Score, one: LoadedSequence, result: str, named: Sequence[CountingLine]
) -> Score:
    """The score with how well passages were found, over lines that were named or else drawn.

    Lines drawn in a session over which these tracks cannot be counted are told and left out.

    Raises:
        CountingError: the same of lines that were named, or nobody knows the frames a second.
    """
    lines = tuple(named) or _drawn(one, result)
    if not lines:
        return score
    try:
        return replace(score, passages=_passages(one, result, lines))
    except CountingError as error:
        if named:
            raise
        say(
            msg(
                "note: no passages of {result} on {name}: {error}",
                result=result,
                name=one.subject.name,
                error=error,
            )
        )
        return score


def _drawn(one: LoadedSequence, result: str) -> tuple[CountingLine, ...]:
    """Lines of a session: of the truth's, else of the result's."""
    return one.truth.lines or one.results[result].lines


def _passages(
    one: LoadedSequence, result: str, lines: tuple[CountingLine, ...]
) -> tuple[PassageScore, ...]:
    fps = one.subject.footage.fps
    if fps is None:
        raise CountingError(
            "passages over {name!r} are compared in time, and neither ground truth nor result "
            "states its frames per second; name a session, or put a seqinfo.ini beside a text",
            name=lines[0].name,
        )
    happened = _counted(one, one.truth, lines, fps)
    found = _counted(one, one.results[result], lines, fps)
    hits = [
        compare_passages(found.of_line(number), happened.of_line(number))
        for number in range(len(lines))
    ]
    return tuple(
        PassageScore(line.name, each.happened, each.found, each.hit)
        for line, each in zip(lines, hits, strict=True)
    )


def _counted(
    one: LoadedSequence, tracks: Tracks, lines: tuple[CountingLine, ...], fps: float
) -> Passages:
    """Passages within the frames that are measured."""
    frame = np.asarray(tracks.columns["frame"])
    kept = (frame >= one.subject.start) & (frame < one.subject.stop)
    columns = {name: np.asarray(column)[kept] for name, column in tracks.columns.items()}
    check_countable(columns, lines, ())
    return passages(columns, fps, lines)
