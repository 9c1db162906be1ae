"""Extracts every text that is translated into resources/translations/trackwright.pot."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Final

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import write_po
from typer.main import get_command

from app.cli.commands import program
from app.cli.help_pages import clean_help
from app.core.commands import menu_of
from app.core.editing.edits import EDITS
from app.core.scenes.score_figures import FIGURES
from app.features.parts.training_settings import TrainingSettings
from app.shell.commands import COMMANDS
from tracking.formats import FORMATS
from tracking.settings import settings_fields, stage_title
from tracking.trackers import TRACKERS

ROOT: Final = Path(__file__).parents[1]
TEMPLATE: Final = ROOT / "resources" / "translations" / "trackwright.pot"
KEYWORDS: Final = {
    "tr": None,
    "N_": None,
    "count_text": (2, 3),
}
"""What is called with a text, and which arguments are one, counted from 1; None: the first."""


def extract() -> Catalog:
    """Every text of the program and the library."""
    catalogue = Catalog(project="trackwright", charset="utf-8")
    for package in ("app", "tracking"):
        found = extract_from_dir(
            str(ROOT / package), method_map=[("**.py", "python")], keywords=KEYWORDS
        )
        for name, _, text, _, _ in found:
            if all(text) if isinstance(text, tuple) else text:
                catalogue.add(text, locations=[(f"{package}/{name}", 0)])
    for text in filter(None, declared_texts()):
        catalogue.add(text, locations=[("declared values", 0)])
    return catalogue


def declared_texts() -> Iterator[str]:
    """Texts of declared values: commands, edits, settings, trackers, formats, figures."""
    for command in COMMANDS:
        yield from (command.title, *menu_of(command), command.also, command.title_one_camera)
    yield from (spec.title for spec in EDITS)
    for figure in FIGURES:
        yield from (figure.name, figure.hint, figure.short)
    yield from (spec.title for spec in TRACKERS.values())
    for each in FORMATS.values():
        yield from (each.title, each.about)
    for kind in (TrainingSettings, *(spec.settings_type for spec in TRACKERS.values())):
        for field in settings_fields(kind):
            stage = field.name.rpartition(".")[0]
            yield from (field.title, field.help, field.group, stage_title(stage))
    commands = get_command(program)
    for command in (commands, *commands.commands.values()):  # type: ignore[attr-defined] # a group
        yield clean_help(command.help or "")
        for parameter in command.params:
            yield from (getattr(parameter, name, "") for name in ("help", "rich_help_panel"))


def template_of(catalogue: Catalog) -> bytes:
    """The catalogue as a file: sorted, without lines and dates, so that little of it changes."""
    stream = BytesIO()
    write_po(
        stream, catalogue, width=100, omit_header=True, sort_by_file=True, include_lineno=False
    )
    return stream.getvalue()


if __name__ == "__main__":
    TEMPLATE.write_bytes(template_of(extract()))
    print(f"{len(extract())} texts in {TEMPLATE.relative_to(ROOT)}")
