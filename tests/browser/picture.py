# SPDX-License-Identifier: MIT
"""picture.py OUT.png PLACE COMMAND...: saves a picture of the report that `grafverif COMMAND... FILE` writes to FILE. PLACE is
an event of a run, such as PROPERTY/EVENT, or the id of a section; see docs/pictures.sh."""
import sys
import time

import browser

out, place, *command = sys.argv[1:]
del sys.argv[1:]


class Picture(browser.Case):
    def test_of_the_page(self):
        browser.run(*command, self.work / "report.html", code=None, folder=browser.SOURCE)
        self.driver.set_window_size(1180, 900)
        self.page.driver.get((self.work / "report.html").as_uri() + "#" + place)
        self.page.wait_for("g.step.active" if "/" in place else "main")
        time.sleep(1)  # until the page has scrolled to the place
        self.driver.save_screenshot(out)


if __name__ == "__main__":
    browser.main()
