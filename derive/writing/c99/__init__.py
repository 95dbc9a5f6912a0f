"""Written as C99: headers without a library, in double and single precision."""
