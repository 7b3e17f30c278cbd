"""What figures become on a page of docs/: the text between its two markers."""

import sys

BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"


def replaced(path, text):
    """The page at the path, with the text between its markers."""
    before, begin, rest = path.read_text(encoding="utf-8").partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        sys.exit(f"{path}: lacks the lines {BEGIN} and {END}, between which the tables stand")
    return before + begin + "\n" + text + end + after
