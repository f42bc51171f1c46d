#!/usr/bin/env python3
"""Checks the shape of the source tree: check_layers.py [ROOT]

- `#include "..."` goes down the list LAYERS only, and there is no folder cycle;
- packages behind a seam are included in their own folder only (SEAMS);
- no file above 700 lines, no function above 80 (an exemption is a comment in the function or in
  the line above it: `// long function: <reason>`);
- no folder that is a drawer (utils, common, ...);
- tests of a library stand on it and those below it (TEST_FOLDERS), in the folders of the sources and
  in namespace liesl::test, or in one of the source's name within it (unity builds: one source sees
  what another calls the same);
- bodies are cast in mbs/bodies only (BODY_CAST); `SolidBody::of` and the like are asked neither in
  mbs/solvers and mbs/sensitivity nor in mbs/system but where bodies are built (BODY_OF).

Prints the sizes, and lines of test by lines of source. Ends with 1 if anything is wrong. Needs nothing but Python 3.
"""

import re
import statistics
import sys
from pathlib import Path

# From the ground up. A folder may include itself and everything before it; folders in one tuple
# are peers and do not see each other. A folder that is not listed is an error: add it here.
LAYERS = [
    ("liegroup",),
    ("mbs/linalg",),
    ("mbs/levelset",),
    ("mbs/sections",),
    ("mbs/solids",),
    ("mbs/model",),
    ("mbs/bodies", "mbs/couplings"),
    ("mbs/system",),
    ("mbs/solvers",),
    ("mbs/sensitivity",),
    ("esl",),
    ("optim/nlp",),
    ("optim/study",),
    ("optim/design",),
    ("optim/problems",),
    ("optim/cycle",),
    ("apps/input", "apps/output"),
    ("apps/report",),
    ("apps/mesh",),
    ("apps/scene",),
    ("apps/study",),
    ("apps/batch",),
    ("apps/compare", "apps/lean"),
    ("apps/tasks",),
    ("apps/export",),
    ("apps/cli",),
    ("apps/bench",),
    ("python/module",),
]

# Headers of a package, and the folders that may include them.
SEAMS = {
    r"(cholmod|klu|umfpack|amd|colamd|btf)\.h": ["mbs/linalg"],
    r"(coin/)?Ip\w+\.h(pp)?": ["optim/nlp"],
    r"nlopt\.h(pp)?": ["optim/nlp"],
    r"muParser.*\.h": ["mbs/model"],
    r"hdf5.*\.h": ["apps/output"],
    r"openssl/.*": ["apps/output"],
    r"toml\+\+/.*|toml\.hpp": ["apps/input", "apps/scene", "apps/study", "apps/cli"],
    r"CLI/.*": ["apps/cli"],
    r"benchmark/.*": ["apps/bench"],
    r"pybind11/.*": ["python/module"],
}

DRAWERS = {"utils", "util", "common", "misc", "helpers", "tools", "base", "core"}
MAX_FILE, SOFT_FILE = 700, 400
MAX_FUNCTION, SOFT_FUNCTION = 80, 40
MAX_CLASS = 250

EXEMPT = re.compile(r"//\s*long function: \S")

TOPS = ["liegroup", "mbs", "esl", "optim", "apps", "python"]
RANK = {folder: rank for rank, layer in enumerate(LAYERS) for folder in layer}


def folder_of(path):
    """Folder of a source path as a string, '' for the root."""
    return "/".join(path.split("/")[:-1])


def source_files(root, tops, kinds=(".hpp", ".cpp")):
    return sorted(
        p.relative_to(root).as_posix()
        for top in tops
        for p in (root / top).rglob("*")
        if p.suffix in kinds
    )


# --- includes ------------------------------------------------------------------------------------


def includes(text):
    """(path, is_quoted) of every #include."""
    found = re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', text, re.M)
    return [(path, mark == '"') for mark, path in found]


def check_includes(texts):
    """Errors of direction and of seams, and the edges folder -> folder."""
    errors, edges = [], {}
    for path, text in texts.items():
        here = folder_of(path)
        if here not in RANK:
            errors.append(f"{path}: folder '{here}' is not in LAYERS of check_layers.py")
            continue
        for target, quoted in includes(text):
            if not quoted:
                errors += seam_errors(path, here, target)
                continue
            there = folder_of(target)
            if target not in texts:
                errors.append(f'{path}: includes "{target}", which is not in the source tree')
            elif there in RANK and there != here:
                edges.setdefault(here, set()).add(there)
                if RANK[there] >= RANK[here]:
                    errors.append(f'{path}: includes "{target}", but {there} is not below {here}')
    return errors, edges


def seam_errors(path, here, header):
    for pattern, folders in SEAMS.items():
        if re.fullmatch(pattern, header) and here not in folders:
            return [f"{path}: includes <{header}>, which belongs to {', '.join(folders)}"]
    return []


def module_edges(texts):
    """Includes between modules; a module is a header and the source of the same name as one."""
    module = lambda path: path.rsplit(".", 1)[0]
    edges = {}
    for path, text in texts.items():
        there = {module(target) for target, quoted in includes(text) if quoted}
        edges.setdefault(module(path), set()).update(there - {module(path)})
    return edges


def find_cycle(edges):
    """A cycle of folders or modules as a list of names, or None."""
    done, path = set(), []

    def visit(folder):
        if folder in path:
            return path[path.index(folder):] + [folder]
        if folder in done:
            return None
        path.append(folder)
        for other in sorted(edges.get(folder, ())):
            cycle = visit(other)
            if cycle:
                return cycle
        done.add(path.pop())
        return None

    return next((c for c in map(visit, sorted(edges)) if c), None)


# --- sizes ---------------------------------------------------------------------------------------

NOISE = re.compile(
    r'R"([^(\s]*)\((?:.|\n)*?\)\1"'  # raw strings
    r'|"(?:\\.|[^"\\\n])*"'  # strings
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])'"  # characters, not digit separators
    r"|//[^\n]*|/\*(?:.|\n)*?\*/"
)
SCOPE = re.compile(r"\b(namespace|class|struct|union|enum|extern)\b")


def without_noise(text):
    """The text without comments and literals; line numbers stay."""
    return NOISE.sub(lambda m: "\n" * m.group().count("\n"), text)


def functions(text):
    """(first line, last line) of every outermost block that looks like a function body.

    A brace opens a function if the statement before it has parentheses and is not a class, a
    namespace or the like. Good enough for formatted sources.
    """
    found, stack, statement, line = [], [], "", 1
    for char in without_noise(text):
        if char == "\n":
            line += 1
        if char == "{":
            head = re.sub(r"template\s*<[^{]*?>\s*(?=class|struct)", "", statement.strip())
            scope = SCOPE.search(head.split("(")[0]) and not head.rstrip().endswith(")")
            inside = any(kind for kind, _ in stack)
            stack.append((bool(not scope and not inside and "(" in head), line))
            statement = ""
        elif char == "}":
            if stack:
                is_function, start = stack.pop()
                if is_function:
                    found.append((start, line))
            statement = ""
        elif char == ";":
            statement = ""
        else:
            statement += char
    return found


def classes(text):
    """(name, first line, last line) of every class and struct, those in others included."""
    found, stack, statement, line = [], [], "", 1
    for char in without_noise(text):
        if char == "\n":
            line += 1
        if char == "{":
            head = re.sub(r"template\s*<(?:[^<>]|<[^<>]*>)*>", "", statement).strip()
            name = re.match(r"(?:class|struct)\s+(?:alignas\([^)]*\)\s*)?(\w+)", head)
            stack.append((name.group(1) if name else None, line))
        elif char == "}" and stack:
            name, start = stack.pop()
            if name:
                found.append((name, start, line))
        statement = "" if char in "{};" else statement + char
        if statement.strip() in ("public:", "private:", "protected:"):
            statement = ""
    return found


def check_sizes(texts):
    errors = []
    for path, text in texts.items():
        lines = text.splitlines()
        if len(lines) > MAX_FILE:
            errors.append(f"{path}: {len(lines)} lines, the limit is {MAX_FILE}")
        for first, last in functions(text):
            length = last - first + 1
            exempt = any(EXEMPT.search(line) for line in lines[max(0, first - 4):last])
            if length > MAX_FUNCTION and not exempt:
                errors.append(f"{path}:{first}: function of {length} lines, the limit is "
                              f"{MAX_FUNCTION}")
    return errors


def check_classes(texts):
    return [f"{path}:{first}: class {name} of {last - first + 1} lines, the limit is {MAX_CLASS}"
            for path, text in texts.items() for name, first, last in classes(text)
            if last - first + 1 > MAX_CLASS]


def check_modules(texts):
    cycle = find_cycle(module_edges(texts))
    return ["module cycle: " + " -> ".join(cycle)] if cycle else []


# --- tests ---------------------------------------------------------------------------------------

# Tests of a top folder include it and those before it.
TEST_FOLDERS = {"liegroup", "mbs", "esl", "optim", "apps"}


def reached(path, tests, sources):
    """Top folders of sources that a file of tests includes, itself or by another one of tests."""
    seen, open_ends, tops = set(), [path], {}
    while open_ends:
        here = open_ends.pop()
        if here in seen:
            continue
        seen.add(here)
        for target, quoted in includes(tests[here]):
            below = target if target in tests else f"tests/{target}"
            if quoted and target in sources:
                tops.setdefault(target.split("/")[0], f'"{target}" by {here}')
            elif quoted and below in tests:
                open_ends.append(below)
    return tops


def check_tests(tests, sources):
    """Errors of what tests stand on, where they lie and in which namespace."""
    errors = []
    for path, text in tests.items():
        top, *rest = path.split("/")[1:]
        names = set(re.findall(r"^namespace (\w[\w:]*) \{", text, re.M))
        stem = path.split("/")[-1].split(".")[0]
        own = {"liesl::test"} | ({f"liesl::test::{stem}"} if stem.endswith("_test") else set())
        for name in sorted(names - own - {"detail"}):
            errors.append(f"{path}: namespace {name}: tests are in liesl::test")
        if stem.endswith("_test") and not names & own:
            errors.append(f"{path}: tests are in namespace liesl::test::{stem}")
        if top not in TEST_FOLDERS:
            continue
        limit = TOPS.index(top)
        for there, how in reached(path, tests, sources).items():
            if TOPS.index(there) > limit:
                errors.append(f"{path}: a test of {top} includes {how}")
        folder, helper = folder_of(path[len("tests/"):]), path.replace("_test.cpp", ".hpp")
        if path.endswith("_test.cpp") and folder not in RANK and helper not in tests:
            errors.append(f"{path}: there is no folder '{folder}' of sources")
    return errors


def print_test_lines(tests, sources):
    """Lines of test by lines of source, by folder, as a table of Markdown."""
    count = lambda texts, folder: sum(len(t.splitlines()) for p, t in texts.items()
                                      if folder_of(p) == folder)
    print("| folder | lines of source | lines of test | test/source |\n|---|---|---|---|")
    for folder in [name for layer in LAYERS for name in layer]:
        lines, tested = count(sources, folder), count(tests, "tests/" + folder)
        if lines:
            print(f"| {folder} | {lines} | {tested} | {tested / lines:.2f} |")
    for top in TOPS:
        if top not in RANK and count(tests, "tests/" + top):
            print(f"| shared by tests of {top} | | {count(tests, 'tests/' + top)} | |")
    print(f"| reference answers | | {count(tests, 'tests/reference')} | |")


BODY = r"(?:\w*Body|\w*Beam|BeamChain|Rigid)\b(?:<[^<>]*>)?"
BODY_CAST = re.compile(rf"\b(?:dynamic|static)_cast<(?:const )?{BODY}\s*[&*]")
# For who needs the data of one kind; whoever solves the equations needs none.
BODY_OF = re.compile(rf"\b{BODY}::of\(")
KINDLESS = {"mbs/system", "mbs/solvers", "mbs/sensitivity"}


def check_casts(texts):
    """What kind a body is, only its own folder knows; others ask its virtual functions."""
    errors = []
    for path, text in texts.items():
        folder, code = folder_of(path), without_noise(text)
        found = list(BODY_CAST.finditer(code)) if folder != "mbs/bodies" else []
        if folder in KINDLESS and not path.startswith("mbs/system/build"):
            found += BODY_OF.finditer(code)
        errors += [f"{path}: {cast.group()}: ask a virtual function of Body" for cast in found]
    return errors


def check_scripts(texts):
    """Sizes of Python files."""
    return [f"{path}: {len(text.splitlines())} lines, the limit is {MAX_FILE}"
            for path, text in texts.items() if len(text.splitlines()) > MAX_FILE]


def check_drawers(texts):
    folders = {part for path in texts for part in path.split("/")[:-1]}
    return [f"folder '{name}' says nothing of what is in it" for name in sorted(folders & DRAWERS)]


# --- report --------------------------------------------------------------------------------------


def comment_ratio(text):
    comments = sum(1 for line in text.splitlines() if line.strip().startswith(("//", "/*", "*")))
    code = sum(1 for line in text.splitlines() if line.strip()) - comments
    return comments, max(code, 1)


def statistics_line(name, texts):
    if not texts:
        return f"{name:<14} no files"
    sizes = sorted(len(t.splitlines()) for t in texts.values())
    lengths = sorted(b - a + 1 for t in texts.values() for a, b in functions(t)) or [0]
    comments, code = map(sum, zip(*(comment_ratio(t) for t in texts.values())))
    return (f"{name:<14} {len(sizes):5d} {sum(sizes):7d} {statistics.median(sizes):7.0f} "
            f"{sizes[-1]:5d} {sum(s > SOFT_FILE for s in sizes):6d} | {len(lengths):6d} "
            f"{statistics.median(lengths):7.0f} {lengths[int(0.99 * (len(lengths) - 1))]:5d} "
            f"{lengths[-1]:5d} {sum(n > SOFT_FUNCTION for n in lengths):5d} | "
            f"{comments / code:7.2f}")


def print_statistics(sources, tests):
    print(f"{'':<14} files   lines  median   max  >{SOFT_FILE}  | functs  median   p99   max  "
          f">{SOFT_FUNCTION} | comment/code")
    for top in TOPS:
        print(statistics_line(top, {p: t for p, t in sources.items() if p.startswith(top + "/")}))
    print(statistics_line("all sources", sources))
    print(statistics_line("tests", tests))
    lines = [sum(len(t.splitlines()) for t in group.values()) for group in (tests, sources)]
    print(f"test/source lines {lines[0] / max(lines[1], 1):.2f}")
    print_test_lines(tests, sources)


def check(root):
    """Everything that is wrong in the tree at `root`, as texts."""
    read = lambda *which: {p: (root / p).read_text(encoding="utf-8")
                           for p in source_files(root, *which)}
    sources, tests, scripts = read(TOPS), read(["tests"]), read([*TOPS, "tests"], (".py",))
    errors, edges = check_includes(sources)
    cycle = find_cycle(edges)
    if cycle:
        errors.append("folder cycle: " + " -> ".join(cycle))
    errors += check_modules(sources)
    errors += check_classes({**sources, **tests})
    errors += check_sizes({**sources, **tests}) + check_scripts(scripts)
    errors += check_tests(tests, sources) + check_casts(sources)
    errors += check_drawers({**sources, **tests})
    print_statistics(sources, tests)
    if not sources:
        errors.append(f"no sources under {root}")
    return errors


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2])
    errors = check(root)
    for error in errors:
        print(error)
    print(f"layers and sizes: {len(errors)} errors" if errors else "layers and sizes: fine")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
