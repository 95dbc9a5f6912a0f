"""The layers of verification, one a file: each catches what the others cannot."""
