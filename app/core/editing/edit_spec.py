"""The declaration of a kind of edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.core.editing.edit_options import EditScope, Option, Way
from app.core.tracks.edit_context import EditContext
from tracking.editing import Change

if TYPE_CHECKING:
    from app.core.editing.flow import EditFlow


@dataclass(frozen=True, slots=True)
class EditCommand:
    """A command that begins an edit of who is selected.

    Attributes:
        id, title, keys, icon, separated: see `Command`. submenu: of the Correct menu.
        scope: how far the edit goes at first; None: the first of its scopes.
        floor: the place of the floor must be known. also: other tools' words for it.
    """

    id: str
    title: str
    keys: tuple[str, ...]
    submenu: str = ""
    icon: str = ""
    separated: bool = False
    scope: EditScope | None = None
    floor: bool = False
    also: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class EditSpec:
    """A kind of edit: everything the program knows of it.

    Attributes:
        name: as review items name what would put them right, e.g. "swap".
        title: in English, before anything is planned; {a} stands for whom it is about.
        plan: the change that Enter applies. Raises EditError where it does not apply.
        scopes: how far it may go; the first is meant unless another is chosen.
        commands: what begins it.
        ways: how it is done, where there is more than one way; one along the floor needs to know
            where that is.
        of_two: it asks for another person, or for another id.
        of_several: it is done to everybody who is selected.
        places: it puts one box or place, which the arrow keys move.
        at_once: it is done without a preview: what it does is seen before.
        leads: whether the playhead goes to the cut when that is put elsewhere; None: where it has
            a cut.
        first, second: what the first and the second key choose between, in place of scopes and
            ways; None: these.
    """

    name: str
    title: str
    plan: Callable[[EditFlow, EditContext], Change]
    scopes: tuple[EditScope, ...]
    commands: tuple[EditCommand, ...] = ()
    ways: tuple[Way, ...] = ()
    of_two: bool = False
    of_several: bool = False
    places: bool = False
    at_once: bool = False
    leads: bool | None = None
    first: tuple[Option, ...] | None = None
    second: tuple[Option, ...] | None = None

    def ways_with(self, *, has_floor: bool) -> tuple[Way, ...]:
        """The ways there are where the place of the floor is known, or is not."""
        return tuple(way for way in self.ways if has_floor or way is not Way.FLOOR)

    def choices(self, *, has_floor: bool) -> tuple[tuple[Option, ...], tuple[Option, ...]]:
        """What the first and the second key choose between."""
        ways = self.ways_with(has_floor=has_floor)
        if self.second is not None:
            return ways, self.second
        return (self.scopes if self.first is None else self.first), ways
