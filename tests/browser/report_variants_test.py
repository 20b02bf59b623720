# SPDX-License-Identifier: MIT
"""Tests the pages of `faults --report`, `tune --report` and `replay --report` in a browser."""
import re

import browser
from browser import Keys, eventually


def block_of(page):
    """Returns the first text in the text language on a page of the documentation."""
    text = (browser.SOURCE / "docs/how-to" / page).read_text(encoding="utf-8")
    return re.search(r"```grafcet\n(.*?)```", text, re.DOTALL).group(1)


class Variants(browser.Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.faults, cls.map, cls.late = cls.folder / "faults.html", cls.folder / "map.html", cls.folder / "late.html"
        driveway, press, pump = (cls.folder / f"{name}.grafcet" for name in ("driveway", "press", "pump"))
        driveway.write_text(block_of("faults.md"), encoding="utf-8")
        press.write_text(block_of("tune.md"), encoding="utf-8")
        pump.write_text(block_of("check-recordings.md") + "closed_loop l { controller pump; "
                        "environment A = free(OUT = START); environment B = free(OUT = STOP);\n"
                        "property p: never PUMP && !START; }", encoding="utf-8")
        browser.run("faults", driveway, "--order", "2", "--report", cls.faults, code=1)
        browser.run("tune", press, "--over", "RAM=1s..9s", "--over", "CLOSING=1s..9s", "--report", cls.map, code=1)
        browser.run("replay", pump, "--log", browser.SOURCE / "docs/pump_late.csv", "--report", cls.late, code=1)

    def play(self, name):
        [button] = [each for each in self.page.all("[data-run]") if each.get_attribute("data-run") == name]
        button.click()
        eventually(lambda: self.page.text(".pick-run option:checked") is not None)
        self.assertEqual(self.page.script("return page.current"), name)

    def test_a_combination_plays_its_run_on_the_drawing(self):
        self.page.open(self.faults)
        self.page.wait_for(".player")
        self.assertIn("violated with combinations", self.page.text(".glance"))
        self.play("safe: First_1 + Second_1")
        self.page.press(Keys.END)
        lit = self.page.script("return [...document.querySelectorAll('.chart-view .step.active')].map(e => e.dataset.element)")
        self.assertEqual(lit, ["step-2"])
        self.page.script("""const s = document.querySelector('select[aria-label=Instance]');
            s.value = [...s.options].find(o => o.text === 'First').value; s.dispatchEvent(new Event('change'))""")
        self.assertIn("is in First_1", self.page.text(".player"))
        self.assertEqual(self.page.all(".player .automaton .node.active"), [], "the drawing has no location of the fault")
        self.assertIn("GREEN", self.page.text(".why .terms"))

    def test_a_violated_point_plays_its_run(self):
        self.page.open(self.map)
        self.page.wait_for(".player")
        self.assertEqual(self.page.text(".map td.current"), "✓")
        self.assertTrue(self.page.script("""return [...document.querySelectorAll('table.map')].every(map => {
            const inner = map.getBoundingClientRect(), outer = map.closest('details').getBoundingClientRect();
            return inner.top >= outer.top && inner.bottom <= outer.bottom && inner.left >= outer.left; })"""), "each map is in the box of its property")
        self.play("prompt: RAM = 7s, CLOSING = 2s")
        self.assertTrue(self.page.all(".chart-view .step.active"))
        steps = self.page.script("return page.player.run.data.violation.steps.map(s => s.words).join('; ')")
        self.assertIn("`X1` at 1 s; deadline 9 s", steps)
        cells = self.page.script("return [...document.querySelectorAll('.map td')].map(e => e.textContent).join('')")
        self.assertEqual((cells.count("✓"), cells.count("✗")), (28, 53))

    def test_a_recording_is_played_up_to_the_deviation(self):
        self.page.open(self.late)
        self.page.wait_for(".player")
        self.assertIn("deviates from 1 chart", self.page.text(".glance"))
        self.play("pump")
        self.page.press(Keys.END)
        active = "return [...document.querySelectorAll('.chart-view .step.active')].map(e => e.dataset.element)"
        self.assertEqual(self.page.script(active), ["step-3"])
        self.assertIn("`HORN` is 0, but the chart sets it to 1", self.page.text(".player").replace("\u201c", "`"))
        [link] = self.page.all("#recording a")
        self.assertIn("2.6 s", link.text)
        link.click()
        eventually(lambda: self.page.script(active) == ["step-2"])

    def test_pages_are_readable_on_each_screen_and_by_all(self):
        for made, name in ((self.faults, "faults"), (self.map, "map"), (self.late, "recording")):
            for size in ("laptop", "phone"):
                for scheme in ("light", "dark"):
                    with self.subTest(name=name, size=size, scheme=scheme):
                        self.page.size(size)
                        self.page.scheme(scheme)
                        self.page.open(made)
                        self.page.wait_for(".player")
                        self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0)
                        self.assertEqual(self.page.script(browser.FAINT_TEXTS), [])
                        self.assertEqual(self.page.script(browser.UNNAMED), [])
                        self.page.screenshot(f"{name}-{size}-{scheme}")


if __name__ == "__main__":
    browser.main()
