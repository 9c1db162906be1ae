"""The open recording as one document: session, tracks shown, selection, pending edit."""
