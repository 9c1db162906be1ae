"""Make the environments of other programs: `python -m tests.peers [NAME...]`."""

from __future__ import annotations

import argparse

from tests.peers.environments import PEERS


def main() -> None:
    """Install those that are named, or all that are not installed yet."""
    parser = argparse.ArgumentParser(prog="python -m tests.peers", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(PEERS))
    names = parser.parse_args().names
    unknown = sorted(set(names) - set(PEERS))
    if unknown:
        parser.error(f"no such peer: {', '.join(unknown)}; there are {', '.join(PEERS)}")
    for peer in PEERS.values():
        if peer.name in names or not (names or peer.installed):
            print(f"{peer.name}: {' '.join((*peer.alone, *peer.packages))}", flush=True)
            peer.install()


if __name__ == "__main__":
    main()
