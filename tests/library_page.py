"""The reference in docs/library.md, made from docstrings: `python -m tests.library_page`."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from typing import Any

import tracking

PAGE = Path(__file__).parents[1] / "docs" / "library.md"
_BEGIN = "<!-- made from docstrings: python -m tests.library_page -->"


def signatures() -> str:
    """Every public name with its signature, a line each."""
    return "".join(f"{_signature(name)}\n" for name in sorted(tracking.__all__))


def _signature(name: str) -> str:
    value = getattr(tracking, name)
    return f"class {name}" if inspect.isclass(value) else f"{name}{_shown(value)}"


class _Words(str):
    """An annotation that is shown as it is written."""

    def __repr__(self) -> str:
        return str(self)


def _shown(function: Any) -> str:
    """The signature as it is written, with paths spelt out."""
    signature = inspect.signature(function)
    parameters = [
        one.replace(annotation=_Words(one.annotation)) for one in signature.parameters.values()
    ]
    shown = str(
        signature.replace(
            parameters=parameters, return_annotation=_Words(signature.return_annotation)
        )
    )
    return shown.replace("AnyPath", "str | os.PathLike[str]")


def reference() -> str:
    """The functions with their docstrings, as Markdown."""
    functions = [name for name in tracking.__all__ if not inspect.isclass(getattr(tracking, name))]
    return "\n".join(_section(name) for name in functions)


def _section(name: str) -> str:
    value = getattr(tracking, name)
    said = inspect.cleandoc(value.__doc__ or "")
    said = re.sub(r"^(Args|Returns|Raises):$", r"**\1**\n", said, flags=re.MULTILINE)
    said = re.sub(
        r"^    ([a-z_]+(?:, [a-z_]+)*|\w+Error(?:, \w+Error)*): ",
        r"- `\1`: ",
        said,
        flags=re.MULTILINE,
    )
    said = re.sub(r"^ {4,}", "  ", said, flags=re.MULTILINE)
    return f"### {name}\n\n```text\n{name}{_shown(value)}\n```\n\n{said}\n"


def page(before: str) -> str:
    """The page with its reference made anew."""
    head, mark, _ = before.partition(_BEGIN)
    assert mark, f"{PAGE.name} lacks the line {_BEGIN}"
    return f"{head}{_BEGIN}\n\n{reference()}"


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    (PAGE.parents[1] / "tests" / "golden" / "library.txt").write_text(
        signatures(), encoding="utf-8"
    )
