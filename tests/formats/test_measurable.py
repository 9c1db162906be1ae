"""Files of tracks as they are measured."""

from __future__ import annotations

from pathlib import Path

from tracking.formats import Filmed, format_of, measurable

KITTI = "{} {} Pedestrian 0 0 -10 10 20 40 80 -1 -1 -1 -1000 -1000 -1000 -10\n"


def test_ids_of_every_format_are_those_of_the_file(tmp_path: Path) -> None:
    texts = {
        "mot.txt": "1,0,1,1,5,5,1\n1,3,1,1,5,5,1\n",
        "kitti.txt": KITTI.format(0, 0) + KITTI.format(0, 3),
    }
    for name, text in texts.items():
        path = tmp_path / name
        path.write_text(text)
        found = measurable(path, format_of(path), Filmed())
        assert found.columns["track"].tolist() == [0, 3], name
        assert found.notes == (), name
