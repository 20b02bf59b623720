# SPDX-License-Identifier: MIT
"""Tests the layout of the timing diagram in a browser."""
import browser

FAULTY = browser.SOURCE / "samples/testing_station/faulty.grafcet"


class TimingDiagram(browser.Case):
    def test_its_texts_stay_on_the_page_and_off_each_other(self):
        browser.run("check", FAULTY, "--property", "P16", "--trace-svg", self.work / "p16.svg", code=None)
        self.page.open(self.work / "p16.svg")
        self.assertGreater(len(self.page.all("text")), 20)
        self.assertEqual(self.page.script(browser.SVG_FAULTS), [])
        self.page.screenshot("timing-diagram")


if __name__ == "__main__":
    browser.main()
