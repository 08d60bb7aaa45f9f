#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""figure_layout_test.py PROGRAM: in each figure of a command, at three sizes, all labels are on the page and apart.

pdftotext says where the words of a drawing are. A TikZ drawing is typeset first, where pdflatex is installed."""
import itertools
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SIZES = "8x6", "12x8", "16x10"
MOTION = "base", "tip", "displacement", "time", "limit"
# The command, words of its figure, and the sizes that are too small for it.
FIGURES = {
    "criterion": ("criterion damped", ("excitation", "frequency", "amplitude", "critical", "natural", "slips", "sticks", "case"), ()),
    "held": ("criterion road", (*MOTION, "holding", "held"), ()),
    "map": ("map paper --x frequency=20:30:6 --y amplitude=1e-4:1e-3:5", ("frequency", "amplitude", "1/30"), ()),
    "decades": ("map paper --x length=0.5:2:6:log --y force=10:1e5:5:log", ("length", "axial", "force", "stick", "state"), ()),
    "states": ("map paper --x frequency=20:30:6 --y amplitude=1e-4:1e-3:5 --states-only", ("frequency", "stick", "stick-slip"), ()),
    "motion": ("map damped --x frequency=20:30:2 --y amplitude=1e-3:2e-3:2 --quantity peak-to-peak --set numerics.modes=3 --duration 0.5",
               ("frequency", "amplitude", "peak"), ()),
    "plan": ("criterion paper --plan plan.csv", ("margin", "row", "limit", "sticks", "slips"), ()),
    "modes": ("modes paper --count 8", ("deflection", "x", *(f"{n}:" for n in range(1, 9))), ()),
    "history": ("respond damped --amplitude 1.5mm --duration 0.3 --method event-driven --output h.csv",
                (*MOTION, "midspan", "stick", "slip", "friction", "force"), ()),
    "windows": ("nvh squeak-stand", (*MOTION, "stick", "slip", "windows", "slips", "peak", "wall"), ("8x6",)),
    "squeal": ("squeal reed --map s.csv --speeds 0.05:1 --ratios 0.001:0.05", ("speed", "damping", "steady", "squeal"), ()),
    "sweep": ("sweep damped --parameter amplitude=1e-3:1.5e-3:3 --settle 2 --periods 4 --set numerics.modes=5 --output s.csv",
              ("amplitude", "displacement", "force", "rising", "falling"), ()),
    "margins": ("uncertainty uncertain --samples 100", ("margin", "samples", "slips", "sticks"), ()),
    "one": ("compare friction-maxima friction-maxima.csv", ("frequency", "force", "difference", "reference", "yours", "allowed"), ()),
    "three": ("compare stick-frequencies stick.csv", ("mode", "trigonometric", "difference", "reference", "yours"), ("8x6", "12x8")),
    "validation": ("validate", ("period", "Slider", "Friction", "Strip", "play", "dimensions", "energy"), ("8x6",)),
}
TEX = r"""\documentclass{article}\usepackage[paperwidth=%scm,paperheight=%scm,margin=0pt]{geometry}
\usepackage{gnuplot-lua-tikz}\pagestyle{empty}\parindent0pt\topskip0pt\begin{document}\input{figure.tex}\end{document}"""


def words_of(pdf):
    """The page, and the words with their boxes: xMin, yMin, xMax, yMax, pt."""
    text = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, text=True, check=True).stdout
    page = [float(x) for x in re.search(r'<page width="([\d.]+)" height="([\d.]+)"', text).groups()]
    word = re.compile(r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">(.*?)</word>')
    return page, [([float(x) for x in found[:4]], found[4]) for found in word.findall(text)]


def overlap(one, other):
    """Whether two words cover each other. A box is as high as the font, a third of it over and under the letters, which are cut off. Which side
    that is, a word of one or two letters does not tell: it is cut on all sides."""
    def inner(box, text):
        wide, high = box[2] - box[0], box[3] - box[1]
        cut = min(wide, high) / 6
        x, y = cut * (wide < high or len(text) < 3), cut * (wide > high or len(text) < 3)
        return box[0] + x, box[1] + y, box[2] - x, box[3] - y
    a, b = inner(*one), inner(*other)
    return min(a[2], b[2]) > max(a[0], b[0]) and min(a[3], b[3]) > max(a[1], b[1])


class FigureLayout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "plan.csv").write_text("excitation.amplitude\n1e-6\n1e-4\n1e-3\n")
        for name in "friction-maxima", "stick-frequencies":  # stick.csv
            self.run_program(f"reference export {name} --output .")

    def run_program(self, line):
        done = subprocess.run([PROGRAM, *line.split()], cwd=self.folder, capture_output=True, text=True)
        return done.returncode, done.stderr

    def draw(self, name, size, ending, options=""):
        """The size that is drawn: that one, or the smallest that the program names."""
        command, _, too_small = FIGURES[name]
        line = f"{command} --figure figure.{ending} {options} --size "
        status, errors = self.run_program(line + size)
        least = re.search(r"must be at least (\S+) for all labels", errors)
        self.assertEqual(bool(least), size in too_small, errors)
        if least:
            size = least[1]
            status, errors = self.run_program(line + size)
        self.assertEqual(status, 0, errors)
        return [float(x) for x in size.split("x")]

    def check(self, pdf, labels, size):
        page, words = words_of(pdf)
        for wide, drawn in zip(size, page):
            self.assertAlmostEqual(wide / 2.54 * 72, drawn, delta=1)
        for label in labels:
            self.assertTrue(any(label in text for _, text in words), f"no {label}")
        for box, text in words:
            self.assertTrue(box[0] >= 0 and box[1] >= 0 and box[2] <= page[0] and box[3] <= page[1], f"{text} leaves the page")
        for one, other in itertools.combinations(words, 2):
            self.assertFalse(overlap(one, other), f"{one[1]} lies on {other[1]}")

    def test_labels_are_on_the_page_and_apart(self):
        for name, size in itertools.product(FIGURES, SIZES):
            with self.subTest(name, size=size):
                drawn = self.draw(name, size, "pdf")
                self.check(self.folder / "figure.pdf", FIGURES[name][1], drawn)

    @unittest.skipUnless(shutil.which("pdflatex"), "no pdflatex")
    def test_tex_is_typeset_with_the_same_labels(self):
        for name in FIGURES:
            with self.subTest(name):
                drawn = self.draw(name, "12x8", "tex", "--font Any,7")
                (self.folder / "page.tex").write_text(TEX % tuple(drawn))
                done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "page.tex"], cwd=self.folder, capture_output=True, text=True,
                                      errors="replace")
                self.assertEqual(done.returncode, 0, done.stdout[-2000:])
                self.check(self.folder / "page.pdf", FIGURES[name][1], drawn)

    def test_png_and_svg_have_the_size(self):
        for name in FIGURES:
            with self.subTest(name):
                wide, high = self.draw(name, "12x8", "png")
                self.assertEqual(struct.unpack(">II", (self.folder / "figure.png").read_bytes()[16:24]), (80 * wide, 80 * high))
                self.draw(name, "12x8", "svg")
                text = (self.folder / "figure.svg").read_text()
                for label in FIGURES[name][1]:
                    self.assertIn(label, re.sub("<[^>]*>", "", text))


    def test_report_draws_a_figure_of_the_paper_with_another_law(self):
        line = "report --only fig2,fig11 --output drawn --size 12x"
        self.assertEqual(self.run_program(line + "6 --set friction.static_coefficient=0.5")[0], 0)
        for name, size, labels in ("fig2", (12, 6), ("0.5", "velocity")), ("limits", (12, 6), ("start-up", "steady", "amplitude")):
            self.check(self.folder / f"drawn/{name}.pdf", labels, size)
        self.assertIn("must be at least 1", self.run_program(line + "4")[1])
        self.assertIn("must be at least 2", self.run_program(line + "6 --font Any,12")[1])
        self.assertIn("--font is Any,12", self.run_program("report --only fig2 --output drawn --font Any,12")[1])
        self.assertIn("static-shapes", self.run_program("report --only fig8")[1])


if __name__ == "__main__":
    unittest.main()
