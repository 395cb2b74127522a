// SPDX-License-Identifier: GPL-3.0-or-later
// The fold in space: a swatch in, a canvas that can be turned, coloured and
// pointed at out.  It draws when something changed and is still otherwise.
import {
    BackSide, BufferAttribute, BufferGeometry, CanvasTexture, DataTexture, DirectionalLight, DoubleSide, FrontSide,
    HemisphereLight, LinearFilter, LineBasicMaterial, LineLoop, Mesh, MeshBasicMaterial, MeshStandardMaterial,
    PerspectiveCamera, Raycaster, Scene, SRGBColorSpace, Spherical, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { scaleTable, stitchColour } from "./colours.js";
import { between } from "./data.js";

// Where the viewer of each view stands, seen from the swatch.
export const views = {
    tilted: [0.45, -0.62, 1],
    front: [0, 0, 1],
    back: [0, 0, -1],
    edge: [0, -1, 0.12],
};

const BEHIND = 0.8;         // brightness of the wrong side beside the right one, as in pictures

// ---- geometry ----

// Two triangles a cell, counter-clockwise seen from the right side; the triangle's number tells its cell.
function gridGeometry(nx, ny) {
    const across = nx + 1, points = across * (ny + 1);
    const geometry = new BufferGeometry(), uv = new Float32Array(2 * points), index = new Uint32Array(6 * nx * ny);
    for (let i = 0; i < points; i++) {
        uv[2 * i] = i % across / nx;
        uv[2 * i + 1] = Math.floor(i / across) / ny;
    }
    for (let cell = 0; cell < nx * ny; cell++) {
        const a = Math.floor(cell / nx) * across + cell % nx;
        index.set([a, a + 1, a + across + 1, a, a + across + 1, a + across], 6 * cell);
    }
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * points), 3));
    geometry.setAttribute("uv", new BufferAttribute(uv, 2));
    geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
}

// ---- colours ----

// A knit stitch is a V, a purl stitch a bump: drawn a little darker than the wool.
function drawStitch(context, id, x, y, size) {
    context.beginPath();
    if (id === 0) {
        context.moveTo(x + 0.14 * size, y + 0.08 * size);
        context.lineTo(x + 0.5 * size, y + 0.86 * size);
        context.lineTo(x + 0.86 * size, y + 0.08 * size);
    } else if (id === 1) {
        context.moveTo(x + 0.1 * size, y + 0.62 * size);
        context.quadraticCurveTo(x + 0.5 * size, y + 0.12 * size, x + 0.9 * size, y + 0.62 * size);
    }
    context.stroke();
}

// What one side of the fabric shows: a purl stitch is a knit one from behind.
function stitchTexture(swatch, safe, behind) {
    const { columns, rows, grid, stitches } = swatch;
    const size = Math.max(1, Math.min(24, Math.floor(2048 / Math.max(columns, rows))));
    const canvas = document.createElement("canvas");
    canvas.width = columns * size;
    canvas.height = rows * size;
    const context = canvas.getContext("2d");
    context.strokeStyle = "rgba(0, 0, 0, 0.2)";
    context.lineWidth = 0.13 * size;
    context.lineCap = context.lineJoin = "round";
    for (let row = 0; row < rows; row++)
        for (let column = 0; column < columns; column++) {
            const own = grid[row * columns + column], id = behind ? stitches[own].ws : own;
            const x = column * size, y = (rows - 1 - row) * size;
            context.fillStyle = stitchColour(swatch, id, safe);
            context.fillRect(x, y, size, size);
            if (size >= 8)
                drawStitch(context, id, x, y, size);
        }
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    texture.anisotropy = 8;
    return texture;
}

function fieldTexture(nx, ny) {
    const texture = new DataTexture(new Uint8Array(4 * nx * ny).fill(255), nx, ny);
    texture.colorSpace = SRGBColorSpace;
    texture.magFilter = texture.minFilter = LinearFilter;
    return texture;
}

// ---- the fold ----

export class Fold {
    // Throws where there is no WebGL.
    constructor(holder, swatch) {
        const canvas = document.createElement("canvas");
        const context = canvas.getContext("webgl2", { antialias: true, alpha: true });
        if (!context)
            throw new Error("no WebGL");
        this.swatch = swatch;
        this.holder = holder;
        this.canvas = canvas;
        this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        holder.append(canvas);
        this.makeScene();
        this.makeMark();
        this.makeControls();
        new ResizeObserver(() => this.resize()).observe(holder);
        this.setTime(swatch.nsteps - 1);
        this.resize();
        this.look("tilted");
    }

    makeScene() {
        const { nx, ny } = this.swatch;
        this.scene = new Scene();
        this.camera = new PerspectiveCamera(26, 1, 0.1, 1000);
        this.geometry = gridGeometry(nx, ny);
        const material = { roughness: 0.9, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
        this.sides = [FrontSide, BackSide].map((side) => new Mesh(this.geometry, new MeshStandardMaterial({ ...material, side })));
        this.sides[1].material.color.setRGB(BEHIND, BEHIND, BEHIND, SRGBColorSpace);
        this.field = fieldTexture(nx, ny);
        this.key = new DirectionalLight(0xffffff, 1.9);
        this.scene.add(...this.sides, new HemisphereLight(0xffffff, 0xb9b2aa, 1.55), this.key, this.key.target);
        for (const side of this.sides)
            side.frustumCulled = false;
        this.target = new Mesh(this.geometry, new MeshBasicMaterial({ side: DoubleSide }));   // never drawn: what the pointer hits
        this.radius = this.largest();
    }

    // How far the swatch reaches from its middle, over all steps.
    largest() {
        const { x, y, z } = this.swatch.fields;
        let most = 0;
        for (let i = 0; i < x.length; i++)
            most = Math.max(most, x[i] ** 2 + y[i] ** 2 + z[i] ** 2);
        return Math.sqrt(most) || 1;
    }

    // The marked stitch: its cells, its outline, and a shine through what hides it.
    makeMark() {
        const n = this.swatch.per_stitch, outline = new BufferGeometry();
        this.markGeometry = gridGeometry(n, n);
        outline.setAttribute("position", new BufferAttribute(new Float32Array(3 * 4 * n), 3));
        const paint = { color: 0xffd23f, side: DoubleSide, transparent: true };
        this.mark = [
            new Mesh(this.markGeometry, new MeshBasicMaterial({ ...paint, opacity: 0.9 })),
            new Mesh(this.markGeometry, new MeshBasicMaterial({ ...paint, opacity: 0.35, depthTest: false })),
            new LineLoop(outline, new LineBasicMaterial({ color: 0x1c1917, depthTest: false, transparent: true })),
        ];
        this.mark.forEach((part, i) => {
            part.renderOrder = i + 1;
            part.frustumCulled = false;
            part.visible = false;
        });
        this.scene.add(...this.mark);
    }

    makeControls() {
        this.controls = new OrbitControls(this.camera, this.canvas);
        this.controls.enableDamping = true;
        this.controls.dampingFactor = 0.12;
        this.controls.minDistance = this.radius * 0.4;
        this.controls.maxDistance = this.radius * 20;
        this.controls.addEventListener("change", () => this.invalidate());
        this.ray = new Raycaster();
    }

    // ---- drawing ----

    invalidate() {
        this.frame ??= requestAnimationFrame(() => {
            this.frame = null;
            if (this.controls.update())
                this.invalidate();
            this.draw();
        });
    }

    // The light comes over the viewer's left shoulder.
    draw() {
        const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
        const up = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
        this.key.target.position.copy(this.controls.target);
        this.key.position.copy(this.camera.position).addScaledVector(right, -0.9 * this.radius).addScaledVector(up, 1.3 * this.radius);
        this.renderer.render(this.scene, this.camera);
    }

    resize() {
        const width = this.holder.clientWidth, height = this.holder.clientHeight;
        if (!width || !height)
            return;
        this.renderer.setSize(width, height);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.invalidate();
    }

    // ---- what is shown ----

    setTime(time) {
        const position = this.geometry.getAttribute("position"), { points, fields } = this.swatch;
        this.time = time;
        ["x", "y", "z"].forEach((axis, i) => between(fields[axis], points, time, position.array, i, 3));
        position.needsUpdate = true;
        this.geometry.computeVertexNormals();
        this.geometry.computeBoundingSphere();
        this.colourField();
        this.setMark(this.marked);
        this.invalidate();
    }

    setColours(mode, safe) {
        this.mode = mode;
        this.safe = safe;
        if (mode.name === "stitch") {
            if (this.stitchSafe !== safe) {
                this.stitch?.forEach((texture) => texture.dispose());
                this.stitch = [false, true].map((behind) => stitchTexture(this.swatch, safe, behind));
                this.stitchSafe = safe;
            }
            this.sides.forEach((side, i) => { side.material.map = this.stitch[i]; });
        } else {
            this.table = scaleTable(this.swatch, mode);
            this.sides.forEach((side) => { side.material.map = this.field; });
            this.colourField();
        }
        this.sides.forEach((side) => { side.material.needsUpdate = true; });
        this.invalidate();
    }

    colourField() {
        if (!this.mode || this.mode.name === "stitch")
            return;
        const { cells, fields } = this.swatch, { low, high } = this.mode, to = this.field.image.data;
        this.values ??= new Float32Array(cells);
        between(fields[this.mode.name], cells, this.time, this.values);
        for (let i = 0; i < cells; i++) {
            const level = Math.round(255 * Math.max(0, Math.min(1, (this.values[i] - low) / (high - low))));
            for (let c = 0; c < 3; c++)
                to[4 * i + c] = this.table[3 * level + c];
        }
        this.field.needsUpdate = true;
    }

    setMark(stitch) {
        this.marked = stitch;
        for (const part of this.mark)
            part.visible = Boolean(stitch);
        if (stitch)
            this.placeMark(stitch);
        this.invalidate();
    }

    placeMark({ column, row }) {
        const n = this.swatch.per_stitch, across = this.swatch.nx + 1;
        const from = this.geometry.getAttribute("position").array;
        const to = this.markGeometry.getAttribute("position"), line = this.mark[2].geometry.getAttribute("position");
        const copy = (attribute, k, x, y) => {
            const i = 3 * ((row * n + y) * across + column * n + x);
            attribute.array.set(from.subarray(i, i + 3), 3 * k);
        };
        for (let k = 0; k < (n + 1) ** 2; k++)
            copy(to, k, k % (n + 1), Math.floor(k / (n + 1)));
        for (let k = 0; k < n; k++) {
            copy(line, k, k, 0);
            copy(line, n + k, n, k);
            copy(line, 2 * n + k, n - k, n);
            copy(line, 3 * n + k, 0, n - k);
        }
        to.needsUpdate = line.needsUpdate = true;
    }

    // The stitch at a place on the screen, or null.
    pick(clientX, clientY) {
        const box = this.canvas.getBoundingClientRect(), { nx, per_stitch } = this.swatch;
        const at = new Vector2((clientX - box.left) / box.width * 2 - 1, 1 - (clientY - box.top) / box.height * 2);
        this.camera.updateMatrixWorld();        // a frame may not have been drawn since it moved
        this.ray.setFromCamera(at, this.camera);
        const [hit] = this.ray.intersectObject(this.target);
        if (!hit)
            return null;
        const cell = Math.floor(hit.faceIndex / 2);
        return { column: Math.floor(cell % nx / per_stitch), row: Math.floor(Math.floor(cell / nx) / per_stitch) };
    }

    // Where the middle of a stitch is on the screen.
    place({ column, row }) {
        const n = this.swatch.per_stitch, across = this.swatch.nx + 1;
        const from = this.geometry.getAttribute("position").array, box = this.canvas.getBoundingClientRect();
        const middle = new Vector3();
        for (const [x, y] of [[0, 0], [n, 0], [0, n], [n, n]])
            middle.add(new Vector3().fromArray(from, 3 * ((row * n + y) * across + column * n + x)));
        this.camera.updateMatrixWorld();
        middle.divideScalar(4).project(this.camera);
        return { x: box.left + (middle.x + 1) / 2 * box.width, y: box.top + (1 - middle.y) / 2 * box.height };
    }

    // ---- the viewer ----

    look(view) {
        const half = Math.tan(this.camera.fov * Math.PI / 360) * Math.min(1, this.camera.aspect);
        this.controls.target.set(0, 0, 0);
        this.camera.position.fromArray(views[view]).setLength(0.94 * this.radius / Math.sin(Math.atan(half)));
        this.controls.update();
        this.invalidate();
    }

    turn(across, up) {
        const from = this.camera.position.clone().sub(this.controls.target);
        const angles = new Spherical().setFromVector3(from);
        angles.theta -= across;
        angles.phi -= up;
        angles.makeSafe();
        this.camera.position.setFromSpherical(angles).add(this.controls.target);
        this.controls.update();
        this.invalidate();
    }

    zoom(factor) {
        const from = this.camera.position.clone().sub(this.controls.target);
        const { minDistance, maxDistance } = this.controls;
        from.setLength(Math.max(minDistance, Math.min(maxDistance, from.length() / factor)));
        this.camera.position.copy(from.add(this.controls.target));
        this.controls.update();
        this.invalidate();
    }

    pan(across, up) {
        const step = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(across * this.radius)
            .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * this.radius);
        this.camera.position.add(step);
        this.controls.target.add(step);
        this.controls.update();
        this.invalidate();
    }
}
