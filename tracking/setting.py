"""One field of a settings dataclass: its default with unit, range and help."""

from __future__ import annotations

import dataclasses
from typing import Any


def setting(
    default: Any,
    unit: str,
    allowed: tuple[float, float] | None,
    about: str,
    *,
    odd: bool = False,
    formerly: tuple[str, ...] = (),
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
    """
    about_it = {"unit": unit, "range": allowed, "help": about, "odd": odd, "formerly": formerly}
    return dataclasses.field(default=default, metadata=about_it)
