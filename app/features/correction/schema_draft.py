"""A schema while it is edited: what each attribute was before, and what becomes of its values."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from app.core.i18n import count_text, tr
from tracking.editing import SchemaChange
from tracking.errors import EditError
from tracking.tracks import (
    Attribute,
    AttributeType,
    Labels,
    Schema,
    check_schema,
    label_as_stored,
    unfit_values,
)


@dataclass(frozen=True, slots=True)
class DraftRow:
    """An attribute as it is to be; old: as it is in the session, None for a new one."""

    attribute: Attribute
    old: Attribute | None = None


class SchemaDraft:
    """Attributes in an order, and what was removed."""

    def __init__(self, labels: Labels) -> None:
        """The schema of a session, to be changed."""
        self._labels = labels
        self.rows = [DraftRow(one, one) for one in labels.schema]

    def add(self) -> int:
        """A new attribute at the end; its place."""
        names = {row.attribute.name for row in self.rows}
        numbers = iter(range(1, len(names) + 2))
        name = next(new for number in numbers if (new := f"attribute {number}") not in names)
        self.rows.append(DraftRow(Attribute(name)))
        return len(self.rows) - 1

    def remove(self, at: int) -> None:
        """Without an attribute."""
        del self.rows[at]

    def move(self, at: int, by: int) -> int:
        """An attribute further up (-1) or down; its new place."""
        to = min(max(at + by, 0), len(self.rows) - 1)
        self.rows.insert(to, self.rows.pop(at))
        return to

    def put(self, at: int, attribute: Attribute) -> None:
        """Another attribute in the place of one."""
        self.rows[at] = replace(self.rows[at], attribute=attribute)

    def take(self, schema: Schema) -> None:
        """Another schema; attributes of the same names are the ones there were."""
        old = {one.name: one for one in self._labels.schema}
        self.rows = [DraftRow(one, old.get(one.name)) for one in schema]

    @property
    def schema(self) -> Schema:
        """As it is to be."""
        return tuple(row.attribute for row in self.rows)

    @property
    def wanted(self) -> SchemaChange:
        """The edit."""
        renamed = {row.old.name: row.attribute.name for row in self.rows if row.old is not None}
        renamed = {old: new for old, new in renamed.items() if old != new}
        choices = {row.attribute.name: dict(_renamed_choices(row)) for row in self.rows}
        return SchemaChange(
            self.schema, renamed, {name: pairs for name, pairs in choices.items() if pairs}
        )

    @property
    def is_changed(self) -> bool:
        """Whether it is another schema than the session's."""
        return self.schema != self._labels.schema

    def why_not(self) -> str:
        """Why it cannot be taken; "" where it can."""
        try:
            check_schema(self.schema)
        except EditError as error:
            return tr(error.message)
        return ""

    def effects(self) -> tuple[str, ...]:
        """What becomes of values that people have, a line each."""
        wanted = self.wanted
        kept = {row.old.name for row in self.rows if row.old is not None}
        lines = []
        for one in self._labels.schema:
            count = self._count(one.name)
            if one.name in wanted.renamed:
                lines.append(_values(count, wanted.renamed[one.name], one.name))
            elif one.name not in kept and count:
                lines.append(
                    count_text(
                        count,
                        "{name} is removed: {n} person keeps it as an attribute of their own.",
                        "{name} is removed: {n} people keep it as an attribute of their own.",
                        name=one.name,
                    )
                )
        for name, pairs in wanted.choices.items():
            lines += [
                tr("{name}: {old} becomes {new}.", name=name, old=old, new=new)
                for old, new in pairs.items()
            ]
        return (*lines, *self._unfit(wanted))

    def _count(self, name: str) -> int:
        return sum(name in label.attributes for label in self._labels.tracks.values())

    def _unfit(self, wanted: SchemaChange) -> Iterator[str]:
        """Values that will not suit."""
        after = {}
        for track, label in self._labels.tracks.items():
            values = {}
            for key, value in label.attributes.items():
                name = wanted.renamed.get(key, key)
                values[name] = wanted.choices.get(name, {}).get(value, value)
            after[track] = label_as_stored(wanted.schema, replace(label, attributes=values))
        yield from map(tr, unfit_values(wanted.schema, after))


def _values(count: int, new: str, old: str) -> str:
    return count_text(
        count,
        "{old} becomes {new}, with the value of {n} person.",
        "{old} becomes {new}, with the values of {n} people.",
        old=old,
        new=new,
    )


def _renamed_choices(row: DraftRow) -> Iterator[tuple[str, str]]:
    """Choices that stand in the place of another one: both are new there, or gone."""
    old, new = row.old, row.attribute
    if old is None or old.type is not AttributeType.CHOICE or new.type is not old.type:
        return
    if len(old.choices) != len(new.choices):
        return
    for before, after in zip(old.choices, new.choices, strict=True):
        if before not in new.choices and after not in old.choices:
            yield before, after
