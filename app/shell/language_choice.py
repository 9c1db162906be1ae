"""The language of the window: the system's or one that was chosen, for our texts and for Qt's."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from PySide6.QtCore import QLibraryInfo, QLocale, QObject, QTimer, QTranslator, Signal
from PySide6.QtGui import QFontDatabase, QFontInfo
from PySide6.QtWidgets import QApplication

from app.core.i18n import language_in_use, tr, use_language
from app.core.widgets.user_settings import UserSettings
from app.shell.hand_over import why_not_now
from tracking.translation import (
    ENGLISH,
    FONT_PACKAGES,
    asked_language,
    environment_languages,
    forget_asked_language,
    languages,
)

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

SYSTEM = ""
_KEY = "language"
_LOOK_MS = 300
_SCRIPTS = {"ja": QFontDatabase.WritingSystem.Japanese}
"""Writing systems that a plain installation may have no font for."""


class LanguageChoice(QObject):
    """The language of the window, kept from one start to the next.

    Signals: `changed()`, the window is to be built anew: nothing is under way in it.
    """

    changed = Signal()

    def __init__(self, remembered: UserSettings, window: MainWindow) -> None:
        super().__init__(window)
        self._remembered, self._window = remembered, window
        self._waiting = QTimer(self, interval=_LOOK_MS)
        self._waiting.timeout.connect(self._look)

    @property
    def language(self) -> str:
        """What was chosen; `SYSTEM`: as the system."""
        return chosen_language(self._remembered)

    def choose(self, language: str) -> None:
        """Show the window in another language, and remember it; what is under way ends first."""
        forget_asked_language()
        self._remembered.set_text(_KEY, language)
        if why_not := why_not_now(self._window):
            self._window.notice.say(tr("The language changes soon: {why}", why=why_not))
            self._waiting.start()
        elif self._window.isVisible():
            QTimer.singleShot(0, self, self._look)  # once the menu it was chosen in has closed

    def _look(self) -> None:
        if not why_not_now(self._window) and not _held_by_somebody():
            self._waiting.stop()
            self.changed.emit()
        elif not self._waiting.isActive():
            self._waiting.start()

    def close(self) -> None:
        """The window closes."""
        self._waiting.stop()


def _held_by_somebody() -> bool:
    """Whether a menu or a dialog is open, or a button of the mouse is held."""
    popup, dialog = QApplication.activePopupWidget(), QApplication.activeModalWidget()
    return popup is not None or dialog is not None or bool(QApplication.mouseButtons().value)


def chosen_language(remembered: UserSettings) -> str:
    """The language that the command line asks for, else the one chosen in the window; `SYSTEM`."""
    named = asked_language() or remembered.text(_KEY)
    return named if asked_language() or named in languages() else SYSTEM


def name_of_language(language: str) -> str:
    """What a language calls itself."""
    return "English" if language == ENGLISH else QLocale(language).nativeLanguageName()


def why_unreadable(language: str) -> str:
    """What to do where no font here has the letters of a language; "" where one has."""
    script = _SCRIPTS.get(language.partition("_")[0])
    if script is None or QFontDatabase.families(script):
        return ""
    return tr(
        "No font here has the letters of {language}: they would be empty boxes. Install one first, "
        "e.g. {package} on Debian and Ubuntu.",
        language=name_of_language(language),
        package=FONT_PACKAGES[language.partition("_")[0]],
    )


def show_language(application: QApplication, remembered: UserSettings) -> None:
    """Show our texts, Qt's own, and numbers in the language that holds now."""
    language = chosen_language(remembered)
    if language != SYSTEM:
        use_language(language)
    else:
        _use_language_of_system()
    for old in application.findChildren(QTranslator):
        application.removeTranslator(old)
        old.setParent(None)
    _translate_qt(application)
    _use_letters(application)
    # Numbers are typed as they are shown beside: never with a comma that parts thousands.
    numbers = QLocale(language_in_use() or ENGLISH)
    options = QLocale.NumberOption.OmitGroupSeparator | QLocale.NumberOption.RejectGroupSeparator
    numbers.setNumberOptions(options)
    QLocale.setDefault(numbers)


class _QtTexts(QTranslator):
    """Qt's own texts; where a newer Qt gives a text a letter to press, its older translation."""

    def translate(
        self, context: str, source: str, disambiguation: str | None = None, n: int = -1
    ) -> str:
        """A text of Qt in the language of the file; "": it has none."""
        said = super().translate(context, source, disambiguation, n) or ""
        at = source.find("&")
        if said or at < 0 or at + 1 >= len(source):
            return said
        plain = super().translate(context, source.replace("&", ""), disambiguation, n) or ""
        end = len(plain.rstrip(":"))
        return f"{plain[:end]}(&{source[at + 1].upper()}){plain[end:]}" if plain else ""


def _use_language_of_system() -> None:
    """What the environment names; where it names none, as on Windows, what the desktop says."""
    if environment_languages():
        use_language()
        return
    known = languages()
    for named in QLocale.system().uiLanguages():
        language = named.replace("-", "_")
        if {language, language.partition("_")[0]} & set(known):
            use_language(language)
            return
    use_language(ENGLISH)


def _use_letters(application: QApplication) -> None:
    """Draw letters that the usual font lacks as the language in use writes them.

    Without a word from us the first font that has them is taken: Japanese in Chinese shapes.
    """
    if not sys.platform.startswith("linux"):
        return
    font = application.font()
    usual = QFontInfo(font).family()  # "Sans Serif" alone would stand for the other one, too
    script = _SCRIPTS.get(language_in_use())
    having = QFontDatabase.families(script) if script is not None else []
    best = [] if usual in having else sorted(having, key=_unlike)[:1]
    if best or len(font.families()) > 1:
        font.setFamilies([usual, *best])
        application.setFont(font)


def _unlike(family: str) -> tuple[bool, bool, str]:
    """Sorts fonts made for Japanese first, and among them those without serifs or equal widths."""
    words = family.split()
    ours = bool({"JP", "Gothic", "PGothic", "IPAexGothic", "IPAPGothic", "UI"} & set(words))
    plain = not {"Serif", "Mincho", "Mono"} & set(words)
    return not ours, not plain, family


def _translate_qt(application: QApplication) -> None:
    """Show Qt's own texts, as on buttons and in file dialogs, in the language of ours."""
    if language := language_in_use():
        translator = _QtTexts(application)
        place = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        if translator.load(QLocale(language), "qtbase", "_", place):
            application.installTranslator(translator)
