"""Figures in a text: written by a run, found again by the words around them."""

import math
import re

# A number as documents write it, or a word where a text is asked for.
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
WORD = r"[A-Za-z][A-Za-z ]*"
GAP = re.compile(r"\{(:[^{}]*)?\}")


class Fresh:
    """A figure of a run: its value, and how far a text may be from it.

    within: units of the last digit that the text has; relative: of the value (what optimisers and other
    kernels of OpenBLAS leave open); most: the text and the value are at most that, and nothing else is asked
    (residuals, whose digits mean nothing). The largest of within and relative counts.
    """

    def __init__(self, value, within=1.0, relative=0.0, most=None):
        self.value, self.within, self.relative, self.most = value, within, relative, most

    def agrees(self, text):
        if isinstance(self.value, str):
            return text == self.value
        written = float(text)
        if self.most is not None:
            return max(abs(written), abs(self.value)) <= self.most or max(written, self.value) <= 0
        allowed = max(self.within * unit_of_last_digit(text), self.relative * abs(self.value))
        return abs(written - self.value) <= allowed * (1 + 1e-9)


def unit_of_last_digit(text):
    """Of "5.144e-4" 1e-7, of "-23.479" 1e-3."""
    mantissa, _, exponent = text.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def show(form, value):
    """A value as documents write it: "5.144e-4", not "5.144e-04"; "0", not "-0"."""
    text = value if isinstance(value, str) else ("{" + (form or "") + "}").format(value)
    text = re.sub(r"e([-+])0*(\d+)$", lambda m: "e" + m[1].replace("+", "") + m[2], text)
    return text.lstrip("-") if re.fullmatch(r"-0(\.0*)?", text) else text


class Sentence:
    """Words with gaps, "{:.5f}", that hold figures; a line break of the document counts as a space."""

    def __init__(self, words, figures):
        """figures: a function that runs what is needed and returns as many Fresh (or numbers, or texts)."""
        self.words, self.figures = words, figures
        self.forms = [m[1] for m in GAP.finditer(words)]

    def pattern(self, fresh=None):
        """The words, each gap a group; before a run a number or a word."""
        gaps = [f"({NUMBER}|{WORD})" if f is None else f"({WORD})" if isinstance(f.value, str) else f"({NUMBER})"
                for f in fresh or [None] * len(self.forms)]
        parts = [r"\s+".join(map(re.escape, re.split(r"\s+", part))) for part in GAP.sub("\0", self.words).split("\0")]
        return "".join(part + gap for part, gap in zip(parts, [*gaps, ""]))

    def place(self, text, fresh=None):
        """Where it stands, once. @throws LookupError"""
        found = list(re.finditer(self.pattern(fresh), text))
        if len(found) != 1:
            raise LookupError(f"found {len(found)} times instead of once: {self.words}")
        return found[0]


def evaluate(sentence):
    """The figures of a sentence, of a run. @throws LookupError if they are not as many as its gaps"""
    fresh = [f if isinstance(f, Fresh) else Fresh(f) for f in sentence.figures()]
    if len(fresh) != len(sentence.forms):
        raise LookupError(f"{len(fresh)} figures for {len(sentence.forms)} gaps: {sentence.words}")
    if any(not isinstance(f.value, str) and not math.isfinite(f.value) for f in fresh):
        raise LookupError(f"a figure is not finite: {sentence.words}")
    return fresh


def problems(text, sentence, fresh):
    """Yields what a text says otherwise than the run."""
    match = sentence.place(text, fresh)
    for written, form, value in zip(match.groups(), sentence.forms, fresh):
        if not value.agrees(written):
            yield f"{written} instead of {show(form, value.value)}: {sentence.words}"


def rewritten(text, sentence, fresh):
    """The text with the figures of the run."""
    match = sentence.place(text, fresh)
    out, at = [], match.start()
    for group, (form, value) in enumerate(zip(sentence.forms, fresh), 1):
        out += [text[at : match.start(group)], show(form, value.value)]
        at = match.end(group)
    return text[: match.start()] + "".join(out) + text[at:]
