"""One field of a settings dataclass: its default with unit, range and help."""

from __future__ import annotations

import dataclasses
from typing import Any, Final

RESULT: Final = "Result"
"""The group of settings that say in which form a result comes."""


def setting(
    default: Any,
    unit: str,
    allowed: tuple[float, float] | None,
    about: str,
    *,
    odd: bool = False,
    formerly: tuple[str, ...] = (),
    group: str = RESULT,
) -> Any:
    """A dataclass field with its description, from which form, command line and checks are made.

    Args:
        default: in force where nothing else is asked for.
        unit: "" for a pure number.
        allowed: lowest and highest value; None where any will do.
        about: one line.
        odd: whether even numbers are refused.
        formerly: names it had in earlier versions, without the stage. Sessions that were made
            with them are read under the present name; who types one is told the present one.
        group: the heading it stands under among the settings of its tracker.
    """
    about_it = {"unit": unit, "range": allowed, "help": about, "odd": odd, "formerly": formerly}
    about_it["group"] = group
    return dataclasses.field(default=default, metadata=about_it)
