#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tests the evidence site in headless Chromium.

  site_test.py REPORT AXE

REPORT is the folder of the report, with the folder site. AXE is the folder for axe-core, the accessibility checker, which is
fetched when it is missing. The packages chromium-driver, python3-selenium and poppler-utils are needed.
"""

import base64
import hashlib
import io
import json
import subprocess
import sys
import tarfile
import unittest
import urllib.request
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

AXE_URL = "https://registry.npmjs.org/axe-core/-/axe-core-4.14.1.tgz"
AXE_SHA512 = "FHfa+lmNjQZfJz1q8wKqIDwC6DExcHt/pkjNQb09a3NPjCKg2rhu5qb2S4r76ASyFNNtuFooJpZe37OgudVGtQ=="
# These pages are checked in the browser; the other tables have the same template.
SHOWN = ("index.html", "verdicts.html", "requirements.html", "claims.html", "figures.html", "scoreboard.html", "mutants.html", "data/stick-slip-events.html", "history.html",
         "tables.html", "source/tests/solver/contact_test.cpp.html")


def fetch_axe(folder):
    """The text of axe-core, whose package must have the published digest."""
    file = folder / "axe.min.js"
    if not file.exists():
        package = urllib.request.urlopen(AXE_URL, timeout=60).read()
        digest = base64.b64encode(hashlib.sha512(package).digest()).decode()
        if digest != AXE_SHA512:
            sys.exit(f"the digest of {AXE_URL} is {digest}, but must be {AXE_SHA512}")
        folder.mkdir(parents=True, exist_ok=True)
        with tarfile.open(fileobj=io.BytesIO(package)) as archive:
            file.write_bytes(archive.extractfile("package/axe.min.js").read())
    return file.read_text()


class Links(HTMLParser):
    """The addresses and the identities of a page."""

    def __init__(self, page):
        super().__init__()
        self.addresses, self.identities = set(), []
        self.feed(page.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.addresses.add(value)
            if name == "id":
                self.identities.append(value)


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--host-resolver-rules=MAP * ~NOTFOUND"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(options=options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def open(self, name, width=1200):
        self.browser.set_window_size(width, 900)
        self.browser.get((SITE / name.partition("?")[0]).as_uri() + "".join(name.partition("?")[1:]))

    def shown_rows(self):
        return [row for row in self.browser.find_elements(By.CSS_SELECTOR, "tbody tr") if row.is_displayed()]

    def test_links_resolve(self):
        pages = {page: Links(page) for page in SITE.rglob("*.html")}
        for page, links in pages.items():
            self.assertEqual(len(links.identities), len(set(links.identities)), f"{page}: an id stands twice")
            for address in links.addresses:
                parts = urlsplit(address)
                if parts.scheme == "data":
                    continue
                self.assertEqual(parts.scheme + parts.netloc, "", f"{page}: {address} leaves the site")
                target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
                self.assertTrue(target.is_file(), f"{page}: {address} is missing")
                if parts.fragment:
                    self.assertIn(unquote(parts.fragment), pages[target].identities, f"{page}: {address} has no target")

    def test_loads_without_network_and_without_errors(self):
        for name in SHOWN:
            with self.subTest(name):
                self.open(name)
                loaded = self.browser.execute_script("return performance.getEntriesByType('resource').map(e => e.name)")
                self.assertEqual([address for address in loaded if not address.startswith(("file:", "data:"))], [])
                self.assertEqual(self.browser.get_log("browser"), [])

    def test_search_keeps_the_rows_with_all_words(self):
        self.open("requirements.html")
        rows = len(self.shown_rows())
        self.browser.find_element(By.ID, "query").send_keys("energies BALANCE")
        found = self.shown_rows()
        self.assertGreater(rows, 50)
        self.assertEqual([row.get_attribute("id") for row in found], ["F8"])
        self.assertEqual(self.browser.find_element(By.ID, "count").text, f"1 of {rows} rows")

    def test_search_over_all_pages_leads_to_sentences_and_rows(self):
        for name, words, found in ((SHOWN[0], "E6 errATA", "errata.html"), (SHOWN[-1], "which data SET for", "data.html"),
                                   (SHOWN[1], "undamped-history-70 tolerances", "data/undamped-history-70.html")):
            with self.subTest(name):
                self.open(name)
                self.browser.find_element(By.ID, "everywhere").send_keys(words)
                self.assertRegex(self.browser.find_element(By.ID, "hits").text, r"^\d+ found")
                self.browser.find_element(By.ID, "everywhere").send_keys(Keys.ENTER)
                self.assertIn(found, self.browser.current_url)
        for name in (SHOWN[0], SHOWN[-1]):
            with self.subTest(name):
                self.open(name)
                self.browser.find_element(By.ID, "everywhere").send_keys("flutter LOAD")
                row = next(link for link in self.browser.find_elements(By.CSS_SELECTOR, "#found a") if "#" in link.get_attribute("href"))
                row.click()
                self.assertIn("load", self.browser.find_element(By.CSS_SELECTOR, "tr:target").text.lower())

    def test_groups_lead_to_pages_and_the_matrix_to_its_folded_row(self):
        self.open("data/stick-slip-events.html")
        groups = self.browser.find_elements(By.CSS_SELECTOR, "nav summary")
        self.assertEqual([group.text for group in groups], ["Use it", "Evidence", "Data", "Other codes"])
        groups[3].click()
        self.browser.find_element(By.CSS_SELECTOR, "nav [href$='scoreboard.html']").click()
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "tr:target"), [])
        mark = self.browser.find_elements(By.CSS_SELECTOR, ".matrix .use")[-1]
        code = mark.get_attribute("title").partition(",")[0]
        mark.click()
        row = self.browser.find_element(By.CSS_SELECTOR, "tr:target")
        self.assertTrue(row.is_displayed() and row.text.startswith(code) and "agrees" in row.text, row.text)

    def test_each_criterion_leads_to_its_requirement_tests_data_and_command(self):
        self.open("verdicts.html")
        rows = [[cell.get_attribute("innerHTML") for cell in row.find_elements(By.TAG_NAME, "td")] for row in self.shown_rows()]
        self.assertGreater(sum("figures.html#" in row[10] for row in rows), len(rows) // 2)
        for row in rows:
            for column, link in ((1, "requirements.html#"), (9, "tests.html?q="), (11, "../studies/"), (12, "<code>")):
                self.assertIn(link, row[column])

    def test_history_is_drawn_and_rows_hide_on_a_phone(self):
        self.open("history.html", 500)
        self.assertGreater(len(self.browser.find_elements(By.TAG_NAME, "polyline")), 2)
        self.browser.find_element(By.ID, "query").send_keys("nothing has this")
        self.assertEqual(self.shown_rows(), [])

    def test_link_to_the_tests_of_a_requirement_shows_these_only(self):
        self.open("requirements.html")
        link = self.browser.find_element(By.CSS_SELECTOR, "#X2 a")  # as a word, X2 stands in X20 as well
        count = int(link.text)
        link.click()
        shown = self.browser.execute_script(
            "return [...document.querySelectorAll('tbody tr:not([hidden])')].map(row => row.cells[2].textContent.trim())")
        self.assertEqual(shown, ["X2"] * count)

    def test_front_page_shows_the_critical_amplitude_at_a_frequency(self):
        self.open("index.html")
        tabled = self.browser.execute_script(
            "return [...document.querySelectorAll('figure tbody tr')].map(row => [...row.cells].map(cell => cell.textContent))")
        figure = self.browser.find_element(By.ID, "limits")
        slider = self.browser.find_element(By.ID, "frequency")
        # By a script, because the pointer moves by whole pixels and a row is 1.2 of them wide.
        point = ("const { left, width } = arguments[0].getBoundingClientRect();"
                 "arguments[0].dispatchEvent(new PointerEvent('pointermove', { clientX: left + width * (70 + 426 * 38 / 155) / 516 }))")  # 40 Hz
        for row, move in ((tabled[-1], lambda: slider.send_keys(Keys.END)),
                          (tabled[3], lambda: self.browser.execute_script(point, figure))):
            move()
            self.assertEqual(self.browser.find_element(By.CSS_SELECTOR, "figure output").text, f"{row[0]} Hz")
            shown = [one.text.removesuffix(" mm") for one in self.browser.find_elements(By.CSS_SELECTOR, ".legend strong")]
            self.assertEqual([float(one) for one in shown], [float(one) for one in row[1:]])

    def test_front_page_has_three_boxes_and_leads_to_criteria_without_templates(self):
        self.open("index.html")
        self.assertEqual([box.get_attribute("class") for box in self.browser.find_elements(By.CSS_SELECTOR, "section[class]")], ["use", "margin", "avoid"])
        self.browser.find_element(By.CSS_SELECTOR, "main a[href='argument.html']").click()
        self.browser.find_element(By.CSS_SELECTOR, "#force [data-name='Criteria met'] a").click()
        self.assertGreater(len(self.shown_rows()), 3)
        for page in SITE.glob("*.html"):
            self.assertNotRegex(page.read_text(), r"map\(attribute|<<|&lt;&lt;", page.name)

    def test_sorts_numbers_by_value_in_both_directions(self):
        self.open("tolerances.html")
        head = self.browser.find_elements(By.CSS_SELECTOR, "th button")[5]
        for direction in (1, -1):
            head.click()
            values = self.browser.execute_script("return [...document.querySelectorAll('tbody tr')].map(r => r.cells[5].dataset.value)")
            values = [float(value) for value in values]
            self.assertEqual(values, sorted(values, reverse=direction < 0))
            self.assertLess(min(values), max(values))

    def test_is_readable_at_the_width_of_a_phone(self):
        for name in {*SHOWN, *(page.name for page in SITE.glob("*.html"))}:
            with self.subTest(name):
                self.open(name)
                # Chromium's window is no narrower than 500 pixels: the width is set as a phone has it, with one column in a row, then two.
                for width in (360, 390):
                    self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                                 {"width": width, "height": 740, "deviceScaleFactor": 1, "mobile": True})
                    self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), width)
                self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_report_is_tagged_with_headings_and_all_figures(self):
        structure = subprocess.run(["pdfinfo", "-struct", SITE.parent / "vv-report.pdf"], capture_output=True, text=True, check=True)
        elements = structure.stdout.split()
        self.open("figures.html")
        self.assertEqual(elements.count("Figure"), len(self.shown_rows()))
        self.assertEqual([row.find_element(By.TAG_NAME, "td").text for row in self.shown_rows()][:2], ["1", "2"])
        self.assertEqual(elements.count("Document"), 1)
        self.assertGreater(elements.count("H1"), 10)
        self.assertGreater(elements.count("P"), 500)

    def test_accessibility_checker_finds_no_violation(self):
        for name in SHOWN:
            with self.subTest(name):
                self.open(name)
                self.browser.execute_script(AXE)
                result = self.browser.execute_async_script(
                    "const done = arguments[arguments.length - 1]; axe.run({preload: false}).then(done, error => done({error: String(error)}))")
                self.assertNotIn("error", result)
                self.assertGreater(len(result["passes"]), 15)
                found = [(one["id"], one["help"], [node["html"] for node in one["nodes"]][:3]) for one in result["violations"]]
                self.assertEqual(found, [], json.dumps(found, indent=1))


if __name__ == "__main__":
    SITE = Path(sys.argv[1]).resolve() / "site"
    AXE = fetch_axe(Path(sys.argv[2]))
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
