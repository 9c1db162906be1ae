"""The window around everything: menus, keys, commands."""
