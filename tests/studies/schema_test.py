#!/usr/bin/env python3
"""schema_test.py PROGRAM DATA: shipped files fit the JSON Schema that `liesl schema` prints, mistakes do not.

Ends with 77 (skipped) without python3-jsonschema.
"""

import json
import subprocess
import sys
from pathlib import Path

try:
    import tomllib
    from jsonschema import Draft7Validator
except ImportError as error:
    print(f"skipped: {error}; apt-get install python3-jsonschema", file=sys.stderr)
    sys.exit(77)

PROGRAM, DATA = sys.argv[1], Path(sys.argv[2])


def validator(kind):
    text = subprocess.run([PROGRAM, "schema", kind], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    Draft7Validator.check_schema(schema)
    return Draft7Validator(schema)


KINDS = {kind: validator(kind) for kind in ("scene", "study", "batch", "comparison", "sensitivity")}


def kind_of(path):
    first = path.name.split("_")[0]
    return {"batch": "batch", "compare": "comparison", "sensitivity": "sensitivity"}.get(first, "study" if path.parent.name == "studies" else "scene")


def errors(kind, document):
    return [f"{'.'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in KINDS[kind].iter_errors(document)]


failed = 0
files = [path for folder in ("scenes", "parts", "stability", "stability/studies", "studies") for path in sorted((DATA / folder).glob("*.toml"))]
for path in files:
    kind = kind_of(path)
    for error in errors(kind, tomllib.loads(path.read_text(encoding="utf-8"))):
        print(f"{path.name} as a {kind}: {error}")
        failed += 1

# What editors find the schema by: the first line of a file, and the schema as the program prints it.
for path in files:
    line = path.read_text(encoding="utf-8").splitlines()[0]
    up = "../" * len(path.parent.relative_to(DATA).parts)
    if line != f"#:schema {up}schema/{kind_of(path)}.json":
        print(f"{path.name} begins with '{line}'")
        failed += 1
for kind in KINDS:
    written = (DATA / f"schema/{kind}.json").read_text(encoding="utf-8")
    if json.loads(written) != KINDS[kind].schema:
        print(f"data/schema/{kind}.json is not what `liesl schema {kind}` prints")
        failed += 1

scene = tomllib.loads((DATA / "scenes/slider_crank.toml").read_text(encoding="utf-8"))
MISTAKES = {
    "a key that is none": lambda s: s["simulation"].update(stepp=1e-3),
    "a negative step": lambda s: s["simulation"].update(step=-1),
    "a missing modulus": lambda s: s["materials"]["steel"].pop("E"),
    "a body of two kinds": lambda s: s["bodies"]["rod"].update(rigid={"at": [0, 0, 0], "mass": 1}),
    "a point of four numbers": lambda s: s["bodies"]["slider"]["rigid"].update(at=[0, 0, 0, 0]),
    "no diameter": lambda s: s["sections"]["rod"].pop("diameter"),
}
for name, change in MISTAKES.items():
    wrong = json.loads(json.dumps(scene))
    change(wrong)
    if not errors("scene", wrong):
        print(f"{name} is not found")
        failed += 1
print(f"{len(files)} files, {len(MISTAKES)} mistakes, {failed} failed")
sys.exit(1 if failed or not files else 0)
