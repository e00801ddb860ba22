#!/bin/sh
# demo.sh RIDGELINE FOLDER - draws the demo scenes: of each a picture (.svg, .png), the step trace (.vcd) and the drawing (.seg)
# in FOLDER, and a row of the table.
ridgeline=$1
out=$2
mkdir -p "$out" || exit 1
row=1
for scene in smooth random sinc ridgeline pylon temple shadows peaks dunes; do
    to=$out/$scene
    "$ridgeline" plot -v "tests/scenes/$scene.gp" -o "$to.svg" -o "$to.png" -o "$to.vcd" -o "$to.seg" \
        --stats "$to.json" >"$to.table" || exit 1
    # The head of the table once, then rows.
    tail -n +$row "$to.table"
    rm -f "$to.table"
    row=2
done
echo "Pictures, step traces and drawings are in $out."
