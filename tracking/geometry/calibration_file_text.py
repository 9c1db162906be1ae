"""Untrusted calibration text into plain values, with caps on size, depth and numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, ParseError

import numpy as np
import yaml
from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import fromstring

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.translation import msg

MAX_BYTES = 256 * 1024
_MAX_DEPTH = 12
_MAX_NODES = 20_000
_MAX_NUMBERS = 10_000
_MATRIX_TAG = "tag:yaml.org,2002:opencv-matrix"


_BROKEN = (
    *(yaml.YAMLError, ValueError, TypeError, RecursionError),
    *(LookupError, AttributeError, OverflowError),
)
"""What PyYAML and conversions raise on text that is not what its tags say."""


def read_text(path: Path) -> str:
    """The text of a calibration file; CalibrationError where it is missing, binary or too large."""
    try:
        if path.exists() and not path.is_file():  # a pipe would keep us waiting for ever
            raise CalibrationError("{path}: not a file; give the calibration file", path=path)
        if path.stat().st_size > MAX_BYTES:
            raise CalibrationError(
                "{path}: larger than {size} KiB, too large for a calibration; give the "
                "calibration file",
                path=path,
                size=MAX_BYTES // 1024,
            )
        return path.read_text("utf-8-sig")
    except OSError as error:
        raise CalibrationError(
            "{path}: cannot be read ({reason}); check the path", path=path, reason=error.strerror
        ) from error
    except UnicodeDecodeError as error:
        raise CalibrationError(
            "{path}: not a text file; give the calibration file", path=path
        ) from error


def parse_yaml(text: str, where: Path) -> dict[str, Any]:
    """The top mapping of OpenCV FileStorage or plain YAML; OpenCV's matrices become arrays."""
    if text.startswith("%YAML"):
        # OpenCV writes "%YAML:1.0", which is no YAML directive. Its line stays, so that lines are
        # told as an editor numbers them.
        text = "\n" + text.partition("\n")[2]
    try:
        content = yaml.load(text, _CappedLoader)
    except _BROKEN as error:
        raise CalibrationError(
            "{where}: not readable as YAML ({why})", where=where, why=_one_line(error)
        ) from error
    if not isinstance(content, dict):
        raise CalibrationError(
            "{where}: holds no named values; give a calibration file", where=where
        )
    return {str(key): value for key, value in content.items()}


def parse_xml(text: str, where: Path) -> dict[str, Any]:
    """The values of an OpenCV FileStorage in XML; matrices become arrays."""
    try:
        root = fromstring(text.encode(), forbid_dtd=True)
    except (ParseError, DefusedXmlException, ValueError) as error:
        raise CalibrationError(
            "{where}: not readable as XML ({why})", where=where, why=_one_line(error)
        ) from error
    if root.tag != "opencv_storage":
        raise CalibrationError(
            "{where}: not an OpenCV file, its root is <{tag}>", where=where, tag=root.tag[:40]
        )
    try:
        return {child.tag: _xml_value(child) for child in root}
    except (ValueError, TypeError, OverflowError) as error:
        raise CalibrationError(
            "{where}: a broken value ({why})", where=where, why=_one_line(error)
        ) from error


def matrix(rows: Any, cols: Any, data: Any) -> Floats:
    """A (rows, cols) array of numbers that may still be text; ValueError where they do not fit."""
    rows, cols = int(rows), int(cols)
    if not isinstance(data, list) or not 0 < rows * cols == len(data) <= _MAX_NUMBERS:
        raise ValueError(
            msg("a matrix of {rows} x {cols} with other contents", rows=rows, cols=cols)
        )
    return np.array([float(number) for number in data]).reshape(rows, cols)


def _xml_value(element: Element) -> Any:
    if element.get("type_id") == "opencv-matrix":
        parts = {child.tag: child.text or "" for child in element}
        return matrix(parts.get("rows", "0"), parts.get("cols", "0"), parts.get("data", "").split())
    return (element.text or "").strip()


def _one_line(error: Exception) -> str:
    problem = getattr(error, "problem", None)
    mark = getattr(error, "problem_mark", None)
    text = " ".join(str(problem or error).split())[:120]
    return msg("{text}, line {line}", text=text, line=mark.line + 1) if mark is not None else text


class _CappedLoader(yaml.SafeLoader):
    """PyYAML's safe loader that refuses deep, huge and self-referring documents."""

    _depth = 0
    _nodes = 0

    def compose_node(self, parent: yaml.Node | None, index: Any) -> yaml.Node | None:
        """Compose as PyYAML does, counting levels and values."""
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("references are not used in calibrations")
        self._depth += 1
        self._nodes += 1
        if self._depth > _MAX_DEPTH or self._nodes > _MAX_NODES:
            raise yaml.YAMLError("nested too deep or too many values for a calibration")
        node: yaml.Node | None = super().compose_node(parent, index)
        self._depth -= 1
        return node


def _construct_matrix(loader: _CappedLoader, node: yaml.Node) -> Floats:
    if not isinstance(node, yaml.MappingNode):
        raise ValueError("an opencv-matrix without rows, cols and data")
    parts = loader.construct_mapping(node, deep=True)
    return matrix(parts.get("rows"), parts.get("cols"), parts.get("data"))


_CappedLoader.add_constructor(_MATRIX_TAG, _construct_matrix)
