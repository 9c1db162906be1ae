"""Figures of the stereo trackers in docs/results.md, from those of docs/results/stereo.md.

`python -m tests.benchmarks.stereo.overview` writes them between two comments of docs/results.md.
"""

from __future__ import annotations

from tests.benchmarks.command import parser_of
from tests.benchmarks.pages import DOCS, Figures, template
from tests.benchmarks.stereo.__main__ import PAGE

OVERVIEW = DOCS / "results.md"
BEGIN = "<!-- written by python -m tests.benchmarks.stereo.overview -->"
END = "<!-- until here -->"


def passage(figures: Figures) -> str:
    """The text between the comments: of the fresh clips, if any were measured."""
    return template("stereo/overview.md.j2").render({**PAGE.words, **figures}).strip()


def with_passage(text: str, figures: Figures) -> str:
    """The overview's text with the passage in the place of its older one."""
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n\n{passage(figures)}\n\n{END}{after}"


def main() -> None:
    """Write the passage into the overview; the only option is --help."""
    parser_of("stereo.overview", __doc__).parse_args()
    text = with_passage(OVERVIEW.read_text(encoding="utf-8"), PAGE.figures())
    OVERVIEW.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
