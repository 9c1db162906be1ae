"""What commands print: results on stdout, everything else on stderr.

Words of people and files are shown on a terminal as they are written, never obeyed by it: this is
the one place that prints.
"""

from __future__ import annotations

import errno
import io
import json
import os
import shutil
import sys
import tempfile
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import typer

from tracking.errors import OutputError
from tracking.progress import Progress
from tracking.text_columns import columns_of, to_left
from tracking.translation import N_, Message, msg, tr

STDOUT = Path("-")
"""Stands for stdout where a command asks for a file of text to make."""
_HELD_BYTES = 16 << 20
"""Of a document that is not complete yet, before it is put on a disk."""
_JOINERS = "\u200c\u200d"
"""Invisible letters that scripts and emoji need; they neither move nor hide anything."""


def escape_what_stdout_lacks() -> None:
    r"""Have letters that the encoding of stdout or stderr lacks written as Python writes them.

    What is shown of 入口 in Latin-1 is `\u5165\u53e3`. Where either is closed, it goes nowhere.
    """
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def name_stdout_in_errors() -> None:
    """Have whatever the system says of writing to stdout raised as an OutputError about it.

    Its own errors name no file, and so look like mistakes of the program. That nobody reads any
    more stays a BrokenPipeError.
    """
    stream = sys.stdout
    if isinstance(stream, io.TextIOWrapper) and stream is sys.__stdout__:  # which is not closed
        sys.stdout = io.TextIOWrapper(
            io.BufferedWriter(_Stdout(stream.fileno(), "w", closefd=False)),
            stream.encoding,
            stream.errors,
            line_buffering=stream.line_buffering,
            write_through=stream.write_through,
        )


class _Stdout(io.FileIO):
    """The file behind stdout, under every buffer: what is printed by whatever way goes through."""

    def write(self, data: Any) -> Any:
        """Raises OutputError where the system refuses, BrokenPipeError where nobody reads."""
        try:
            return super().write(data)
        except BrokenPipeError:
            raise
        except OSError as error:
            full = error.errno in (errno.ENOSPC, errno.EDQUOT)
            raise OutputError(
                "cannot write to stdout: {reason}",
                N_("make room") if full else N_("send it to another file or program"),
                reason=error.strerror,
            ) from error


def escape_controls(text: object) -> str:
    r"""A text on one line in which nothing commands the terminal; a message is translated.

    Control characters, line ends, marks that turn the direction of writing, and halves of broken
    file names are shown as Python writes them: `\x1b`, `\n`, `\u202e`, `\udcff`.
    """
    words = text.translated() if isinstance(text, Message) else str(text)
    return "".join(sign if _is_harmless(sign) else _escaped(sign) for sign in words)


def _is_harmless(sign: str) -> bool:
    return sign.isprintable() or sign in _JOINERS or unicodedata.category(sign) == "Zs"


def _escaped(sign: str) -> str:
    return sign.encode("unicode_escape", "surrogatepass").decode("ascii")


def print_line(text: object = "") -> None:
    """A line on stdout."""
    print(escape_controls(text))


def print_lines(text: str) -> None:
    """A text of several lines on stdout; callers use `escape_controls` on names in it."""
    for line in text.split("\n"):
        print_line(line)


def print_pieces(pieces: Iterable[str]) -> None:
    """A JSON document on stdout, made piece by piece: nothing of it where one cannot be made."""
    with tempfile.SpooledTemporaryFile(_HELD_BYTES, "w+", encoding="ascii") as whole:
        whole.writelines(pieces)
        whole.seek(0)
        shutil.copyfileobj(whole, sys.stdout)


def print_file(path: Path) -> None:
    """A text file on stdout: byte for byte, but shown line by line where that is a terminal."""
    if sys.stdout.isatty():
        with path.open(encoding="utf-8", errors="surrogateescape") as text:
            for line in text:
                print_line(line.rstrip("\n"))
        return
    sys.stdout.flush()
    with path.open("rb") as stream:
        shutil.copyfileobj(stream, sys.stdout.buffer)
    sys.stdout.buffer.flush()


@contextmanager
def text_at(out: Path, ending: str = ".csv") -> Iterator[Path]:
    """Where to write a text that is asked for at `out`; what is written for - goes to stdout.

    Args:
        ending: of the file that is written for stdout, which is gone afterwards.
    """
    if out != STDOUT:
        yield out
        return
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / f"stdout{ending}"
        yield place
        print_file(place)


def refuse_two_documents(out: Path | None, option: str, *, as_json: bool) -> None:
    """Raises BadParameter where a text and a JSON document are both to go to stdout."""
    if as_json and out == STDOUT:
        reason = msg("- and --json cannot both go to stdout; name a file or leave --json out")
        raise typer.BadParameter(reason, param_hint=option)


def print_json(document: Any) -> None:
    """One JSON document on stdout; a NaN in it is a mistake of ours, not of the reader."""
    print(json.dumps(document, indent=2, allow_nan=False))


def print_table(rows: Sequence[tuple[str, object]]) -> None:
    """Names and values on stdout, one below the other."""
    shown = [[tr(cell) if isinstance(cell, Message) else cell for cell in row] for row in rows]
    width = max((columns_of(str(name)) for name, _ in shown), default=0)
    for name, value in shown:
        print_line(f"{to_left(str(name), width)}  {value}")


def say(message: object) -> None:
    """A line on stderr."""
    print(escape_controls(message), file=sys.stderr, flush=True)


@contextmanager
def progress(what: str) -> Iterator[Progress]:
    """A progress bar on stderr while the block runs; one line where it is no terminal."""
    if not sys.stderr.isatty():
        say(msg("{what} ...", what=what))
        yield lambda *_: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    name = TextColumn("{task.description}", markup=False)
    columns = (name, BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(escape_controls(what), total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)
