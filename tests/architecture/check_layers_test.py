#!/usr/bin/env python3
"""Shows that check_layers.py can fail: one bad tree for each thing it checks."""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_layers  # noqa: E402

GOOD = {
    "liegroup/so3.hpp": "#pragma once\n#include <Eigen/Core>\n",
    "mbs/model/model.hpp": '#include "liegroup/so3.hpp"\n',
    "optim/cycle/cycle.cpp": '#include "mbs/model/model.hpp"\nint f() {\n  return 1;\n}\n',
}


def errors_of(changes):
    """Errors of the good tree with some files changed or added."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**GOOD, **changes}.items():
            file = Path(folder) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()):
            return check_layers.check(Path(folder))


TESTS = "namespace liesl::test {\n}\n"


class CheckLayers(unittest.TestCase):
    def refuses(self, changes, *words):
        errors = errors_of(changes)
        self.assertTrue(errors, "nothing was found")
        text = "\n".join(errors)
        for word in words:
            self.assertIn(word, text)

    def test_good_tree(self):
        self.assertEqual(errors_of({}), [])

    def test_include_upwards(self):
        self.refuses({"liegroup/se3.hpp": '#include "mbs/model/model.hpp"\n'}, "not below")

    def test_include_of_a_peer(self):
        self.refuses({"mbs/bodies/a.hpp": "", "mbs/couplings/b.hpp": '#include "mbs/bodies/a.hpp"\n'},
                     "not below")

    def test_cycle(self):
        self.refuses({"liegroup/se3.hpp": '#include "mbs/model/model.hpp"\n'},
                     "folder cycle: liegroup -> mbs/model -> liegroup")

    def test_cycle_of_modules_through_a_source(self):
        self.refuses({"mbs/model/a.hpp": "", "mbs/model/a.cpp": '#include "mbs/model/b.hpp"\n',
                      "mbs/model/b.hpp": '#include "mbs/model/a.hpp"\n'},
                     "module cycle: mbs/model/a -> mbs/model/b -> mbs/model/a")

    def test_source_and_its_header_are_no_cycle(self):
        self.assertEqual(errors_of({"mbs/model/a.hpp": "", "mbs/model/b.hpp": "",
                                    "mbs/model/a.cpp": '#include "mbs/model/a.hpp"\n'
                                                       '#include "mbs/model/b.hpp"\n'}), [])

    def test_long_class(self):
        lines = "  int f() const { return 1; }\n" * 125
        body = lines + " private:\n  struct Inner {\n    int x = 0;\n  };\n" + lines
        text = "namespace liesl {\ntemplate <class T, class U = std::vector<T>>\nclass A : B<T> {\n" \
               + body + "};\n}  // namespace\n"
        self.refuses({"mbs/model/a.hpp": text}, "mbs/model/a.hpp:3: class A of 256 lines")
        short = text.replace(lines, "", 1)
        self.assertEqual(errors_of({"mbs/model/a.hpp": short}), [])

    def test_test_that_stands_on_apps(self):
        apps = {"apps/scene/scene.hpp": "", "tests/reference/shipped.hpp":
                '#include "apps/scene/scene.hpp"\n'}
        bad = {"tests/mbs/model/a_test.cpp": '#include "reference/shipped.hpp"\n'}
        self.refuses({**apps, **bad}, "a test of mbs includes", "by tests/reference/shipped.hpp")
        self.refuses({**apps, "tests/optim/cycle/a_test.cpp": '#include "reference/shipped.hpp"\n'},
                     "a test of optim includes")
        good = {"tests/apps/scene/a_test.cpp": '#include "reference/shipped.hpp"\n' + TESTS}
        self.assertEqual(errors_of({**apps, **good}), [])

    def test_test_in_no_folder_of_the_sources(self):
        self.refuses({"tests/mbs/a_test.cpp": ""}, "no folder 'mbs' of sources")
        self.assertEqual(errors_of({"tests/mbs/a_test.cpp": TESTS, "tests/mbs/a.hpp": ""}), [])

    def test_second_namespace_of_tests(self):
        self.refuses({"tests/mbs/run.hpp": "namespace liesl::cases {\n}\n"}, "liesl::cases")
        self.refuses({"tests/mbs/model/a_test.cpp": "namespace liesl {\n}\n"}, "namespace liesl: tests")
        self.refuses({"tests/mbs/model/a_test.cpp": "namespace {\n}\n"}, "in namespace liesl::test::a_test")
        self.refuses({"tests/mbs/model/a_test.cpp": "namespace liesl::test::b_test {\n}\n"}, "liesl::test::b_test: tests")

    def test_cast_of_a_body(self):
        cast = "const auto* b = dynamic_cast<const SolidBody<G>*>(&body);\n"
        self.refuses({"mbs/solvers/a.cpp": cast}, "mbs/solvers/a.cpp: dynamic_cast<const SolidBody<G>*")
        self.refuses({"esl/a.cpp": "dynamic_cast<const BeamChain<G>&>(body);\n"}, "esl/a.cpp: dynamic_cast")
        fixed = "beam.modal = static_cast<const ModalBody<G>*>(beam.body);\n"
        self.refuses({"apps/tasks/a.cpp": fixed}, "apps/tasks/a.cpp: static_cast<const ModalBody<G>*")
        other = "dynamic_cast<const MotionAnalysis<G>&>(given);\n"
        self.assertEqual(errors_of({"mbs/bodies/a.cpp": cast, "optim/cycle/a.cpp": other}), [])

    def test_kind_of_a_body_asked_by_a_solver(self):
        asked = "const auto* body = SolidBody<G>::of(*model.bodies.at(index));\n"
        for path in ("mbs/solvers/a.cpp", "mbs/system/energy.cpp", "mbs/sensitivity/a.hpp"):
            self.refuses({path: asked}, f"{path}: SolidBody<G>::of(: ask a virtual function")
        self.refuses({"mbs/solvers/a.cpp": "BeamChain<SE2>::of(body);\n"}, "BeamChain<SE2>::of(")
        other = "const auto m = BodyMatrix<6>::of(b);\n// SolidBody<G>::of(body)\n"
        good = {"mbs/system/build_body.cpp": asked, "esl/a.cpp": asked, "apps/tasks/a.cpp": asked}
        self.assertEqual(errors_of({**good, "mbs/solvers/a.cpp": other}), [])

    def test_unknown_folder(self):
        self.refuses({"mbs/stuff/a.hpp": ""}, "'mbs/stuff' is not in LAYERS")

    def test_missing_include(self):
        self.refuses({"mbs/model/a.cpp": '#include "liegroup/nothing.hpp"\n'}, "not in the source")

    def test_seam(self):
        self.refuses({"esl/a.cpp": "#include <cholmod.h>\n"}, "belongs to mbs/linalg")

    def test_long_file(self):
        self.refuses({"tests/mbs/model/a_test.cpp": "// line\n" * 701}, "701 lines")
        self.refuses({"apps/plot/a.py": "x = 1\n" * 701}, "701 lines")

    def test_long_function(self):
        body = "template <class T>\nT f(T x) {\n" + "  x += 1;\n" * 90 + "  return x;\n}\n"
        wrapped = "namespace liesl {\nclass A {\n public:\n" + body + "};\n}  // namespace\n"
        self.refuses({"mbs/model/a.hpp": wrapped}, "mbs/model/a.hpp:5: function of 93 lines")

    def test_exempt_function(self):
        body = "  x += 1;\n" * 90
        text = "// long function: one closed formula\nint f(int x) {\n" + body + "}\n"
        self.assertEqual(errors_of({"mbs/model/a.hpp": text}), [])

    def test_braces_in_literals_do_not_count(self):
        text = 'const char* a = "{(";\nchar b = \'{\';\nauto c = R"(f() {)";\n' + "int x;\n" * 100
        self.assertEqual(errors_of({"mbs/model/a.hpp": text}), [])

    def test_drawer(self):
        self.refuses({"mbs/utils/a.hpp": ""}, "'utils' says nothing")

    def test_empty_tree(self):
        with tempfile.TemporaryDirectory() as folder:
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertTrue(check_layers.check(Path(folder)))


if __name__ == "__main__":
    unittest.main()
