"""Ending by a signal reaches its end, whatever goes wrong on the way."""

import io
import sys
from types import SimpleNamespace
from unittest.mock import Mock

import pytest

from app.shell import shutdown_signals


def test_a_terminal_that_is_closed_keeps_nobody_from_ending(monkeypatch):
    closed = io.StringIO()
    closed.close()
    monkeypatch.setattr(sys, "stderr", closed)
    window = Mock()
    window.files.describe_unsaved.return_value = ["kept"]
    assert _ended(monkeypatch, window)


def test_a_fault_in_closing_keeps_nobody_from_ending(monkeypatch):
    window = Mock()
    window.files.describe_unsaved.side_effect = RuntimeError
    with pytest.raises(RuntimeError):
        _ended(monkeypatch, window)
    assert shutdown_signals.QCoreApplication.quit.called


def _ended(monkeypatch, window):
    monkeypatch.setattr(shutdown_signals, "QCoreApplication", Mock())
    stand_in = SimpleNamespace(_host=SimpleNamespace(window=window))
    stand_in._close = lambda: shutdown_signals.EndBySignal._close(stand_in)
    shutdown_signals.EndBySignal._end(stand_in)
    return shutdown_signals.QCoreApplication.quit.called
