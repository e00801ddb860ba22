#!/bin/sh
# grbl.sh BUILD - how long drawings take and how evenly the motors step, beside a simulated Grbl (peers/grbl_motion.c) that is sent the same
# drawing as G-code. A jump is the change of a motor's speed from one step to the next, 1/80 mm over the time between two steps, where
# they are less than 20 ms apart; the largest, and the root of the mean square. "vector": a Grbl that limits the pen's acceleration, as we do, and not each axis'.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
motion() { # VCD: s, largest jump, root mean square
    awk '/^\$timescale/ { unit = $2 * ($3 == "ps" ? 1e-12 : 1e-9) }
        /^\$var/ { name[$4] = $5 }
        /^\$end$/ { begun = 1 }
        /^#/ { t = substr($0, 2) * unit }
        begun && /^1/ && !start { start = t }
        begun && /^1/ && (pin = name[substr($0, 2)]) ~ /step/ {
            v = 1 / 80 / (t - at[pin])
            if (t - at[pin] >= 0.02) v = 0
            if (v && speed[pin]) {
                jump = v - speed[pin]; if (jump < 0) jump = -jump
                if (jump > most) most = jump
                sum += jump * jump; n++
            }
            speed[pin] = v; at[pin] = t
        }
        END { printf "%.2f %.1f %.3f\n", t - start, most, sqrt(sum / n) }' "$1"
}
echo 'Motion at 80 steps/mm, 100 mm/s, 1000 mm/s^2, junction deviation 0.01 mm; jumps of speed from step to step, mm/s'
printf '%-20s |%26s |%26s |%26s\n%-20s' '' ours Grbl 'Grbl, vector' drawing
for who in 1 2 3; do printf ' |%8s %8s %8s' s largest rms; done
echo
row() { # name, file without suffix
    $1/bench/grbl_motion <"$3.gcode" >"$work/grbl.vcd"
    $1/bench/grbl_motion vector <"$3.gcode" >"$work/vector.vcd"
    printf '%-20s' "$2"
    for vcd in "$3" "$work/grbl" "$work/vector"; do printf ' |%8s %8s %8s' $(motion "$vcd.vcd"); done
    echo
}
drawing() { # build, name; the scene's text on standard input
    cat >"$work/scene.gp"
    "$1/host/ridgeline" plot "$work/scene.gp" -o "$work/scene.vcd" -o "$work/scene.gcode" && row "$1" "$2" "$work/scene"
}
echo 'set isosamples 40; splot exp(-x**2-y**2)' | drawing "$1" 'hill 40x40'
echo 'set isosamples 40; set xrange [-12:12]; set yrange [-12:12]; splot sin(sqrt(x**2+y**2))/sqrt(x**2+y**2)' | drawing "$1" 'sinc 40x40'
echo 'set isosamples 20; splot rand(0)' | drawing "$1" 'random 20x20'
echo 'set parametric; set urange [0:6.2832]; set vrange [0:6.2832]; set isosamples 100,16; splot (3+cos(v))*cos(u), (3+cos(v))*sin(u), sin(v)' | drawing "$1" 'torus 100x16'
