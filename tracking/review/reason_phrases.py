"""Reasons as messages, and what would put them right."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from tracking.review.core.evidence import BODY_M
from tracking.tracks import PART_NAMES
from tracking.translation import N_, Message, all_of, msg


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
            "", N_("{a} and {b} look like each other from {time} on: their colours swapped")
        ),
        "turn": Words(
            "", N_("{a} goes on as {b} was walking and {b} as {a}, {way} off, at {time}")
        ),
        "crossing": Words("", N_("{a} and {b} passed within {way} at {time}")),
        "shared": Words("", N_("{a} and {b} were seen as one for {figure:.1f} s until {time}")),
        "lost": Words(
            "",
            N_("{a} ends in the middle of the {ground}, and {b} begins near it at {time}"),
            fix_two="merge",
        ),
        "ended": Words(
            N_("{a} ends in the middle of the {ground} at {time}"),
            N_("{a} ends in the middle of the {ground} at {time}, beside {b}"),
            fix_two="look",
        ),
        "begun": Words(
            N_("{a} begins in the middle of the {ground} at {time}"),
            N_("{a} begins in the middle of the {ground} at {time}, beside {b}"),
            fix_two="look",
        ),
        "colour": Words(N_("{a} has other colours from {time} on"), fix_one="split"),
        "height": Words(
            N_("the height of {a} changes by {figure:.2f} m at {time}"), fix_one="split"
        ),
        "jump": Words(N_("{a} jumps by {way} at {time}"), fix_one="split"),
        "reversal": Words(N_("{a} turns back at {way}/s, half hidden, at {time}"), fix_one="split"),
        "predicted": Words(
            N_("{a} was out of sight for {figure:.1f} s and is seen again at {time}"),
            N_("{a} was out of sight for {figure:.1f} s and is seen again at {time}, beside {b}"),
            fix_one="split",
        ),
        "drift": Words(
            N_("{a} is not seen any more from {time} on and goes on for {figure:.1f} s"),
            fix_one="delete",
        ),
        "margin": Words(
            N_("another choice for {a} would have been nearly as good at {time}"),
            N_("another choice for {a} would have been nearly as good at {time}, beside {b}"),
        ),
        "spread": Words(N_("the particles of {a} spread over {way} at {time}")),
        "split": Words(N_("the particles of {a} fall in two at {time}")),
        "part": Words(N_("the {parts} of {a} failed at {time}")),
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
) -> Message:
    """A reason as a sentence, e.g. "4 and 7 passed within 0.3 m at 00:41".

    Where the floor is not known (`on_floor`), ways are said in body heights: see `Evidence.place`.
    Of a moment that is not the very one it is said that it is `about` then.
    """
    words = WORDS[kind]
    return msg(
        words.two if second else words.one,
        a=first,
        b=second,
        figure=figure,
        way=msg("{metres:.1f} m", metres=figure)
        if on_floor
        else msg("{heights:.1f} body heights", heights=figure / BODY_M),
        ground=msg("floor") if on_floor else msg("image"),
        time=msg("about {time}", time=clock(seconds)) if about else clock(seconds),
        parts=_parts(int(figure)) if kind == "part" else "",
    )


def _parts(which: int) -> Message:
    """The parts of a sum of 1 head, 2 torso, 4 hip-leg: "head", "head, torso and hip-leg"."""
    return all_of([msg(name) for part, name in enumerate(PART_NAMES) if which >> part & 1])


def fix(kind: str, second: int) -> str:
    """What would put it right: "swap", "split", "merge", "delete" or "look"."""
    words = WORDS[kind]
    return words.fix_two if second else words.fix_one


def clock(seconds: float) -> str:
    """Minutes, seconds and hundredths, as rows of the queue say them: "00:41.75"; with hours."""
    minutes, hundredths = divmod(round(100 * seconds), 6000)
    hours, minute = divmod(minutes, 60)
    text = f"{minute:02}:{hundredths // 100:02}.{hundredths % 100:02}"
    return f"{hours}:{text}" if hours else text
