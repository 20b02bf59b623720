# SPDX-License-Identifier: MIT
"""picture.py FILE PROPERTY/EVENT OUT.png: saves a picture of the player of a report at an event of a counterexample;
see docs/pictures.sh."""
import sys
import time

import browser

file, place, out = sys.argv[1:]
del sys.argv[1:]


class Picture(browser.Case):
    def test_of_the_player(self):
        browser.run("report", file, "-o", self.work / "report.html", code=1)
        self.driver.set_window_size(1180, 900)
        self.page.driver.get((self.work / "report.html").as_uri() + "#" + place)
        self.page.wait_for("g.step.active")
        time.sleep(1)  # until the page has scrolled to the event
        self.driver.save_screenshot(out)


if __name__ == "__main__":
    browser.main()
