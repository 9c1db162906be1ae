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
) -> Any:
    """A dataclass field with its description, from which form, command line and checks are made.

    Args:
        default: in force where nothing else is asked for.
        unit: "" for a pure number.
        allowed: lowest and highest value; None where any will do.
        about: one line.
        odd: whether even numbers are refused.
    """
    return dataclasses.field(
        default=default, metadata={"unit": unit, "range": allowed, "help": about, "odd": odd}
    )
