#!/usr/bin/env python3
"""figures.py PROGRAM DATA [PART ...]: the figures in data/*/README.md and of pages in docs/outputs.md, from one run of each.

Runs what the sentences of a part need and compares: a figure may be off by one unit of its last digit, that of an
optimised design by what another kernel of OpenBLAS leaves open. Parts: scenes, studies, methods, kernels, batches, stability,
pages; "long", an hour of runs with two kernels and of the batch, is run only where it is asked for. Times are in no part.

  --write          writes the figures of this run into the documents instead
  --solved DIR     folders of studies that are solved already (build/release/tests/studies)
  --only WORDS     only sentences that hold these words

Ends with 1 and a line a figure if anything differs.
"""

import argparse
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import batches  # noqa: E402
import kernels  # noqa: E402
import pages  # noqa: E402
import scenes  # noqa: E402
import studies  # noqa: E402
from runs import Runner  # noqa: E402
from sentences import evaluate, problems, rewritten  # noqa: E402

STUDIES = "data/studies/README.md"
# Part -> the document, and its sentences.
PARTS = {
    "scenes": ("data/scenes/README.md", scenes.sentences),
    "studies": (STUDIES, studies.sentences),
    "methods": (STUDIES, studies.methods),
    "kernels": (STUDIES, kernels.sentences),
    "batches": (STUDIES, batches.sentences),
    "stability": ("data/stability/README.md", studies.stability),
    "pages": ("docs/outputs.md", pages.sentences),
    "long": (STUDIES, lambda run: [*kernels.long(run), *batches.whole(run)]),
}


def look(file, sentence, write):
    """(figures, problems) of one sentence; with `write` the figures go into the file, and only what is not found is a
    problem."""
    text = file.read_text(encoding="utf-8")
    try:
        fresh = evaluate(sentence)
        found = [] if write else list(problems(text, sentence, fresh))
        if write:
            file.write_text(rewritten(text, sentence, fresh), encoding="utf-8")
    except (LookupError, KeyError) as problem:
        return 0, [f"{type(problem).__name__}: {problem}"]
    return len(fresh), found


def part(word):
    """argparse's own choices refuse that none is named."""
    if word not in PARTS:
        raise argparse.ArgumentTypeError(f"'{word}' is none of {', '.join(PARTS)}")
    return word


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("data", type=Path)
    parser.add_argument("parts", nargs="*", type=part)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--solved", type=Path)
    parser.add_argument("--only", default="")
    o = parser.parse_args()
    held, wrong = 0, []
    with tempfile.TemporaryDirectory(prefix="liesl-figures-") as work:
        run = Runner(o.program, o.data, Path(work), o.solved)
        for name in o.parts or [name for name in PARTS if name != "long"]:
            document, sentences = PARTS[name]
            file = o.data.resolve().parent / document
            for sentence in sentences(run):
                if o.only not in sentence.words:
                    continue
                count, found = look(file, sentence, o.write)
                held += count
                wrong += found
                for line in found:
                    print(f"{document}: {line}", flush=True)
    print(f"{held} figures, {len(wrong)} of them wrong")
    return 1 if wrong or held == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
