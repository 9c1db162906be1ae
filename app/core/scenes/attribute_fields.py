"""The attributes of the selected person that the schema knows, as the track panel shows them."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.tracks import Attribute


@dataclass(frozen=True, slots=True)
class AttributeField:
    """One of them.

    Attributes:
        attribute: it. value: what was said; None: nothing, the default is shown.
        used: what was said of others, for completion.
        why: why the value does not suit; "": it does.
        active: the digit keys set it.
    """

    attribute: Attribute
    value: str | None = None
    used: tuple[str, ...] = ()
    why: str = ""
    active: bool = False
