"""Environments of other programs, made on demand and kept under `build/peers/`."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import venv
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
KEPT = HERE.parents[1] / "build" / "peers"
MEMORY_KIB = 8 << 20
"""What a script may take: one that grows without bound ends, and not the machine."""


@dataclass(frozen=True, slots=True)
class Peer:
    """A program of others.

    Attributes:
        name: as it is asked for.
        alone: packages installed without what they ask for: it is not needed here.
        packages: packages installed with what they ask for.
    """

    name: str
    packages: tuple[str, ...]
    alone: tuple[str, ...] = ()

    @property
    def python(self) -> Path:
        """Its interpreter, whether it is there or not."""
        return KEPT / self.name / "bin" / "python"

    @property
    def installed(self) -> bool:
        """Whether its environment has been made, whole."""
        return (KEPT / self.name / "ready").is_file()

    def install(self) -> None:
        """Make its environment anew.

        Raises:
            subprocess.CalledProcessError: its packages cannot be had.
        """
        folder = KEPT / self.name
        venv.create(folder, clear=True, with_pip=True)
        pip = [self.python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, *self.packages], check=True)
        if self.alone:
            subprocess.run([*pip, "--no-deps", *self.alone], check=True)
        (folder / "ready").touch()

    def run(self, script: str, *arguments: Path | str) -> str:
        """Run one of the scripts of this folder in its environment, on one thread.

        Returns:
            What it prints.

        Raises:
            RuntimeError: it is not installed, or the script fails.
        """
        if not self.installed:
            raise RuntimeError(self.absent)
        one_thread = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "RAYON_NUM_THREADS": "1"}
        command = [*_limited(), self.python, HERE / script, *arguments]
        ended = subprocess.run(
            command, env=os.environ | one_thread, capture_output=True, text=True, check=False
        )
        if ended.returncode:
            why = ended.stderr.strip()[-2000:] or f"it ended with status {ended.returncode}"
            raise RuntimeError(f"{self.name}: {script} failed: {why}")
        return ended.stdout

    def told(self, script: str, *arguments: Path | str) -> Any:
        """What a script says as JSON in its last line; its program may say other things first."""
        return json.loads(self.run(script, *arguments).splitlines()[-1])

    @property
    def absent(self) -> str:
        """What to tell when it is not installed."""
        made_by = f"{Path(sys.executable).name} -m tests.peers {self.name}"
        return f"{self.name} is not installed: {made_by}"


def require(*peers: Peer) -> None:
    """End the program with a line for each that is not installed."""
    if absent := [peer.absent for peer in peers if not peer.installed]:
        sys.exit("\n".join(absent))


def _limited() -> tuple[str, ...]:
    """How a command is begun with no more than `MEMORY_KIB`, where the system has prlimit."""
    found = shutil.which("prlimit")
    return (found, f"--as={MEMORY_KIB * 1024}", "--") if found else ()


# TrackEval asks for plotting and mask packages that its box measures do not use.
TRACKEVAL = Peer("trackeval", ("numpy==2.4.6", "scipy==1.17.1"), alone=("trackeval==1.3.0",))
# The last version of py-motmetrics calls what NumPy 2 no longer has.
MOTMETRICS = Peer(
    "py-motmetrics", ("motmetrics==1.4.0", "numpy==1.26.4", "scipy==1.15.3", "pandas==2.2.3")
)
MOTRICS = Peer("motrics", ("motrics==0.3.0", "numpy==2.4.6"))
# They read the files that are written here, or write files that are read here.
DATUMARO = Peer("datumaro", ("datumaro==1.13.12",))
PYCOCOTOOLS = Peer("pycocotools", ("pycocotools==2.0.11",))
JUPEDSIM = Peer("jupedsim", ("jupedsim==1.4.2",))
SLEAP_IO = Peer("sleap-io", ("sleap-io==0.9.5",))
LABEL_STUDIO = Peer("label-studio-sdk", ("label-studio-sdk==2.1.2",))
# What its files need of it; it asks for the runtimes of models, too.
X_ANYLABELING = Peer(
    "x-anylabeling",
    (
        *("PyQt6==6.9.1", "PyQt6-Qt6==6.9.2", "numpy==2.4.6", "scipy==1.17.1", "pillow==13.0.0"),
        *("opencv-contrib-python-headless==5.0.0.93", "pillow-heif==1.8.1", "PyYAML==6.0.3"),
        *("importlib_metadata==10.2.0", "jsonlines==4.0.0", "natsort==8.4.0", "tqdm==4.70.1"),
        *("termcolor==3.3.0", "requests==2.34.2", "matplotlib==3.11.2", "shapely==2.2.0"),
        *("psutil==7.2.2", "darkdetect==0.8.0", "Markdown==3.11.3", "qimage2ndarray==1.10.0"),
        *("cryptography==50.0.2", "json_repair==0.64.6", "pyclipper==1.4.0", "openai==3.54.0"),
        *("tokenizers==0.23.3", "lapx==0.11.1", "socksio==1.0.0"),
    ),
    alone=("x-anylabeling-cvhub==4.2.1",),
)

# They follow the same detections; norfair and motpy are older than NumPy 2.
_OLD_NUMPY = ("numpy==1.26.4", "scipy==1.15.3")
_NEW_NUMPY = ("numpy==2.4.6", "scipy==1.17.1")
NORFAIR = Peer("norfair", ("norfair==2.3.0", "filterpy==1.4.5", *_OLD_NUMPY))
MOTPY = Peer("motpy", ("motpy==0.0.10", "filterpy==2.0.0", *_OLD_NUMPY))
TRACKERS = Peer("trackers", ("trackers==2.6.1", "supervision==0.31.2", *_NEW_NUMPY))
STONESOUP = Peer("stonesoup", ("stonesoup==1.9.1", *_NEW_NUMPY))

_ALL = (
    *(TRACKEVAL, MOTMETRICS, MOTRICS, DATUMARO, PYCOCOTOOLS, JUPEDSIM, SLEAP_IO, LABEL_STUDIO),
    *(X_ANYLABELING, NORFAIR, MOTPY, TRACKERS, STONESOUP),
)
PEERS = {peer.name: peer for peer in _ALL}
