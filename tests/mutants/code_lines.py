"""Lines of C++ that are code: without comments, texts, preprocessor and what only declares or asserts."""

import re

NOT_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'""", re.DOTALL)
LEFT_OUT = re.compile(r"^\s*(#|static_assert|assert\(|using\b|namespace\b|template\b|friend\b|typedef\b|//)|\boperator\b")


def masked(text):
    """The text with blanks for comments and with '~' for what is quoted; every other character keeps its place."""

    def mask(match):
        found = match.group()
        if found.startswith("/"):
            return re.sub(r"[^\n]", " ", found)
        return found[0] + re.sub(r"[^\n]", "~", found[1:-1]) + found[-1]

    return NOT_CODE.sub(mask, text)


def code_lines(text):
    """Pairs of a line's number (from 0) and the masked line."""
    is_continued = False
    for number, line in enumerate(masked(text).split("\n")):
        was_continued, is_continued = is_continued, line.endswith("\\")
        if line.strip(" {}();,") and not was_continued and not LEFT_OUT.search(line):
            yield number, line
