# SPDX-License-Identifier: MIT
"""The page of `report` as a reader uses it: keys are pressed, addresses followed, conditions unfolded."""
import browser
from browser import Keys, eventually

FAULTY = browser.SOURCE / "samples/testing_station/faulty.grafcet"
HOSTILE = """
grafcet press {
    input START;
    output MOTOR;
    initial step 0;
    step 1 { MOTOR; }
    transition T0: 0 -> 1 when rise(START);
    transition T1: 1 -> 0 when 2s/X1 && !START;
    accept step-reactivated "</script><script>document.title = 'taken'</script>";
}
closed_loop shop {
    controller press;
    environment Start = free(OUT = START);
    property idle "</script><img src=x onerror=document.title='taken'> ' & \u202e": never MOTOR;
}
"""
WIDE = """return [...document.querySelectorAll('body *')].filter(e => e.getBoundingClientRect().right > innerWidth + 1)
          .map(e => e.tagName + '.' + e.className).slice(0, 9)"""
LIT = ".chart-view .step.active"


class Report(browser.Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = cls.folder / "report.html"
        browser.run("report", FAULTY, "--property", "P15", "--property", "P16", "--timeout", "20s", "-o", cls.made, code=0)

    def at(self, address):
        self.page.open("about:blank")
        self.page.open(self.made.resolve().as_uri() + address)
        self.page.wait_for(".player")

    def lit(self):
        return self.page.script(f"return [...document.querySelectorAll('{LIT}')].map(e => e.dataset.element)")

    def place(self):
        return self.page.script("return location.hash")

    def test_it_says_at_a_glance_what_holds(self):
        self.page.open(self.made)
        self.assertIn("Every verdict is as expected", self.page.text(".glance"))
        self.assertIn("cycle takes no time", self.page.text(".assumed"))
        self.assertTrue(self.page.find("#property-P16").get_attribute("open"))
        self.assertFalse(self.page.find("#property-P15").get_attribute("open"))

    def test_the_counterexample_is_played_to_its_end_by_keys(self):
        self.at("#P16/0")
        self.assertEqual(sorted(self.lit()), ["step-0", "step-watchdog_in-W5", "step-watchdog_out-W0"])
        self.page.find(".chart-view").send_keys(Keys.END)
        eventually(lambda: self.place() == "#P16/138", what="the end")
        self.assertEqual(sorted(self.lit()), ["step-0", "step-watchdog_in-W5", "step-watchdog_out-W0"])
        self.page.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
        self.assertIn("step-12", self.lit())
        self.page.press(Keys.ARROW_RIGHT)
        self.assertIn("T12", self.page.text(".caption"))
        cleared = self.page.script("return [...document.querySelectorAll('.chart-view .transition.cleared')].map(e => e.dataset.element)")
        self.assertEqual(cleared, ["transition-T12"])
        self.assertTrue(self.page.all(".chart-view .transition.cleared .tick"), "not by colour alone")
        self.assertTrue(self.page.all(f"{LIT} .token"), "not by colour alone")
        self.page.press(Keys.HOME)
        self.assertEqual(self.place(), "#P16/0")

    def test_an_address_leads_to_its_moment(self):
        self.at("#P16/23")
        self.assertIn("23 of 138", self.page.text(".place"))
        self.page.script("location.hash = '#P16/40'")
        eventually(lambda: "40 of 138" in self.page.text(".place"))
        self.at("#P16/99999999")
        self.assertIn("138 of 138", self.page.text(".place"))
        self.at("#nobody/3")
        self.assertTrue(self.lit(), "it begins somewhere")

    def test_the_false_term_of_a_condition_is_pointed_at(self):
        self.at("#P16/131")
        picker = self.page.find(".pick select")
        self.page.script("""const s = arguments[0]; s.value = [...s.options].find(o => o.text === 'T12').value;
                            s.dispatchEvent(new Event('change'))""", picker)
        self.assertIn("T12 is enabled, but its condition is false", self.page.text(".pick + .why .answer"))
        self.assertIn("H_IN", " ".join(self.page.texts(".pick + .why .term.false")))
        self.page.script("""const s = arguments[0]; s.value = [...s.options].find(o => o.text === 'TW2').value;
                            s.dispatchEvent(new Event('change'))""", picker)
        self.assertIn("is not active", self.page.text(".pick + .why .answer"))

    def test_every_cleared_transition_was_enabled_and_its_condition_true(self):
        self.at("#P16/0")
        wrong = self.page.script("""
            const player = window.page.player, run = player.run, faults = [];
            let seen = 0;
            for (let m = 1; m <= run.last; ++m)
                for (const act of run.trace.moments[m].acts) {
                    if (!act.does.includes("evolve")) continue;
                    const chart = player.chartOf(act.controller), reader = new Decision(run, chart, act.controller, m, true);
                    chart.transitions.forEach((transition, place) => {
                        const id = run.controllers[act.controller].transitions[place];
                        const enabled = transition.from.every(s => run.isActive(run.controllers[act.controller].steps[s], m - 1));
                        const fires = enabled && reader.value(transition.condition) === 1;
                        ++seen;
                        if (fires !== act.fired.includes(id)) faults.push(`${transition.name} at ${m}`);
                    });
                }
            return [seen, faults];
        """.replace("new Decision", "new window.page.Decision"))
        self.assertGreater(wrong[0], 500)
        self.assertEqual(wrong[1], [])

    def test_the_decisive_moment_of_a_claim_is_found(self):
        self.at("")
        [button] = [b for b in self.page.all(".controls button") if "decisive" in b.text]
        self.page.find(".chart-view").send_keys(Keys.HOME)
        button.click()
        claim = self.page.texts(".why .term.true")
        self.assertIn("V_S", " ".join(claim))

    def test_moves_inside_a_cycle_are_stepped_one_by_one(self):
        self.at("#P16/136")
        self.page.script("document.querySelectorAll('.controls input[type=checkbox]')[1].click()")
        self.page.find(".chart-view").send_keys(Keys.ARROW_RIGHT)
        eventually(lambda: self.place() == "#P16/136+1")
        self.assertIn("a cycle begins", self.page.text(".caption"))

    def test_signals_are_filtered(self):
        self.at("#P16/10")
        self.page.find(".filters input[type=search]").send_keys("V_G")
        self.assertEqual(sorted(self.page.texts(".signals tbody th")), ["V_G_IN", "V_G_OUT"])

    def test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader(self):
        for size in browser.SIZES:
            self.page.size(size)
            for scheme in browser.SCHEMES:
                self.page.scheme(scheme)
                self.at("#P16/131")
                self.page.screenshot(f"report-{size}-{scheme}")
                self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0, f"{size}: {self.page.script(WIDE)}")
                self.assertEqual(self.page.script(browser.FAINT_TEXTS), [], f"{size}, {scheme}")
                self.assertEqual(self.page.script(browser.UNNAMED), [], size)

    def test_it_is_printed(self):
        self.at("#P16/131")
        self.assertGreater(len(self.page.pdf()), 30000)

    def test_hostile_names_are_shown_as_text(self):
        source, made = self.work / "hostile.grafcet", self.work / "hostile.html"
        source.write_text(HOSTILE, encoding="utf-8")
        browser.run("report", source, "-o", made, "--date", "<script>document.title='taken'</script>", code=None)
        self.page.open(made)
        self.page.wait_for(".player")
        self.assertNotEqual(self.page.script("return document.title"), "taken")
        self.assertIn("<img src=x", self.page.text("#property-idle"))
        self.assertEqual(len(self.page.all("script")), 2)
        self.assertEqual(self.page.all("img"), [])

    def test_a_long_run_scrolls(self):
        """Ten thousand rows, of which only those in sight exist."""
        self.at("#P16/0")
        took = self.page.script("""
            const data = structuredClone(window.page.data.runs.find(r => r.name === 'P16'));
            const moments = data.run.moments, rows = data.rows, n = moments.length;
            for (let k = n; k < 20000; ++k) {
                moments.push({...moments[5], time: k * 1000, values: [[17, k % 7]]});
                rows.push({moment: k, words: `row ${k}`, cleared: "", shown: true});
            }
            data.name = "long";
            window.page.data.runs.push(data);
            const begin = performance.now();
            window.page.open("long");
            for (let k = 0; k < 100; ++k) window.page.player.go(n + k * 190);
            return performance.now() - begin;
        """)
        self.assertLess(len(self.page.all(".rows .row")), 60)
        self.assertLess(len(self.page.all(".timing-space *")), 6000)
        self.assertLess(took, 20000, "a hundred jumps")


if __name__ == "__main__":
    browser.main()
