"""Loading one offer: imported, checked, and given up on where it hangs."""

from __future__ import annotations

import importlib
from typing import Any, Final

from tracking.plugins.blame import accused
from tracking.plugins.offers import Offer
from tracking.plugins.time_limit import in_time

LOAD_S: Final = 20.0
"""A plug-in that takes longer to import is given up on; torch takes 5 s from a slow disk."""


def load(offer: Offer, wanted: tuple[type, ...]) -> Any:
    """What an offer leads to.

    Args:
        wanted: the types that it may be of.

    Raises PluginError where a plug-in cannot be imported in time, or is nothing of the kind; what
    is built in raises as it is.
    """
    value = offer.value
    if value is None:
        value = (
            _imported(offer) if offer.built_in else in_time(lambda: _imported(offer), offer, LOAD_S)
        )
    if not isinstance(value, wanted):
        raise accused(
            offer,
            "{target} is {found}, and should be {wanted}",
            target=offer.target,
            found=type(value).__name__,
            wanted=" | ".join(one.__name__ for one in wanted),
        )
    if (name := getattr(value, "name", offer.name)) != offer.name:
        raise accused(
            offer, "its entry point says {offered}, it calls itself {name}",
            offered=offer.name, name=name,
        )  # fmt: skip
    return value


def _imported(offer: Offer) -> Any:
    module, _, attribute = offer.target.partition(":")
    value = importlib.import_module(module)
    for name in filter(None, attribute.split(".")):
        value = getattr(value, name)
    return value
