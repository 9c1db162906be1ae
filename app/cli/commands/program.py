"""The program that the commands belong to, and what can be said to every one of them."""

from __future__ import annotations

from typing import Annotated

import typer

import tracking
from app.cli.help_pages import WIDTH, HelpGroup
from app.cli.output import print_line
from tracking.translation import languages

program = typer.Typer(
    name="trackwright",
    help="A workbench for people tracked in recorded stereo footage.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    cls=HelpGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": WIDTH},
)


def _say_version(asked: bool) -> None:
    if asked:
        print_line(f"trackwright {tracking.__version__}")
        raise typer.Exit


@program.callback()
def every_command(
    debug: Annotated[bool, typer.Option("--debug", help="Show the traceback of an error.")] = False,
    language: Annotated[
        str | None,
        typer.Option(
            "--language",
            metavar="<language>",
            help="Show texts in this language, e.g. ja; otherwise in that of LANGUAGE, LC_ALL or "
            "LANG.",
            autocompletion=languages,
        ),
    ] = None,
    version: Annotated[
        bool,
        typer.Option("--version", help="Show the version.", callback=_say_version, is_eager=True),
    ] = False,
) -> None:
    """A workbench for people tracked in recorded stereo footage."""
