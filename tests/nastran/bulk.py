"""Reads a deck of Nastran by the rules of its fixed fields, and of nothing else: what is written wrong raises
DeckError with the line."""

import re

WIDTH = 80  # columns that are read
TITLE = 72  # of the case control
LARGE, SMALL = 16, 8  # columns of a field
# Types of the fields after the name: I integer, R real, A text; blanks may stand for any but those in upper case.
CARDS = {
    "GRID": "Iirrrii", "MAT1": "IRrRr", "PSOLID": "II", "PSHELL": "IIR", "PBARL": "II-A----RRRRRR",
    "CBAR": "IIIIRRR", "CTRIA3": "II" + 3 * "I", "CTRIA6": "II" + 6 * "I", "CQUAD4": "II" + 4 * "I",
    "CQUAD8": "II" + 8 * "I", "CTETRA": "II" + 10 * "i", "CHEXA": "II" + 20 * "i",
    "FORCE": "IIiRRRR", "MOMENT": "IIiRRRR", "SPC": "IIIR", "SPC1": "III", "LOAD": "IR" + 200 * "ri",
    "PARAM": "AI", "NLPARM": "II",
}
REAL = re.compile(r"[+-]?(\d+\.\d*|\.\d+)(E[+-]?\d+|[+-]\d+)?$")  # a point is what makes it a real number


class DeckError(Exception):
    pass


class Deck:
    """`control`: lines; `subcases`: number -> {"LOAD": n, ...}; `cards`: name -> lists of fields (None: blank)."""

    def __init__(self, text):
        self.control, self.subcases, self.cards = [], {}, {}
        lines = text.split("\n")
        if lines[-1] != "" or "ENDDATA" not in lines:
            raise DeckError("the deck does not end with ENDDATA and a line end")
        for n, line in enumerate(lines, 1):
            if len(line) > WIDTH or "\t" in line or not line.isascii():
                raise DeckError(f"line {n} has {len(line)} columns, tabs or foreign letters: {line}")
        begin, end = lines.index("BEGIN BULK"), lines.index("ENDDATA")
        self._read_control([line for line in lines[:begin] if not line.startswith("$")])
        self._read_bulk([(n, line) for n, line in enumerate(lines[:end], 1) if n > begin + 1 and not line.startswith("$")])
        self._check_loads()

    def of(self, name):
        return self.cards.get(name, [])

    def _read_control(self, lines):
        if not re.fullmatch(r"SOL (101|106)", lines[0]) or lines[1] != "CEND":
            raise DeckError(f"executive control: {lines[:2]}")
        self.solution, case = int(lines[0].split()[1]), {}
        self.common = case
        for line in lines[2:]:
            if len(line) > TITLE:
                raise DeckError(f"case control has {len(line)} columns: {line}")
            self.control.append(line)
            if line.startswith("SUBCASE "):
                case = self.subcases[int(line.split()[1])] = dict(self.common)
            elif found := re.fullmatch(r"\s*(LOAD|SPC|NLPARM) = (\d+)", line):
                case[found.group(1)] = int(found.group(2))
            elif not re.match(r"\s*(TITLE|LABEL|DISPLACEMENT) = ", line):
                raise DeckError(f"case control: {line}")

    def _read_bulk(self, lines):
        entry = []
        for n, line in [*lines, (0, "END")]:
            if entry and line.startswith("*"):
                entry.append((n, line))
                continue
            if entry:
                self._add(entry)
            entry = [(n, line)]

    def _check_loads(self):
        """Every set of loads that is asked for has a card."""
        single = {card[0] for name in ("FORCE", "MOMENT") for card in self.of(name)}
        combined = {card[0]: card[3::2] for card in self.of("LOAD")}
        for case, of in self.subcases.items():
            number = of.get("LOAD")
            if number is not None and number not in single | set(combined):
                raise DeckError(f"subcase {case} asks for loads {number}, of which there is no card")
        for number, sets in combined.items():
            missing = {s for s in sets if s is not None} - single
            if missing:
                raise DeckError(f"LOAD {number} combines sets {sorted(missing)}, of which there is no card")

    def _add(self, entry):
        n, first = entry[0]
        if "," in first[:10]:
            fields = first.split(",")
            name, fields = fields[0], fields[1:]
            if any(len(field) > SMALL for field in fields) or len(fields) > 8 or len(entry) > 1:
                raise DeckError(f"line {n}: free fields of more than 8 columns, or more than 8 of them: {first}")
        else:
            name, fields = first[:8].rstrip(), []
            if not name.endswith("*") or len(entry) % 2:
                raise DeckError(f"line {n}: no large fields, or an odd number of lines: {first}")
            name = name[:-1]
            for at, line in entry:
                if at != n and line[:8].rstrip() != "*":
                    raise DeckError(f"line {at}: what continues an entry begins with '*': {line}")
                fields += [line[8 + LARGE * k: 8 + LARGE * (k + 1)] for k in range(4)]
                if line[8 + 4 * LARGE:].strip():
                    raise DeckError(f"line {at}: something stands behind the last field: {line}")
        fields = [field.strip() for field in fields]
        while fields and not fields[-1]:
            fields.pop()
        self.cards.setdefault(name, []).append(self._typed(name, fields, n))

    @staticmethod
    def _typed(name, fields, n):
        kinds = CARDS.get(name)
        if kinds is None or len(fields) > len(kinds):
            raise DeckError(f"line {n}: {name} is not known, or has {len(fields)} fields")
        out = []
        for k, kind in enumerate(kinds):
            text = fields[k] if k < len(fields) else ""
            if not text:
                if kind.isupper() and name != "PBARL":
                    raise DeckError(f"line {n}: field {k + 2} of {name} is blank")
                out.append(None)
            elif kind in "Ii" and re.fullmatch(r"\d{1,8}", text):
                out.append(int(text))
            elif kind in "Rr" and REAL.match(text):
                out.append(float(re.sub(r"(?<=[\d.])([+-]\d+)$", r"E\1", text) if "E" not in text else text))
            elif kind == "A" and re.fullmatch(r"[A-Z][A-Z0-9]{0,7}", text):
                out.append(text)
            else:
                raise DeckError(f"line {n}: field {k + 2} of {name} is '{text}', which is no {kind}")
        return out


def by_number(cards):
    """Number -> card; each number once."""
    out = {}
    for card in cards:
        if card[0] in out:
            raise DeckError(f"{card[0]} is there twice")
        out[card[0]] = card
    return out
