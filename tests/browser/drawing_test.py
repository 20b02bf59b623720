# SPDX-License-Identifier: MIT
"""Tests drawn charts in a browser: all texts fit into their boxes, in every tested font."""
import browser

# Script that returns the names of steps and the labels of actions that extend beyond their boxes.
MISFITS = """
return [...document.querySelectorAll('g.step > text.name, g.action > text.label, g.forcing > text.label')]
  .filter((text) => {
    const inner = text.getBBox(), outer = text.parentNode.querySelector('rect, path').getBBox();
    return inner.x < outer.x || inner.x + inner.width > outer.x + outer.width;
  }).map((text) => text.parentNode.id);
"""
FONTS = ["", "'DejaVu Sans'", "'Liberation Sans'", "sans-serif"]  # the first entry keeps the font of the drawing


class Drawing(browser.Case):
    def test_texts_fit_and_do_not_overlap_other_elements(self):
        charts = [*browser.SOURCE.glob("samples/*/*.grafcet"), *browser.SOURCE.glob("tests/unit/app/elements/*.grafcet")]
        charts = [chart for chart in charts if "\nprogram " not in chart.read_text()]  # programs are not drawn
        self.assertGreater(len(charts), 20)
        for chart in sorted(charts):
            drawing = self.work / (chart.stem + ".svg")
            browser.run("draw", chart, "-o", drawing)
            self.page.open(drawing)
            self.assertGreater(len(self.page.all("g.step")), 0, chart)
            for font in FONTS:
                self.page.script("if (arguments[0]) document.documentElement.setAttribute('font-family', arguments[0])", font)
                self.assertEqual(self.page.script(MISFITS), [], f"{chart} in {font}")
                self.assertEqual(self.page.script(browser.SVG_FAULTS), [], f"{chart} in {font}")

    def test_a_style_of_the_page_overrides_the_colours(self):
        browser.run("draw", browser.SOURCE / "samples/blinker/blinker.grafcet", "-o", self.work / "blinker.svg")
        self.page.open(self.work / "blinker.svg")
        colour = self.page.script("""
            const style = document.createElementNS('http://www.w3.org/2000/svg', 'style');
            style.textContent = '#step-1 rect { fill: rgb(1, 2, 3) } .paper { fill: none }';
            document.documentElement.append(style);
            return [getComputedStyle(document.querySelector('#step-1 rect')).fill,
                    getComputedStyle(document.querySelector('.paper')).fill];""")
        self.assertEqual(colour, ["rgb(1, 2, 3)", "none"])


if __name__ == "__main__":
    browser.main()
