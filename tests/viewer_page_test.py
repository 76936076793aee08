"""viewer_page_test.py CLI POINTS: the viewer's page in a headless Chromium, used as a person would.

Exit status 77, which ctest takes as skipped, where there is no Chromium."""

import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "support"))
from browser import Browser, chromium, pixels  # noqa: E402

WIDTH, HEIGHT = 700, 520
PLACE = (430, 240)  # on the surface, in the middle of what the panel leaves free
READY = "document.getElementById('message').hidden"


def check(holds, what):
    if not holds:
        raise AssertionError(what)
    print("ok:", what)


def scene(browser):
    """The pixels right of the panel and above the timeline, without the edge that shows the focus."""
    return pixels(browser.screenshot(285, 5, WIDTH - 290, 410))


def difference(a, b):
    """How many pixels differ visibly."""
    return sum(max(abs(x - y) for x, y in zip(p, q)) > 12
               for row_a, row_b in zip(a, b) for p, q in zip(row_a, row_b))


def text(browser, selector):
    browser.settle()
    return browser.evaluate(f"document.querySelector('{selector}').textContent")


def check_picture(browser):
    picture = scene(browser)
    background = picture[0][-1]
    drawn = sum(p != background for row in picture for p in row)
    share = drawn / (len(picture) * len(picture[0]))
    check(0.1 < share < 0.9, f"the surface covers {share:.0%} of the picture")
    check(sum(r > g + 40 and r > b + 40 for row in picture for r, g, b in row) < 20,
          "nothing is seen from inside")
    return picture


def check_switches(browser, first):
    """Each switch changes the picture, and back."""
    for layer in ("surface", "wireframe", "points", "egh", "emst", "smooth"):
        if layer == "emst":
            browser.click("#surface")  # the tree shows better without
            first_now = scene(browser)
        else:
            first_now = first
        browser.click(f"#{layer}")
        check(difference(scene(browser), first_now) > 100, f"the switch '{layer}' changes the picture")
        browser.click(f"#{layer}")
        check(difference(scene(browser), first_now) == 0, f"the switch '{layer}' goes back")
        if layer == "emst":
            browser.click("#surface")
    check(browser.evaluate("document.getElementById('hidden').disabled"),
          "the switch of hidden vertices is off where there are none")


def check_navigation(browser, first):
    browser.drag(PLACE, (PLACE[0] + 90, PLACE[1] + 20))
    turned = scene(browser)
    check(difference(turned, first) > 1000, "a drag turns")
    browser.drag(PLACE, (PLACE[0] + 60, PLACE[1]), button="right")
    moved = scene(browser)
    shifted = [row[60:] for row in moved]
    check(difference(moved, turned) > 1000, "a right drag moves")
    check(3 * difference(shifted, turned) < difference(moved, turned), "by as much as the pointer")
    browser.mouse("mouseWheel", *PLACE, deltaX=0, deltaY=-200)
    check(difference(scene(browser), moved) > 1000, "the wheel zooms")
    browser.key("r")
    check(difference(scene(browser), first) == 0, "R resets the view")
    browser.key("ArrowLeft")
    check(difference(scene(browser), first) > 1000, "an arrow key turns")
    browser.key("r")
    browser.key("2")
    check(browser.evaluate("document.getElementById('wireframe').checked"), "key 2 switches")
    browser.key("2")


def check_work_per_frame(browser):
    """What lives on the graphics processor stays there: to turn is to draw, once a layer."""
    browser.evaluate("""(() => {
        window.calls = {bufferData: 0, drawElements: 0, clear: 0};
        for (const name in calls) {
            const of = WebGLRenderingContext.prototype[name];
            WebGLRenderingContext.prototype[name] = function (...a) { ++calls[name]; return of.apply(this, a); };
        } })()""")
    browser.drag(PLACE, (PLACE[0] + 90, PLACE[1] + 20))
    browser.settle()
    frames, draws = browser.evaluate("calls.clear"), browser.evaluate("calls.drawElements")
    check(frames > 0 and draws == frames, "a frame draws the surface once, no more")
    check(browser.evaluate("calls.bufferData") == 0, "and sends nothing to the graphics processor")
    browser.key("r")


def check_touch(browser, first):
    x, y = PLACE
    touch = lambda kind, *points: browser.call(
        "Input.dispatchTouchEvent", type=kind,
        touchPoints=[{"x": px, "y": py, "id": i} for i, (px, py) in enumerate(points)])
    touch("touchStart", (x, y))
    touch("touchMove", (x + 70, y))
    touch("touchEnd")
    turned = scene(browser)
    check(difference(turned, first) > 1000, "a finger turns")
    touch("touchStart", (x - 20, y), (x + 20, y))
    touch("touchMove", (x - 60, y), (x + 60, y))
    touch("touchEnd")
    check(difference(scene(browser), turned) > 1000, "two fingers zoom")
    browser.key("r")
    check(difference(scene(browser), first) == 0, "and R resets the view")


def check_steps(browser, first, triangles):
    check(f"{triangles:,} triangles" in text(browser, "#place"), "the last step has all triangles")
    browser.click("#back")
    steps = browser.evaluate("Number(document.getElementById('step').max)")
    check(f"step {steps - 1:,} of {steps:,}" in text(browser, "#place"), "one step back")
    browser.evaluate("document.getElementById('step').focus()")
    browser.key("Home")
    hull = scene(browser)
    check("step 0 of" in text(browser, "#place"), "the slider goes to the start")
    check(difference(hull, first) > 1000, "which looks otherwise: the convex hull")
    browser.click("#play")
    check(browser.evaluate("document.getElementById('play').ariaPressed === 'true'"), "it plays")
    browser.evaluate("new Promise(done => setTimeout(done, 700))")
    browser.click("#play")
    step = browser.evaluate("Number(document.getElementById('step').value)")
    check(0 < step < steps, f"and pauses, at step {step}")
    browser.evaluate("document.getElementById('step').focus()")
    browser.key("End")
    check(difference(scene(browser), first) == 0, "at the end the surface is there again")


def check_lost_context(browser, first):
    browser.evaluate("""new Promise(done => {
        const lost = document.getElementById('view').getContext('webgl')
            .getExtension('WEBGL_lose_context');
        lost.loseContext();
        setTimeout(() => { lost.restoreContext(); setTimeout(done, 300); }, 300); })""")
    check(difference(scene(browser), first) == 0, "a lost context comes back")


def check_dark(browser, first):
    browser.call("Emulation.setEmulatedMedia",
                 features=[{"name": "prefers-color-scheme", "value": "dark"}])
    check(max(scene(browser)[0][-1]) < 60 < min(first[0][-1]), "dark where the system is")


def check_hidden(cli, folder):
    """set_with_hidden_point of tests/support/sculpt_stages.cpp."""
    points, page = folder / "hidden.xyz", folder / "hidden.html"
    points.write_text("8 10 14\n10 14 14\n1002 1005 259\n1 8 11\n1015 1006 255\n6 14 10\n"
                      "1003 1005 254\n3012 9001 6756\n5010 25002 31254\n4001 16008 16002\n"
                      "1003 1008 264\n3003 9011 6763\n2006 4014 2015\n")
    # From a side on which the panel does not cover it, and from farther off.
    run = subprocess.run([cli, "--quiet", "--method", "paper", "--view", "210,20", "--viewer", page,
                          points, folder / "a.ply"], stderr=subprocess.DEVNULL)
    check(run.returncode == 4, "a set of which one point stays hidden")
    with Browser(WIDTH, HEIGHT) as browser:
        browser.open(page.as_uri(), READY)
        check(text(browser, "#hidden ~ output") == "1", "the page counts it")
        for _ in range(4):
            browser.key("-")
        with_it = scene(browser)
        magenta = [p for row in with_it for p in row if min(p[0], p[2]) > p[1] + 90]
        check(20 < len(magenta) < 300, "and shows it, through the surface")
        browser.click("#hidden")
        check(difference(scene(browser), with_it) >= len(magenta), "its switch takes it away")
        check(not browser.errors, f"no errors: {browser.errors}")


def check_without_webgl(url):
    with Browser(WIDTH, HEIGHT, ["--disable-3d-apis"]) as browser:
        browser.open(url, "!document.getElementById('message').textContent.startsWith('Loading')")
        check("no WebGL" in text(browser, "#message"), "without WebGL the page says so")


def main(cli, points):
    with tempfile.TemporaryDirectory() as folder:
        # A name that HTML would misread.
        page = pathlib.Path(folder) / "a <b>&.html"
        surface = pathlib.Path(folder) / "a.off"
        subprocess.run([cli, "--quiet", "--up", "y", "--viewer", page, points, surface], check=True)
        triangles = surface.read_text().count("\n3 ")
        url = page.as_uri()
        with Browser(WIDTH, HEIGHT) as browser:
            browser.open(url, READY)
            check(text(browser, "h1") == pathlib.Path(points).name, "the title is the file's name")
            first = check_picture(browser)
            check_switches(browser, first)
            check_navigation(browser, first)
            check_work_per_frame(browser)
            check_touch(browser, first)
            check_steps(browser, first, triangles)
            check_lost_context(browser, first)
            check_dark(browser, first)
            check(not browser.errors, f"no errors: {browser.errors}")
            check(browser.requests == [url], f"nothing else was loaded: {browser.requests[1:]}")
        check_hidden(cli, pathlib.Path(folder))
        check_without_webgl(url)


if chromium() is None:
    print("skipped: no chromium here (apt-get install chromium)")
    sys.exit(77)
main(*sys.argv[1:])
