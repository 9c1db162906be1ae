"""A package to begin a plug-in with: a whole one, whose tests pass."""

from __future__ import annotations

import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

import resources
from tracking.errors import OutputError
from tracking.plugins import PluginKind

_TEMPLATES = Path(resources.__file__).parent / "plugin_package"
_NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_LONGEST = 40
_ABOUT = {
    PluginKind.TRACKER: "Tracker {name}",
    PluginKind.FORMAT: "Format {name}",
    PluginKind.RECORDING: "Recordings of {name}",
    PluginKind.DETECTOR: "Detector {name}",
}
_EXAMPLE = {
    PluginKind.TRACKER: "trackwright track RECORDING -o session.h5 --tracker {name}",
    PluginKind.FORMAT: "trackwright export SESSION -o tracks.txt --format {name}",
    PluginKind.RECORDING: "trackwright info RECORDING",
    PluginKind.DETECTOR: "trackwright track RECORDING -o session.h5 --model {name}",
}


def named_rightly(name: str) -> bool:
    """Whether a name can be one of a plug-in."""
    return _NAME.fullmatch(name) is not None and len(name) <= _LONGEST


@dataclass(frozen=True, slots=True)
class PluginPackage:
    """A package of one plug-in, by its kind and name."""

    kind: PluginKind
    name: str

    @property
    def package(self) -> str:
        """The distribution, and the folder it is made in."""
        return f"trackwright-{self.name}"

    @property
    def values(self) -> dict[str, str]:
        """What the templates are filled with."""
        words = self.name.split("-")
        return {
            "kind": self.kind.value,
            "name": self.name,
            "package": self.package,
            "module": self.package.replace("-", "_"),
            "group": self.kind.group,
            "variable": self.kind.value.upper(),
            "camel": "".join(word.capitalize() for word in words),
            "about": _ABOUT[self.kind].format(name=self.name),
            "example": _EXAMPLE[self.kind].format(name=self.name),
        }

    @property
    def files(self) -> dict[str, str]:
        """The template of each file, by its place in the package."""
        module, kind = self.values["module"], self.kind.value
        return {
            "pyproject.toml": "pyproject.toml.jinja",
            "README.md": "README.md.jinja",
            f"src/{module}/__init__.py": f"{kind}/module.py.jinja",
            f"tests/test_{module}.py": f"{kind}/test.py.jinja",
        }


def make_package(package: PluginPackage, folder: Path) -> Path:
    """Write the package into a new folder of its name; that folder, which appears whole.

    Raises OutputError where there is one already, or it cannot be written.
    """
    place = folder / package.package
    if place.exists() or place.is_symlink():
        raise OutputError("{place} is there already; choose another name or --out", place=place)
    made = Environment(
        loader=FileSystemLoader(_TEMPLATES), undefined=StrictUndefined, keep_trailing_newline=True
    )
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder, prefix=f".{package.package}-") as held:
            inside = Path(held) / "package"
            for name, template in package.files.items():
                file = inside / name
                file.parent.mkdir(parents=True, exist_ok=True)
                text = made.get_template(template).render(package.values)
                file.write_text(text, encoding="utf-8")
            inside.rename(place)
    except OSError as error:
        raise OutputError(
            "cannot make {place}: {reason}; choose another folder with --out",
            place=place,
            reason=error.strerror or type(error).__name__,
        ) from error
    return place
