#!/usr/bin/env python3
"""Checks the shape of the source tree: check_layers.py [ROOT]

- `#include "..."` goes down the list LAYERS only, and there is no folder cycle;
- packages behind a seam are included in their own folder only (SEAMS);
- no file above 700 lines, no function above 80 (an exemption is a comment in the function or in
  the line above it: `// long function: <reason>`);
- no folder that is a drawer (utils, common, ...).

Prints the sizes. Ends with 1 if anything is wrong. Needs nothing but Python 3.
"""

import re
import statistics
import sys
from pathlib import Path

# From the ground up. A folder may include itself and everything before it; folders in one tuple
# are peers and do not see each other. A folder that is not listed is an error: add it here.
LAYERS = [
    ("liegroup",),
    ("mbs/levelset",),
    ("mbs/sections",),
    ("mbs/linalg",),
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
    ("optim/cycle",),
    ("apps/input", "apps/output"),
    ("apps/mesh",),
    ("apps/scene",),
    ("apps/study",),
    ("apps/batch",),
    ("apps/compare", "apps/lean"),
    ("apps/tasks",),
    ("apps/cli",),
    ("apps/bench",),
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
}

DRAWERS = {"utils", "util", "common", "misc", "helpers", "tools", "base", "core"}
MAX_FILE, SOFT_FILE = 700, 400
MAX_FUNCTION, SOFT_FUNCTION = 80, 40
MAX_CLASS = 250

# Includes that close a cycle of modules and classes over the limit that are still to be mended. Only
# for the tree that this script lies in; an entry that is mended is an error until it is taken out.
KNOWN_INCLUDES = {
    ("apps/scene/scene", "apps/scene/reader"),
    ("apps/study/study", "apps/study/study_reader"),
    ("mbs/model/time_function", "mbs/model/time_function_kind"),
    ("mbs/sections/section", "mbs/sections/dual_geometry"),
    ("mbs/sections/section", "mbs/sections/shape_dimensions"),
    ("mbs/solids/solid_model", "mbs/solids/interface_map"),
    ("optim/nlp/ipopt_driver", "optim/nlp/feasibility"),
}
KNOWN_CLASSES = {
    ("apps/lean/lean_search.cpp", "LeanSearch"),
    ("apps/scene/read_solids.cpp", "SolidReader"),
    ("apps/input/validate.cpp", "Validator"),
}
EXEMPT = re.compile(r"//\s*long function: \S")

TOPS = ["liegroup", "mbs", "esl", "optim", "apps"]
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


def reaches(edges, start, end):
    """Whether a path of edges leads from start to end."""
    seen, open_ends = set(), [start]
    while open_ends:
        here = open_ends.pop()
        if here == end:
            return True
        if here not in seen:
            seen.add(here)
            open_ends += edges.get(here, ())
    return False


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


def check_classes(texts, known=frozenset()):
    errors, met = [], set()
    for path, text in texts.items():
        for name, first, last in classes(text):
            if last - first + 1 <= MAX_CLASS:
                continue
            met.add((path, name))
            if (path, name) not in known:
                errors.append(f"{path}:{first}: class {name} of {last - first + 1} lines, the limit is "
                              f"{MAX_CLASS}")
    return errors + [f"{path}: class {name} is not too long any more: take it out of KNOWN_CLASSES"
                     for path, name in sorted(known - met)]


def check_modules(texts, known=frozenset()):
    edges, errors = module_edges(texts), []
    for here, there in sorted(known):
        if there not in edges.get(here, ()) or not reaches(edges, there, here):
            errors.append(f"{here} -> {there} closes no cycle any more: take it out of KNOWN_INCLUDES")
    for here, there in known:
        edges.get(here, set()).discard(there)
    cycle = find_cycle(edges)
    return errors + (["module cycle: " + " -> ".join(cycle)] if cycle else [])


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


def check(root):
    """Everything that is wrong in the tree at `root`, as texts."""
    read = lambda *which: {p: (root / p).read_text(encoding="utf-8")
                           for p in source_files(root, *which)}
    sources, tests, scripts = read(TOPS), read(["tests"]), read([*TOPS, "tests"], (".py",))
    errors, edges = check_includes(sources)
    cycle = find_cycle(edges)
    if cycle:
        errors.append("folder cycle: " + " -> ".join(cycle))
    own = root.resolve() == Path(__file__).resolve().parents[2]
    errors += check_modules(sources, KNOWN_INCLUDES if own else set())
    errors += check_classes({**sources, **tests}, KNOWN_CLASSES if own else set())
    errors += check_sizes({**sources, **tests}) + check_scripts(scripts)
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
