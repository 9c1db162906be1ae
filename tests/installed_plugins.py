"""Packages of plug-ins as an installer leaves them: modules, and metadata with entry points."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path


def install_package(package: Path, site: Path) -> None:
    """What `pip install` would put into `site` of a package that `plugins new` made."""
    told = tomllib.loads((package / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    shutil.copytree(package / "src", site, dirs_exist_ok=True)
    points = {
        (group, name): target
        for group, offered in told["entry-points"].items()
        for name, target in offered.items()
    }
    write_metadata(site, told["name"], told["version"], points)


def install_module(
    site: Path, package: str, code: str, points: dict[tuple[str, str], str], version: str = "1.0"
) -> None:
    """A package of one module, with its entry points: (group, name) -> attribute."""
    module = package.replace("-", "_")
    site.mkdir(parents=True, exist_ok=True)
    (site / f"{module}.py").write_text(code, encoding="utf-8")
    targets = {key: f"{module}:{attribute}" for key, attribute in points.items()}
    write_metadata(site, package, version, targets)


def write_metadata(
    site: Path, package: str, version: str, points: dict[tuple[str, str], str]
) -> None:
    """The dist-info folder of a package; points: (group, name) -> "module:ATTRIBUTE"."""
    info = site / f"{package.replace('-', '_')}-{version}.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {package}\nVersion: {version}\n", encoding="utf-8"
    )
    groups = dict.fromkeys(group for group, _ in points)
    lines = []
    for group in groups:
        lines.append(f"[{group}]")
        lines += [f"{name} = {value}" for (of, name), value in points.items() if of == group]
    (info / "entry_points.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
