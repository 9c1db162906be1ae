"""The program: command line and window over the library `tracking`."""
