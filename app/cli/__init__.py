"""The command line: what is typed is turned into calls of the library, results into text."""
