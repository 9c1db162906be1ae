"""A folder with the program packed: as .tar.gz, and as a Debian package."""

from __future__ import annotations

import os
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path
from textwrap import dedent

ROOT = Path(__file__).parents[2]
LIBRARIES = ("libc6", "libegl1", "libgl1", "libxcb1", "libx11-6", "libdrm2", "fontconfig")
"""What any desktop has, and no program brings along: it must fit the machine's drivers. Names of
Debian 12 and later, and of Ubuntu 22.04 and later."""
_TIME = int(os.environ.get("SOURCE_DATE_EPOCH", "1580601600"))


def packed_folder(folder: Path, out: Path) -> Path:
    """The folder as an archive in `out`; it unpacks to one folder, for any user."""
    file = out / "trackwright-linux-x86_64.tar.gz"
    with tarfile.open(file, "w:gz", compresslevel=9) as archive:
        archive.add(folder, "trackwright", filter=_anybodys)
    return file


def _anybodys(entry: tarfile.TarInfo) -> tarfile.TarInfo:
    entry.uid = entry.gid = 0
    entry.uname = entry.gname = "root"
    entry.mtime = _TIME
    return entry


def debian_package(folder: Path, out: Path, version: str) -> Path:
    """The folder as a Debian package in `out`, with menu entry, icon and type of sessions."""
    file = out / f"trackwright_{version}_amd64.deb"
    with tempfile.TemporaryDirectory() as temporary:
        root = Path(temporary) / "root"
        shutil.copytree(folder, root / "opt" / "trackwright", symlinks=True)
        (root / "usr" / "bin").mkdir(parents=True)
        (root / "usr" / "bin" / "trackwright").symlink_to("/opt/trackwright/trackwright")
        resources = ROOT / "resources"
        _put(resources / "desktop" / "trackwright.desktop", root / "usr/share/applications")
        _put(resources / "desktop" / "trackwright.xml", root / "usr/share/mime/packages")
        icons = root / "usr/share/icons/hicolor/scalable/apps"
        _put(resources / "icons" / "trackwright.svg", icons)
        _put(ROOT / "LICENSE", root / "usr/share/doc/trackwright", "copyright")
        (root / "DEBIAN").mkdir()
        (root / "DEBIAN" / "control").write_text(_control(root, version))
        for path in (root, *root.rglob("*")):
            if path.is_dir() and not path.is_symlink():
                path.chmod(0o755)
        command = ["dpkg-deb", "--root-owner-group", "-Zxz", "--build", str(root), str(file)]
        times = {**os.environ, "SOURCE_DATE_EPOCH": str(_TIME)}
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=times)
    return file


def _put(file: Path, folder: Path, name: str | None = None) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(file, folder / (name or file.name))


def _control(root: Path, version: str) -> str:
    size_kb = sum(path.lstat().st_size for path in root.rglob("*")) // 1024
    return dedent(f"""\
        Package: trackwright
        Version: {version}
        Architecture: amd64
        Maintainer: trackwright's developers <nobody@localhost>
        Installed-Size: {size_kb}
        Depends: {", ".join(LIBRARIES)}
        Recommends: fonts-dejavu-core
        Section: science
        Priority: optional
        Description: Tracks people in recorded footage, and shows where that is likely wrong
         A workbench that plays stereo or one-camera footage of people beside an overhead view of
         the tracker, lets operators correct tracks, and saves ground truth and scores.
        """)
