# SPDX-License-Identifier: MIT
"""picture.py OUT.png: the player on the counterexample of the README; see docs/pictures.sh."""
import sys
import time

import browser

out = sys.argv.pop()


class Picture(browser.Case):
    def test_of_the_player(self):
        browser.run("report", browser.SOURCE / "docs/blinker_pressed.grafcet", "-o", self.work / "report.html", code=1)
        self.driver.set_window_size(1180, 900)
        self.page.driver.get((self.work / "report.html").as_uri() + "#answered/10")
        self.page.wait_for("g.step.active")
        time.sleep(1)  # until it has scrolled there
        self.driver.save_screenshot(out)


if __name__ == "__main__":
    browser.main()
