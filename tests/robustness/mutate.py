"""Mutations of a text of keys and values: what a user may mistype, and worse."""

import re

NUMBER = re.compile(r"(?<![\w.\"])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w\"])")
WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9.]*")
STRING = re.compile(r'"[^"\n]*"')

NUMBERS = ["0", "-1", "1", "2", "0.5", "1e-300", "1e300", "-1e9", "1e9", "nan", "inf", "-inf", "1e-9", "1e18"]
NUMBERS += ["3.7", "-0.0", "99999999999", "9223372036854775808", "0x10", "1_000", '"1"', "true", "[]", "{}", "[1]"]
STRINGS = ['""', '"ground"', '"nothing"', '"ground.start"', "1", "[]", "{}", "true", '"a.b.c"', '"é"', '"\\u0000"']
STRINGS += ['"' + "x" * 300 + '"', '"sin(t)/0"', '"1/0"', '"t <"']
BYTES = ["\x00", "\xff", "[", "]", "{", "}", "=", '"', "'", "#", "\n", ",", ".", "\ufeff", "é"]


def replace(random, text, pattern, choices):
    """One match of a pattern by one of the choices; a number also by a factor of itself."""
    matches = list(pattern.finditer(text))
    if not matches:
        return text
    m = random.choice(matches)
    new = random.choice(choices)
    if pattern is NUMBER and random.random() < 0.4:
        try:
            new = repr(float(m.group()) * random.choice([-1, 0.01, 0.1, 10, 100, 1e-6, 1e6]))
        except ValueError:
            pass
    return text[: m.start()] + new + text[m.end() :]


def swap_words(random, text):
    words = list(WORD.finditer(text))
    if len(words) < 2:
        return text
    a, b = random.choice(words), random.choice(words)
    return text[: a.start()] + b.group() + text[a.end() :]


def change_lines(random, text):
    lines = text.splitlines()
    i, j = random.randrange(len(lines)), random.randrange(len(lines))
    kind = random.randrange(4)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(j, lines[i])
    elif kind == 2:
        lines[i], lines[j] = lines[j], lines[i]
    else:
        lines[i] = lines[i][: random.randrange(len(lines[i]) + 1)]
    return "\n".join(lines) + "\n"


def change_bytes(random, text):
    at = random.randrange(len(text))
    kind = random.randrange(3)
    if kind == 0:
        return text[:at] + random.choice(BYTES) + text[at:]
    if kind == 1:
        return text[:at] + text[at + 1 :]
    return text[:at]


def mutated(random, text):
    """One to three changes, numbers most often: what is refused at once tests little."""
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        if not text:
            break
        kind = random.random()
        if kind < 0.55:
            text = replace(random, text, NUMBER, NUMBERS)
        elif kind < 0.7:
            text = replace(random, text, STRING, STRINGS)
        elif kind < 0.8:
            text = swap_words(random, text)
        elif kind < 0.93:
            text = change_lines(random, text)
        else:
            text = change_bytes(random, text)
    return text
