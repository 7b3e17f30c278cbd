"""The changes that make a mutant: four kinds, each of one line. The compiler judges whether the result is C++."""

import re

KINDS = ["operator", "constant", "condition", "deletion"]

OPERATORS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " % ": " * ", " += ": " -= ", " -= ": " += ", " *= ": " /= ",
             " /= ": " *= ", " & ": " | ", " | ": " & ", "std::min(": "std::max(", "std::max(": "std::min(",
             "std::min<": "std::max<", "std::max<": "std::min<", "++": "--", "--": "++"}
COMPARISONS = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ",
               " || ": " && "}
NUMBER = re.compile(r"(?<![\w.'])(\d+)(\.\d+)?([uUlLzZfF]*)(?![\w.'>])")
STATEMENT = re.compile(r"(break|continue|return|(\+\+|--)[\w.>\[\]-]+|[\w.:>*\[\]()-]+( ([-+*/|&^]|<<|>>)?= .*|\(.*\)|\+\+|--));")
GUARD = re.compile(r"(if|for|while) \(.*\) .*;")


def replaced(line, start, end, text):
    return line[:start] + text + line[end:]


def swaps(line, code, table):
    for before, after in table.items():
        start = code.find(before)
        while start >= 0:
            yield replaced(line, start, start + len(before), after)
            start = code.find(before, start + 1)


def constants(line, code):
    for match in NUMBER.finditer(code):
        whole, fraction, suffix = match.groups()
        if fraction:
            value = "1.0" if float(whole + fraction) == 0 else "2 * " + whole + fraction
            yield replaced(line, *match.span(), value + suffix)
        else:
            yield replaced(line, *match.span(), str(int(whole) + 1) + suffix)
            if int(whole) > 0:
                yield replaced(line, *match.span(), str(int(whole) - 1) + suffix)
    for match in re.finditer(r"\b(true|false)\b", code):
        yield replaced(line, *match.span(), "false" if match.group() == "true" else "true")


def end_of_brackets(code, start):
    """Place of the bracket that closes the one at `start`, or -1."""
    depth = 0
    for place in range(start, len(code)):
        depth += {"(": 1, ")": -1}.get(code[place], 0)
        if depth == 0:
            return place
    return -1


def without_loop_head(code):
    """The code without what counts in `for (...; ...; ...)`: a change there runs over an end, which only sanitizers see, or
    never ends."""
    match = re.search(r"\bfor \(", code)
    end = end_of_brackets(code, match.end() - 1) if match else -1
    if not match or ";" not in code[match.end():]:
        return code
    end = end if end > 0 else len(code)
    return code[:match.start()] + " " * (end - match.start()) + code[end:]


def conditions(line, code):
    yield from swaps(line, code, COMPARISONS)
    for match in re.finditer(r"(?<![\w=])!(?=[\w(])", code):
        yield replaced(line, *match.span(), "")
    for match in re.finditer(r"\b(?:if|while) \(", code):
        start, end = match.end(), end_of_brackets(code, match.end() - 1)
        if end > 0 and ";" not in code[start:end] and " = " not in code[start:end]:
            yield replaced(line, start, end, "!(" + line[start:end] + ")")


def deletions(line, code, above, below):
    """The line as an empty statement, where it is one statement and nothing but that. `above` and `below` are the code
    lines around it."""
    statement = code.strip()
    begins = above.rstrip().endswith((";", "{", "}", ":")) or re.match(r"\s*(if|for|while|else)\b.*\)?$", above)
    whole = all(statement.count(a) == statement.count(b) for a, b in ["()", "{}", "[]"])
    if begins and whole and not below.strip().startswith("else") and (
            STATEMENT.fullmatch(statement) or GUARD.fullmatch(statement)):
        yield line[:len(line) - len(line.lstrip())] + ";"


def changes(kind, line, code, above, below):
    """All changes of one kind: other texts of `line`, whose masked text is `code`."""
    if kind == "operator":
        return list(swaps(line, without_loop_head(code), OPERATORS))
    if kind == "constant":
        return list(constants(line, code))
    if kind == "condition":
        return list(conditions(line, without_loop_head(code)))
    return list(deletions(line, code, above, below))
