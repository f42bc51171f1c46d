#!/usr/bin/env python3
"""What finds, compares and writes figures in texts, on texts of its own; and that every sentence stands in its document."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from figures import PARTS  # noqa: E402
from sentences import Fresh, Sentence, evaluate, problems, rewritten, show  # noqa: E402

TEXT = "| rod | 1.2576 |\nThe rod weighs\n0.2103 kg and ends optimal.\nA rate of 5.144e-4 /s.\n"


def say(words, *values):
    sentence = Sentence(words, lambda: list(values))
    fresh = evaluate(sentence)
    return list(problems(TEXT, sentence, fresh)), rewritten(TEXT, sentence, fresh)


class Sentences(unittest.TestCase):
    def test_agrees_within_a_unit_of_the_last_digit(self):
        self.assertEqual(say("| rod | {:.4f} |", 1.25768)[0], [])
        self.assertEqual(len(say("| rod | {:.4f} |", 1.2579)[0]), 1)

    def test_exponents_have_their_own_last_digit(self):
        self.assertEqual(say("rate of {:.3e} /s", 5.1449e-4)[0], [])
        self.assertEqual(len(say("rate of {:.3e} /s", 5.15e-4)[0]), 1)

    def test_line_breaks_are_spaces_and_texts_are_figures(self):
        problems_, text = say("weighs {:.4f} kg and ends {}.", 0.2103, "infeasible")
        self.assertEqual(problems_, ["infeasible".join(["optimal instead of ", ": weighs {:.4f} kg and ends {}."])])
        self.assertIn("weighs\n0.2103 kg and ends infeasible.", text)

    def test_relative_and_bounded_figures(self):
        self.assertEqual(say("weighs {:.4f} kg", Fresh(0.2106, relative=2e-3))[0], [])
        self.assertEqual(say("rate of {:.3e} /s", Fresh(-3e-4, most=1e-3))[0], [])
        self.assertEqual(len(say("rate of {:.3e} /s", Fresh(2e-3, most=1e-3))[0]), 1)

    def test_refuses_what_is_not_there_once_and_what_is_no_number(self):
        for words in ("weighs {} g", "o{} "):
            with self.assertRaises(LookupError):
                say(words, 1.0)
        with self.assertRaises(LookupError):
            say("| rod | {:.4f} |", float("nan"))
        with self.assertRaises(LookupError):
            say("| rod | {:.4f} |", 1.0, 2.0)

    def test_writes_as_documents_do(self):
        self.assertEqual(show(":.3e", 5.1443e-4), "5.144e-4")
        self.assertEqual(show(":.2f", -0.001), "0.00")
        self.assertEqual(say("| rod | {:.4f} |", 1.3)[1], TEXT.replace("1.2576", "1.3000"))


class Documents(unittest.TestCase):
    def test_every_sentence_stands_in_its_document_once(self):
        """Of all parts, those that only run by hand, too: without a run."""
        for part, (document, sentences) in PARTS.items():
            text = (Path(__file__).parents[2] / document).read_text(encoding="utf-8")
            found = list(sentences(None))
            self.assertTrue(found or part == "long", part)  # which needs a processor with both kernels
            for sentence in found:
                sentence.place(text)


if __name__ == "__main__":
    unittest.main()
