"""The experiments of three papers, repeated: tables, figures, and the papers' numbers beside ours."""
