# SPDX-License-Identifier: MIT
"""Tests the page of `report` for PLC programs in a browser: the lines with their values, the marks of executed lines and
active steps, the choice of an instance, and the drawn chart."""
import browser
from browser import Keys, eventually

SPINDLE = browser.SOURCE / "samples/spindle/spindle.grafcet"
LOOP = """
program plc = "plc.st";
closed_loop l {
    controller plc every 10ms;
    environment A = free(OUT = A);
    environment B = free(OUT = B);
    property dark "the lamp is never lit": never Lamp;
}
"""
PROGRAM = """FUNCTION_BLOCK Counter
VAR_INPUT Up : BOOL; END_VAR
VAR_OUTPUT Sum : INT; END_VAR
VAR Edge : R_TRIG; END_VAR
Edge(CLK := Up);
IF Edge.Q AND Sum < 3 THEN
    Sum := Sum + 1; (* </script><img src=x onerror="document.title='taken'"> *)
ELSE
    Sum := Sum;
END_IF
END_FUNCTION_BLOCK
PROGRAM Main
VAR_INPUT A, B : BOOL; END_VAR
VAR_OUTPUT Lamp : BOOL; END_VAR
VAR First, Second : Counter; Timer : TON; END_VAR
First(Up := A);
Second(Up := B);
Timer(IN := A, PT := T#20ms);
Lamp := First.Sum = 1 AND Second.Sum = 2 AND Timer.Q;
END_PROGRAM
"""


class ReportOfPrograms(browser.Case):
    def report_of(self, source, *options):
        """Opens the report of `source`."""
        made = self.work / "report.html"
        browser.run("report", source, *options, "-o", made, code=None)
        self.page.open("about:blank")
        self.page.open(made)
        self.page.wait_for(".player")

    def report_of_counters(self):
        (self.work / "plc.st").write_text(PROGRAM)
        (self.work / "loop.grafcet").write_text(LOOP)
        self.report_of(self.work / "loop.grafcet")

    def line(self, text):
        """Returns the mark, the values and the classes of the displayed line that contains `text`."""
        return self.page.script("""
            const row = [...document.querySelectorAll('.lines .row')].find(r => r.querySelector('.code').textContent.includes(arguments[0]));
            return row && [row.querySelector('.mark').textContent, row.querySelector('.values').textContent,
                           row.querySelector('.code').className]""", text)

    def at(self, text):
        """Scrolls to a line and returns it."""
        self.page.script("""const p = [...window.page.player.programs.values()][0];
                            p.list.show(p.lines.findIndex(line => line.includes(arguments[0])))""", text)
        return eventually(lambda: self.line(text), what=text)

    def test_executed_branches_are_marked_and_show_their_values(self):
        self.report_of_counters()
        self.page.script("window.page.player.go(window.page.player.run.last)")
        mark, values, _ = self.at("Lamp := First")
        self.assertEqual(mark, "●")
        self.assertEqual(values, "Lamp := TRUEFirst.Sum 1Second.Sum 2Timer.Q TRUE")
        mark, values, _ = self.at("Timer(IN")
        self.assertEqual(values, "Timer.IN := TRUETimer.PT := T#20msA TRUE")
        plus, same = self.at("Sum + 1"), self.at("Sum := Sum;")
        self.assertEqual({plus[0], same[0]}, {"●", ""}, "exactly one branch is executed")
        self.assertIn("skipped", (plus if plus[0] == "" else same)[2], "not by a missing mark alone")

    def test_a_selection_determines_the_instance(self):
        self.report_of_counters()
        self.page.script("window.page.player.go(window.page.player.run.last)")
        self.assertIn("instance of Counter", self.page.text(".program .pick"))
        choose = lambda name: self.page.script("""const s = document.querySelector('.program select');
            s.value = [...s.options].find(o => o.text === arguments[0]).value; s.dispatchEvent(new Event('change'))""", name)
        sums = {}
        for name in ("First", "Second"):
            choose(name)
            plus, same = self.at("Sum + 1"), self.at("Sum := Sum;")
            sums[name] = (plus[1] + same[1]).split(":= ")[1][0]
        self.assertEqual(sums, {"First": "1", "Second": "2"})

    def test_text_of_the_program_is_not_interpreted(self):
        self.report_of_counters()
        self.assertNotEqual(self.page.script("return document.title"), "taken")
        self.assertEqual(self.page.all("img"), [])
        self.assertIn("<img src=x", self.page.text("#program-0"))

    def test_the_chart_of_the_program_has_tokens_and_cleared_transitions(self):
        self.report_of(SPINDLE, "--loop", "machine")
        player = "window.page.player"
        self.page.script(f"window.page.open('guarded'); {player}.go(0)")
        lit = lambda: self.page.script("return [...document.querySelectorAll('.chart-view .step.active')].map(e => e.dataset.element)")
        self.assertEqual(lit(), ["step-Idle"])
        self.assertEqual(self.at("INITIAL_STEP Idle")[0], "■")
        cleared = self.page.script(f"""const found = [];
            for (const m of {player}.stops) {{ {player}.go(m);
                for (const e of document.querySelectorAll('.chart-view .transition.cleared')) found.push(e.dataset.element); }}
            return found""")
        self.assertEqual(cleared[:4], ["transition-T1", "transition-T2", "transition-T3", "transition-T4"])
        self.assertEqual(self.page.all(".pick-run + div .pick + .why"), [], "a program has no conditions to explain")
        self.page.find(".player").click()
        self.page.press(Keys.HOME)
        for size in browser.SIZES:
            self.page.size(size)
            self.page.screenshot(f"report-program-{size}")

    def test_a_click_on_a_transition_leads_to_its_condition(self):
        self.report_of(SPINDLE, "--loop", "machine")
        self.page.script("""document.querySelector('.chart-view [data-element=condition-T4]')
                                .dispatchEvent(new MouseEvent('click', {bubbles: true}))""")
        eventually(lambda: "Coasting.T" in (self.page.text(".lines .row.current .code") or ""), what="the line")


if __name__ == "__main__":
    browser.main()
