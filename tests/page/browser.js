// SPDX-License-Identifier: GPL-3.0-or-later
// A browser and a page of the rib example in; a line "pass NAME" or "fail NAME"
// for each thing a person would try, then "done", out.
// node browser.js CHROMIUM PAGE FOLDER-WITH-PLAYWRIGHT PAGE-OF-101-STEPS
const { createRequire } = require("node:module");
const { pathToFileURL } = require("node:url");
const [, , executablePath, path, modules, thinned] = process.argv;
const { chromium } = createRequire(`${modules}/package.json`)("playwright-core");

const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"];
const patience = 180000;        // ms for any one thing: a loaded machine is slow, not wrong
const software = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

function expect(name, holds) {
    console.log(`${holds ? "pass" : "fail"} ${name}`);
}

// Opens the page; troubles collects errors and every request but the page's own.
async function open(browser, options = {}, file = path) {
    const page = await browser.newPage({ viewport: { width: 1100, height: 800 }, ...options });
    page.setDefaultTimeout(patience);
    const troubles = [];
    page.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
    page.on("pageerror", (error) => troubles.push(error.message));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || troubles.push(request.url()));
    await page.goto(pathToFileURL(file).href);
    return { page, troubles };
}

// What the fold shows now: pixels it covers, of them red and blue, their light, a sum that changes with the picture.
const look = (page) => page.evaluate(() => {
    const { fold } = globalThis.weft, gl = fold.renderer.getContext();
    fold.draw();
    const width = gl.drawingBufferWidth, height = gl.drawingBufferHeight, pixel = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    let covered = 0, red = 0, blue = 0, light = 0, sum = 0;
    for (let i = 0; i < pixel.length; i += 4) {
        covered += pixel[i + 3] > 0;
        red += pixel[i] > 1.5 * pixel[i + 2];
        blue += pixel[i + 2] > 1.5 * pixel[i];
        light += pixel[i] + pixel[i + 1] + pixel[i + 2];
        sum = (sum * 31 + pixel[i] + 3 * pixel[i + 1] + 7 * pixel[i + 2]) % 1000003;
    }
    return { all: width * height, covered, red, blue, light, sum };
});
const marked = (page) => page.evaluate(() => JSON.stringify(globalThis.weft.state.marked));
const text = (page, id) => page.locator(`#${id}`).innerText();
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function tryFold(page) {
    const first = await look(page);
    expect("the fold is drawn", first.covered > 0.1 * first.all && first.covered < 0.9 * first.all);
    expect("knit is red and purl blue", first.red > 0.02 * first.all && first.blue > 0.02 * first.all);
    expect("the title is the script's name", await text(page, "title") === "a <b> & c.knit");
    await page.locator("#views button", { hasText: "front" }).click();
    await page.locator("#time").fill("0");
    const face = await look(page);
    await page.locator("#views button", { hasText: "back" }).click();
    const back = await look(page);
    expect("from behind knit is purl", Math.abs(face.red - back.blue) < 0.1 * face.red && Math.abs(face.blue - back.red) < 0.1 * face.blue);
    expect("and darker", back.light < 0.9 * face.light);
    await page.locator("#views button", { hasText: "tilted" }).click();
    const flat = await look(page);
    expect("the slider changes the picture", flat.sum !== first.sum && await text(page, "growth") === "0 %");
    expect("and the energies", /total\s+0/.test(await text(page, "energies")));
    await page.locator("#play").click();
    await page.waitForFunction(() => globalThis.weft.state.time > 0.2);
    expect("play moves on", (await look(page)).sum !== flat.sum);
    await page.keyboard.press(".");
    expect("a key stops it at a step", await page.evaluate(() => !globalThis.weft.state.playing && globalThis.weft.state.time % 1 === 0));
    await page.locator("#time").fill("10");
}

async function tryMark(page) {
    const stitch = { column: 7, row: 12 }, wanted = JSON.stringify(stitch), { sum } = await look(page);
    let place = await page.evaluate((s) => globalThis.weft.chart.place(s), stitch);
    await page.mouse.move(place.x, place.y);
    await settle(page);
    expect("pointing at the chart marks the stitch", await marked(page) === wanted);
    expect("in the fold", (await look(page)).sum !== sum);
    expect("and names it", /row 13, column 8: purl/.test(await text(page, "readout")));
    await page.mouse.move(5, 5);
    await settle(page);
    expect("leaving it marks nothing", await marked(page) === "null" && (await look(page)).sum === sum);
    await page.locator("#views button", { hasText: "front" }).click();
    await settle(page);
    place = await page.evaluate((s) => globalThis.weft.fold.place(s), stitch);
    await page.mouse.move(place.x, place.y);
    await settle(page);
    expect("pointing at the fold marks the stitch", await marked(page) === wanted);
    expect("in the chart", await page.evaluate((s) => {
        const box = document.querySelector("#chart .mark").getBoundingClientRect(), at = globalThis.weft.chart.place(s);
        return box.width > 2 && Math.abs(box.left + box.width / 2 - at.x) < 1.5 && Math.abs(box.top + box.height / 2 - at.y) < 1.5;
    }, stitch));
    await page.mouse.move(5, 5);
    await page.locator("#chart").focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    expect("arrows in the chart move the mark", await marked(page) === '{"column":0,"row":1}');
}

async function tryColours(page) {
    const seen = new Set([(await look(page)).sum]), legends = new Set([await text(page, "legend")]);
    for (const mode of ["height", "mean", "gauss", "bending", "stretching"]) {
        await page.locator("#mode").selectOption(mode);
        seen.add((await look(page)).sum);
        legends.add(await text(page, "legend"));
    }
    expect("each field has its picture", seen.size === 6);
    expect("and its legend", legends.size === 6);
    await page.locator("#mode").selectOption("stitch");
    const paper = await look(page);
    await page.locator("#safe").click();
    const safe = await look(page);
    expect("a palette for colour-blind eyes", safe.sum !== paper.sum);
    await page.locator("#safe").click();
}

async function tryKeys(page) {
    await page.locator("#fold").focus();
    for (const key of ["ArrowLeft", "+", "Shift+ArrowUp", "k", "e", "f", "0", "3"]) {
        const { sum } = await look(page);
        await page.keyboard.press(key);
        await settle(page);
        expect(`key ${key} changes the picture`, (await look(page)).sum !== sum);
    }
    const { sum } = await look(page), box = await page.locator("#fold").boundingBox();
    await page.mouse.move(box.x + 300, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 380, box.y + 330, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    await settle(page);
    expect("dragging turns it", (await look(page)).sum !== sum);
    await page.keyboard.press("?");
    expect("the keys are documented", /Space/.test(await text(page, "keys")));
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await paper();
    await page.keyboard.press("t");
    expect("light and dark", await paper() !== light);
}

async function tryPhone(browser) {
    const { page } = await open(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: "dark" });
    expect("a phone needs no scrolling sideways", await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    expect("dark where the system is dark", await page.evaluate(() => document.documentElement.dataset.theme === "dark"));
    const place = await page.evaluate(() => {
        document.querySelector("#chart").scrollIntoView();
        return globalThis.weft.chart.place({ column: 2, row: 3 });
    });
    await page.touchscreen.tap(place.x, place.y);
    await settle(page);
    expect("a finger marks a stitch", await marked(page) === '{"column":2,"row":3}');
}

async function tryPlain(browser) {
    const { page, troubles } = await open(browser);
    expect("without WebGL a message", /no WebGL/.test(await text(page, "nowebgl")));
    expect("the chart and the numbers", await page.locator("#chart canvas").isVisible() && /bending/.test(await text(page, "energies")));
    await page.locator("#time").fill("0");
    expect("and no error", troubles.length === 0 && /total\s+0/.test(await text(page, "energies")));
    expect("all steps are there", await text(page, "ending") === "converged");
    const { page: other } = await open(browser, {}, thinned);
    expect("of more than 50 steps it says which", await text(other, "ending") === "converged; one growth step in 3 is shown");
}

// A browser with these flags; whatever happens, it is closed.
async function inBrowser(more, attempt) {
    const browser = await chromium.launch({ executablePath, args: [...flags, ...more], timeout: patience });
    try {
        await attempt(browser);
    } finally {
        await browser.close();
    }
}

async function main() {
    await inBrowser(software, async (browser) => {
        const { page, troubles } = await open(browser);
        await tryFold(page);
        await tryMark(page);
        await tryColours(page);
        await tryKeys(page);
        expect("no error, no request", troubles.length === 0);
        troubles.forEach((trouble) => console.error(trouble));
        await tryPhone(browser);
    });
    await inBrowser(["--disable-3d-apis"], tryPlain);
    console.log("done");
}

main().catch((error) => {
    console.error(error);
    process.exit(1);
});
