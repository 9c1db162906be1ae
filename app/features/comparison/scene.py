"""Another person's session beside the open one, as the views show it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class DisagreementRow:
    """A stretch in which both sessions say something else.

    Attributes:
        text: what, e.g. "4 here, 7 (your 5) there". when: from where to where.
        frame: where to look. track: of the open session, 0: nobody there.
    """

    text: str
    when: str
    frame: int
    track: int


@dataclass(frozen=True, slots=True)
class AgreementScene:
    """The panel: how far two sessions agree, and where they do not.

    Attributes:
        title: whose session. figures: IDF1 and kappa in words.
        outdated: the open session was changed after it was compared.
    """

    title: str
    figures: str
    rows: tuple[DisagreementRow, ...]
    outdated: bool = False
