#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes read by readers that are not ours: VTK and the Khronos glTF validator.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# No symmetry, and sampled otherwise than it is solved.
cat >"$work/x.knit" <<'KNIT'
Cast on 5 sts
Row 1 (RS): k1, p2, k2.
Row 2 (WS): p1, k4.
Row 3 (RS): k3, p2.
Row 4 (WS): k1, p1, k3.
mesh  { per_stitch = 2 }
solve { steps = 4 }
output "x.vtp" { per_stitch = 3 }
output "a.vtp" { per_stitch = 3; format = ascii }
output "x.pvd" { per_stitch = 3 }
output "x.obj" { per_stitch = 3 }
output "x.ply" { per_stitch = 3 }
output "x.stl" { per_stitch = 3 }
output "x.glb" { per_stitch = 3 }
output "x.txt"
output "r.json"
KNIT

run_there() { (cd "$work" && "$WEFT" run -q x.knit); }
check 'all meshes are written' run_there

# ---- VTK ----

python=
for candidate in python3 /usr/bin/python3; do
    if [ -z "$python" ] && "$candidate" -c 'import vtkmodules.vtkIOXML' >/dev/null 2>&1; then
        python=$candidate
    fi
done
if [ -n "$python" ]; then
    check 'VTK read all' sh -c '"$1" "$2" "$3" >"$3/vtk"' - "$python" "$WEFT_SOURCE/tests/output/readers.py" "$work"
    while read -r line; do
        case $line in
            'ok - '*) pass "VTK: ${line#ok - }" ;;
            *) fail "VTK: ${line#not ok - }" ;;
        esac
    done <"$work/vtk"
else
    skip 'VTK reads the meshes' 'no python3-vtk9 (some 660 MB with all it needs)'
fi

# ---- the glTF validator ----

validator=$WEFT_SOURCE/viewer/node_modules/gltf-validator
if [ -d "$validator" ] && command -v node >/dev/null 2>&1; then
    exits 0 'the glTF validator finds nothing to say' node "$WEFT_SOURCE/tests/output/gltf.cjs" "$validator" "$work/x.glb"
    out 'it saw the growth and all triangles' '^animations 1, morph true, triangles 360$'
else
    skip 'the glTF validator finds nothing to say' 'no gltf-validator in viewer/node_modules'
fi

finish
