# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes read by VTK: a folder with the files of readers.sh in; on standard
# output a line of TAP without number for each thing that must hold.
import json
import math
import os
import re
import struct
import sys

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

os.chdir(sys.argv[1])
SAMPLES = 3                     # cells along a stitch's side, as the script of readers.sh has it
WIDTH, HEIGHT = 1.4, 1.2        # of a stitch
SRGB = {"K": (200, 53, 43), "P": (47, 95, 168)}
failed = []


def check(what, good, why=""):
    print("ok" if good else "not ok", "-", what, "#" if not good else "", why if not good else "")


def single(x):
    """The 32-bit float next to x."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def close(a, b, tolerance=1e-5):
    return len(a) == len(b) and all(abs(x - y) <= tolerance for p, q in zip(a, b) for x, y in zip(p, q))


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points(mesh):
    return [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]


def cells(mesh):
    out = []
    for i in range(mesh.GetNumberOfCells()):
        ids = mesh.GetCell(i).GetPointIds()
        out.append(tuple(ids.GetId(k) for k in range(ids.GetNumberOfIds())))
    return out


def array(data, name):
    values = data.GetArray(name)
    return values and [values.GetTuple(i) for i in range(values.GetNumberOfTuples())]


def scalars(mesh, name):
    return [v[0] for v in array(mesh.GetCellData(), name)]


def everything(mesh):
    data = {"points": points(mesh), "cells": cells(mesh)}
    for part in (mesh.GetPointData(), mesh.GetCellData()):
        for i in range(part.GetNumberOfArrays()):
            data[part.GetArrayName(i)] = array(part, part.GetArrayName(i))
    return data


# ---- what must come out: the chart, the report and the .vtp, which is checked first ----

with open("x.txt") as stream:
    chart = [line.split() for line in stream.read().splitlines()[1:]]
with open("r.json") as stream:
    report = json.load(stream)
rows, columns = len(chart), len(chart[0])
nx, ny = columns * SAMPLES, rows * SAMPLES
stitch = [chart[j // SAMPLES][i // SAMPLES] for j in range(ny) for i in range(nx)]

vtp = read(vtkXMLPolyDataReader(), "x.vtp")
position, quads = points(vtp), cells(vtp)
normal = array(vtp.GetPointData(), "normal")
triangles = [t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]

check("vtp: so many points and cells as the output asks for, whatever the solver used",
      len(position) == (nx + 1) * (ny + 1) and len(quads) == nx * ny
      and report["discretisation"]["per_stitch"] != SAMPLES)
check("vtp: cells", quads == [(j * (nx + 1) + i, j * (nx + 1) + i + 1, (j + 1) * (nx + 1) + i + 1, (j + 1) * (nx + 1) + i)
                              for j in range(ny) for i in range(nx)])
check("vtp: rows", scalars(vtp, "row") == [j // SAMPLES + 1 for j in range(ny) for i in range(nx)])
check("vtp: columns", scalars(vtp, "column") == [i // SAMPLES + 1 for j in range(ny) for i in range(nx)])
check("vtp: stitches", scalars(vtp, "stitch_id") == [j // SAMPLES * columns + i // SAMPLES for j in range(ny) for i in range(nx)])
check("vtp: knit and purl", scalars(vtp, "knit_sign") == [1 if s == "K" else -1 for s in stitch])
kx, ky = report["parameters"]["K.kx"]["value"], report["parameters"]["K.ky"]["value"]
check("vtp: natural curvatures", scalars(vtp, "kx") == [kx if s == "K" else -kx for s in stitch]
      and scalars(vtp, "ky") == [ky if s == "K" else -ky for s in stitch])
check("vtp: unit normals", all(abs(math.hypot(*n) - 1) < 1e-12 for n in normal))
flat = [[p - d for p, d in zip(*both)] for both in zip(position, array(vtp.GetPointData(), "displacement"))]
check("vtp: displacements from the flat sheet",
      all(abs(f[0] - flat[0][0] - k % (nx + 1) * WIDTH / SAMPLES) < 1e-12
          and abs(f[1] - flat[0][1] - k // (nx + 1) * HEIGHT / SAMPLES) < 1e-12 and abs(f[2] - flat[0][2]) < 1e-12
          for k, f in enumerate(flat)))
area = WIDTH * HEIGHT / SAMPLES ** 2
for name in ("stretching", "bending"):
    total = sum(scalars(vtp, name + "_density")) * area
    wanted = report["energy"][name]
    check("vtp: %s energy" % name, abs(total - wanted) < 0.1 * report["energy"]["total"], "%g, not %g" % (total, wanted))
mean, gauss = scalars(vtp, "mean_curvature"), scalars(vtp, "gaussian_curvature")
most = max(abs(h) + math.sqrt(max(h * h - g, 0)) for h, g in zip(mean, gauss))
wanted = report["shape"]["max_normal_curvature"]
check("vtp: curvatures", 0.5 * wanted < most < 1.5 * wanted and all(h * h >= g - 1e-9 for h, g in zip(mean, gauss)),
      "%g, not %g" % (most, wanted))
ascii = read(vtkXMLPolyDataReader(), "a.vtp")
check("vtp, ascii: every field as in binary", everything(ascii) == everything(vtp))
check("vtp, ascii: is text", all(byte < 128 for byte in open("a.vtp", "rb").read()))

# ---- growth: what the .pvd names ----

with open("x.pvd") as stream:
    steps = re.findall(r'timestep="([^"]*)".*file="([^"]*)"', stream.read())
grown = [(float(growth), read(vtkXMLPolyDataReader(), name)) for growth, name in steps]
check("pvd: all steps", [g for g, mesh in grown] == [0, 0.25, 0.5, 0.75, 1])
check("pvd: the last is the folded surface", everything(grown[-1][1]) == everything(vtp))
check("pvd: the first is flat", close([p[:2] for p in points(grown[0][1])], [f[:2] for f in flat], 0.02))

# ---- PLY ----

ply = read(vtkPLYReader(), "x.ply")
check("ply: points", points(ply) == [tuple(map(single, p)) for p in position])
check("ply: cells", cells(ply) == quads)
check("ply: normals", close(array(ply.GetPointData(), "Normals") or [], normal, 1e-6))
check("ply: colours of the cells", array(ply.GetCellData(), "RGB") == [SRGB[s] for s in stitch])
around = [[] for p in position]
for q, s in zip(quads, stitch):
    for k in q:
        around[k].append(SRGB[s])
check("ply: colours of the points", close(array(ply.GetPointData(), "RGB"),
                                          [[sum(c) / len(a) for c in zip(*a)] for a in around], 0.501))

# ---- STL ----

reader = vtkSTLReader()
reader.MergingOff()
stl = read(reader, "x.stl")
p = points(stl)
check("stl: triangles", [tuple(p[k] for k in c) for c in cells(stl)]
      == [tuple(tuple(map(single, position[k])) for k in t) for t in triangles])
check("stl: says what is lost", b"Lost: " in open("x.stl", "rb").read(80))

# ---- OBJ ----

obj = read(vtkOBJReader(), "x.obj")
check("obj: points", points(obj) == [tuple(map(single, p)) for p in position])
check("obj: normals", close(array(obj.GetPointData(), "Normals") or [], normal, 1e-6))
check("obj: cells, the knits first", cells(obj) == [q for kind in "KP" for q, s in zip(quads, stitch) if s == kind])
check("obj: a material for each", scalars(obj, "MaterialIds") == [float(s == "P") for s in sorted(stitch)])

# ---- glTF ----


def leaf(data):
    while data.IsA("vtkMultiBlockDataSet"):
        data = data.GetBlock(0)
    return data


def linear(byte):
    c = byte / 255
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


reader = vtkGLTFReader()
glb = leaf(read(reader, "x.glb"))
ordered = [i for kind in "KP" for i, s in enumerate(stitch) if s == kind]
corner = [t for i in ordered for t in triangles[2 * i:2 * i + 2]]
source = [None] * glb.GetNumberOfPoints()       # the point each vertex stands for
for mine, theirs in zip(corner, cells(glb)):
    for k, v in zip(mine, theirs):
        source[v] = k
check("glb: triangles", len(cells(glb)) == len(corner) and None not in source)
check("glb: positions", points(glb) == [tuple(map(single, position[k])) for k in source])
check("glb: normals", close(array(glb.GetPointData(), "NORMAL"), [normal[k] for k in source], 1e-6))
colour = array(glb.GetPointData(), "COLOR_0")
check("glb: colours, linear", close([colour[v] for c in cells(glb) for v in c],
                                    [[linear(b) for b in SRGB[stitch[i]]] + [1] for i in ordered for k in range(6)], 0.003))
reader.EnableAnimation(0)
reader.SetFrameRate(60)
reader.UpdateInformation()
check("glb: an animation", reader.GetNumberOfAnimations() == 1 and reader.GetAnimationDuration(0) == 4)
for growth, mesh in grown:
    reader.UpdateTimeStep(4 * growth)
    moved = leaf(reader.GetOutput())
    check("glb: growth %g" % growth, close(points(moved), [points(mesh)[k] for k in source], 1e-4))
