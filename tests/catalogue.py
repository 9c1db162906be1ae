"""Extracts every text that is translated into resources/translations/trackwright.pot.

The catalogues of all languages are brought up to it, and compiled. `--missing` lists what is not
translated yet, in the form of a catalogue; `--add FILE` takes translations from such a file.
"""

from __future__ import annotations

import argparse
import ast
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from io import BytesIO
from itertools import chain
from pathlib import Path
from typing import Final

from babel.messages.catalog import Catalog
from babel.messages.pofile import write_po
from jinja2 import Environment, nodes
from typer import Context
from typer.main import get_command

from app.cli.commands.program import program
from app.cli.help_pages import clean_help
from app.core.commands import menu_of
from app.core.editing.edits import EDITS
from app.core.interrupts import STOPPED
from app.core.scenes.score_figures import FIGURES
from app.features.parts.training_settings import TrainingSettings
from app.shell.commands import COMMANDS
from tests import languages
from tracking import errors
from tracking.formats import FORMATS
from tracking.formats.track_format import Content
from tracking.scoring.report.meanings import MOTMETRICS
from tracking.scoring.report.measures import ALL
from tracking.settings import settings_fields, stage_title
from tracking.trackers import TRACKERS

ROOT: Final = Path(__file__).parents[1]
TEMPLATE: Final = ROOT / "resources" / "translations" / "trackwright.pot"
SINGLE: Final = frozenset({"tr", "N_", "msg", "joined", "joined_text"})
COUNTING: Final = frozenset({"count_text", "count_msg"})
ERRORS: Final = frozenset(
    {
        *(name for name in vars(errors) if name.endswith("Error")),
        *("RecordingMissing", "NotOnFloorError", "Refused", "EndedEarlyError", "advising"),
    }
)
"""Whatever is raised with a template, and one of what to do about it."""


_SAID_OF_PARAMETERS: Final = ("help", "rich_help_panel", "show_default")


@dataclass(frozen=True, slots=True)
class Use:
    """Texts that stand in one call: one of them is shown, or one and many of a count."""

    place: str
    call: ast.Call
    texts: tuple[str, ...]
    counting: bool = False

    @property
    def values(self) -> frozenset[str] | None:
        """Names of the values that the call gives; None where it does not name them one by one."""
        names = {keyword.arg for keyword in self.call.keywords} - {"option"}
        if None in names:
            return None
        return frozenset({*map(str, names), *(("n",) if self.counting else ())})


def extract() -> Catalog:
    """Every text of the program and the library."""
    catalogue = Catalog(project="trackwright", charset="utf-8")
    for use in uses():
        for text in (use.texts,) if use.counting else use.texts:
            if text:
                catalogue.add(text, locations=[(use.place, 0)])
    for texts, place in texts_of_templates():
        catalogue.add(texts if len(texts) > 1 else texts[0], locations=[(place, 0)])
    declared = {getattr(text, "template", text) for text in declared_texts()}
    for text in sorted(filter(None, declared)):
        catalogue.add(text, locations=[("declared values", 0)])
    return catalogue


def uses() -> Iterator[Use]:
    """Every call with texts that are translated, in order of files."""
    for package in ("app", "tracking"):
        for path in sorted((ROOT / package).rglob("*.py")):
            yield from uses_in(path)


def uses_in(path: Path) -> Iterator[Use]:
    """Those of one file."""
    place = path.relative_to(ROOT).as_posix()
    for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(call, ast.Call):
            continue
        name = called(call)
        if name in COUNTING:
            texts = tuple(chain(*map(texts_in, call.args[1:3])))
            yield Use(place, call, texts, counting=len(texts) == 2)
        elif name in SINGLE | ERRORS:
            taken = call.args[: 1 if name in SINGLE else 2]
            yield Use(place, call, tuple(chain(*map(texts_in, taken))))


def texts_of_templates() -> Iterator[tuple[tuple[str, ...], str]]:
    """Those of templates of pages, one or one and many, with the template."""
    for texts, _, place in uses_in_templates():
        yield texts, place


def uses_in_templates() -> Iterator[tuple[tuple[str, ...], frozenset[str], str]]:
    """The texts of each call in templates of pages, the names of its values, and the template."""
    for path in sorted((ROOT / "tracking").rglob("*.html")):
        place = path.relative_to(ROOT).as_posix()
        tree = Environment(autoescape=True).parse(path.read_text(encoding="utf-8"))
        for call in tree.find_all(nodes.Call):
            name = getattr(call.node, "name", "")
            counting = name in COUNTING
            taken = call.args[:1] if name in SINGLE else call.args[1:3] if counting else ()
            texts = tuple(each.value for each in taken if isinstance(each, nodes.Const))
            if texts:
                values = {each.key for each in call.kwargs}
                yield texts, frozenset(values | ({"n"} if counting else set())), place


def called(call: ast.Call) -> str:
    """The name of what is called."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def texts_in(argument: ast.expr) -> Iterator[str]:
    """The texts that an argument may be, whatever it depends on."""
    if isinstance(argument, ast.IfExp):
        yield from (*texts_in(argument.body), *texts_in(argument.orelse))
    elif isinstance(argument, ast.Constant) and isinstance(argument.value, str):
        yield argument.value


def declared_texts() -> Iterator[str]:
    """Texts of declared values: commands, edits, settings, trackers, formats, figures."""
    yield STOPPED
    for command in COMMANDS:
        yield from (command.title, *menu_of(command), command.also, command.title_one_camera)
    yield from (spec.title for spec in EDITS)
    for figure in FIGURES:
        yield from (figure.name, figure.hint, figure.short)
    yield from (spec.title for spec in TRACKERS.values())
    for each in FORMATS.values():
        yield from (each.title, each.about)
    yield from Content
    for measure in (*ALL, *MOTMETRICS.values()):
        yield measure.says
    for measure in ALL:
        yield from (measure.name, measure.group)
    for kind in (TrainingSettings, *(spec.settings_type for spec in TRACKERS.values())):
        for field in settings_fields(kind):
            stage = field.name.rpartition(".")[0]
            yield from (field.title, field.help, field.group, field.unit, stage_title(stage))
    commands = get_command(program)
    for command in (commands, *commands.commands.values()):  # type: ignore[attr-defined] # a group
        yield clean_help(command.help or "")
        for parameter in command.get_params(Context(command)):
            said = (getattr(parameter, name, "") for name in _SAID_OF_PARAMETERS)
            yield from (text for text in said if isinstance(text, str))


def template_of(catalogue: Catalog) -> bytes:
    """The catalogue as a file: sorted, without lines and dates, so that little of it changes."""
    stream = BytesIO()
    write_po(
        stream, catalogue, width=100, omit_header=True, sort_by_file=True, include_lineno=False
    )
    return stream.getvalue()


def main() -> None:
    """Write the template and the catalogues, or list what a catalogue lacks."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--missing", action="store_true", help="list what is not translated")
    parser.add_argument(
        "--add", type=Path, metavar="FILE", help="take translations from a .po file"
    )
    parser.add_argument("--language", default="ja", help="whose catalogue; ja unless given")
    asked = parser.parse_args()
    template = extract()
    if asked.missing:
        catalogue = languages.update_of(asked.language, template)
        sys.stdout.buffer.write(languages.po_of(languages.missing(catalogue)))
        return
    TEMPLATE.write_bytes(template_of(template))
    print(f"{len(template)} texts in {TEMPLATE.relative_to(ROOT)}")
    added = {} if asked.add is None else languages.translations(languages.read(asked.add))
    for unknown in languages.without(added, template):
        print(f"no text of the program: {unknown[0]!r}")
    for language in sorted({*languages.languages(), *([asked.language] if added else [])}):
        catalogue = languages.update(
            language, template, added if language == asked.language else {}
        )
        left = len(languages.missing(catalogue))
        print(
            f"{language}: {len(catalogue) - left} translated, {left} missing (--missing lists them)"
        )
        for fault in languages.faults(catalogue):
            print(f"{language}: {fault}")


if __name__ == "__main__":
    main()
