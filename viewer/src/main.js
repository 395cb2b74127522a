// SPDX-License-Identifier: GPL-3.0-or-later
// The page: the swatch's data in; fold, chart, numbers and what moves them
// tied together out.
import { Chart } from "./chart.js";
import { modesOf, number, stitchColour, stitchName } from "./colours.js";
import { readSwatch } from "./data.js";
import { Fold, views } from "./fold.js";
import { element, energies, growthAt, parameters, readout, summary } from "./numbers.js";

const $ = (id) => document.getElementById(id);
const SECONDS = 5;          // of the growth from start to end

const swatch = readSwatch($("weft-data").textContent);
const last = swatch.nsteps - 1, modes = modesOf(swatch);
const state = { time: last, mode: modes[0], safe: false, marked: null, playing: false };
const chart = new Chart($("chart"), swatch);
const showEnergies = energies($("energies"), swatch);
const fold = makeFold();

function makeFold() {
    try {
        return new Fold($("fold"), swatch);
    } catch {
        $("nowebgl").hidden = false;
        document.body.classList.add("flat");
        return null;
    }
}

// ---- the growth ----

function setTime(time) {
    state.time = Math.max(0, Math.min(last, time));
    $("time").value = state.time;
    $("time").style.setProperty("--share", last ? state.time / last : 1);
    $("growth").textContent = `${Math.round(100 * growthAt(swatch, state.time))} %`;
    showEnergies(state.time);
    fold?.setTime(state.time);
    showStitch();
}

function setPlaying(playing) {
    state.playing = playing && last > 0;
    $("play").classList.toggle("playing", state.playing);
    $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play the growth");
    $("play").title = state.playing ? "Pause (Space)" : "Play the growth (Space)";
    if (!state.playing)
        return;
    if (state.time >= last)
        setTime(0);
    let before = null;
    requestAnimationFrame(function tick(now) {
        if (!state.playing)
            return;
        setTime(state.time + (before === null ? 0 : (now - before) / 1000 / SECONDS * last));
        before = now;
        if (state.time >= last)
            setPlaying(false);
        else
            requestAnimationFrame(tick);
    });
}

function stepTo(time) {
    setPlaying(false);
    setTime(time);
}

// ---- colours ----

function stitchLegend() {
    const used = [...new Set(swatch.grid)].sort((a, b) => a - b);
    const seen = [...new Set(used.flatMap((id) => [id, swatch.stitches[id].ws]))].sort((a, b) => a - b);
    return seen.map((id) => element("span", { class: "key" },
        element("i", { style: `background: ${stitchColour(swatch, id, state.safe)}` }),
        id < 2 ? `${stitchName(swatch, id)} side` : stitchName(swatch, id)));
}

function fieldLegend(mode) {
    const ramp = `background: linear-gradient(to right, ${swatch.scales[mode.scale].join(", ")})`;
    return [
        element("span", {}, mode.title),
        element("span", { class: "scale" }, number(mode.low, 2), element("i", { style: ramp }), number(mode.high, 2)),
        element("span", { class: "aside" }, `${mode.ends} of the folded swatch`),
    ];
}

function setColours(mode, safe) {
    state.mode = mode;
    state.safe = safe;
    $("mode").value = mode.name;
    $("safe").setAttribute("aria-pressed", safe);
    $("legend").replaceChildren(...(mode.name === "stitch" ? stitchLegend() : fieldLegend(mode)));
    fold?.setColours(mode, safe);
    chart.setColours(safe);
}

function setTheme(dark) {
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    $("theme").textContent = dark ? "Light" : "Dark";
    chart.draw();
}

// ---- the marked stitch ----

function same(a, b) {
    return a === b || Boolean(a && b && a.column === b.column && a.row === b.row);
}

function showStitch() {
    const said = state.marked && readout(swatch, state.marked, state.time);
    $("readout").replaceChildren(...(said
        ? [element("strong", {}, said.head), ...said.values.map((value) => element("span", {}, value))]
        : [`Point at a stitch, ${fold ? "in the fold or " : ""}in the chart.`]));
}

function mark(stitch) {
    if (same(stitch, state.marked))
        return;
    state.marked = stitch;
    chart.setMark(stitch);
    fold?.setMark(stitch);
    showStitch();
}

function moveMark(across, up) {
    const { column, row } = state.marked ?? { column: -across, row: -up };
    mark({
        column: Math.max(0, Math.min(swatch.columns - 1, column + across)),
        row: Math.max(0, Math.min(swatch.rows - 1, row + up)),
    });
}

// Points at what is under the pointer, once a frame; a finger that turns the fold marks nothing.
function follow(holder, target) {
    let place = null;
    const look = () => {
        if (place)
            mark(target.pick(place.x, place.y));
        place = null;
    };
    const point = (event) => {
        const turning = target === fold && (event.buttons !== 0 && event.type !== "pointerdown");
        if (turning || event.target.closest("button"))
            return;
        if (!place)
            requestAnimationFrame(look);
        place = { x: event.clientX, y: event.clientY };
    };
    holder.addEventListener("pointermove", point);
    holder.addEventListener("pointerdown", point);
    holder.addEventListener("pointerleave", (event) => {
        if (event.pointerType === "mouse") {
            place = null;
            mark(null);
        }
    });
}

// ---- keys ----

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function toggleHelp() {
    const hidden = $("keys").toggleAttribute("hidden");
    $("help").setAttribute("aria-expanded", !hidden);
}

const keys = {
    " ": () => setPlaying(!state.playing),
    ",": () => stepTo(Math.ceil(state.time - 1e-6) - 1),
    ".": () => stepTo(Math.floor(state.time + 1e-6) + 1),
    "+": () => fold?.zoom(1.15),
    "=": () => fold?.zoom(1.15),
    "-": () => fold?.zoom(1 / 1.15),
    "0": () => fold?.look("tilted"),
    f: () => fold?.look("front"),
    k: () => fold?.look("back"),
    e: () => fold?.look("edge"),
    b: () => setColours(state.mode, !state.safe),
    t: () => setTheme(document.documentElement.dataset.theme !== "dark"),
    "?": toggleHelp,
};
modes.forEach((mode, i) => { keys[i + 1] = () => fold && setColours(mode, state.safe); });

// Controls keep the keys they know; all others belong to the page.
function onKey(event) {
    const focus = document.activeElement, arrow = arrows[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey || focus?.tagName === "SELECT")
        return;
    if (arrow && focus === $("time"))
        return;
    if (event.key === " " && ["BUTTON", "SUMMARY"].includes(focus?.tagName))
        return;
    const action = arrow ? () => onArrow(focus, arrow, event.shiftKey) : keys[event.key.toLowerCase()];
    if (action) {
        event.preventDefault();
        action();
    }
}

function onArrow(focus, [across, up], shift) {
    if (focus === $("chart"))
        moveMark(across, up);
    else if (shift)
        fold?.pan(-0.08 * across, -0.08 * up);
    else
        fold?.turn(-0.14 * across, -0.14 * up);
}

// ---- begin ----

function fill() {
    const [words, ending] = summary(swatch);
    $("title").textContent = swatch.title;
    $("summary").textContent = words;
    $("ending").textContent = ending;
    $("footer").textContent = `weft ${swatch.weft}`;
    $("time").max = last;
    $("ticks").append(...swatch.steps.map((_, step) => element("option", { value: step })));
    $("mode").append(...modes.map(({ name, label }) => element("option", { value: name }, label)));
    $("views").append(...Object.keys(views).map((view) => {
        const button = element("button", { type: "button" }, view);
        button.addEventListener("click", () => fold?.look(view));
        return button;
    }));
    parameters($("parameters"), swatch);
}

function listen() {
    $("time").addEventListener("input", () => stepTo(Number($("time").value)));
    $("play").addEventListener("click", () => setPlaying(!state.playing));
    $("mode").addEventListener("change", () => setColours(modes.find(({ name }) => name === $("mode").value), state.safe));
    $("safe").addEventListener("click", keys.b);
    $("theme").addEventListener("click", keys.t);
    $("help").addEventListener("click", toggleHelp);
    addEventListener("keydown", onKey);
    follow($("chart"), chart);
    if (fold)
        follow($("fold"), fold);
    const wish = matchMedia("(prefers-color-scheme: dark)");
    wish.addEventListener("change", () => setTheme(wish.matches));
    return wish.matches;
}

fill();
setTheme(listen());
setColours(modes[0], false);
setTime(last);
setPlaying(false);

// For those who drive the page from outside: tests, a browser's console.
globalThis.weft = { swatch, state, chart, fold, setTime, mark };
