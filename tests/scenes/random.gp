# The random surface of Anderson's Table 1: uniform heights in [0,1), from a data file.
set title "uniform random heights, 60x60, seen from (6,8,3)"
set view from 6,8,3
splot 'random60.dat' nonuniform matrix with lines
