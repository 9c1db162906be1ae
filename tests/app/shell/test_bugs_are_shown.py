import sys
from types import SimpleNamespace

from app.shell import application


def test_what_nobody_caught_is_shown_in_the_window_which_lives_on(window, monkeypatch):
    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    application._catch_bugs(SimpleNamespace(window=window))
    error = ValueError("surprise")
    sys.excepthook(ValueError, error, None)
    assert "A bug in trackwright: ValueError: surprise" in window.notice.text
    assert window.isVisible()
