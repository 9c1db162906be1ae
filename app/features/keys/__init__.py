"""Keys of commands: profiles, the user's own changes, and the dialog that edits them."""
