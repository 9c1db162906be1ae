"""One field of a settings dataclass: its default with unit, range and help."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
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
    expert: bool = False,
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
        expert: whether it is shown on request only, as few users have reason to change it.
    """
    about_it = {"unit": unit, "range": allowed, "help": about, "odd": odd, "formerly": formerly}
    about_it |= {"group": group, "expert": expert}
    return dataclasses.field(default=default, metadata=about_it)


def stage(default_factory: Callable[[], Any], unused: tuple[str, ...] = ()) -> Any:
    """A dataclass field that holds the settings of an earlier stage.

    Args:
        default_factory: makes the settings of the stage.
        unused: names of settings of the stage that this tracker does nothing with. They are not
            offered, and refused like those of another tracker.
    """
    return dataclasses.field(default_factory=default_factory, metadata={"unused": unused})
