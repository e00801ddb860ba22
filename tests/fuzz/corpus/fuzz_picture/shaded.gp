set hatch 30,1
set isosamples 6
set light 2 from 3,4,9
set pen hatch 2 crease 3
splot [-1:1][-1:1] x*y
