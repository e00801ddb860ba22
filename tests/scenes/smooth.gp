# The smooth surface of Anderson's Table 1 (Hidden Line Elimination in Projected Grid Surfaces, 1982).
set title "exp(-x^2-y^2), 60x60, seen from (6,8,3)"
set xrange [-2:2]
set yrange [-2:2]
set isosamples 60
set view from 6,8,3
splot exp(-x**2 - y**2)
