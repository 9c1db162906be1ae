"""Icons, themes and default settings that ship with the program."""
