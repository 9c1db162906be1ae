"""Import, export, backups and recovery of sessions: what dialogs show."""
