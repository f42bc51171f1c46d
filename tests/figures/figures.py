#!/usr/bin/env python3
"""figures.py PROGRAM DATA [scenes|studies|stability ...]: the figures in data/*/README.md, from one run of each.

Runs what the sentences of scenes.py and studies.py need and compares: a figure may be off by one unit of its last
digit, that of an optimised design by what another kernel of OpenBLAS leaves open.

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
import scenes  # noqa: E402
import studies  # noqa: E402
from runs import Runner  # noqa: E402
from sentences import evaluate, problems, rewritten  # noqa: E402

DOCUMENTS = {"scenes": scenes.sentences, "studies": studies.sentences, "stability": studies.stability}


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


def document(word):
    """A place of figures; argparse's own choices refuse that none is named."""
    if word not in DOCUMENTS:
        raise argparse.ArgumentTypeError(f"'{word}' is none of {', '.join(DOCUMENTS)}")
    return word


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("data", type=Path)
    parser.add_argument("documents", nargs="*", type=document)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--solved", type=Path)
    parser.add_argument("--only", default="")
    o = parser.parse_args()
    held, wrong = 0, []
    with tempfile.TemporaryDirectory(prefix="liesl-figures-") as work:
        run = Runner(o.program, o.data, Path(work), o.solved)
        for name in o.documents or DOCUMENTS:
            file = o.data / name / "README.md"
            for sentence in DOCUMENTS[name](run):
                if o.only not in sentence.words:
                    continue
                count, found = look(file, sentence, o.write)
                held += count
                wrong += found
                for line in found:
                    print(f"data/{name}/README.md: {line}", flush=True)
    print(f"{held} figures, {len(wrong)} of them wrong")
    return 1 if wrong or held == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
