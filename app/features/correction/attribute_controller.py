"""What people's attributes are: values of the schema's, which of them the digit keys set."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QLineEdit, QPlainTextEdit, QWidget

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.i18n import tr
from app.core.keymap import key_or_title
from app.core.scenes import TrackCard
from app.core.scenes.attribute_fields import AttributeField
from app.core.widgets.user_settings import UserSettings
from app.features.correction.controller import EditController
from app.features.correction.schema_dialog import SchemaDialog
from app.features.correction.schema_draft import SchemaDraft
from app.features.correction.schema_form import value_text
from tracking.editing import SchemaChange, plan_schema
from tracking.formats.schema_files import SCHEMA_NAME, find_schema_file, schema_of_project
from tracking.tracks import (
    Attribute,
    AttributeType,
    Schema,
    as_stored,
    attribute_named,
    used_values,
    why_unfit,
)

MOST_KEYS = 9
_TYPED_INTO = (QLineEdit, QPlainTextEdit, QAbstractSpinBox)
_PLAIN = (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)


class AttributeController(Controller):
    """Sets attributes of the selected person as the schema has them.

    While an attribute is active, the keys 1 to 9 set it instead of what they do otherwise, unless
    a field is typed into.
    """

    def __init__(
        self, document: Document, page: QWidget, editing: EditController, parent: QObject
    ) -> None:
        """page: the keys count while its window has the keyboard."""
        super().__init__(parent)
        self._document, self._page, self._editing = document, page, editing
        app = QCoreApplication.instance()
        if app is not None:
            app.installEventFilter(self)

    @property
    def schema(self) -> Schema:
        """Of the session; none without one."""
        session = self._document.session
        return session.labels.schema if session is not None else ()

    @property
    def active(self) -> Attribute | None:
        """The attribute that digit keys set."""
        return attribute_named(self.schema, self._document.correcting.mode.attribute)

    @property
    def armed_text(self) -> str:
        """Which attribute the digit keys set, in a few words; "" for none."""
        active = self.active
        if active is None:
            return ""
        last = min(MOST_KEYS, len(active.options))
        return tr("Keys 1 to {last} set {name}", last=last, name=active.name)

    def card(self) -> TrackCard | None:
        """The selected person in words, with the schema's attributes apart from their own."""
        card, session = self._document.card(), self._document.session
        if card is None or session is None or not self.schema:
            return card
        said, active = dict(card.attributes), self.active
        fields = tuple(
            AttributeField(
                one,
                value := said.pop(one.name, None),
                used_values(session.labels, one.name) if one.type is AttributeType.TEXT else (),
                tr(why) if value is not None and (why := why_unfit(one, value)) else "",
                one == active,
            )
            for one in self.schema
        )
        return replace(card, attributes=tuple(said.items()), fields=fields)

    def give(self, track: int, name: str, value: str | None) -> None:
        """Say the value of an attribute; None: nothing any more."""
        attribute = attribute_named(self.schema, name)
        if attribute is not None and value is not None:
            value = as_stored(attribute, value)
        self._editing.set_attribute(track, name, value)

    def set_own(self, track: int, pairs: tuple[tuple[str, str], ...]) -> None:
        """Set a person's own attributes to these; those of the schema stay."""
        known = {one.name for one in self.schema}
        said = dict(self._document.label(track).attributes)
        kept = tuple((key, value) for key, value in said.items() if key in known)
        given = dict((*pairs, *((key, value) for key, value in kept if key not in dict(pairs))))
        self._editing.set_attributes(track, tuple(given.items()))

    def next_active(self) -> None:
        """Have the digit keys set the next attribute that has options; after the last: none."""
        names = [one.name for one in self.schema if one.options]
        mode = self._document.correcting.mode
        at = names.index(mode.attribute) + 1 if mode.attribute in names else 0
        mode.attribute = names[at] if at < len(names) else ""
        self._tell_active()
        self.changed.emit()

    def _tell_active(self) -> None:
        active = self.active
        if active is None:
            self.said.emit(tr("The digit keys set no attribute any more"))
            return
        choices = (
            f"{number} {value_text(active, option)}"
            for number, option in enumerate(active.options[:MOST_KEYS], 1)
        )
        self.said.emit(
            tr("Keys set {name}: {choices}", name=active.name, choices=", ".join(choices))
        )

    def choose(self, number: int) -> bool:
        """Set the active attribute of the selected person to an option; whether there is one."""
        active, track = self.active, self._document.selection.track
        if active is None or number > len(active.options):
            return False
        if not track:
            self.said.emit(tr("Select a person first"))
            return True
        value = active.options[number - 1]
        if self._document.label(track).attributes.get(active.name) != value:
            self.give(track, active.name, value)
        return True

    def change(self, wanted: SchemaChange) -> None:
        """Change the schema, as one edit."""
        self._editing.change_labels(lambda table, labels: plan_schema(table, labels, wanted))

    def ask_schema(self) -> None:
        """Open the dialog in which the schema is changed."""
        session = self._document.session
        if session is None:
            self.said.emit(tr("Track the recording or draw a person first"))
            return
        last = UserSettings().last_folder("attributes")
        folder = self._document.recording.folder
        project = find_schema_file(folder)
        draft = SchemaDraft(session.labels)
        dialog = SchemaDialog(draft, project.parent if project else folder, last, self._page)
        if project is not None and not session.labels.schema:
            dialog.read(project)
        dialog.wanted.connect(self.change)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    # digit keys

    def close(self) -> None:
        """Take none any more."""
        app = QCoreApplication.instance()
        if app is not None:
            app.removeEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Keep a digit from its command, and set the attribute instead."""
        kinds = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)
        if event.type() not in kinds or not isinstance(event, QKeyEvent):
            return False
        number = self._number(event)
        if not number or not isinstance(watched, QWidget):
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()
        else:
            self.choose(number)
        return True

    def _number(self, event: QKeyEvent) -> int:
        """The digit that is meant for the active attribute; 0: none is."""
        if self.active is None or event.modifiers() not in _PLAIN:
            return 0
        number = int(event.key()) - int(Qt.Key.Key_0)
        focus, window = QApplication.focusWidget(), QApplication.activeWindow()
        if not 1 <= number <= min(MOST_KEYS, len(self.active.options)):
            return 0
        here = window is None or window is self._page.window()
        return 0 if isinstance(focus, _TYPED_INTO) or not here else number


def schema_notes(document: Document) -> tuple[str, ...]:
    """What to tell where the project's attributes cannot be read, or are not the session's."""
    project = schema_of_project(document.recording.folder)
    session = document.session
    if project.notes or not project.schema or session is None:
        return tuple(map(tr, project.notes))
    if session.labels.schema == project.schema:
        return ()
    return (
        tr(
            "{file} of the project says other attributes than this session; {key}, Import... takes "
            "them.",
            file=SCHEMA_NAME,
            key=key_or_title("tracks.schema"),
        ),
    )
