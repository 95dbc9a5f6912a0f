"""The smallest edits that would make a printed formula right."""
