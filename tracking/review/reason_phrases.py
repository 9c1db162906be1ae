"""Reasons in words, and what would put them right."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from tracking.review.core.evidence import BODY_M
from tracking.tracks import PART_NAMES


@dataclass(frozen=True, slots=True)
class Words:
    """How a kind of reason is said.

    Attributes:
        one, two: sentences about one track (a) and about two (a, b); they may name `figure`, the
            `time` and the body `parts`.
        fix_one, fix_two: what usually puts it right; see `ReviewItem.fix`.
    """

    one: str
    two: str = ""
    fix_one: str = "look"
    fix_two: str = "swap"


WORDS: Mapping[str, Words] = MappingProxyType(
    {
        "exchange": Words(
            "", "{a} and {b} look like each other from {time} on: their colours swapped"
        ),
        "turn": Words("", "{a} goes on as {b} was walking and {b} as {a}, {way} off, at {time}"),
        "crossing": Words("", "{a} and {b} passed within {way} at {time}"),
        "shared": Words("", "{a} and {b} were seen as one for {figure:.1f} s until {time}"),
        "lost": Words(
            "",
            "{a} ends in the middle of the {ground}, and {b} begins near it at {time}",
            fix_two="merge",
        ),
        "ended": Words(
            "{a} ends in the middle of the {ground} at {time}",
            "{a} ends in the middle of the {ground} at {time}, beside {b}",
            fix_two="look",
        ),
        "begun": Words(
            "{a} begins in the middle of the {ground} at {time}",
            "{a} begins in the middle of the {ground} at {time}, beside {b}",
            fix_two="look",
        ),
        "colour": Words("{a} has other colours from {time} on", fix_one="split"),
        "height": Words("the height of {a} changes by {figure:.2f} m at {time}", fix_one="split"),
        "jump": Words("{a} jumps by {way} at {time}", fix_one="split"),
        "reversal": Words("{a} turns back at {way}/s, half hidden, at {time}", fix_one="split"),
        "predicted": Words(
            "{a} was out of sight for {figure:.1f} s and is seen again at {time}",
            "{a} was out of sight for {figure:.1f} s and is seen again at {time}, beside {b}",
            fix_one="split",
        ),
        "drift": Words(
            "{a} is not seen any more from {time} on and goes on for {figure:.1f} s",
            fix_one="delete",
        ),
        "margin": Words(
            "another choice for {a} would have been nearly as good at {time}",
            "another choice for {a} would have been nearly as good at {time}, beside {b}",
        ),
        "spread": Words("the particles of {a} spread over {way} at {time}"),
        "split": Words("the particles of {a} fall in two at {time}"),
        "part": Words("the {parts} of {a} failed at {time}"),
    }
)
"""By kind of reason."""

KINDS = tuple(WORDS)
"""All kinds of review items there are."""


def sentence(
    kind: str,
    first: int,
    second: int,
    figure: float,
    seconds: float,
    *,
    on_floor: bool = True,
    about: bool = False,
) -> str:
    """A reason as a sentence, e.g. "4 and 7 passed within 0.3 m at 00:41".

    Where the floor is not known (`on_floor`), ways are said in body heights: see `Evidence.place`.
    Of a moment that is not the very one it is said that it is `about` then.
    """
    words = WORDS[kind]
    said = words.two if second else words.one
    parts = _parts(int(figure)) if kind == "part" else ""
    way = f"{figure:.1f} m" if on_floor else f"{figure / BODY_M:.1f} body heights"
    ground = "floor" if on_floor else "image"
    time = f"about {clock(seconds)}" if about else clock(seconds)
    return said.format(
        a=first, b=second, figure=figure, way=way, ground=ground, time=time, parts=parts
    )


def _parts(which: int) -> str:
    """The parts of a sum of 1 head, 2 torso, 4 hip-leg: "head", "head, torso and hip-leg"."""
    names = [name for part, name in enumerate(PART_NAMES) if which >> part & 1]
    return " and ".join((", ".join(names[:-1]), names[-1]) if len(names) > 1 else names)


def fix(kind: str, second: int) -> str:
    """What would put it right: "swap", "split", "merge", "delete" or "look"."""
    words = WORDS[kind]
    return words.fix_two if second else words.fix_one


def clock(seconds: float) -> str:
    """Minutes and seconds, with hours where there are some: "00:41", "1:02:07"."""
    minutes, second = divmod(int(seconds), 60)
    hours, minute = divmod(minutes, 60)
    return f"{hours}:{minute:02}:{second:02}" if hours else f"{minute:02}:{second:02}"
