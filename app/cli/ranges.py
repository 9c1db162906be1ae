"""Ranges of frames as they are typed: A:B, from 0, B not included."""

from __future__ import annotations

import re

from tracking.errors import SettingsError

_MOST_DIGITS = 9  # of a frame number: what is longer lies beyond every recording
ANY_END = 10**_MOST_DIGITS
"""Behind every frame there can be."""


def parse_range(
    text: str | None, count: int | None, option: str = "--frames"
) -> tuple[int, int] | None:
    """A:B as numbers; either may be left out. None where nothing was typed.

    Args:
        count: of the frames there are; stands for B where that is left out. None: nobody knows.
        option: which it was typed for.

    Raises:
        SettingsError: it is no such text, lies where no frame can be, or B is not above A.
    """
    if text is None:
        return None
    found = re.fullmatch(r"\s*(-?\d*)\s*:\s*(-?\d*)\s*", text, re.ASCII)
    if found is None:
        raise SettingsError(
            "frames {text!r} are not A:B, e.g. {flag} 100:400", text=text, flag=option
        )
    start, stop = found.groups()
    if "-" in start + stop or max(len(start), len(stop)) > _MOST_DIGITS:
        if count is None:
            raise SettingsError(
                "{flag} {text}: frames count from 0 and have at most {most} digits",
                flag=option,
                text=text.strip(),
                most=_MOST_DIGITS,
            )
        raise SettingsError(
            "frames {text} are not all there: choose a range within 0:{count}",
            text=text.strip(),
            count=count,
        )
    if stop and int(stop) <= int(start or 0):
        raise SettingsError(
            "{flag} {text} holds no frames; name them as A:B with A below B",
            flag=option,
            text=text.strip(),
        )
    return int(start or 0), int(stop or (ANY_END if count is None else count))
